// The canvas of a page.
// SPDX-License-Identifier: MIT
#include "teach/live.h"

#include "base/resources.h"
#include "brdf/choice.h"
#include "brdf/glsl_text.h"
#include "gl/shader.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>

namespace facet::teach {
namespace {

Json words(const base::Texts& texts) {
    Json out = Json::object();
    for (const char* key : {"ball", "no_webgl", "light", "furnace", "lit_by"})
        out[key] = texts(fmt::format("teach.live_{}", key));
    for (const char* key : {"n_dot_v", "n_dot_l", "n_dot_h", "v_dot_h", "specular", "diffuse",
                            "full", "reflected", "transmitted"})
        out[key] = texts(fmt::format("teach.word_{}", key));
    for (const tables::BrdfSlot& slot : tables::brdf_slots)
        out[fmt::format("slot_{}", slot.key)] = texts(fmt::format("teach.slot_{}", slot.key));
    return out;
}

/// A slot's values: those that lessons have too.
Json switch_of(const tables::BrdfSlot& slot) {
    Json values = Json::array();
    for (const tables::BrdfTerm& term : tables::brdf_terms) {
        if (term.slot != slot.key) continue;
        std::string name(term.name);
        std::ranges::replace(name, '_', '-');
        values.push_back({{"name", name}, {"help", term.notes.help}});
    }
    return {{"slot", slot.key}, {"values", values}};
}

base::Result<Json> model_of(const std::string& text, const base::Texts& texts) {
    const auto choice = brdf::parse_choice(text, brdf::Use::lesson);
    if (!choice) return tl::unexpected(choice.error());
    Json chosen = Json::object();
    for (const tables::BrdfSlot& slot : tables::brdf_slots)
        chosen[std::string(slot.key)] = slot.index(*choice);
    return Json{{"brdf", text},
                {"name", text.empty() ? texts("teach.model_default") : text},
                // The lecture masks the environment in a way of its own.
                {"environment_masking", static_cast<int>(choice->environment_masking)},
                {"chosen", chosen}};
}

Json sliders_of(const Live& live, const base::Texts& texts) {
    Json out = Json::array();
    for (const LiveSlider& slider : live_sliders()) {
        const std::string name(slider.name);
        const bool is_shown = std::ranges::find(live.sliders, name) != live.sliders.end();
        out.push_back({{"name", name},
                       {"label", texts("teach.slider_" + name)},
                       {"low", slider.low},
                       {"high", slider.high},
                       {"step", slider.step},
                       {"value", live.initial.value(name, slider.initial)},
                       {"shown", is_shown}});
    }
    return out;
}

}  // namespace

base::Result<Json> live_config(const Live& live, const base::Texts& texts) {
    const auto folder = base::data_folder();
    if (!folder) return tl::unexpected(folder.error());
    const auto brdf_text = brdf::glsl_text_of_all();
    if (!brdf_text) return tl::unexpected(brdf_text.error());
    Json out{{"shaders", Json::object()}, {"switches", Json::array()}, {"models", Json::array()}};
    // The model's text is in the page once; live.js puts it where the others have the mark.
    const gl::ShaderSources whole{*folder / "glsl", {{"generated/brdf.glsl", *brdf_text}}};
    const gl::ShaderSources marked{*folder / "glsl", {{"generated/brdf.glsl", "//@brdf"}}};
    for (const char* file : {"generated/brdf.glsl", "frame/full_screen.vert", "teach/albedo.frag",
                             "teach/average.frag", "teach/canvas.frag", "teach/probe.frag"}) {
        const bool is_model = std::string_view(file).starts_with("generated");
        auto text = gl::assemble(is_model ? whole : marked, file, "");
        if (!text) return tl::unexpected(text.error());
        std::string_view body = text->text;
        // Desktop GLSL's first line gives way to the browser's.
        if (body.starts_with("#version")) body.remove_prefix(body.find('\n') + 1);
        out["shaders"][file] = body;
    }
    for (const tables::BrdfSlot& slot : tables::brdf_slots)
        if (std::ranges::find(live.switches, slot.key) != live.switches.end())
            out["switches"].push_back(switch_of(slot));
    std::vector<std::string> models = live.models;
    if (models.empty()) models.emplace_back();
    for (const std::string& text : models) {
        auto model = model_of(text, texts);
        if (!model) return tl::unexpected(model.error());
        out["models"].push_back(std::move(*model));
    }
    out["sliders"] = sliders_of(live, texts);
    out["views"] = Json::array();
    for (std::size_t i = 0; i < live_views().size(); ++i) {
        const std::string name(live_views()[i]);
        if (live.views.empty() ? i == 0 : std::ranges::find(live.views, name) != live.views.end())
            out["views"].push_back(
                {{"index", i}, {"name", name}, {"label", texts("teach.show_" + name)}});
    }
    for (std::size_t i = 0; i < live_curves().size(); ++i)
        if (live_curves()[i] == live.curve)
            out["curve"] = {{"index", i},
                            {"label", texts(fmt::format("teach.curve_{}", live.curve))}};
    out["furnace"] = live.furnace;
    out["words"] = words(texts);
    return out;
}

}  // namespace facet::teach
