// The ways to a context without a window.
// SPDX-License-Identifier: MIT
#include "gl/context.h"

#include <gtest/gtest.h>

namespace facet::gl {
namespace {

TEST(Context, SurfacelessEglGivesACoreProfile) {
    base::Log log;
    const auto gl = Context::create(Backend::egl, log);
    ASSERT_TRUE(gl) << base::to_line(gl.error());
    EXPECT_EQ(gl->backend(), "egl");
    EXPECT_NE(gl->version().find("Core Profile"), std::string::npos) << gl->version();
}

TEST(Context, OsMesaGivesACoreProfile) {
    base::Log log;
    const auto gl = Context::create(Backend::osmesa, log);
    ASSERT_TRUE(gl) << base::to_line(gl.error());
    EXPECT_EQ(gl->backend(), "osmesa");
    EXPECT_NE(gl->version().find("Core Profile"), std::string::npos) << gl->version();
}

TEST(Context, TheProbeGivesEachWayARendererOrAReason) {
    const auto reports = probe_backends();
    ASSERT_EQ(reports.size(), 3U);
    for (const BackendReport& report : reports)
        EXPECT_NE(report.works, report.renderer.empty()) << report.name << ": " << report.reason;
    for (const BackendReport& report : reports)
        EXPECT_NE(report.works, !report.reason.empty()) << report.name << ": " << report.reason;
}

TEST(Context, AnErrorNamesThePass) {
    base::Log log;
    const auto gl = Context::create(Backend::automatic, log);
    ASSERT_TRUE(gl);
    gl->api().Enable(0xFFFF);
    const auto status = gl->check("the test");
    ASSERT_FALSE(status);
    EXPECT_EQ(status.error().where, "the test");
    EXPECT_TRUE(gl->check("after it")) << "the error was taken";
}

}  // namespace
}  // namespace facet::gl
