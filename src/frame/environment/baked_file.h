// Baked environments that are kept in files, from one run of the program to the next.
// SPDX-License-Identifier: MIT
#pragma once

#include "base/file.h"
#include "base/result.h"
#include "base/thread_pool.h"
#include "frame/environment/bake.h"
#include "frame/environment/environment_maps.h"

#include <cstddef>
#include <optional>
#include <span>
#include <string>

namespace facet::frame {

/// bake_environment(), or from `settings.cache_folder` what it gave before: the same bytes. Adds
/// warn_of(), and a warning where the folder cannot be used.
[[nodiscard]] BakedEnvironment baked_environment(const image::Image& latlong,
                                                 const EnvironmentSettings& settings,
                                                 base::ThreadPool& pool, base::Warnings& warnings);

/// SHA-256 of all that a bake hangs on: the picture, how it is turned, this build of the program,
/// and what chooses between the variants of libm's functions. Empty where the build has no id.
[[nodiscard]] std::string bake_key(const image::Image& latlong, float rotation_deg, float intensity,
                                   base::ThreadPool& pool);

/// As bytes of this machine; baked_from() gives the same again.
[[nodiscard]] base::Bytes bytes_of(const BakedEnvironment& baked);
/// None where sizes do not fit together.
[[nodiscard]] std::optional<BakedEnvironment> baked_from(std::span<const std::byte> bytes);

}  // namespace facet::frame
