// A real window on a screen without a monitor: a person's hands (xdotool) drag, type and press
// keys, and screenshots tell what came of it. SPDX-License-Identifier: MIT
#include "base/file.h"
#include "image/image.h"
#include "support/process.h"
#include "support/temporary_folder.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

namespace facet::studio {
namespace {

using support::Ran;
using support::TemporaryFolder;
using support::text_of;

bool has_tools() { return std::system("command -v Xvfb xdotool xwd >/dev/null 2>&1") == 0; }

/// Starts a screen and the studio on it, then does `steps` with helpers at hand, then ends both.
/// Without rays, which come in their own time: a screen at rest is a finished picture then.
/// A window of 1280x720 has the roughness slider of the material panel at x 1060 to 1238, y 242.
Ran with_window(const TemporaryFolder& folder, const std::string& steps,
                const std::string& arguments = "") {
    const std::string script = R"(
set -eu
exec 3>display
Xvfb -displayfd 3 -screen 0 1280x720x24 -nolisten tcp -noreset >/dev/null 2>&1 &
screen=$!
trap 'kill $studio $screen 2>/dev/null || true; wait 2>/dev/null || true' EXIT
studio=
tries=0
until [ -s display ]; do sleep 0.05; tries=$((tries + 1)); [ $tries -lt 200 ]; done
export DISPLAY=:$(cat display) XDG_CONFIG_HOME="$PWD/config" XDG_STATE_HOME="$PWD/state" LANG=C
start() {
    ")" FACET_BINARY_DIR R"(/facet" studio scene.glb --shadows off "$@" \
        --window 1280x720 2>studio.err &
    studio=$!
    tries=0
    until xdotool search --name "Facet Studio" >/dev/null 2>&1; do
        sleep 0.1; tries=$((tries + 1)); kill -0 $studio; [ $tries -lt 200 ]
    done
    rest
}
# Processor time of the studio so far, in ticks of 10 ms.
ticks() { cut -d' ' -f14,15 /proc/$studio/stat | tr ' ' '+'; }
# Waits until the studio sleeps and two screenshots are alike: the picture is finished then. Alike
# alone they are during a long frame too.
rest() {
    sleep 0.6; xwd -root -silent -out a.xwd; tries=0; before=$(($(ticks)))
    until
        sleep 0.8; xwd -root -silent -out b.xwd; now=$(($(ticks)))
        [ $((now - before)) -lt 5 ] && cmp -s a.xwd b.xwd
    do
        before=$now; mv b.xwd a.xwd; tries=$((tries + 1)); [ $tries -lt 100 ]
    done
}
shot() { rest; mv a.xwd "$1"; }
# At once: a busy machine sees all of it between two frames.
drag() { xdotool mousemove $1 $2 mousedown 1 mousemove $3 $4 mouseup 1; }
start )" + arguments + "\n" + steps;
    folder.write("hands.sh", script);
    return support::run({"/bin/sh", "hands.sh"}, {.folder = folder.path()});
}

/// A screenshot of `xwd`: 24 bits in 32, blue first (XWDFile.h, version 7).
struct Screenshot {
    std::string bytes;
    std::size_t start = 0, width = 0, height = 0, stride = 0;
    explicit Screenshot(const std::filesystem::path& file) : bytes(text_of(file)) {
        const auto field = [&](std::size_t index) {
            std::size_t value = 0;
            for (std::size_t i = 0; i < 4 && index * 4 + i < bytes.size(); ++i)
                value = value << 8U | static_cast<unsigned char>(bytes[index * 4 + i]);
            return value;
        };
        width = field(4);
        height = field(5);
        stride = field(12);
        start = field(0) + field(19) * 12;
    }
    [[nodiscard]] int channel(std::size_t x, std::size_t y, std::size_t c) const {
        return static_cast<unsigned char>(bytes[start + y * stride + x * 4 + c]);
    }
};

/// Share of the pixels of a box that differ.
double changed(const Screenshot& a, const Screenshot& b, std::size_t x0, std::size_t y0,
               std::size_t x1, std::size_t y1) {
    if (a.width != b.width || a.width < x1 || a.height < y1) return -1.0;
    std::size_t different = 0;
    for (std::size_t y = y0; y < y1; ++y)
        for (std::size_t x = x0; x < x1; ++x)
            for (std::size_t c = 0; c < 3; ++c)
                if (a.channel(x, y, c) != b.channel(x, y, c)) {
                    ++different;
                    break;
                }
    return static_cast<double>(different) / static_cast<double>((x1 - x0) * (y1 - y0));
}

void copy_showcase(const TemporaryFolder& folder) {
    std::filesystem::copy_file(FACET_SOURCE_DIR "/resources/scenes/showcase.glb",
                               folder / "scene.glb");
}

TEST(StudioWindow, ADragOfTheSliderChangesTheGoldUndoPutsItBackAndSaveKeepsIt) {
    if (!has_tools()) GTEST_SKIP() << "apt-get install xvfb xdotool x11-apps";
    const TemporaryFolder folder;
    copy_showcase(folder);
    const Ran ran = with_window(folder, R"(
xdotool mousemove 640 715
shot before.xwd
drag 1200 242 1090 242
xdotool mousemove 640 715
shot after.xwd
xdotool key ctrl+z
shot undone.xwd
xdotool key ctrl+y
rest
cp scene.glb old.glb
xdotool key ctrl+s
tries=0
while cmp -s scene.glb old.glb; do sleep 0.1; tries=$((tries + 1)); [ $tries -lt 100 ]; done
shot saved.xwd
xdotool key ctrl+q
wait $studio
ls state/facet 2>/dev/null >left.txt || true
start --exposure 1
xdotool mousemove 640 715
shot again.xwd
)",
                                "--exposure 1");
    ASSERT_EQ(ran.exit, 0) << ran.err << text_of(folder / "studio.err");
    const Screenshot before(folder / "before.xwd");
    const Screenshot after(folder / "after.xwd");
    // The gold ball is in the middle of the viewport, above; the clay one on its left.
    EXPECT_GT(changed(before, after, 560, 120, 640, 200), 0.3);
    EXPECT_EQ(changed(before, after, 425, 160, 510, 230), 0.0);
    EXPECT_EQ(changed(before, Screenshot(folder / "undone.xwd"), 280, 60, 920, 460), 0.0);
    EXPECT_NE(text_of(folder / "scene.glb"), text_of(folder / "old.glb"));
    EXPECT_EQ(text_of(folder / "left.txt"), "") << "nothing unsaved is left behind";
    EXPECT_EQ(changed(after, Screenshot(folder / "again.xwd"), 280, 60, 920, 460), 0.0);
}

TEST(StudioWindow, WorkOfAKilledSessionIsOfferedAndRestored) {
    if (!has_tools()) GTEST_SKIP() << "apt-get install xvfb xdotool x11-apps";
    const TemporaryFolder folder;
    copy_showcase(folder);
    const Ran ran = with_window(folder, R"(
drag 1200 242 1090 242
xdotool mousemove 640 715
tries=0
until ls state/facet/*.json >kept 2>/dev/null; do
    sleep 0.1; tries=$((tries + 1)); [ $tries -lt 200 ]
done
shot after.xwd
kill -9 $studio
wait $studio 2>/dev/null || true
start --exposure 1
shot offered.xwd
xdotool key Return
rest
)");
    ASSERT_EQ(ran.exit, 0) << ran.err << text_of(folder / "studio.err");
    const auto kept = std::filesystem::directory_iterator(folder / "state/facet");
    EXPECT_NE(text_of(kept->path()).find("roughness"), std::string::npos);
    // A dialog in the middle of the window, over a dimmed one.
    EXPECT_GT(changed(Screenshot(folder / "after.xwd"), Screenshot(folder / "offered.xwd"), 500,
                      300, 780, 420),
              0.5);
}

TEST(StudioWindow, AFileThatChangesIsReadAgainAndOneThatVanishesIsNoHarm) {
    if (!has_tools()) GTEST_SKIP() << "apt-get install xvfb xdotool x11-apps";
    const TemporaryFolder folder;
    copy_showcase(folder);
    const Ran red = support::facet({"studio", "scene.glb", "--offscreen", "--do", "-"},
                                   {.folder = folder.path(),
                                    .input = "set material.gold.base_color \"1 0 0\"\n"
                                             "wait\nsave red.glb\n"});
    ASSERT_EQ(red.exit, 0) << red.err;
    const Ran ran = with_window(folder, R"(
xdotool mousemove 640 715
shot before.xwd
mv red.glb scene.glb
sleep 2.5
shot red.xwd
rm scene.glb
sleep 2.5
xdotool mousemove 650 715
shot gone.xwd
kill -0 $studio
)");
    ASSERT_EQ(ran.exit, 0) << ran.err << text_of(folder / "studio.err");
    const Screenshot before(folder / "before.xwd");
    EXPECT_GT(changed(before, Screenshot(folder / "red.xwd"), 560, 120, 640, 200), 0.3);
    EXPECT_EQ(
        changed(Screenshot(folder / "red.xwd"), Screenshot(folder / "gone.xwd"), 280, 60, 920, 460),
        0.0);
}

TEST(StudioWindow, TurningTheViewByTheMouseAndKeysThatTypeIntoFieldsOnly) {
    if (!has_tools()) GTEST_SKIP() << "apt-get install xvfb xdotool x11-apps";
    const TemporaryFolder folder;
    copy_showcase(folder);
    const Ran ran = with_window(folder, R"(
xdotool mousemove 640 715
shot before.xwd
drag 600 300 700 320
xdotool mousemove 640 715
shot turned.xwd
xdotool key h
shot home.xwd
)");
    ASSERT_EQ(ran.exit, 0) << ran.err << text_of(folder / "studio.err");
    const Screenshot before(folder / "before.xwd");
    EXPECT_GT(changed(before, Screenshot(folder / "turned.xwd"), 280, 60, 920, 460), 0.5);
    EXPECT_EQ(changed(before, Screenshot(folder / "home.xwd"), 280, 60, 920, 460), 0.0);
}

}  // namespace
}  // namespace facet::studio
