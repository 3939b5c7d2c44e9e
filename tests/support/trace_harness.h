// Traces a scene value and gives its radiance.
// SPDX-License-Identifier: MIT
#pragma once

#include "support/shapes.h"
#include "trace/trace.h"

#include <gtest/gtest.h>

namespace facet::test {

/// One picture to trace.
struct TraceShot {
    scene::Scene scene;
    std::shared_ptr<const image::Image> latlong = constant_environment(math::Vec3(0.0F));
    scene::Camera camera = camera_on_z(4.0F, 1.0F);
    tables::BrdfChoice brdf{};
    bool shows_environment = false;
    trace::TraceSettings settings{.picture = {64, 64}, .size = {64, 64}, .samples = 16};
    unsigned threads = 0;
};

inline trace::Traced traced(const TraceShot& shot) {
    base::ThreadPool pool(shot.threads);
    const scene::Environment environment{"test", shot.latlong};
    const auto tracer = trace::Tracer::create({.scene = shot.scene,
                                               .environment = environment,
                                               .camera = shot.camera,
                                               .shows_environment = shot.shows_environment,
                                               .brdf = shot.brdf},
                                              {}, pool);
    if (!tracer) {
        ADD_FAILURE() << base::to_line(tracer.error());
        return {.radiance = image::Image(shot.settings.size, 4, image::Sample::f32)};
    }
    return tracer->trace(shot.settings, pool);
}

inline math::Vec4 pixel(const image::Image& picture, std::uint32_t x, std::uint32_t y) {
    const auto v = picture.as<float>();
    const std::size_t i = (std::size_t{y} * picture.size.width + x) * 4;
    return {v[i], v[i + 1], v[i + 2], v[i + 3]};
}

/// Mean over the whole picture.
inline math::Vec4 mean(const image::Image& picture) {
    double sum[4] = {};
    const auto values = picture.as<float>();
    for (std::size_t i = 0; i < values.size(); ++i) sum[i % 4] += static_cast<double>(values[i]);
    const auto count = static_cast<double>(picture.size.pixels());
    return {sum[0] / count, sum[1] / count, sum[2] / count, sum[3] / count};
}

}  // namespace facet::test
