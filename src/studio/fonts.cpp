// The letters of the user interface.
// SPDX-License-Identifier: MIT
#include "studio/fonts.h"

#include <imgui.h>

#include <array>
#include <filesystem>
#include <system_error>

namespace facet::studio {
namespace {

/// Debian's packages fonts-dejavu-core, fonts-noto-core, fonts-liberation; each has Latin, Greek
/// and Cyrillic.
constexpr std::array files = {"/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf",
                              "/usr/share/fonts/truetype/noto/NotoSans-Regular.ttf",
                              "/usr/share/fonts/truetype/liberation/LiberationSans-Regular.ttf"};

/// Pairs of first and last letter: Latin, Greek, Cyrillic, punctuation, arrows, mathematics,
/// shapes.
constexpr std::array<ImWchar, 17> ranges = {0x0020, 0x00FF, 0x0370, 0x03FF, 0x0400, 0x04FF,
                                            0x2010, 0x2030, 0x2070, 0x209F, 0x2190, 0x21FF,
                                            0x2200, 0x22FF, 0x25A0, 0x25FF, 0};

}  // namespace

Fonts load_fonts(float size_px) {
    ImFontAtlas& atlas = *ImGui::GetIO().Fonts;
    atlas.Clear();
    for (const char* file : files) {
        std::error_code error;
        if (!std::filesystem::is_regular_file(file, error)) continue;
        if (atlas.AddFontFromFileTTF(file, size_px, nullptr, ranges.data()) != nullptr)
            return {.has_cyrillic = true};
    }
    ImFontConfig config;
    config.SizePixels = size_px;
    atlas.AddFontDefault(&config);
    return {};
}

}  // namespace facet::studio
