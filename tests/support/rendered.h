// Pictures that a test renders from the outside.
// SPDX-License-Identifier: MIT
#pragma once

#include "render/render.h"

#include <gtest/gtest.h>

#include <optional>
#include <string>
#include <utility>

namespace facet::test {

/// A small picture on nothing, at a fixed exposure: what an error against the reference is taken
/// of.
inline render::Request small_request(std::string scene, std::string env) {
    render::Request request{.scene = std::move(scene)};
    tables::Settings& s = request.settings;
    s.size = {80, 60};
    s.env = std::move(env);
    s.background = "none";
    s.tonemap = "none";
    s.exposure = "0.5";
    return request;
}

/// Nothing, and a failure of the test, where it is not drawn.
inline std::optional<render::Rendered> rendered(const render::Request& request) {
    base::Log log;
    auto out = render::render(request, log);
    if (out) return std::move(*out);
    ADD_FAILURE() << base::to_line(out.error());
    return std::nullopt;
}

/// Radiance of a picture, f32 [height, width, 4].
inline image::Image radiance_of(render::Request request) {
    request.want_linear = true;
    auto out = rendered(request);
    if (!out) return {request.settings.size, 4, image::Sample::f32};
    return std::move(out->layers.front().image);
}

/// RMSE against the reference of a request that compares; 1 where it is not drawn.
inline double rmse_to_reference(const render::Request& request) {
    const auto picture = rendered(request);
    return picture ? picture->compared->rmse : 1.0;
}

/// What a picture is lit by: `light` may be empty.
struct Lit {
    const char* light;
    const char* env;
};
inline constexpr Lit every_light[] = {
    {"", "studio"},
    {"directional:azimuth=40,elevation=50,lux=3", "black"},
    {"rect:position=1.6 2.6 2.2,target=0 0.5 0,nit=60,width=1,height=0.5", "black"}};

}  // namespace facet::test
