// Views of an OpenColorIO configuration.
// SPDX-License-Identifier: MIT
#include "render/render.h"
#include "support/temporary_folder.h"

#include <gtest/gtest.h>

#include <cstdlib>

namespace facet::render {
namespace {

constexpr const char* config = R"(ocio_profile_version: 1
search_path: .
strictparsing: true
roles:
  default: lin
  scene_linear: lin
displays:
  screen:
    - !<View> {name: half, colorspace: half}
    - !<View> {name: raw, colorspace: lin}
active_displays: [screen]
active_views: [half, raw]
colorspaces:
  - !<ColorSpace>
    name: lin
    bitdepth: 32f
  - !<ColorSpace>
    name: half
    bitdepth: 32f
    from_reference: !<MatrixTransform> {matrix: [0.5, 0, 0, 0, 0, 0.5, 0, 0, 0, 0, 0.5, 0, 0, 0, 0, 1]}
)";

base::Result<Rendered> corner(const std::string& tonemap, const std::string& reference = "") {
    Request request{.scene = "builtin:ball"};
    tables::Settings& s = request.settings;
    s.size = {32, 24};
    s.env = "furnace";
    s.exposure = "0.8";
    s.quality = "draft";
    s.tonemap = tonemap;
    s.reference = reference;
    base::Log log;
    return render(request, log);
}

int first_code(const base::Result<Rendered>& rendered) {
    if (!rendered) ADD_FAILURE() << base::to_line(rendered.error());
    return rendered ? rendered->display.as<std::uint8_t>()[0] : -1;
}

TEST(Ocio, ViewsAreThoseOfTheConfigurationInRasterAndReference) {
    const support::TemporaryFolder folder;
    folder.write("config.ocio", config);
    ::setenv("OCIO", (folder / "config.ocio").c_str(), 1);
    EXPECT_EQ(first_code(corner("ocio")), 102);  // 0.8 / 2 of 255
    EXPECT_EQ(first_code(corner("ocio:raw")), 204);
    EXPECT_EQ(first_code(corner("ocio:screen/half", "2")), 102);
    const auto wrong = corner("ocio:filmic");
    ASSERT_FALSE(wrong);
    EXPECT_EQ(wrong.error().code, base::ErrorCode::usage);
    EXPECT_NE(wrong.error().found.find("half, raw"), std::string::npos);
    ::unsetenv("OCIO");
    const auto none = corner("ocio");
    ASSERT_FALSE(none);
    EXPECT_EQ(none.error().code, base::ErrorCode::usage);
}

}  // namespace
}  // namespace facet::render
