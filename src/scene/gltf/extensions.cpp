// The glTF extensions this renderer knows.
// SPDX-License-Identifier: MIT
#include "scene/gltf/extensions.h"

#include "tables/gltf_features.h"

#include <algorithm>

namespace facet::scene::gltf {
namespace {

/// Another form of what the file has in plain form as well, unless it is required.
bool has_fallback(std::string_view extension) {
    return extension.ends_with("_compression") || extension == "KHR_texture_basisu" ||
           extension == "EXT_texture_avif" || extension == "MSFT_texture_dds";
}

/// What a build needs for an extension that it lacks only a library for; empty for others.
std::string_view package_of(const tables::GltfFeature* feature) {
    if (feature == nullptr || feature->codec == tables::Codec::none) return {};
    return feature->codec == tables::Codec::meshopt ? "libmeshoptimizer-dev (FACET_MESHOPT=ON)"
                                                    : "libdraco-dev (FACET_DRACO=ON)";
}

base::Error missing(const std::string& name) {
    const std::string_view package = package_of(tables::gltf_feature(name));
    const std::string ignore = "--ignore-required " + name + " to render it all the same";
    return {.code = base::ErrorCode::feature_missing,
            .where = "/extensionsRequired",
            .what = "required extension is not supported",
            .found = name + ", without it the picture lacks " + std::string(loss_without(name)),
            .remedy =
                package.empty() ? ignore : "build with " + std::string(package) + ", or " + ignore};
}

}  // namespace

bool is_implemented(std::string_view extension) {
    const tables::GltfFeature* const feature = tables::gltf_feature(extension);
    return feature != nullptr && feature->loaded == tables::Support::yes;
}

std::string_view loss_without(std::string_view extension) {
    const tables::GltfFeature* const feature = tables::gltf_feature(extension);
    return feature != nullptr && !feature->loss.empty() ? feature->loss : "what it describes";
}

base::Status check_implemented(const Json& json, const LoadOptions& options,
                               base::Warnings& warnings) {
    const auto& ignored = options.ignored_required;
    for (std::size_t i = 0; i < count_at(json, "extensionsRequired"); ++i) {
        const Json& name = *element_at(json, "extensionsRequired", i);
        if (!name.is_string() || is_implemented(name.get<std::string>())) continue;
        const bool is_ignored =
            std::find(ignored.begin(), ignored.end(), name.get<std::string>()) != ignored.end();
        if (!is_ignored) return base::fail(missing(name.get<std::string>()));
    }
    for (std::size_t i = 0; i < count_at(json, "extensionsUsed"); ++i) {
        const Json& name = *element_at(json, "extensionsUsed", i);
        if (!name.is_string() || is_implemented(name.get<std::string>())) continue;
        constexpr std::size_t most = 100;
        if (warnings.size() >= most) break;
        const std::string text = name.get<std::string>();
        warnings.push_back(
            {.file = {},
             .where = "/extensionsUsed",
             .what = "extension is not supported",
             .found = has_fallback(text)
                          ? text + ", the plain data beside it is shown"
                          : text + ", the picture lacks " + std::string(loss_without(text)),
             .remedy = {}});
    }
    return {};
}

}  // namespace facet::scene::gltf
