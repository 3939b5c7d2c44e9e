// The command line: help, lists, and what a mistake is answered with.
// SPDX-License-Identifier: MIT
#include "support/process.h"
#include "support/temporary_folder.h"
#include "tables/commands.h"
#include "tables/exit_codes.h"
#include "tables/settings.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace facet::cli {
namespace {

using support::facet;
using support::line_count;
using support::Ran;

/// One mistake: what is typed, and what the one line on standard error says.
struct Mistake {
    std::vector<std::string> arguments;
    std::string line;
};

TEST(Usage, AMistakeIsOneLineAndStatus2) {
    const Mistake mistakes[] = {
        {{"render", "a.glb", "--expsure", "2"},
         "facet: --expsure: unknown option; did you mean --exposure\n"},
        {{"render", "a.glb", "--expsure=2"},
         "facet: --expsure: unknown option; did you mean --exposure\n"},
        {{"rendr", "a.glb"}, "facet: rendr: unknown command; did you mean render\n"},
        {{"render", "a.glb", "--fov"}, "facet: --fov: needs a value\n"},
        {{"render", "a.glb", "b.glb"},
         "facet: b.glb: one argument too many; facet render --help\n"},
        {{"render", "a.glb", "--fov", "200"},
         "facet: --fov: is out of range: 0 to 179 (DEG) (200)\n"},
        {{"render", "a.glb", "--quality", "finl"},
         "facet: --quality: is one of draft, standard, final (finl); did you mean final\n"},
        {{"render", "a.glb", "-q", "-v"}, "facet: --quiet: excludes --verbose\n"},
        {{"render", "a.glb", "-o", "-", "--aov", "albedo"},
         "facet: --aov: excludes -o -; give a file\n"},
        {{"--list", "aov"}, "facet: --list: no such list (aov); did you mean aovs\n"},
        {{"help", "ligths"}, "facet: ligths: no such topic; did you mean lights\n"},
        {{"--list", "cameras"},
         "facet: --list: cameras are those of a scene; facet render SCENE --list cameras\n"},
    };
    for (const Mistake& mistake : mistakes) {
        const Ran ran = facet(mistake.arguments);
        EXPECT_EQ(ran.exit, 2) << mistake.line;
        EXPECT_EQ(ran.err, mistake.line);
        EXPECT_EQ(ran.out, "") << mistake.line;
    }
}
TEST(Usage, NumbersMustBeFiniteAndWhole) {
    for (const char* number : {"nan", "inf", "1e999", "", "1,5", "0x10"})
        EXPECT_EQ(facet({"render", "a.glb", "--fov", number}).exit, 2) << number;
    for (const char* number : {"1.5", "-1", "99999999999999999999"})
        EXPECT_EQ(facet({"render", "a.glb", "--threads", number}).exit, 2) << number;
    for (const char* size : {"0x10", "10", "10x", "10x-1", "axb", "10x10x10"})
        EXPECT_EQ(facet({"render", "a.glb", "--size", size}).exit, 2) << size;
}
TEST(Usage, APictureOfAMillionPixelsASideReachesALimit) {
    EXPECT_EQ(facet({"render", "a.glb", "--size", "1000000x1000000"}).exit, 5);
}
TEST(Usage, WithJsonAMistakeIsAnObjectToo) {
    const Ran ran = facet({"render", "a.glb", "--expsure", "2", "--json"});
    const auto object = nlohmann::json::parse(ran.out);
    EXPECT_EQ(object["severity"], "error");
    EXPECT_EQ(object["code"], "usage");
    EXPECT_EQ(object["path"], "--expsure");
    EXPECT_EQ(line_count(ran.out), 1U);
}
TEST(Usage, WithoutACommandTheHelpGoesToStandardError) {
    const Ran ran = facet({});
    EXPECT_EQ(ran.exit, 2);
    EXPECT_EQ(ran.out, "");
    EXPECT_NE(ran.err.find("Commands"), std::string::npos);
}
TEST(Usage, AVariableThatNothingReadsIsWarnedAbout) {
    const Ran ran = facet({"help", "lights"}, {.environment = {"FACET_THRAEDS=2"}});
    EXPECT_EQ(ran.exit, 0);
    EXPECT_EQ(ran.err,
              "facet: warning: FACET_THRAEDS: this environment variable is ignored; did you mean "
              "FACET_THREADS\n");
}
TEST(Usage, ABadVariableIsAMistakeThatNamesIt) {
    const Ran ran = facet({"render", "a.glb"}, {.environment = {"FACET_THREADS=many"}});
    EXPECT_EQ(ran.exit, 2);
    EXPECT_TRUE(ran.err.starts_with("facet: FACET_THREADS: ")) << ran.err;
}
TEST(Usage, ControlCharactersOfAnArgumentDoNotReachTheTerminal) {
    const Ran ran = facet({"render", "a\x1b[2J\n.glb"});
    EXPECT_EQ(ran.exit, 3);
    EXPECT_EQ(ran.err.find('\x1b'), std::string::npos) << ran.err;
    EXPECT_EQ(line_count(ran.err), 1U) << ran.err;
}

TEST(Help, OfEveryCommandFitsAScreenAndStartsWithAnExample) {
    for (const auto& command : tables::commands) {
        const Ran ran = facet({std::string(command.key), "--help"});
        EXPECT_EQ(ran.exit, 0) << command.key;
        EXPECT_TRUE(ran.out.starts_with("Example: facet ")) << command.key;
        EXPECT_LE(line_count(ran.out), 60U) << command.key;
        EXPECT_EQ(ran.err, "") << command.key;
    }
}
TEST(Help, NamesEveryCommandAndEverySetting) {
    const std::string general = facet({"--help"}).out;
    for (const auto& command : tables::commands)
        EXPECT_NE(general.find(command.help), std::string::npos) << command.key;
    const std::string render = facet({"help", "render"}).out + facet({"help", "more"}).out;
    for (const auto& setting : tables::settings) {
        std::string flag = "--" + std::string(setting.key);
        for (char& c : flag) c = c == '_' ? '-' : c;
        EXPECT_NE(render.find(flag), std::string::npos) << flag;
    }
}
TEST(Help, EveryTopicThatIsNamedIsThere) {
    for (const char* topic :
         {"lights", "cameras", "quality", "set", "aovs", "studio", "more", "exit-codes"}) {
        const Ran ran = facet({"help", topic});
        EXPECT_EQ(ran.exit, 0) << topic;
        EXPECT_TRUE(ran.out.starts_with("Example: facet ")) << topic;
    }
}
TEST(Lists, HaveALineForEachName) {
    for (const char* list : {"scenes", "environments", "lights", "aovs", "tonemaps", "brdf"}) {
        const Ran ran = facet({"--list", list});
        EXPECT_EQ(ran.exit, 0) << list << ran.err;
        EXPECT_GE(line_count(ran.out), 3U) << list << "\n" << ran.out;
    }
}
TEST(Version, IsOneObjectWithJson) {
    const auto object = nlohmann::json::parse(facet({"--version", "--json"}).out);
    EXPECT_EQ(object["facet"], 1);
    EXPECT_TRUE(object["version"].is_string());
}

TEST(Streams, AReaderThatGoesAwayIsQuietAndStatus75) {
    // The pipe is written to until that fails: only then has the reader gone for certain.
    const Ran ran =
        support::run({"/bin/sh", "-c",
                      "(trap '' PIPE; while echo x; do :; done 2>/dev/null; " FACET_BINARY_DIR
                      "/facet help set; echo $? >&2) | true"});
    EXPECT_EQ(ran.err, "75\n");
}
TEST(Streams, ClosedOnesDoNotPutMessagesIntoFiles) {
    const Ran ran =
        support::run({"/bin/sh", "-c", FACET_BINARY_DIR "/facet render - 2>&1 <&-; echo $?"});
    EXPECT_EQ(ran.out, "facet: -: standard input is closed; give a file\n2\n");
}
TEST(Streams, AFullDiskUnderStandardOutputIsStatus75) {
    const Ran ran =
        support::run({"/bin/sh", "-c", FACET_BINARY_DIR "/facet --help >/dev/full; echo $?"});
    EXPECT_EQ(ran.out, "75\n");
}

}  // namespace
}  // namespace facet::cli
