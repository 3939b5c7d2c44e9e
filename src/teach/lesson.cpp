// A lesson as its folder says.
// SPDX-License-Identifier: MIT
#include "teach/lesson.h"

#include "base/file.h"
#include "base/resources.h"
#include "base/text.h"
#include "base/texts.h"
#include "brdf/choice.h"
#include "tables/aovs.h"
#include "tables/settings_json.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <span>

namespace facet::teach {
namespace {

namespace fs = std::filesystem;

constexpr tables::Range any{-1e30F, 1e30F};

constexpr LiveSlider sliders[] = {
    {"roughness", 0.03, 1.0, 0.01, 0.4},   {"metallic", 0.0, 1.0, 0.01, 0.0},
    {"f0", 0.0, 1.0, 0.005, 0.04},         {"base", 0.0, 1.0, 0.01, 0.8},
    {"view_deg", 0.0, 89.0, 1.0, 45.0},    {"light_deg", -89.0, 89.0, 1.0, 45.0},
    {"azimuth_deg", 0.0, 180.0, 1.0, 0.0}, {"intensity", 0.1, 10.0, 0.05, 1.0},
};
constexpr std::string_view views[] = {"full", "specular", "diffuse", "D",       "G",      "F", "kd",
                                      "ks",   "n_dot_h",  "n_dot_l", "n_dot_v", "v_dot_h"};
constexpr std::string_view curves[] = {"lobe", "D", "F", "G"};

/// Members that are the lesson's own among those of a picture; the rest are settings.
bool is_own(std::string_view key) { return key == "scene" || key == "label" || key == "show"; }

void read_picture(Fields& fields, const Json& json, Picture& picture) {
    const std::string scene = fields.text("scene", picture.scene);
    if (scene != picture.scene) {  // paths and materials are those of a scene
        picture.settings.set.clear();
        picture.settings.material.clear();
    }
    picture.scene = scene;
    if (const Localized label = fields.label("label"); !label.empty()) picture.label = label;
    picture.show = fields.text("show", picture.show);
    if (!picture.show.empty() && !tables::aov_named(picture.show)) {
        std::vector<std::string> names;
        for (const tables::AovRow& row : tables::aovs) names.emplace_back(row.key);
        fields.refuse("show", "no such AOV", picture.show, base::suggestion(picture.show, names));
    }
    if (!json.is_object()) return;
    for (const auto& [key, value] : json.items()) {
        if (is_own(key) || fields.is_known(key)) continue;
        if (const auto set = tables::assign_json(picture.settings, key, *fields.find(key)); !set)
            fields.keep(set.error(), key);
    }
}

/// "over": one setting, or one path of `set`, takes each of the values in turn.
struct Sweep {
    std::string key;
    std::string path;  ///< where the key is "set"
    Json values = Json::array();
    std::string label;  ///< with {} for the value
};

Sweep read_sweep(Fields& strip) {
    Sweep out;
    const Json* over = strip.find("over");
    if (over == nullptr) return out;
    Fields fields(*over, strip.pointer_to("over"));
    out.key = fields.text("key", "");
    out.path = fields.text("path", "");
    out.values = fields.array("values");
    out.label = fields.text("label", "{}");
    if (out.key.empty() == out.path.empty())
        fields.refuse("", "needs either key or path", over->dump());
    if (const auto done = fields.finish(); !done) strip.keep(done.error(), "over");
    return out;
}

Picture swept(const Picture& usual, const Sweep& sweep, const Json& value, Fields& strip) {
    Picture picture = usual;
    const std::string key = sweep.path.empty() ? sweep.key : "set";
    const Json assigned = sweep.path.empty() ? value : Json{{sweep.path, value}};
    if (const auto set = tables::assign_json(picture.settings, key, assigned); !set)
        strip.keep(set.error(), "over");
    std::string text = sweep.label;
    if (const std::size_t at = text.find("{}"); at != std::string::npos)
        text.replace(at, 2, value.is_string() ? value.get<std::string>() : value.dump());
    picture.label.texts = {{"", text}};
    return picture;
}

Strip read_strip(const std::string& name, const Json& json, const std::string& pointer,
                 const Picture& usual, Fields& lesson) {
    Strip strip{.name = name, .pictures = {}};
    Fields fields(json, pointer);
    Picture own = usual;
    const Json& list = fields.array("pictures");
    const Sweep sweep = read_sweep(fields);
    read_picture(fields, json, own);
    for (std::size_t i = 0; i < list.size(); ++i) {
        Fields one(list[i], fmt::format("{}/pictures/{}", pointer, i));
        Picture picture = own;
        read_picture(one, list[i], picture);
        if (const auto done = one.finish(); !done) fields.keep(done.error(), "pictures");
        strip.pictures.push_back(std::move(picture));
    }
    for (const Json& value : sweep.values)
        strip.pictures.push_back(swept(own, sweep, value, fields));
    if (strip.pictures.empty()) strip.pictures.push_back(own);
    if (const auto done = fields.finish(); !done) lesson.keep(done.error(), "strips");
    return strip;
}

PlotAxis read_axis(Fields& plot, std::string_view key) {
    PlotAxis axis;
    const Json* json = plot.find(key);
    if (json == nullptr) return axis;
    Fields fields(*json, plot.pointer_to(key));
    axis.label = fields.label("label");
    if (json->is_object() && json->contains("low")) axis.low = fields.number("low", 0, any);
    if (json->is_object() && json->contains("high")) axis.high = fields.number("high", 1, any);
    axis.logarithmic = fields.flag("logarithmic", false);
    if (axis.logarithmic && axis.low && *axis.low <= 0.0)
        fields.refuse("low", "a logarithmic axis starts above 0", json->dump());
    if (const auto done = fields.finish(); !done) plot.keep(done.error(), key);
    return axis;
}

Plot read_plot(const std::string& name, const Json& json, const std::string& pointer,
               Fields& lesson) {
    Plot plot{.name = name};
    Fields fields(json, pointer);
    plot.title = fields.label("title");
    plot.polar = fields.flag("polar", false);
    plot.variable = fields.text("over", plot.polar ? "theta_l" : "");
    if (Ask probe; !set_variable(probe, plot.variable, 0.5))
        fields.refuse("over", "no such variable", plot.variable,
                      base::suggestion(plot.variable, variable_names()));
    plot.x = read_axis(fields, "x");
    plot.y = read_axis(fields, "y");
    const Json& list = fields.array("curves");
    const Ask usual = read_ask(fields, {});
    for (std::size_t i = 0; i < list.size(); ++i) {
        Fields one(list[i], fmt::format("{}/curves/{}", pointer, i));
        PlotCurve curve{.label = one.label("label"), .ask = read_ask(one, usual), .color = i};
        curve.color = static_cast<std::size_t>(one.number("color", static_cast<double>(i), {0, 7}));
        curve.dash = static_cast<std::size_t>(one.number("dash", 0, {0, 2}));
        if (const auto done = one.finish(); !done) fields.keep(done.error(), "curves");
        plot.curves.push_back(std::move(curve));
    }
    if (plot.curves.empty()) fields.refuse("curves", "a plot has a curve at least", name);
    if (const auto done = fields.finish(); !done) lesson.keep(done.error(), "plots");
    return plot;
}

Number read_number(const std::string& name, const Json& json, const std::string& pointer,
                   Fields& lesson) {
    Number number{.name = name};
    Fields fields(json, pointer);
    number.label = fields.label("label");
    if (number.label.empty()) fields.refuse("label", "a number needs a label", name);
    number.digits = static_cast<int>(fields.number("digits", 4, {0, 9}));
    number.percent = fields.flag("percent", false);
    if (const Json* row = fields.find("reference")) {
        Fields table(*row, pointer + "/reference");
        number.reference =
            TableRow{table.text("table", ""), table.object("inputs"), table.text("output", "")};
        if (const auto done = table.finish(); !done) fields.keep(done.error(), "reference");
    }
    number.ask = read_ask(fields, {});
    if (const auto done = fields.finish(); !done) lesson.keep(done.error(), "numbers");
    return number;
}

/// The picture of the lesson on the index: one of a strip.
void read_cover(Fields& lesson, Lesson& out) {
    const Json* json = lesson.find("cover");
    const Strip* shown = out.strips.empty() ? nullptr : &out.strips.front();
    std::size_t index = shown == nullptr ? 0 : shown->pictures.size() / 2;
    if (json != nullptr) {
        Fields fields(*json, "/cover");
        const std::string name = fields.text("strip", "");
        index = static_cast<std::size_t>(fields.number("picture", 0, {0, 1000}));
        const auto found = std::ranges::find(out.strips, name, &Strip::name);
        shown = found == out.strips.end() ? nullptr : &*found;
        if (shown == nullptr || index >= shown->pictures.size())
            fields.refuse("strip", "no such picture", json->dump());
        if (const auto done = fields.finish(); !done) return lesson.keep(done.error(), "cover");
    }
    if (shown != nullptr) out.cover = shown->pictures[index];
}

template <class Names>
void check_names(Fields& fields, std::string_view key, const std::vector<std::string>& given,
                 const Names& allowed) {
    const std::vector<std::string> names(allowed.begin(), allowed.end());
    for (const std::string& name : given)
        if (std::ranges::find(names, name) == names.end())
            fields.refuse(key, "no such name", name, base::suggestion(name, names));
}

Live read_live(const Json& json, Fields& lesson) {
    Live live;
    Fields fields(json, "/live");
    live.sliders = fields.texts("sliders");
    live.switches = fields.texts("switches");
    live.models = fields.texts("models");
    live.views = fields.texts("views");
    live.curve = fields.text("curve", "lobe");
    live.initial = fields.object("initial");
    live.furnace = fields.flag("furnace", false);
    std::vector<std::string> slider_names, slots;
    for (const LiveSlider& slider : sliders) slider_names.emplace_back(slider.name);
    for (const tables::BrdfSlot& slot : tables::brdf_slots) slots.emplace_back(slot.key);
    std::vector<std::string> set;
    for (const auto& [key, value] : live.initial.items()) {
        set.push_back(key);
        if (!value.is_number()) fields.refuse("initial", "not a number", value.dump());
    }
    check_names(fields, "sliders", live.sliders, slider_names);
    check_names(fields, "initial", set, slider_names);
    check_names(fields, "switches", live.switches, slots);
    check_names(fields, "views", live.views, std::span(views));
    check_names(fields, "curve", {live.curve}, std::span(curves));
    for (const std::string& model : live.models)
        if (const auto choice = brdf::parse_choice(model, brdf::Use::lesson); !choice)
            fields.keep(choice.error(), "models");
    if (const auto done = fields.finish(); !done) lesson.keep(done.error(), "live");
    return live;
}

base::Result<fs::path> lessons_folder() {
    const auto folder = base::data_folder();
    if (!folder) return tl::unexpected(folder.error());
    return *folder / "resources" / "lessons";
}

}  // namespace

std::span<const LiveSlider> live_sliders() { return sliders; }
std::span<const std::string_view> live_views() { return views; }
std::span<const std::string_view> live_curves() { return curves; }

std::string Lesson::title(std::string_view language) const {
    const auto text = texts.find(language);
    if (text == texts.end()) return name;
    for (const std::string_view line : base::split(text->second, '\n'))
        if (line.starts_with("# ")) return std::string(base::trimmed(line.substr(2)));
    return name;
}

base::Status parse_lesson(std::string_view text, Lesson& out) {
    const Json json = Json::parse(text.begin(), text.end(), nullptr, false);
    if (json.is_discarded())
        return base::fail({.code = base::ErrorCode::input_invalid, .what = "not JSON"});
    Fields fields(json, "");
    if (fields.number("facet", 0, {0, 1}) != 1.0)
        fields.refuse("facet", "is not 1", "", R"("facet": 1)");
    out.order = fields.number("order", 1e6, {0, 1e6F});
    Picture usual{.scene = "builtin:ball"};
    if (const Json* defaults = fields.find("defaults")) {
        Fields own(*defaults, "/defaults");
        read_picture(own, *defaults, usual);
        if (const auto done = own.finish(); !done) fields.keep(done.error(), "defaults");
    }
    for (const auto& [name, strip] : fields.object("strips").items())
        out.strips.push_back(read_strip(name, strip, "/strips/" + name, usual, fields));
    read_cover(fields, out);
    for (const auto& [name, plot] : fields.object("plots").items())
        out.plots.push_back(read_plot(name, plot, "/plots/" + name, fields));
    for (const auto& [name, number] : fields.object("numbers").items())
        out.numbers.push_back(read_number(name, number, "/numbers/" + name, fields));
    if (const Json* live = fields.find("live")) out.live = read_live(*live, fields);
    if (const Json* studio = fields.find("studio")) {
        Fields own(*studio, "/studio");
        Picture opened = usual;  // of a page's pictures only their light, not their shape
        opened.settings.size = tables::Settings{}.size;
        opened.settings.background = tables::Settings{}.background;
        read_picture(own, *studio, opened);
        if (const auto done = own.finish(); !done) fields.keep(done.error(), "studio");
        out.studio = std::move(opened);
    }
    return fields.finish();
}

base::Result<Lesson> read_lesson(const fs::path& folder) {
    Lesson lesson;
    lesson.folder = folder;
    lesson.name = fs::absolute(folder / "x").parent_path().filename().string();
    for (const std::string_view language : base::languages) {
        auto text = base::read_text_file(folder / fmt::format("{}.md", language), most_file_bytes);
        if (!text) return tl::unexpected(text.error());
        lesson.texts[std::string(language)] = std::move(*text);
    }
    const fs::path path = folder / "lesson.json";
    const auto json = base::read_text_file(path, most_file_bytes);
    if (!json) return tl::unexpected(json.error());
    if (auto parsed = parse_lesson(*json, lesson); !parsed)
        return tl::unexpected(base::in_file(parsed.error(), path.string()));
    return lesson;
}

std::vector<std::string> lesson_names() {
    std::vector<std::string> names;
    const auto folder = lessons_folder();
    std::error_code error;
    if (folder)
        for (const auto& entry : fs::directory_iterator(*folder, error))
            if (fs::exists(entry.path() / "lesson.json", error))
                names.push_back(entry.path().filename().string());
    std::ranges::sort(names);
    return names;
}

base::Result<std::vector<Lesson>> all_lessons() {
    const auto folder = lessons_folder();
    if (!folder) return tl::unexpected(folder.error());
    std::vector<Lesson> lessons;
    for (const std::string& name : lesson_names()) {
        auto lesson = read_lesson(*folder / name);
        if (!lesson) return tl::unexpected(lesson.error());
        lessons.push_back(std::move(*lesson));
    }
    std::ranges::stable_sort(lessons, {}, &Lesson::order);
    return lessons;
}

base::Result<Lesson> find_lesson(std::string_view name) {
    const std::vector<std::string> names = lesson_names();
    if (std::ranges::find(names, name) != names.end()) return read_lesson(*lessons_folder() / name);
    std::error_code error;
    if (fs::is_directory(fs::path(name), error)) return read_lesson(fs::path(name));
    return base::fail({.code = base::ErrorCode::usage,
                       .what = "no such lesson",
                       .found = std::string(name),
                       .remedy = base::suggestion(name, names) + "; facet teach --list lessons"});
}

}  // namespace facet::teach
