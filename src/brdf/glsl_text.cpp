// The BRDF of a choice as GLSL.
// SPDX-License-Identifier: MIT
#include "brdf/glsl_text.h"

#include "base/text.h"

#include <spdlog/fmt/fmt.h>

#include <set>
#include <string_view>

namespace facet::brdf {
namespace {

/// The slot that decides which row of `slot` is used: most decide for themselves.
std::string_view deciding_slot(std::string_view slot) {
    for (const tables::BrdfTerm& term : tables::brdf_terms)
        if (term.slot == slot && !term.notes.follows.empty()) return term.notes.follows;
    return slot;
}

/// The row of `slot` that `choice` picks; null where the table has a hole.
const tables::BrdfTerm* chosen(std::string_view slot, const tables::BrdfChoice& choice) {
    const std::string_view decider = deciding_slot(slot);
    for (const tables::BrdfSlot& user_slot : tables::brdf_slots) {
        if (user_slot.key != decider) continue;
        std::size_t left = user_slot.index(choice);
        for (const tables::BrdfTerm& term : tables::brdf_terms)
            if (term.slot == slot && left-- == 0) return &term;
    }
    return nullptr;
}

tl::unexpected<base::Error> without_row(const tables::BrdfSlotFunction& function) {
    return base::fail(
        {.what = "brdf_terms.def has no row for a slot", .found = std::string(function.slot)});
}

/// The files of a term that are not among `seen` yet.
std::string include_lines(const tables::BrdfTerm& term, std::set<std::string_view>& seen) {
    std::string out;
    for (const std::string_view file : base::split(term.files, ' '))
        if (!file.empty() && seen.insert(file).second)
            out += fmt::format("#include \"brdf/{}.glsl\"\n", file);
    return out;
}

/// The files of what layers are of and no slot calls.
std::string layer_includes(std::set<std::string_view>& seen) {
    std::string out;
    for (const tables::BrdfTerm& term : tables::brdf_terms)
        if (term.name == "sheen_charlie") out += include_lines(term, seen);
    for (const char* file : {"d_ggx_anisotropic", "v_smith_ggx_anisotropic"})
        if (seen.insert(file).second) out += fmt::format("#include \"brdf/{}.glsl\"\n", file);
    return out;
}

/// Prelude, terms and slots, model: in the order that GLSL needs.
std::string assembled(bool needs_e_l, const std::string& terms, Parts parts) {
    std::string text = fmt::format(
        "#define FACET_BRDF_NEEDS_E_L {}\n#include \"brdf/prelude.glsl\"\n", needs_e_l ? 1 : 0);
    text += terms;
    for (const char* part : {"albedo_coordinates", "brdf_types", "conserving", "cook_torrance",
                             "model", "layers", "transmission", "anisotropy", "thin_film"})
        text += fmt::format("#include \"brdf/model/{}.glsl\"\n", part);
    if (parts == Parts::sampling) text += "#include \"brdf/model/sampling.glsl\"\n";
    return text;
}

}  // namespace

base::Result<std::string> glsl_text(const tables::BrdfChoice& choice, Parts parts) {
    const bool has_fresnel = choice.fresnel != tables::Fresnel::none;
    const bool conserves = choice.multiscatter != tables::Multiscatter::off && has_fresnel;
    std::string includes;
    std::string slots;
    std::set<std::string_view> seen;
    for (const tables::BrdfSlotFunction& function : tables::brdf_slot_functions) {
        if (function.samples && parts == Parts::shading) continue;
        const tables::BrdfTerm* term = chosen(function.slot, choice);
        if (term == nullptr) return without_row(function);
        includes += include_lines(*term, seen);
        slots += fmt::format("{} {{ return {}; }}\n", function.signature, term->call);
    }
    includes += layer_includes(seen);
    slots += fmt::format("bool slot_conserves() {{ return {}; }}\n", conserves);
    slots += fmt::format("bool slot_has_fresnel() {{ return {}; }}\n", has_fresnel);
    const bool needs_e_l = choice.multiscatter == tables::Multiscatter::kulla_conty;
    return assembled(needs_e_l, includes + slots, parts);
}

base::Result<std::string> glsl_text_of_all() {
    std::string chosen;
    for (const tables::BrdfSlot& slot : tables::brdf_slots)
        chosen += fmt::format("uniform int chosen_{};\n", slot.key);
    std::string includes;
    std::string slots;
    std::set<std::string_view> seen;
    for (const tables::BrdfSlotFunction& function : tables::brdf_slot_functions) {
        std::string body;
        int index = 0;
        for (const tables::BrdfTerm& term : tables::brdf_terms) {
            if (term.slot != function.slot) continue;
            includes += include_lines(term, seen);
            body += fmt::format("    if (chosen_{} == {}) return {};\n",
                                deciding_slot(function.slot), index++, term.call);
        }
        if (body.empty()) return without_row(function);
        slots += fmt::format("{} {{\n{}    return {}(0);\n}}\n", function.signature, body,
                             function.signature.substr(0, function.signature.find(' ')));
    }
    includes += layer_includes(seen);
    slots += fmt::format("bool slot_has_fresnel() {{ return chosen_fresnel != {}; }}\n",
                         static_cast<int>(tables::Fresnel::none));
    slots += fmt::format(
        "bool slot_conserves() {{ return chosen_multiscatter != {} && slot_has_fresnel(); }}\n",
        static_cast<int>(tables::Multiscatter::off));
    return assembled(true, chosen + includes + slots, Parts::sampling);
}

}  // namespace facet::brdf
