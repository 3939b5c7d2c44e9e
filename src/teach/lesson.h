// A lesson as its folder says: lesson.json and one Markdown text a language. docs/lessons.md
// describes the form. SPDX-License-Identifier: MIT
#pragma once

#include "tables/settings.h"
#include "teach/ask.h"
#include "teach/fields.h"

#include <cstddef>
#include <filesystem>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace facet::teach {

/// Of a lesson's files, and of those that pages are made of.
inline constexpr std::size_t most_file_bytes = std::size_t{1} << 20;

/// One picture of a strip: what `facet render` makes of it, or one of its AOVs.
struct Picture {
    Localized label;
    std::string scene;
    tables::Settings settings;
    std::string show;  ///< an AOV; empty: the picture itself
};

struct Strip {
    std::string name;
    std::vector<Picture> pictures;
};

struct PlotCurve {
    Localized label;
    Ask ask;
    std::size_t color = 0;
    std::size_t dash = 0;
};
struct PlotAxis {
    Localized label;
    std::optional<double> low, high;
    bool logarithmic = false;
};
/// Curves over one variable; a polar one is over theta_l.
struct Plot {
    std::string name;
    Localized title;
    std::string variable;
    bool polar = false;
    PlotAxis x, y;
    std::vector<PlotCurve> curves;
};

/// Where a number can be found independently: a row of a table of reference values.
struct TableRow {
    std::string table;
    Json inputs;
    std::string output;
};
struct Number {
    std::string name;
    Localized label;
    Ask ask;
    int digits = 4;
    bool percent = false;
    std::optional<TableRow> reference;
};

/// The canvas of the page: which of its controls there are, and how they stand at first.
struct Live {
    std::vector<std::string>
        sliders;  ///< roughness metallic f0 base view_deg light_deg azimuth_deg intensity
    std::vector<std::string> switches;  ///< slots of --brdf
    std::vector<std::string> models;    ///< values of --brdf, a button each
    std::vector<std::string> views;     ///< what the ball shows
    std::string curve;                  ///< lobe, D, F or G
    Json initial;                       ///< of sliders
    bool furnace = false;               ///< lit from everywhere instead of by the light
};

struct Lesson {
    std::string name;
    std::filesystem::path folder;
    double order = 0.0;
    std::map<std::string, std::string, std::less<>> texts;  ///< Markdown by language
    std::vector<Strip> strips;
    std::vector<Plot> plots;
    std::vector<Number> numbers;
    std::optional<Live> live;
    std::optional<Picture> cover;   ///< on the index; none: the middle of the first strip
    std::optional<Picture> studio;  ///< what `facet studio --lesson` opens

    [[nodiscard]] std::string title(std::string_view language) const;
};

/// Reads the folder of a lesson. Errors: input_invalid, with file and JSON pointer.
[[nodiscard]] base::Result<Lesson> read_lesson(const std::filesystem::path& folder);
/// lesson.json's text; `out` has its name and texts.
[[nodiscard]] base::Status parse_lesson(std::string_view json, Lesson& out);

/// The program's own lessons in their order.
[[nodiscard]] base::Result<std::vector<Lesson>> all_lessons();
/// Their names, sorted.
[[nodiscard]] std::vector<std::string> lesson_names();
/// One of them by name, or the lesson in a folder of that path. Errors: usage, with the nearest
/// names.
[[nodiscard]] base::Result<Lesson> find_lesson(std::string_view name_or_folder);

/// Sets one control of the canvas has: names and ranges, for lesson.json and the page alike.
struct LiveSlider {
    std::string_view name;
    double low, high, step, initial;
};
[[nodiscard]] std::span<const LiveSlider> live_sliders();
[[nodiscard]] std::span<const std::string_view> live_views();
[[nodiscard]] std::span<const std::string_view> live_curves();

}  // namespace facet::teach
