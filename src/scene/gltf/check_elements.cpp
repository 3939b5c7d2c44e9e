// Checks of the numbers in the buffers: what accessors claim, and what their use asks.
// SPDX-License-Identifier: MIT
#include "scene/gltf/check.h"
#include "scene/gltf/element_uses.h"
#include "scene/gltf/elements.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace facet::scene::gltf {
namespace {

void check_floats(const Accessor& accessor, const std::vector<double>& values,
                  const std::string& where, Problems& problems) {
    if (accessor.component != Component::f32) return;
    std::size_t told = 0;
    for (std::size_t i = 0; i < values.size() && told < 3; ++i)
        if (!std::isfinite(values[i])) {
            problems.error("ACCESSOR_INVALID_FLOAT", where, "number is NaN or infinite",
                           fmt::format("{} at {}", values[i], i));
            ++told;
        }
}

/// One bound of one component.
struct Bound {
    const char* key;  ///< "min" or "max"
    double declared;
    double actual;
    std::size_t beyond;  ///< elements outside
};

void report(const Bound& bound, std::size_t component, const std::string& where,
            Problems& problems) {
    const bool is_min = bound.key[1] == 'i';
    const std::string at = fmt::format("{}/{}/{}", where, bound.key, component);
    if (bound.declared != bound.actual)
        problems.error(is_min ? "ACCESSOR_MIN_MISMATCH" : "ACCESSOR_MAX_MISMATCH", at,
                       "bound is not that of the data",
                       fmt::format("{}, but it is {}", bound.declared, bound.actual));
    if (bound.beyond > 0)
        problems.error(
            is_min ? "ACCESSOR_ELEMENT_OUT_OF_MIN_BOUND" : "ACCESSOR_ELEMENT_OUT_OF_MAX_BOUND", at,
            "elements beyond the bound", fmt::format("{} of them", bound.beyond));
}

std::optional<double> declared_at(const Json& json, const char* key, std::size_t component,
                                  const Accessor& accessor) {
    const Json* const value = element_at(json, key, component);
    if (value == nullptr || !value->is_number() || count_at(json, key) != accessor.components)
        return std::nullopt;
    const double number = value->get<double>();
    // JSON has more digits than the data can hold.
    return accessor.component == Component::f32 ? static_cast<double>(static_cast<float>(number))
                                                : number;
}

void check_bounds(const Json& json, const Accessor& accessor, const std::vector<double>& values,
                  const std::string& where, Problems& problems) {
    for (std::size_t c = 0; c < accessor.components; ++c) {
        const auto low = declared_at(json, "min", c, accessor);
        const auto high = declared_at(json, "max", c, accessor);
        if (!low && !high) continue;
        Bound min{"min", low.value_or(0), std::numeric_limits<double>::infinity(), 0};
        Bound max{"max", high.value_or(0), -std::numeric_limits<double>::infinity(), 0};
        for (std::size_t i = c; i < values.size(); i += accessor.components) {
            min.actual = std::min(min.actual, values[i]);
            max.actual = std::max(max.actual, values[i]);
            min.beyond += values[i] < min.declared ? 1 : 0;
            max.beyond += values[i] > max.declared ? 1 : 0;
        }
        if (low) report(min, c, where, problems);
        if (high) report(max, c, where, problems);
    }
}

}  // namespace

void check_elements(const Asset& asset, Problems& problems) {
    for (std::size_t i = 0; i < asset.accessors.size(); ++i) {
        const Accessor& accessor = asset.accessors[i];
        if (!accessor.is_sound || !has_data(accessor)) continue;
        const std::string where = pointer_text("accessors", i);
        const std::vector<double> values = read_raw(accessor);
        const std::size_t before = problems.error_count();
        check_floats(accessor, values, where, problems);
        // Bounds may be those of what was encoded (KHR_meshopt_compression, "Compression modes and
        // filters").
        if (problems.error_count() == before && !accessor.is_lossy)
            check_bounds(*element_at(asset.json, "accessors", i), accessor, values, where,
                         problems);
    }
    check_primitive_elements(asset, problems);
    check_bind_matrices(asset, problems);
    check_keyframes(asset, problems);
}

}  // namespace facet::scene::gltf
