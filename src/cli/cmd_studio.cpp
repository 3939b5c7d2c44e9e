// facet studio: the material-editing sandbox.
// SPDX-License-Identifier: MIT
#include "base/file.h"
#include "base/text.h"
#include "base/texts.h"
#include "cli/flags.h"
#include "cli/output_gate.h"
#include "cli/setting_flags.h"
#include "gl/context.h"
#include "studio/studio.h"
#include "teach/lesson.h"
#include "teach/markdown.h"
#include "teach/page.h"

#include <memory>

namespace facet::cli {
namespace {

using base::ErrorCode;
using base::fail;
using base::Result;

constexpr std::size_t most_script_bytes = std::size_t{1} << 20;

struct StudioOptions {
    std::string scene;
    bool offscreen = false;
    std::optional<double> frames;
    std::string shot;
    std::string script;
    std::string language;
    std::string theme;
    std::string window;
    std::string lesson;
    TypedSettings typed;
};

base::Status read_script(const std::string& path, studio::StudioRequest& request) {
    if (path.empty()) return {};
    const auto bytes = path == "-" ? base::read_stdin(most_script_bytes)
                                   : base::read_file(path, most_script_bytes);
    if (!bytes) return tl::unexpected(base::in_file(bytes.error(), path));
    const std::string_view text(reinterpret_cast<const char*>(bytes->data()), bytes->size());
    auto steps = studio::parse_script(text, path);
    if (!steps) return tl::unexpected(steps.error());
    request.script = std::move(*steps);
    request.has_script = true;
    return {};
}

base::Status read_theme(const std::string& name, studio::StudioRequest& request) {
    if (name.empty()) return {};
    if (name != "dark" && name != "light")
        return fail({.code = ErrorCode::usage,
                     .file = "--theme",
                     .what = "no such theme",
                     .found = name,
                     .remedy = "dark or light"});
    request.theme = name == "dark" ? studio::Theme::dark : studio::Theme::light;
    return {};
}

base::Status read_window(const std::string& text, studio::StudioRequest& request) {
    if (text.empty()) return {};
    const auto sides = base::split(text, 'x');
    if (sides.size() == 2) {
        const auto width = base::parse_integer(sides[0]);
        const auto height = base::parse_integer(sides[1]);
        if (width && height && *width >= 320 && *height >= 240 && *width <= 8192 &&
            *height <= 8192) {
            request.window_points = {static_cast<std::uint32_t>(*width),
                                     static_cast<std::uint32_t>(*height)};
            return {};
        }
    }
    return fail({.code = ErrorCode::usage,
                 .file = "--window",
                 .what = "not WxH from 320x240 to 8192x8192",
                 .found = text,
                 .remedy = "for example 1440x860"});
}

/// A lesson's text, its pictures as views, and its scene.
base::Status read_lesson(const StudioOptions& options, studio::StudioRequest& request) {
    if (options.lesson.empty()) return {};
    if (!options.scene.empty())
        return fail({.code = ErrorCode::usage,
                     .file = "--lesson",
                     .what = "opens a scene of its own",
                     .found = options.scene});
    const auto lesson = teach::find_lesson(options.lesson);
    if (!lesson) return tl::unexpected(base::in_file(lesson.error(), "--lesson"));
    studio::StudioLesson guide;
    for (const auto& [language, text] : lesson->texts)
        guide.texts[language] = {lesson->title(language), teach::summary_of(*lesson, language),
                                 teach::plain_section(text, 1)};
    const auto add_view = [&](const teach::Picture& picture) {
        studio::LessonView view{.document = {picture.scene, picture.settings}};
        for (const std::string_view language : base::languages)
            view.labels[std::string(language)] = picture.label.in(language);
        if (!picture.show.empty()) view.show = picture.show;
        guide.views.push_back(std::move(view));
    };
    for (const teach::Strip& strip : lesson->strips)
        for (const teach::Picture& picture : strip.pictures)
            if (picture.settings.reference.empty()) add_view(picture);
    if (lesson->studio) {
        request.scene = lesson->studio->scene;
        request.settings = lesson->studio->settings;
    } else if (!guide.views.empty()) {
        request.scene = guide.views.front().document.scene;
        request.settings = guide.views.front().document.settings;
    }
    request.lesson = std::move(guide);
    return {};
}

base::Status check(const StudioOptions& options) {
    if (options.offscreen && !options.frames && options.script.empty())
        return fail({.code = ErrorCode::usage,
                     .file = "--offscreen",
                     .what = "nobody can close it",
                     .remedy = "add --frames N, or --do SCRIPT"});
    if (!options.shot.empty() && !options.frames)
        return fail({.code = ErrorCode::usage,
                     .file = "--shot",
                     .what = "needs --frames N",
                     .remedy = "a script has its own: shot FILE"});
    if (options.scene == "-")
        return fail({.code = ErrorCode::usage,
                     .file = "-",
                     .what = "the studio cannot save to standard input",
                     .remedy = "give a file"});
    if (options.shot.empty()) return {};
    return check_output(options.shot, {}, std::vector{options.scene});
}

Result<Exit> run_studio(const StudioOptions& options, Io& io) {
    if (auto checked = check(options); !checked) return tl::unexpected(checked.error());
    auto settings = options.typed.read();
    if (!settings) return tl::unexpected(settings.error());
    studio::StudioRequest request{.settings = *settings,
                                  .offscreen = options.offscreen,
                                  .frames = static_cast<std::uint32_t>(options.frames.value_or(0)),
                                  .shot = options.shot,
                                  .language = options.language};
    if (!options.scene.empty()) request.scene = options.scene;
    if (auto s = read_lesson(options, request); !s) return tl::unexpected(s.error());
    if (auto s = read_script(options.script, request); !s) return tl::unexpected(s.error());
    if (auto s = read_theme(options.theme, request); !s) return tl::unexpected(s.error());
    if (auto s = read_window(options.window, request); !s) return tl::unexpected(s.error());
    gl::prepare_environment(settings->threads);
    base::Log log = io.log();
    if (auto s = studio::run(request, log); !s) return tl::unexpected(s.error());
    return Exit::done;
}

}  // namespace

void add_studio(Declaration& command) {
    auto options = std::make_shared<StudioOptions>();
    auto& flags = command.flags;
    flags.push_back(
        {"SCENE", &options->scene, "", "", ".gltf, .glb or builtin:NAME (builtin:showcase)"});
    flags.push_back({"--offscreen", &options->offscreen, "", "Studio",
                     "no window: the same pictures without a display"});
    flags.push_back({"--frames", BoundedNumber{&options->frames, {1, 1e6}}, "N", "Studio",
                     "ends after so many frames"});
    flags.push_back({"--shot", &options->shot, "PNG", "Studio", "writes the last of them"});
    flags.push_back({"--do", &options->script, "SCRIPT", "Studio",
                     "plays a script of clicks, drags, keys and edits; facet help studio"});
    flags.push_back({"--lesson", &options->lesson, "NAME", "Studio",
                     "opens a lesson's scene with its text and views; --list lessons"});
    flags.push_back({"--window", &options->window, "WxH", "Studio", "size of the window"});
    flags.push_back({"--lang", &options->language, "en|ru", "Studio", "language"});
    flags.push_back({"--theme", &options->theme, "dark|light", "Studio", "colours of the window"});
    options->typed.declare(flags);
    command.job = [options](Io& io) { return run_studio(*options, io); };
}

}  // namespace facet::cli
