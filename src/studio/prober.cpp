// Keeps the inspection true of what is shown.
// SPDX-License-Identifier: MIT
#include "studio/prober.h"

#include "render/job.h"
#include "render/plan.h"

#include <utility>

namespace facet::studio {
namespace {

/// Or the light whose shape has it.
void select_material(const Stage& stage, std::size_t material, Editor& editor) {
    const scene::Scene& scene = stage.scene();
    if (material < stage.materials().size()) {
        editor.material = material;
        return;
    }
    for (const scene::Instance& instance : scene.instances)
        if (instance.light && scene.meshes[instance.mesh.index].material.index == material)
            editor.light = *instance.light;
}

void pick(Stage& stage, Editor& editor, math::Vec2 at_px) {
    const auto probed = stage.probe(at_px);
    if (!probed) return editor.complain(probed.error());
    for (const Probed& value : *probed)
        if (value.aov == tables::Aov::material_id && value.value.x > 0.0F)
            select_material(stage, static_cast<std::size_t>(value.value.x) - 1, editor);
}

}  // namespace

void Prober::look_at_picture(const gl::Context& gl, const Stage& stage, Editor& editor,
                             UiRenderer& pictures, Inspection& inspection) {
    if (!stage.is_finished() || stage.shown_count() == seen_count_) return;
    seen_count_ = stage.shown_count();
    inspection.histogram = histogram(stage.shown());
    if (auto s = pictures.upload(gl, Slot::overlay, clipping_overlay(stage.shown())); !s)
        editor.complain(s.error());
    probed_px_.reset();
}

void Prober::update(const gl::Context& gl, Stage& stage, Editor& editor, UiRenderer& pictures,
                    Inspection& inspection) {
    look_at_picture(gl, stage, editor, pictures, inspection);
    if (const auto at_px = std::exchange(editor.wanted.pick_px, std::nullopt))
        pick(stage, editor, *at_px);
    const auto at_px = std::exchange(editor.wanted.probe_px, std::nullopt);
    if (!at_px || !stage.is_finished() || probed_px_ == at_px) return;
    probed_px_ = at_px;
    auto probed = stage.probe(*at_px);
    if (!probed) return editor.complain(probed.error());
    const math::Vec3 eye_m(stage.job().camera.world_from_view[3]);
    inspection.pixel = facts_of(*at_px, std::move(*probed), eye_m, stage.plan().brdf);
}

}  // namespace facet::studio
