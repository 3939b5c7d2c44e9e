// A picture into its file, and the AOVs into or beside it.
// SPDX-License-Identifier: MIT
#include "render/picture_file.h"

#include "base/file.h"
#include "base/hash.h"
#include "base/text.h"
#include "image/npy.h"
#include "render/stopwatch.h"
#include "render/viewable.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>

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

tables::Gamut gamut_of(const tables::Settings& settings) {
    const auto* const row =
        std::ranges::find(tables::gamuts, std::string_view(settings.gamut), &tables::GamutRow::key);
    return row == tables::gamuts.end() ? tables::Gamut::srgb
                                       : static_cast<tables::Gamut>(row - tables::gamuts.begin());
}

/// PNG can say that its colours are others than sRGB's, and only PQ needs its 16 bits.
base::Status check_gamut(const tables::Settings& settings, PictureFile& file) {
    const tables::Gamut gamut = gamut_of(settings);
    if (gamut == tables::Gamut::srgb) return {};
    if (file.format != ImageFormat::png)
        return base::fail({.code = base::ErrorCode::usage,
                           .file = "--gamut",
                           .what = file.holds_radiance()
                                       ? "the file holds radiance, in Rec.709"
                                       : "the format cannot say which colours it holds",
                           .found = file.path.string(),
                           .remedy = "a .png"});
    if (gamut == tables::Gamut::rec2020_pq) file.depth = image::Depth::u16;
    return {};
}

bool has_side_files(const tables::ImageFormatRow& row, const tables::Settings& settings) {
    return !row.layers || !settings.aov_format.empty();
}

base::Result<base::Bytes> encode_side(tables::Aov aov, const image::Layer& layer, double exposure,
                                      bool npy) {
    if (!npy)
        return image::encode(viewable(aov, layer, exposure),
                             {.format = ImageFormat::png, .fast = true});
    const bool is_id = tables::row(aov).png == tables::PngCode::id_color;
    return image::encode_npy(layer.image, is_id ? image::NpyType::u32 : image::NpyType::f32);
}

base::Result<std::vector<fs::path>> write_side_files(const fs::path& output, bool npy,
                                                     const Rendered& rendered) {
    std::vector<fs::path> sides;
    for (const image::Layer& layer : rendered.layers) {
        const auto aov = tables::aov_named(layer.name);
        if (!aov) continue;
        fs::path side = output;
        side.replace_extension("." + layer.name + (npy ? ".npy" : ".png"));
        const auto bytes = encode_side(*aov, layer, rendered.exposure, npy);
        if (!bytes) return tl::unexpected(bytes.error());
        if (auto written = base::write_file_atomically(side, *bytes); !written)
            return tl::unexpected(written.error());
        sides.push_back(std::move(side));
    }
    return sides;
}

base::Status check_strict(const Request& request, const Rendered& rendered) {
    const auto warning = std::ranges::find(rendered.warnings, false, &base::Warning::spares_result);
    if (!request.settings.strict || warning == rendered.warnings.end()) return {};
    const base::Warning& w = *warning;
    return base::fail({.code = base::ErrorCode::input_invalid,
                       .file = w.file,
                       .where = w.where,
                       .what = w.what,
                       .found = w.found,
                       .remedy = "--strict makes this warning an error"});
}

/// Known only after loading: an output that is one of the files read (faults, F3).
base::Status check_output(const fs::path& output, const Rendered& rendered) {
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

}  // namespace

base::Result<PictureFile> plan_file(const tables::Settings& settings, const fs::path& output) {
    const auto format = format_by_ending(output);
    if (!format) return tl::unexpected(format.error());
    const tables::ImageFormatRow& row = tables::row(*format);
    const auto depth = depth_for(row, settings.depth);
    if (!depth) return tl::unexpected(depth.error());
    if (settings.compare && row.scene_linear && !row.layers)
        return base::fail({.code = base::ErrorCode::usage,
                           .file = "--compare",
                           .what = fmt::format("{} holds one picture", row.key),
                           .found = output.string(),
                           .remedy = "an .exr holds all three, a .png lays them side by side"});
    PictureFile file{output, *format, *depth};
    if (auto fits = check_gamut(settings, file); !fits) return tl::unexpected(fits.error());
    return file;
}

base::Result<base::Bytes> encode_picture(const PictureFile& file, const Request& request,
                                         const Rendered& rendered) {
    if (auto allowed = check_strict(request, rendered); !allowed)
        return tl::unexpected(allowed.error());
    image::WriteOptions options{
        .format = file.format,
        .depth = file.depth,
        .metadata = {{"Software", "Facet"},
                     {"facet.exposure", fmt::format("{}", rendered.exposure)}},
        .gamut = gamut_of(request.settings),
        .fast = request.settings.quality == "draft"};
    if (rendered.reference) {
        options.metadata.emplace_back("facet.reference", request.settings.reference);
        options.metadata.emplace_back("facet.samples",
                                      fmt::format("{}", rendered.reference->samples));
        options.metadata.emplace_back("facet.seed", fmt::format("{}", request.settings.seed));
    }
    const tables::ImageFormatRow& row = tables::row(file.format);
    auto bytes = row.layers         ? image::encode_exr(rendered.layers, options)
                 : row.scene_linear ? image::encode(rendered.layers.front().image, options)
                                    : image::encode(rendered.display, options);
    if (!bytes) return tl::unexpected(base::in_file(bytes.error(), file.path.string()));
    return bytes;
}

base::Result<Written> write_picture(const PictureFile& file, const Request& request,
                                    Rendered& rendered) {
    if (auto allowed = check_output(file.path, rendered); !allowed)
        return tl::unexpected(allowed.error());
    if (!tables::row(file.format).alpha && request.settings.background == "none")
        rendered.warnings.push_back(
            {.where = "--background",
             .what = "the format has no alpha: what is not covered is black",
             .found = file.path.filename().string(),
             .remedy = "a .png, .webp or .exr"});
    Stopwatch watch;
    const auto bytes = encode_picture(file, request, rendered);
    if (!bytes) return tl::unexpected(bytes.error());
    Written written{.sha256 = base::sha256_hex(*bytes), .sides = {}};
    if (has_side_files(tables::row(file.format), request.settings)) {
        const bool npy = request.settings.aov_format == "npy";
        auto sides = write_side_files(file.path, npy, rendered);
        if (!sides) return tl::unexpected(sides.error());
        written.sides = std::move(*sides);
    }
    if (auto s = base::write_file_atomically(file.path, *bytes); !s)
        return tl::unexpected(s.error());
    rendered.ms.write = watch.lap_ms();
    return written;
}

base::Result<Rendered> render_to_file(const Request& request, const fs::path& output,
                                      base::Log& log, const base::Progress& progress) {
    const auto file = plan_file(request.settings, output);
    if (!file) return tl::unexpected(file.error());
    if (auto writable = base::check_writable(output); !writable)
        return tl::unexpected(writable.error());
    Request wanted = request;
    wanted.want_linear = file->holds_radiance();
    auto rendered = render(wanted, log, progress);
    if (!rendered) return rendered;
    if (const auto written = write_picture(*file, request, *rendered); !written)
        return tl::unexpected(written.error());
    return rendered;
}

}  // namespace facet::render
