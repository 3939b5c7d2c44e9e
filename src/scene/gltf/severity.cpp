// What `load` makes of the validator's verdicts.
// SPDX-License-Identifier: MIT
#include "scene/gltf/severity.h"

#include <algorithm>
#include <array>
#include <string_view>

namespace facet::scene::gltf {
namespace {

/// Errors of the specification that leave the picture whole: what they concern is recomputed,
/// clamped, skipped or ignored.
constexpr auto harmless = std::to_array<std::string_view>(
    {"MESH_PRIMITIVE_POSITION_ACCESSOR_WITHOUT_BOUNDS",  // bounds are recomputed
     "ACCESSOR_MIN_MISMATCH",
     "ACCESSOR_MAX_MISMATCH",
     "ACCESSOR_NON_CLAMPED",
     "ROTATION_NON_UNIT",  // scaled to 1
     "UNDECLARED_EXTENSION",
     "UNEXPECTED_EXTENSION_OBJECT",
     "UNUSED_EXTENSION_REQUIRED",
     "NON_REQUIRED_EXTENSION",
     "DUPLICATE_ELEMENTS_IGNORED",  // indices twice; child twice is NODE_PARENT_OVERRIDE
     "BUFFER_VIEW_TARGET_OVERRIDE",
     "BUFFER_DATA_URI_MIME_TYPE_INVALID",
     "MESH_PRIMITIVE_NO_TANGENT_SPACE",
     "MESH_PRIMITIVE_TOO_FEW_TEXCOORDS",
     "MESH_PRIMITIVE_INVALID_ATTRIBUTE",
     "MESH_PRIMITIVE_INDEXED_SEMANTIC_CONTINUITY",
     "MESH_PRIMITIVE_MORPH_TARGET_NO_BASE_ACCESSOR",
     "NODE_WEIGHTS_INVALID_IGNORED",
     "NODE_SKIN_WITH_NON_SKINNED_MESH",
     "SKIN_NO_COMMON_ROOT",
     "NODE_SKIN_NO_SCENE",
     "SKIN_SKELETON_INVALID",
     "IMAGE_MIME_TYPE_INVALID",
     "IMAGE_NON_ENABLED_MIME_TYPE",
     "TEXTURE_INVALID_IMAGE_MIME_TYPE",
     "KHR_MATERIALS_VARIANTS_NON_UNIQUE_VARIANT",
     "NODE_MATRIX_NON_TRS",
     "INVALID_EXTENSION_NAME_FORMAT"});

/// Warnings of the validator that the user of a renderer wants to hear of too.
constexpr auto audible = std::to_array<std::string_view>(
    {"GLB_EXTRA_DATA", "GLB_UNKNOWN_CHUNK_TYPE", "BUFFER_GLB_CHUNK_TOO_BIG",
     "UNKNOWN_ASSET_MINOR_VERSION", "CAMERA_YFOV_GEQUAL_PI", "NODE_SKINNED_MESH_WITHOUT_SKIN",
     "BUFFER_VIEW_COMPRESSION_FALLBACK", "MESH_PRIMITIVE_COMPRESSION_FALLBACK",
     // What a material says and a picture cannot show.
     "MULTIPLE_EXTENSIONS", "KHR_MATERIALS_VOLUME_NO_TRANSMISSION",
     "KHR_MATERIALS_DISPERSION_NO_VOLUME", "KHR_MATERIALS_EMISSIVE_STRENGTH_ZERO_FACTOR",
     "MATERIAL_ALPHA_CUTOFF_INVALID_MODE"});

/// Fine for the validator, not for a renderer that keeps off the network, knows 2.0 only and has
/// to decode what it draws.
constexpr auto refused = std::to_array<std::string_view>(
    {"NON_RELATIVE_URI", "UNKNOWN_ASSET_MIN_VERSION", "BUFFER_VIEW_COMPRESSION_UNSUPPORTED",
     "MESH_PRIMITIVE_COMPRESSION_UNSUPPORTED"});

template <class Table>
bool has(const Table& table, std::string_view code) {
    return std::find(table.begin(), table.end(), code) != table.end();
}

/// What is wrong in an animation matters where it is asked for alone; then its fault says it.
bool is_of_animation(const Problem& problem) {
    return problem.pointer.starts_with("/animations/") || problem.code.starts_with("ANIMATION_") ||
           problem.code.starts_with("KHR_ANIMATION_");
}

/// Factors outside their range are clamped; lights and cameras are not, as no nearest right value
/// is meant.
bool is_clamped(const Problem& problem) {
    return problem.code == "VALUE_NOT_IN_RANGE" && problem.pointer.starts_with("/materials/");
}

/// Empty arrays and objects say nothing, except where something must be there.
bool is_harmless_emptiness(const Problem& problem) {
    return problem.code == "EMPTY_ENTITY" && !problem.pointer.ends_with("/joints") &&
           !problem.pointer.ends_with("/primitives");
}

}  // namespace

Verdict verdict_of(const Problem& problem) {
    if (problem.severity == Severity::error) {
        const bool is_limit = problem.error == base::ErrorCode::limit_reached;
        if (is_limit) return Verdict::error;
        const bool is_downgraded = has(harmless, problem.code) || is_of_animation(problem) ||
                                   is_clamped(problem) || is_harmless_emptiness(problem);
        return is_downgraded ? Verdict::warning : Verdict::error;
    }
    if (has(refused, problem.code)) return Verdict::error;
    if (problem.code == "VALUE_NOT_IN_LIST" && !is_of_animation(problem)) {
        const bool is_light = problem.pointer.starts_with("/extensions/KHR_lights_punctual");
        return is_light ? Verdict::silent : Verdict::error;
    }
    return has(audible, problem.code) ? Verdict::warning : Verdict::silent;
}

}  // namespace facet::scene::gltf
