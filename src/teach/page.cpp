// Pages: a lesson as one HTML file, and the index.
// SPDX-License-Identifier: MIT
#include "teach/page.h"

#include "base/file.h"
#include "base/resources.h"
#include "base/text.h"
#include "teach/live.h"
#include "teach/plot.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>

namespace facet::teach {
namespace {

base::Result<std::string> resource(const char* name) {
    const auto folder = base::data_folder();
    if (!folder) return tl::unexpected(folder.error());
    return base::read_text_file(*folder / "resources" / "teach" / name, most_file_bytes);
}

template <class Named>
const Named* named(const std::vector<Named>& list, const std::string& name) {
    const auto found = std::ranges::find(list, name, &Named::name);
    return found == list.end() ? nullptr : &*found;
}

template <class Named>
tl::unexpected<base::Error> no_such(const Figure& figure, const std::vector<Named>& list) {
    std::vector<std::string> names;
    for (const Named& one : list) names.push_back(one.name);
    return base::fail({.code = base::ErrorCode::input_invalid,
                       .what = fmt::format("lesson.json has no such {}", figure.kind),
                       .found = figure.name,
                       .remedy = base::suggestion(figure.name, names)});
}

/// What the renderer said of a picture, at the place that asked for it.
base::Error of_strip(base::Error error, const std::string& name) {
    std::string where = "/strips/" + name;
    for (const std::string& part : {error.file, error.where})
        if (!part.empty()) where += ": " + part;
    error.file.clear();
    error.where = std::move(where);
    return error;
}

std::string caption_of(const Figure& figure) {
    return figure.caption.empty()
               ? ""
               : fmt::format("<figcaption>{}</figcaption>", base::markup_escaped(figure.caption));
}

std::string image(const std::string& uri, math::Extent size, const std::string& alt) {
    return fmt::format("<img src=\"{}\" width=\"{}\" height=\"{}\" alt=\"{}\">", uri, size.width,
                       size.height, base::markup_escaped(alt));
}

std::string link(const PageLink& to, const char* arrow_before, const char* arrow_after) {
    if (to.file.empty()) return "<span></span>";
    return fmt::format("<a href=\"{}\">{}{}{}</a>", base::markup_escaped(to.file), arrow_before,
                       base::markup_escaped(to.title), arrow_after);
}

/// JSON that may stand in a script element: no "</".
std::string embedded(const Json& json) {
    std::string text = json.dump(-1, ' ', false, Json::error_handler_t::replace);
    for (std::size_t at = 0; (at = text.find("</", at)) != std::string::npos; at += 3)
        text.insert(at + 1, "\\");
    return text;
}

}  // namespace

std::string summary_of(const Lesson& lesson, std::string_view language) {
    const auto text = lesson.texts.find(language);
    if (text == lesson.texts.end()) return {};
    const auto paragraphs = plain_section(text->second, 0);
    return paragraphs.empty() ? std::string{} : paragraphs.front();
}

base::Result<PageMaker> PageMaker::create(const base::Texts& texts, Gallery& gallery) {
    PageMaker maker(texts, gallery);
    auto style = resource("page.css");
    if (!style) return tl::unexpected(style.error());
    auto script = resource("live.js");
    if (!script) return tl::unexpected(script.error());
    maker.style_ = std::move(*style);
    maker.script_ = std::move(*script);
    return maker;
}

base::Result<std::string> PageMaker::strip(const Strip& strip, const Figure& figure) {
    std::string shots;
    std::string commands;
    bool is_wide = false;
    for (const Picture& picture : strip.pictures) {
        const auto shot = gallery_->shot(picture);
        if (!shot) return tl::unexpected(of_strip(shot.error(), strip.name));
        const std::string& label = picture.label.in(texts_->language());
        const std::string alt = figure.caption + (label.empty() ? "" : " — " + label);
        shots +=
            fmt::format("<div class=\"shot\">{}{}</div>",
                        image((*shot)->data_uri, (*shot)->size, alt), base::markup_escaped(label));
        commands += base::markup_escaped((*shot)->command) + "\n";
        is_wide = is_wide || (*shot)->size.width > 400;
    }
    return fmt::format(
        "<figure class=\"strip\"><div class=\"row{}\">{}</div>{}<details><summary>{}</summary>"
        "<pre>{}</pre></details></figure>\n",
        is_wide ? " wide" : "", shots, caption_of(figure), t("teach.commands"), commands);
}

std::string PageMaker::plot(const Plot& plot, const Figure& figure) {
    const std::string uri =
        "data:image/svg+xml;base64," + base::base64(svg_of(plot, texts_->language(), answers_));
    const std::string& title = plot.title.in(texts_->language());
    return fmt::format("<figure class=\"plot\">{}{}</figure>\n",
                       image(uri, {760, 600}, figure.caption.empty() ? title : figure.caption),
                       caption_of(figure));
}

base::Result<std::string> PageMaker::live(const Live& live, const Figure& figure) {
    const auto config = live_config(live, *texts_);
    if (!config) return tl::unexpected(config.error());
    return fmt::format(
        "<figure id=\"live\"><div class=\"models\"></div><div class=\"panes\"><canvas "
        "class=\"ball\" "
        "role=\"img\" aria-label=\"{}\"></canvas><canvas class=\"curve\" role=\"img\" "
        "aria-label=\"{}\"></canvas></div><div class=\"controls\"></div><table "
        "class=\"values\"></table>{}"
        "<script type=\"application/json\" id=\"live-config\">{}</script></figure>\n",
        t("teach.live_ball"), t("teach.live_curve"), caption_of(figure), embedded(*config));
}

base::Result<std::string> PageMaker::figure(const Lesson& lesson, const Figure& figure) {
    if (figure.kind == "strip") {
        const Strip* found = named(lesson.strips, figure.name);
        return found == nullptr ? no_such(figure, lesson.strips) : strip(*found, figure);
    }
    if (figure.kind == "plot") {
        const Plot* found = named(lesson.plots, figure.name);
        if (found == nullptr) return no_such(figure, lesson.plots);
        return plot(*found, figure);
    }
    if (figure.kind == "number") {
        const Number* found = named(lesson.numbers, figure.name);
        if (found == nullptr) return no_such(figure, lesson.numbers);
        return fmt::format("<span class=\"number\">{}</span>",
                           written(*found, answers_(found->ask)));
    }
    if (figure.kind == "live" && lesson.live) return live(*lesson.live, figure);
    return base::fail(
        {.code = base::ErrorCode::input_invalid,
         .what = "no such figure",
         .found = figure.kind + ":" + figure.name,
         .remedy = "strip:NAME, plot:NAME, number:NAME or live:canvas, with NAME in lesson.json"});
}

std::string PageMaker::numbers(const Lesson& lesson) {
    if (lesson.numbers.empty()) return {};
    std::string rows;
    for (const Number& number : lesson.numbers) {
        const std::string command = command_of(number.ask);
        rows +=
            fmt::format("<tr><td>{}</td><td class=\"value\">{}</td><td>{}</td></tr>",
                        base::markup_escaped(number.label.in(texts_->language())),
                        written(number, answers_(number.ask)),
                        command.empty() ? "" : "<pre>" + base::markup_escaped(command) + "</pre>");
    }
    return fmt::format(
        "<h2>{}</h2><p>{}</p><div class=\"table\"><table "
        "class=\"numbers\"><tbody>{}</tbody></table></div>\n",
        t("teach.numbers"), t("teach.numbers_note"), rows);
}

std::string PageMaker::whole(const std::string& title, const std::string& nav,
                             const std::string& body, bool is_live) const {
    // Nothing may be fetched from anywhere: the page holds all it needs.
    return fmt::format(
        "<!DOCTYPE html>\n<html lang=\"{}\">\n<head>\n<meta charset=\"utf-8\">\n"
        "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
        "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; style-src "
        "'unsafe-inline'; "
        "script-src 'unsafe-inline'; img-src data:\">\n<meta name=\"generator\" "
        "content=\"Facet\">\n"
        "<title>{}</title>\n<style>\n{}</style>\n</head>\n<body>\n<header>{}</header>\n<main>\n{}</"
        "main>\n"
        "<footer>{}</footer>\n{}</body>\n</html>\n",
        texts_->language(), base::markup_escaped(title), style_, nav, body, t("teach.footer"),
        is_live ? "<script>\n" + script_ + "</script>\n" : "");
}

base::Result<std::string> PageMaker::lesson_page(const Lesson& lesson, const PageLinks& links) {
    const auto text = lesson.texts.find(texts_->language());
    const std::string file = (lesson.folder / (texts_->language() + ".md")).string();
    const std::string json = (lesson.folder / "lesson.json").string();
    if (text == lesson.texts.end())
        return base::fail(
            {.code = base::ErrorCode::input_invalid, .file = file, .what = "no such text"});
    bool is_live = false;
    const auto article = html_of(text->second, [&](const Figure& one) {
        is_live = is_live || one.kind == "live";
        return figure(lesson, one);
    });
    if (!article)
        return tl::unexpected(base::in_file(
            article.error(), article.error().where.starts_with("/strips/") ? json : file));
    const std::string title = lesson.title(texts_->language());
    const std::string nav =
        fmt::format("<nav>{}<a href=\"index.html\">{}</a>{}</nav>", link(links.before, "← ", ""),
                    t("teach.all_lessons"), link(links.after, "", " →"));
    return whole(
        title, nav,
        fmt::format("<h1>{}</h1>\n{}{}", base::markup_escaped(title), *article, numbers(lesson)),
        is_live);
}

base::Result<std::string> PageMaker::index_page(std::span<const Lesson> lessons) {
    std::string cards;
    for (const Lesson& lesson : lessons) {
        std::string picture;
        if (lesson.cover) {
            const auto shot = gallery_->shot(*lesson.cover);
            if (!shot) return tl::unexpected(shot.error());
            picture = image((*shot)->data_uri, (*shot)->size, "");
        }
        cards += fmt::format("<li><a href=\"{}.html\">{}<b>{}</b><span>{}</span></a></li>\n",
                             base::markup_escaped(lesson.name), picture,
                             base::markup_escaped(lesson.title(texts_->language())),
                             base::markup_escaped(summary_of(lesson, texts_->language())));
    }
    return whole(std::string(t("teach.title")), "",
                 fmt::format("<h1>{}</h1>\n<p>{}</p>\n<ul class=\"cards\">\n{}</ul>\n",
                             t("teach.title"), t("teach.introduction"), cards),
                 false);
}

}  // namespace facet::teach
