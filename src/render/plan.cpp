// The settings of a request, understood.
// SPDX-License-Identifier: MIT
#include "render/plan.h"

#include "base/text.h"
#include "brdf/choice.h"
#include "math/color.h"
#include "render/plan_parts.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <string>

namespace facet::render {
namespace {

using base::ErrorCode;
using base::Result;

/// Larger pictures want --region, or a poster printer.
constexpr std::uint32_t max_side_px = 16384;

std::optional<math::Vec3> parse_hex_color(std::string_view text) {
    if (text.size() != 7 || text[0] != '#') return std::nullopt;
    math::Vec3 color;
    for (int c = 0; c < 3; ++c) {
        const std::string_view digits = text.substr(1 + 2 * static_cast<std::size_t>(c), 2);
        unsigned code = 0;
        const auto parsed = std::from_chars(digits.data(), digits.data() + 2, code, 16);
        if (parsed.ec != std::errc() || parsed.ptr != digits.data() + 2) return std::nullopt;
        color[c] = math::linear_from_srgb(static_cast<float>(code) / 255.0F);
    }
    return color;
}

base::Status plan_size(const tables::Settings& settings, Plan& plan) {
    plan.picture = settings.size;
    if (plan.picture.width == 0 || plan.picture.height == 0 || plan.picture.width > max_side_px ||
        plan.picture.height > max_side_px)
        return base::fail(
            {.code = plan.picture.pixels() == 0 ? ErrorCode::usage : ErrorCode::limit_reached,
             .file = "--size",
             .what = fmt::format("sides are 1 to {} pixels", max_side_px),
             .found = fmt::format("{}x{}", plan.picture.width, plan.picture.height),
             .remedy = "a smaller --size"});
    plan.region = {0, 0, plan.picture};
    if (settings.region.empty()) return {};
    const auto parts = base::split(settings.region, ',');
    const auto sides =
        parts.size() == 3 ? base::split(parts[2], 'x') : std::vector<std::string_view>{};
    if (sides.size() == 2) {
        const auto x = base::parse_integer(parts[0]);
        const auto y = base::parse_integer(parts[1]);
        const auto w = base::parse_integer(sides[0]);
        const auto h = base::parse_integer(sides[1]);
        if (x && y && w && h && *x >= 0 && *y >= 0 && *w > 0 && *h > 0 &&
            *w <= settings.size.width && *h <= settings.size.height &&
            *x <= settings.size.width - *w && *y <= settings.size.height - *h) {
            plan.region = {static_cast<std::uint32_t>(*x),
                           static_cast<std::uint32_t>(*y),
                           {static_cast<std::uint32_t>(*w), static_cast<std::uint32_t>(*h)}};
            return {};
        }
    }
    return usage("--region", "not X,Y,WxH within the picture", settings.region,
                 fmt::format("for example 0,0,{}x{}", plan.picture.width, plan.picture.height));
}

base::Status plan_quality(const tables::Settings& settings, Plan& plan) {
    const auto names = keys(tables::qualities);
    const auto chosen = choose("--quality", settings.quality, names);
    if (!chosen) return tl::unexpected(chosen.error());
    const tables::Quality& quality = tables::qualities[*chosen];
    plan.is_draft = quality.fast_textures;
    plan.sample_count = settings.samples > 0 ? settings.samples : quality.frames;
    plan.rays = quality.rays;
    const std::array<std::string, 4> depths = {"8", "16", "half", "float"};
    if (!settings.depth.empty()) {
        const auto depth = choose("--depth", settings.depth, depths);
        if (!depth) return tl::unexpected(depth.error());
        plan.display_sample = *depth == 1 ? image::Sample::u16 : image::Sample::u8;
    }
    return {};
}

base::Status plan_shadows(const tables::Settings& settings, Plan& plan) {
    if (settings.shadows.empty()) return {};
    const std::array<std::string, 3> names = {"traced", "maps", "off"};
    const auto shadows = choose("--shadows", settings.shadows, names);
    if (!shadows) return tl::unexpected(shadows.error());
    if (*shadows > 0) plan.rays = {};
    plan.has_maps = *shadows == 1;
    return {};
}

base::Status plan_background(const tables::Settings& settings, Plan& plan) {
    const std::string& text = settings.background;
    plan.background = {};
    if (text == "env") return {};
    if (text == "none") {
        plan.background.kind = frame::BackgroundKind::none;
        return {};
    }
    if (const auto color = parse_hex_color(text)) {
        plan.background.kind = frame::BackgroundKind::color;
        plan.background.color = *color;
        return {};
    }
    if (text.starts_with("blur:")) {
        const auto blur = base::parse_number(std::string_view(text).substr(5));
        if (blur && *blur >= 0.0 && *blur <= 1.0) {
            plan.background.blur = static_cast<float>(*blur);
            return {};
        }
    }
    return usage("--background", "not a background", text,
                 "env, none, #rrggbb, or blur:X with X in 0..1");
}

base::Status plan_ground(const tables::Settings& settings, Plan& plan) {
    const std::string& text = settings.ground;
    if (text == "off") return {};
    plan.has_ground = true;
    if (text == "shadow") return {};
    if (text.starts_with("shadow:")) {
        const auto height = base::parse_number(std::string_view(text).substr(7));
        if (height && std::fabs(*height) <= 1e9) {
            plan.ground_m = static_cast<float>(*height);
            return {};
        }
    }
    return usage("--ground", "no such ground", text, "off, shadow, or shadow:Y with Y in metres");
}

base::Status plan_aovs(const tables::Settings& settings, Plan& plan) {
    const auto names = keys(tables::aovs);
    for (const std::string& name : settings.aov) {
        if (name == "beauty") continue;
        if (name == "all") {
            plan.aovs.clear();
            for (std::size_t i = 0; i < names.size(); ++i)
                plan.aovs.push_back(static_cast<tables::Aov>(i));
            return {};
        }
        const auto aov = choose("--aov", name, names);
        if (!aov) return tl::unexpected(aov.error());
        const auto one = static_cast<tables::Aov>(*aov);
        if (std::find(plan.aovs.begin(), plan.aovs.end(), one) == plan.aovs.end())
            plan.aovs.push_back(one);
    }
    return {};
}

/// More would take days; the Sobol points have 2^32.
constexpr std::uint32_t most_reference_samples = 1U << 20U;
constexpr std::uint32_t most_auto_samples = 1U << 14U;

base::Status plan_reference(const tables::Settings& settings, Plan& plan) {
    const std::string_view text = settings.reference;
    if (text.empty()) {
        const char* option = settings.time_limit ? "--time-limit"
                             : settings.compare  ? "--compare"
                                                 : nullptr;
        if (option == nullptr) return {};
        return usage(option, "is for the reference", "",
                     "add --reference SPP, for example --reference 64");
    }
    ReferencePlan reference{.time_s = settings.time_limit};
    constexpr std::string_view automatic = "auto:";
    const auto number = text.starts_with(automatic)
                            ? base::parse_number(text.substr(automatic.size()))
                            : std::nullopt;
    const auto count = base::parse_integer(text);
    if (number && *number > 0.0 && *number < 1.0) {
        reference.noise = *number;
        reference.samples = most_auto_samples;
    } else if (count && *count >= 1 && *count <= most_reference_samples) {
        reference.samples = static_cast<std::uint32_t>(*count);
    } else {
        return usage("--reference", "neither samples per pixel nor auto:NOISE", settings.reference,
                     fmt::format("1 to {}, or auto:0.01 for an error of 0.01 in display values",
                                 most_reference_samples));
    }
    plan.reference = reference;
    return {};
}

base::Status plan_machine(const tables::Settings& settings, Plan& plan) {
    const std::array<std::string, 3> names = {"auto", "egl", "osmesa"};
    const auto backend = choose("--backend", settings.backend, names);
    if (!backend) return tl::unexpected(backend.error());
    plan.backend = static_cast<gl::Backend>(*backend);
    if (settings.max_memory > 0) plan.limits.memory_bytes = std::size_t{settings.max_memory} << 20U;
    if (settings.max_vertices > 0) plan.limits.vertices = settings.max_vertices;
    return {};
}

/// What the frame's targets and their copies take, a pixel: G-buffer 20, radiance and sum 16 each,
/// display 8, and what is read back of them.
constexpr std::uint64_t frame_bytes = 80;
constexpr std::uint64_t aov_bytes = 48;   // target, read-back and layer
constexpr std::uint64_t path_bytes = 24;  // a light path's beside that: one frame's, or the film's
constexpr std::uint64_t ray_bytes =
    560;  // what rays are asked and answer: surfaces read back, sums and means of paths, textures
constexpr std::uint64_t film_bytes =
    96;  // sums, their mean, and its copies for the GL and the file

/// Flat views that a picture is resampled from are finer and wider than it, or several.
constexpr std::uint64_t resampled_views = 3;

base::Status check_memory(const tables::Settings& settings, Plan& plan) {
    const std::uint64_t pixels =
        plan.region.size.pixels() * (plan.is_resampled ? resampled_views : 1);
    const std::size_t paths = tables::of_kind(plan.aovs, tables::AovKind::light_path).size();
    const std::uint64_t needed =
        pixels * (frame_bytes + aov_bytes * plan.aovs.size() + path_bytes * paths +
                  (plan.rays.any() ? ray_bytes : 0) + (plan.reference ? film_bytes : 0));
    if (needed <= plan.limits.memory_bytes) return {};
    return base::fail(
        {.code = ErrorCode::limit_reached,
         .file = "--size",
         .what = fmt::format("the frame needs {} MiB, the limit is {} MiB", needed >> 20U,
                             plan.limits.memory_bytes >> 20U),
         .found = fmt::format("{}x{}", settings.size.width, settings.size.height),
         .remedy = plan.rays.any()
                       ? "--region renders it in parts, --shadows off takes less, "
                         "--max-memory raises the limit"
                       : "--region renders it in parts, --max-memory raises the limit"});
}

}  // namespace

Result<Plan> make_plan(const tables::Settings& settings) {
    Plan plan;
    for (const auto step : {plan_size, plan_quality, plan_shadows, plan_camera, plan_background,
                            plan_ground, plan_exposure, plan_probe, plan_gamut, plan_aovs,
                            plan_reference, plan_resampling, plan_machine, check_memory})
        if (auto status = step(settings, plan); !status) return tl::unexpected(status.error());
    auto brdf = brdf::parse_choice(settings.brdf, brdf::Use::render);
    if (!brdf) return tl::unexpected(base::in_file(brdf.error(), "--brdf"));
    plan.brdf = *brdf;
    return plan;
}

}  // namespace facet::render
