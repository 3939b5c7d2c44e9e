// The glTF importer: read, check, parse, convert.
// SPDX-License-Identifier: MIT
#include "scene/gltf/gltf.h"

#include "base/text.h"
#include "scene/gltf/check.h"
#include "scene/gltf/extensions.h"
#include "scene/gltf/import.h"
#include "scene/gltf/severity.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <set>
#include <string_view>

namespace facet::scene::gltf {
namespace {

/// The first problem that a picture would suffer from, the rest as warnings.
base::Status judge(const Problems& problems, base::Warnings& warnings) {
    for (const Problem& problem : problems.all()) {
        const Verdict verdict = verdict_of(problem);
        if (verdict == Verdict::error) return base::fail(to_error(problem));
        if (verdict == Verdict::warning) warnings.push_back(to_warning(problem));
    }
    return {};
}

std::vector<std::string> names_of(const Json& json, std::string_view path, std::string_view word) {
    std::vector<std::string> names;
    const Json* const items = find_path(json, path);
    if (items == nullptr || !items->is_array()) return names;
    for (const Json& item : *items) {
        const std::string name = string_at(item, "name");
        names.push_back(name.empty() ? fmt::format("{} {}", word, names.size()) : name);
    }
    return names;
}

void list_names(const Json& json, Scene& scene) {
    if (const Json* const used = find(json, "extensionsUsed"); used != nullptr && used->is_array())
        for (const Json& name : *used)
            if (name.is_string()) scene.extensions_used.push_back(name.get<std::string>());
    scene.animations = names_of(json, "animations", "animation");
    scene.variants = names_of(json, "extensions/KHR_materials_variants/variants", "variant");
}

/// --variant finds the first of a name.
void warn_of_names(const Scene& scene, base::Warnings& warnings) {
    std::set<std::string_view> seen;
    for (std::size_t i = 0; i < scene.variants.size(); ++i)
        if (!seen.insert(scene.variants[i]).second && warnings.size() < 100)
            warnings.push_back(
                {.file = {},
                 .where = fmt::format("/extensions/KHR_materials_variants/variants/{}/name", i),
                 .what = "variant cannot be chosen: another before it has its name",
                 .found = scene.variants[i],
                 .remedy = {}});
}

/// The index of the variant asked for. Errors: usage (no such name).
base::Result<std::optional<std::size_t>> variant_of(const LoadOptions& options,
                                                    const Scene& scene) {
    if (options.variant.empty()) return std::nullopt;
    const auto found = std::find(scene.variants.begin(), scene.variants.end(), options.variant);
    if (found != scene.variants.end())
        return static_cast<std::size_t>(found - scene.variants.begin());
    return base::fail({.code = base::ErrorCode::usage,
                       .what = "the file has no such variant",
                       .found = options.variant,
                       .remedy = scene.variants.empty()
                                     ? "it has none"
                                     : "one of " + base::join(scene.variants, ", ")});
}

base::Result<Loaded> convert(Asset& asset, const LoadOptions& options, const base::Limits& limits,
                             base::ThreadPool& pool) {
    Loaded loaded;
    if (auto known = check_implemented(asset.json, options, loaded.warnings); !known)
        return tl::unexpected(known.error());
    Problems problems;
    check_asset(asset, Depth::structure, limits, problems);
    if (auto judged = judge(problems, loaded.warnings); !judged)
        return tl::unexpected(judged.error());
    const auto model = parse_model(asset.json);
    if (!model) return tl::unexpected(model.error());
    Import import{.asset = asset,
                  .model = *model,
                  .options = options,
                  .limits = limits,
                  .pool = pool,
                  .scene = loaded.scene,
                  .warnings = loaded.warnings,
                  .image_sources = {},
                  .images_by_key = {},
                  .variant = {},
                  .default_material = {},
                  .reduced_materials = {}};
    list_names(asset.json, loaded.scene);
    warn_of_names(loaded.scene, loaded.warnings);
    const auto variant = variant_of(options, loaded.scene);
    if (!variant) return tl::unexpected(variant.error());
    import.variant = *variant;
    convert_materials(import);
    auto rig = std::make_shared<Rig>();
    rig->clips = read_clips(import, problems);
    import.has_clips = !rig->clips.empty();
    if (auto converted = convert_nodes(import, *rig); !converted)
        return tl::unexpected(converted.error());
    if (import.has_clips) loaded.scene.rig = std::move(rig);
    if (auto images = load_images(import); !images) return tl::unexpected(images.error());
    if (options.decode_images) drop_missing_normal_maps(loaded.scene);
    loaded.reads = std::move(asset.reads);
    return loaded;
}

}  // namespace

base::Result<Loaded> import_bytes(base::Bytes file, Origin origin, const LoadOptions& options,
                                  const base::Limits& limits, base::ThreadPool& pool) {
    const std::string label = origin.label;
    const auto in_file = [&](base::Error error) {
        return base::fail(base::in_file(std::move(error), label));
    };
    Problems problems;
    base::Warnings warnings;
    std::optional<Asset> asset = open_asset(std::move(file), std::move(origin), limits, problems);
    if (auto judged = judge(problems, warnings); !judged) return in_file(judged.error());
    if (!asset) return in_file({.code = base::ErrorCode::input_invalid, .what = "not a glTF file"});
    auto loaded = convert(*asset, options, limits, pool);
    if (!loaded) return in_file(loaded.error());
    loaded->warnings.insert(loaded->warnings.begin(), warnings.begin(), warnings.end());
    for (base::Warning& warning : loaded->warnings)
        if (warning.file.empty()) warning.file = label;
    return loaded;
}

std::vector<Finding> check_bytes(base::Bytes file, Origin origin, const base::Limits& limits) {
    Problems problems;
    std::optional<Asset> asset = open_asset(std::move(file), std::move(origin), limits, problems);
    if (asset) check_asset(*asset, Depth::elements, limits, problems);
    std::vector<Finding> findings;
    for (const Problem& problem : problems.all()) findings.push_back(to_finding(problem));
    return findings;
}

}  // namespace facet::scene::gltf
