// The value of --brdf: text to a choice of terms.
// SPDX-License-Identifier: MIT
#include "brdf/choice.h"

#include "base/text.h"

#include <algorithm>
#include <span>
#include <string>
#include <vector>

namespace facet::brdf {
namespace {

using tables::BrdfChoice;

std::string with(std::string_view text, char from, char to) {
    std::string out(text);
    std::replace(out.begin(), out.end(), from, to);
    return out;
}

tl::unexpected<base::Error> unknown(std::string what, const std::string& found,
                                    const std::vector<std::string>& names) {
    return base::fail({.code = base::ErrorCode::usage,
                       .what = std::move(what),
                       .found = found,
                       .remedy = base::suggestion(found, names)});
}

/// Names of a slot's terms as the user writes them; the index is that of the slot's enumeration.
std::vector<std::string> term_names(std::string_view slot, Use use) {
    std::vector<std::string> names;
    for (const tables::BrdfTerm& term : tables::brdf_terms)
        if (term.slot == slot && (use == Use::lesson || !term.notes.lesson))
            names.push_back(with(term.name, '_', '-'));
    return names;
}

/// The lecture's set: k_direct for lights, k_IBL for the environment, no compensation (physics:
/// 0.3, 4.3).
BrdfChoice lecture() {
    BrdfChoice choice;
    choice.masking = tables::Masking::schlick_direct;
    choice.environment_masking = tables::Masking::schlick_ibl;
    choice.multiscatter = tables::Multiscatter::off;
    return choice;
}

base::Status set(BrdfChoice& choice, std::string_view part, Use use) {
    const std::size_t equals = part.find('=');
    const std::string key = with(base::trimmed(part.substr(0, equals)), '-', '_');
    std::vector<std::string> known;
    for (const tables::BrdfSlot& slot : tables::brdf_slots) {
        const auto names = term_names(slot.key, use);
        // A slot with one term leaves nothing to choose.
        if (names.size() > 1) known.emplace_back(slot.key);
        if (slot.key != key || names.size() < 2) continue;
        const std::string name = equals == std::string_view::npos
                                     ? ""
                                     : with(base::trimmed(part.substr(equals + 1)), '_', '-');
        const auto found = std::find(names.begin(), names.end(), name);
        if (found == names.end()) return unknown("no such " + key, name, names);
        // Lesson terms stand last in their slot, so that the index is the enumeration's either way.
        slot.set(choice, static_cast<std::size_t>(found - names.begin()));
        return {};
    }
    if (equals == std::string_view::npos) {
        known.emplace_back("lecture");
        if (use == Use::lesson) known.emplace_back("lecture-literal");
        return unknown("no such set of terms, and no slot=term", std::string(part), known);
    }
    return unknown("no such slot", key, known);
}

}  // namespace

base::Result<BrdfChoice> parse_choice(std::string_view text, Use use) {
    BrdfChoice choice;
    for (const std::string_view piece : base::split(text, ','))
        for (const std::string_view part : base::split(piece, ';')) {
            const std::string_view word = base::trimmed(part);
            if (word.empty()) continue;
            if (word == "lecture") {
                choice = lecture();
            } else if (word == "lecture-literal" && use == Use::lesson) {
                choice = lecture();
                choice.width = tables::Width::literal;
            } else if (auto done = set(choice, word, use); !done) {
                return tl::unexpected(done.error());
            }
        }
    return choice;
}

}  // namespace facet::brdf
