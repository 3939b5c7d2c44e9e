// Settings of the camera and of what it makes of light, understood.
// SPDX-License-Identifier: MIT
#include "math/blackbody.h"
#include "math/color.h"
#include "render/plan_parts.h"
#include "scene/lens.h"
#include "scene/spec.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <utility>

namespace facet::render {

namespace {

/// What a panorama has not.
base::Status check_panorama(const tables::Settings& settings) {
    for (const auto& [option, given] : {std::pair{"--aperture", settings.aperture.has_value()},
                                        std::pair{"--vignette", settings.vignette != "off"},
                                        std::pair{"--motion-blur", !settings.motion_blur.empty()},
                                        std::pair{"--distortion", settings.distortion != 0.0F},
                                        std::pair{"--aberration", settings.aberration != 0.0F}})
        if (given)
            return usage(option, "a panorama has no lens", "",
                         "leave it out, or --projection perspective");
    return {};
}

/// `ocio`, `ocio:VIEW` or `ocio:DISPLAY/VIEW`.
base::Status plan_ocio(const tables::Settings& settings, Plan& plan) {
    const char* const file = std::getenv("OCIO");
    if (file == nullptr || *file == '\0')
        return usage("--tonemap", "the variable OCIO names no configuration", settings.tonemap,
                     "export OCIO=config.ocio");
    if (settings.gamut != "srgb")
        return usage("--gamut", "the view of OpenColorIO has its own colours", settings.gamut,
                     "leave one of them out");
    plan.has_ocio = true;
    const std::size_t colon = settings.tonemap.find(':');
    if (colon == std::string::npos) return {};
    const std::string name = settings.tonemap.substr(colon + 1);
    const std::size_t slash = name.find('/');
    if (slash != std::string::npos) plan.ocio_display = name.substr(0, slash);
    plan.ocio_view = slash == std::string::npos ? name : name.substr(slash + 1);
    return {};
}

}  // namespace

base::Status plan_camera(const tables::Settings& settings, Plan& plan) {
    const std::array<std::string, 3> names = {"perspective", "orthographic", "panorama"};
    if (!settings.projection.empty()) {
        const auto one = choose("--projection", settings.projection, names);
        if (!one) return tl::unexpected(one.error());
        if (settings.projection == names[2])
            if (auto fits = check_panorama(settings); !fits) return fits;
    }
    const std::array<std::string, 3> vignettes = {"off", "natural", "full"};
    if (const auto one = choose("--vignette", settings.vignette, vignettes); !one)
        return tl::unexpected(one.error());
    // A lens is looked through at one place a frame, and at one time: a few would show as a few
    // pictures.
    constexpr std::uint32_t lens_frames = 4;
    constexpr std::uint32_t least_frames = 16;
    const bool is_spread = settings.aperture || !settings.motion_blur.empty() ||
                           (settings.shutter && plays_animation(settings));
    if (is_spread && settings.samples == 0)
        plan.sample_count = std::max(plan.sample_count * lens_frames, least_frames);
    for (const auto& [option, given] : {std::pair{"--blades", settings.blades > 0},
                                        std::pair{"--focus", settings.focus.has_value()}})
        if (given && !settings.aperture)
            return usage(option, "needs an aperture", "", "add --aperture N, for example 2.8");
    if (settings.blades == 1 || settings.blades == 2)
        return usage("--blades", "no aperture has so few corners", std::to_string(settings.blades),
                     "3 or more, or 0 for a round one");
    return {};
}

base::Status plan_exposure(const tables::Settings& settings, Plan& plan) {
    const auto names = keys(tables::tonemaps);
    if (settings.tonemap == "ocio" || settings.tonemap.starts_with("ocio:")) {
        if (auto planned = plan_ocio(settings, plan); !planned) return planned;
    } else {
        const auto tonemap = choose("--tonemap", settings.tonemap, names);
        if (!tonemap) return tl::unexpected(tonemap.error());
        plan.tonemap = static_cast<tables::Tonemap>(*tonemap);
    }
    if (settings.ev && settings.exposure != "auto")
        return usage("--ev", "cannot be given together with --exposure", "",
                     "leave one of them out");
    const bool is_set = settings.ev || settings.exposure != "auto";
    // Of an animation the shutter is how long it is seen for, whatever the exposure comes from.
    if (settings.shutter && !(plays_animation(settings) && (is_set || !settings.aperture))) {
        if (!settings.aperture)
            return usage("--shutter", "needs an aperture, or an animation", "",
                         "add --aperture N, for example 8");
        if (is_set)
            return usage("--shutter", "cannot be given together with --ev or --exposure", "",
                         "leave one of them out");
        const double ev = scene::exposure_value(static_cast<double>(*settings.aperture),
                                                static_cast<double>(*settings.shutter),
                                                static_cast<double>(settings.iso));
        plan.exposure = 1.0 / (1.2 * std::exp2(ev));
        return {};
    }
    if (settings.iso != tables::Settings{}.iso)
        return usage("--iso", "needs a shutter and an aperture", "",
                     "add --shutter S --aperture N, or use --ev or --exposure");
    // ISO 12232 with q = 0.65: the saturation luminance of EV 0 is 1.2 nit.
    if (settings.ev) plan.exposure = 1.0 / (1.2 * std::exp2(static_cast<double>(*settings.ev)));
    if (settings.exposure == "auto") return {};
    const auto factor = base::parse_number(settings.exposure);
    if (!factor || *factor <= 0.0 || *factor > 1e12)
        return usage("--exposure", "not a factor above 0 or auto", settings.exposure,
                     "for example 1");
    plan.exposure = *factor;
    return {};
}

base::Status plan_probe(const tables::Settings& settings, Plan& plan) {
    if (settings.probe.empty()) return {};
    plan.has_probe = true;
    if (settings.probe == "auto") return {};
    constexpr tables::Range range{-1e9, 1e9};
    const auto place = scene::parse_vector("place", settings.probe, range);
    if (!place)
        return usage("--probe", "neither auto nor x y z in metres", settings.probe,
                     "for example \"0 1 0\"");
    plan.probe_m = *place;
    return {};
}

base::Status plan_gamut(const tables::Settings& settings, Plan& plan) {
    const auto names = keys(tables::gamuts);
    const auto gamut = choose("--gamut", settings.gamut, names);
    if (!gamut) return tl::unexpected(gamut.error());
    plan.gamut = static_cast<tables::Gamut>(*gamut);
    if (settings.white_balance)
        plan.balance = math::adapted_from(math::blackbody_color(*settings.white_balance));
    if (plan.gamut != tables::Gamut::rec2020_pq) return {};
    if (!settings.depth.empty() && settings.depth != "16")
        return usage("--gamut", "PQ has 16 bits", "--depth " + settings.depth, "--depth 16");
    if (settings.compare)
        return usage("--compare", "compares what a screen of today shows", "--gamut rec2020-pq",
                     "leave one of them out");
    plan.display_sample = image::Sample::u16;
    return {};
}

base::Status plan_resampling(const tables::Settings& settings, Plan& plan) {
    plan.is_panorama = settings.projection == "panorama";
    plan.is_resampled =
        plan.is_panorama || settings.distortion != 0.0F || settings.aberration != 0.0F;
    const bool by_reference_alone = plan.reference && !settings.compare && !plan.is_panorama;
    if (!plan.is_resampled || by_reference_alone || plan.aovs.empty()) return {};
    return base::fail({.code = base::ErrorCode::feature_missing,
                       .file = "--aov",
                       .what = plan.is_panorama ? "a panorama has no AOVs"
                                                : "a lens that bends has AOVs in --reference alone",
                       .found = settings.aov.front(),
                       .remedy = "leave it out"});
}

}  // namespace facet::render
