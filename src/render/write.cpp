// A picture into its file, and the AOVs into or beside it.
// SPDX-License-Identifier: MIT
#include "image/write.h"

#include "base/file.h"
#include "base/text.h"
#include "render/render.h"
#include "render/viewable.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <chrono>

namespace facet::render {
namespace {

namespace fs = std::filesystem;
using tables::ImageFormat;

base::Result<ImageFormat> format_by_ending(const fs::path& output) {
    std::string ending = output.extension().string();
    std::transform(ending.begin(), ending.end(), ending.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    std::vector<std::string> known;
    for (std::size_t i = 0; i < tables::image_formats.size(); ++i)
        for (const std::string_view name : base::split(tables::image_formats[i].endings, ',')) {
            known.push_back(fmt::format(".{}", name));
            if (ending == known.back()) return static_cast<ImageFormat>(i);
        }
    return base::fail({.code = base::ErrorCode::usage,
                       .file = output.string(),
                       .what = "no such picture format",
                       .found = ending,
                       .remedy = "one of " + base::join(known, " ")});
}

base::Result<image::Depth> depth_for(const tables::ImageFormatRow& row, const std::string& asked) {
    const auto allowed = base::split(row.depths, ',');
    std::string_view name = asked;
    // EXR holds float unless half is asked for; the others take their first depth.
    if (asked.empty()) name = row.layers ? "float" : allowed.front();
    if (std::find(allowed.begin(), allowed.end(), name) == allowed.end())
        return base::fail({.code = base::ErrorCode::usage,
                           .file = "--depth",
                           .what = fmt::format("{} has no such depth", row.key),
                           .found = asked,
                           .remedy = fmt::format("one of {}", row.depths)});
    if (name == "8") return image::Depth::u8;
    if (name == "16") return image::Depth::u16;
    return name == "half" ? image::Depth::half : image::Depth::f32;
}

base::Status write_side_files(const fs::path& output, const Rendered& rendered) {
    for (const image::Layer& layer : rendered.layers) {
        const auto aov = tables::aov_named(layer.name);
        if (!aov) continue;
        fs::path side = output;
        side.replace_extension("." + layer.name + ".png");
        const auto bytes = image::encode(viewable(*aov, layer, rendered.exposure),
                                         {.format = ImageFormat::png, .fast = true});
        if (!bytes) return tl::unexpected(bytes.error());
        if (auto written = base::write_file_atomically(side, *bytes); !written) return written;
    }
    return {};
}

/// What can be known only after loading: --strict, and an output that is one of the files read
/// (faults, F3).
base::Status check_result(const Request& request, const fs::path& output,
                          const Rendered& rendered) {
    if (request.settings.strict && !rendered.warnings.empty()) {
        const base::Warning& w = rendered.warnings.front();
        return base::fail({.code = base::ErrorCode::input_invalid,
                           .file = w.file,
                           .where = w.where,
                           .what = w.what,
                           .found = w.found,
                           .remedy = "--strict makes this warning an error"});
    }
    std::error_code error;
    for (const fs::path& read : rendered.reads)
        if (fs::equivalent(read, output, error))
            return base::fail({.code = base::ErrorCode::usage,
                               .file = output.string(),
                               .what = "the output is one of the files read",
                               .found = read.string(),
                               .remedy = "another name for the output"});
    return {};
}

base::Result<base::Bytes> encode(const Rendered& rendered, const image::WriteOptions& options) {
    const tables::ImageFormatRow& row = tables::row(options.format);
    if (row.layers) return image::encode_exr(rendered.layers, options);
    if (row.scene_linear) return image::encode(rendered.layers.front().image, options);
    return image::encode(rendered.display, options);
}

}  // namespace

base::Result<Rendered> render_to_file(const Request& request, const fs::path& output,
                                      base::Log& log, const base::Progress& progress) {
    const auto format = format_by_ending(output);
    if (!format) return tl::unexpected(format.error());
    const tables::ImageFormatRow& row = tables::row(*format);
    const auto depth = depth_for(row, request.settings.depth);
    if (!depth) return tl::unexpected(depth.error());
    if (auto writable = base::check_writable(output); !writable)
        return tl::unexpected(writable.error());
    if (request.settings.compare && row.scene_linear && !row.layers)
        return base::fail({.code = base::ErrorCode::usage,
                           .file = "--compare",
                           .what = fmt::format("{} holds one picture", row.key),
                           .found = output.string(),
                           .remedy = "an .exr holds all three, a .png lays them side by side"});
    Request wanted = request;
    wanted.want_linear = row.scene_linear;
    auto rendered = render(wanted, log, progress);
    if (!rendered) return rendered;
    if (auto allowed = check_result(request, output, *rendered); !allowed)
        return tl::unexpected(allowed.error());
    const auto start = std::chrono::steady_clock::now();
    image::WriteOptions options{
        .format = *format,
        .depth = *depth,
        .metadata = {{"Software", "Facet"},
                     {"facet.exposure", fmt::format("{}", rendered->exposure)}},
        .fast = request.settings.quality == "draft"};
    if (rendered->reference) {
        options.metadata.emplace_back("facet.reference", request.settings.reference);
        options.metadata.emplace_back("facet.samples",
                                      fmt::format("{}", rendered->reference->samples));
        options.metadata.emplace_back("facet.seed", fmt::format("{}", request.settings.seed));
    }
    const auto bytes = encode(*rendered, options);
    if (!bytes) return tl::unexpected(base::in_file(bytes.error(), output.string()));
    if (!row.layers)
        if (auto sides = write_side_files(output, *rendered); !sides)
            return tl::unexpected(sides.error());
    if (auto written = base::write_file_atomically(output, *bytes); !written)
        return tl::unexpected(written.error());
    rendered->ms.write =
        std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
    return rendered;
}

}  // namespace facet::render
