// Image-based light as GL textures.
// SPDX-License-Identifier: MIT
#pragma once

#include "base/result.h"
#include "base/thread_pool.h"
#include "frame/environment/cube_mip.h"
#include "gl/objects.h"
#include "scene/environment.h"
#include "scene/scene.h"

#include <filesystem>
#include <optional>
#include <span>
#include <vector>

namespace facet::frame {

struct EnvironmentMaps {
    gl::Texture radiance_cube;        ///< RGBA16F, prefiltered
    gl::Texture irradiance_cube;      ///< RGBA16F, over pi
    std::optional<scene::Light> sun;  ///< that is not in them
    /// Of the scene around a probe.
    struct Box {
        math::Vec3 low_m, high_m, place_m;
    };
    std::optional<Box> box;    ///< what they show stands on its sides, seen from a place in it
    gl::Texture albedo_table;  ///< RGBA32F, brdf/albedo.h
    gl::Sampler cube_sampler;
    gl::Sampler table_sampler;
    float last_level = 0.0F;
    float unit_nit = 1.0F;      ///< what 1 in the cube is
    std::vector<CubeMip> kept;  ///< BakedEnvironment's
    bool is_black = false;      ///< nothing to light with: its code is left out
};

/// Radiance in nit that a surface of that roughness would mirror from a unit direction, from the
/// nearest level on the CPU.
[[nodiscard]] math::Vec3 prefiltered(const EnvironmentMaps& maps, const math::Vec3& direction,
                                     float roughness);

struct EnvironmentSettings {
    float rotation_deg = 0.0F;
    float intensity = 1.0F;
    std::filesystem::path cache_folder{};  ///< where what is baked is kept; empty: nowhere
};

/// Bakes and uploads. `table`: RGBA f32 [size, size, 4].
[[nodiscard]] base::Result<EnvironmentMaps> upload_environment(
    const gl::Context& gl, const scene::Environment& environment,
    const EnvironmentSettings& settings, std::span<const float> table, std::uint32_t table_size,
    base::ThreadPool& pool, base::Warnings& warnings);

}  // namespace facet::frame
