// Displays of OpenColorIO, by way of OpenImageIO.
// SPDX-License-Identifier: MIT
#include "image/module_oiio/color.h"

#include <OpenImageIO/color.h>

#include <cstdio>
#include <exception>
#include <string>
#include <vector>

namespace {

/// What well-known configurations call linear Rec.709; else the role that renderers work in.
std::string working_space(OIIO::ColorConfig& config) {
    for (const char* const name :
         {"Linear Rec.709 (sRGB)", "lin_rec709_scene", "lin_rec709", "lin_srgb",
          "Utility - Linear - sRGB", "Utility - Linear - Rec.709"})
        for (int i = 0; i < config.getNumColorSpaces(); ++i)
            if (std::string(config.getColorSpaceNameByIndex(i)) == name) return name;
    const char* const role = config.getColorSpaceNameByRole("scene_linear");
    return role == nullptr ? "" : role;
}

bool has(const std::vector<std::string>& names, const std::string& name) {
    for (const std::string& each : names)
        if (each == name) return true;
    return false;
}

std::string joined(const std::vector<std::string>& names) {
    std::string out;
    for (const std::string& name : names) out += (out.empty() ? "" : ", ") + name;
    return out;
}

std::string apply(const FacetOiioShape& shape, float* pixels, std::string display,
                  std::string view) {
    OIIO::ColorConfig config;  // the one that the variable OCIO names
    if (config.has_error()) return config.geterror();
    if (display.empty()) {
        const char* const name = config.getDefaultDisplayName();
        display = name == nullptr ? "" : name;
    }
    if (!has(config.getDisplayNames(), display))
        return "no such display (" + display + "); there is " + joined(config.getDisplayNames());
    if (view.empty()) {
        const char* const name = config.getDefaultViewName(display);
        view = name == nullptr ? "" : name;
    }
    if (!has(config.getViewNames(display), view))
        return "no such view (" + view + "); there is " + joined(config.getViewNames(display));
    const auto processor = config.createDisplayTransform(display, view, working_space(config));
    if (!processor) return config.has_error() ? config.geterror() : "the view cannot be made";
    constexpr OIIO::stride_t sample = sizeof(float);
    processor->apply(pixels, static_cast<int>(shape.width), static_cast<int>(shape.height),
                     static_cast<int>(shape.channels), sample, sample * shape.channels,
                     sample * shape.channels * shape.width);
    return {};
}

}  // namespace

int facet_oiio_display(const FacetOiioShape* shape, float* pixels, const char* display,
                       const char* view, FacetOiioMessage message) {
    std::string problem;
    try {
        problem = apply(*shape, pixels, display, view);
    } catch (const std::exception& exception) {
        problem = exception.what();
    } catch (...) {
        problem = "unknown exception";
    }
    if (problem.empty()) return 0;
    std::snprintf(message.text, message.capacity, "%s", problem.c_str());
    return 1;
}
