// A frame's questions about rays, answered by the reference's ray tracer.
// SPDX-License-Identifier: MIT
#pragma once

#include "base/thread_pool.h"
#include "frame/rays/rays.h"
#include "frame/upload/gpu_scene.h"
#include "render/plan.h"
#include "trace/trace.h"

#include <atomic>

namespace facet::render {

/// What there is to ask about. Everything outlives those who ask.
struct RayScene {
    const trace::Tracer& tracer;
    const frame::GpuScene& draws;
    const frame::PackedLights& lights;
};

class TracedRays final : public frame::Rays {
public:
    /// `frames`: how many samples a pixel gets.
    TracedRays(const RayScene& scene, const tables::RayBudget& plan, std::uint32_t frames,
               std::uint32_t seed, base::ThreadPool& pool)
        : scene_(scene), plan_(plan), frames_(frames), seed_(seed), pool_(pool) {}
    /// Makes indirect() return early, with nothing of use.
    void cancel() { cancelled_ = true; }

    void look_at(const frame::ReadSurfaces& surfaces) override;
    [[nodiscard]] frame::IndirectLight indirect(const frame::EnvironmentMaps& environment) override;
    [[nodiscard]] bool has_indirect() const override { return plan_.samples > 0; }
    [[nodiscard]] bool has_sample_light() const override {
        return plan_.mirrored_alpha > 0.0F || plan_.intricate > 0 || scene_.draws.is_translucent;
    }
    [[nodiscard]] frame::SampleLight sample_light(std::uint32_t frame) override;
    [[nodiscard]] bool has_shadows() const override { return plan_.shadows; }
    [[nodiscard]] std::vector<std::uint8_t> visibility(const frame::TileLights& lights,
                                                       std::size_t slots,
                                                       std::uint32_t frame) override;

private:
    [[nodiscard]] trace::GatherSettings settings() const;

    RayScene scene_;
    tables::RayBudget plan_;
    std::uint32_t frames_;
    std::uint32_t seed_;
    base::ThreadPool& pool_;
    std::atomic<bool> cancelled_ = false;
    trace::Seen seen_;
    trace::IndirectPixels indirect_;
    trace::GroundPixels ground_;
    trace::SampleLight sample_light_;
};

}  // namespace facet::render
