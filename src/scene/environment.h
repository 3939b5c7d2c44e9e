// Environments: the light that comes from infinitely far away, as a lat-long picture; read or
// computed. SPDX-License-Identifier: MIT
#pragma once

#include "base/limits.h"
#include "base/result.h"
#include "base/thread_pool.h"
#include "image/image.h"

#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>

namespace facet::scene {

/// Radiance in nit by direction. `latlong` is f32 [height, width, 3], linear Rec.709. The middle
/// column is the direction -z and columns to its right turn towards +x; row 0 is +y (contract,
/// "Conventions").
struct Environment {
    std::string name;
    std::shared_ptr<const image::Image> latlong;
};

/// The file that `spec` names; none for a computed environment. Errors: usage (unknown name, with
/// the nearest right ones).
[[nodiscard]] base::Result<std::optional<std::filesystem::path>> environment_file(
    const std::string& spec);

/// `spec`: a name of tables/environments.def, with parameters for some
/// (`sky:sun_elevation=30,turbidity=3`), or the path of a lat-long .hdr or .exr. Errors: usage
/// (unknown name or key, with the nearest right ones), those of the image reader.
[[nodiscard]] base::Result<Environment> load_environment(const std::string& spec,
                                                         const base::Limits& limits,
                                                         base::ThreadPool& pool,
                                                         base::Warnings& warnings);

}  // namespace facet::scene
