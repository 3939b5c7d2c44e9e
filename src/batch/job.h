// A batch as its job file describes it: groups of pictures, each the product of some axes; items
// are worked out one at a time, so that a hundred thousand cost nothing until they are rendered.
// SPDX-License-Identifier: MIT
#pragma once

#include "batch/name_template.h"
#include "tables/settings.h"

#include <nlohmann/json.hpp>

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace facet::batch {

using Json = nlohmann::ordered_json;

/// One line, whatever stands in its texts.
[[nodiscard]] inline std::string text_of(const Json& json) {
    return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

/// What a value of an axis sets.
enum class AxisKind { scene, setting, path, frame };

/// One list of values that the pictures of a group run through. `key` is a setting's key, or a path
/// of --set for AxisKind::path.
struct Axis {
    AxisKind kind = AxisKind::setting;
    std::string key;
    std::string pointer;              ///< of the list in the job file
    std::vector<Json> values;         ///< as tables::assign_json takes them
    std::vector<std::string> labels;  ///< as file names and reports have them
};

/// A number, vector or name drawn anew for every item: {"random": [0, 1]} without a count.
struct Draw {
    AxisKind kind = AxisKind::setting;
    std::string key;
    std::string pointer;
    Json from;  ///< [low, high], of numbers or vectors, or texts to choose from
    std::uint64_t seed = 0;
};

/// Lets a value of an axis or a draw say what it says; scenes and frames are no settings, and pass.
/// Errors: as tables::assign_json.
[[nodiscard]] base::Status apply(AxisKind kind, const std::string& key, const Json& value,
                                 tables::Settings& settings);

/// frames: {"orbit": 36}, or {"animation": "Walk", "fps": 24}.
struct Sequence {
    std::size_t frame_count = 0;
    double fps = 24.0;
    std::optional<std::string> animation;  ///< that is played; none: the camera turns
};

/// The product of `axes` over one set of settings; the last axis varies fastest.
struct Group {
    tables::Settings settings;  ///< what does not vary
    std::string scene;          ///< where it does not vary
    NameTemplate output;
    std::vector<Axis> axes;
    std::vector<Draw> draws;
    std::optional<Sequence> sequence;
    std::vector<std::pair<std::string, std::string>> fixed;  ///< key -> label of what was set
    std::size_t first_index = 0;
    std::size_t item_count = 0;
};

/// One picture.
struct Item {
    std::size_t index = 0;
    std::string scene;
    tables::Settings settings;
    std::filesystem::path output;
    std::optional<std::size_t> frame;  ///< of a sequence; `index - frame` is its first item
    std::vector<std::pair<std::string, std::string>> varied;  ///< key -> label
};

/// Where the data set's tables go; paths in them are relative to that folder.
struct DataSet {
    std::filesystem::path folder;
};

class Job {
public:
    std::filesystem::path file;    ///< the job file, as named
    std::filesystem::path folder;  ///< what its paths are relative to
    std::string text_hash;         ///< SHA-256 of the job file
    std::vector<Group> groups;
    std::optional<DataSet> data_set;

    [[nodiscard]] std::size_t item_count() const;
    /// Item `index` of [0, item_count()). Errors: usage (a value that only this combination shows
    /// to be wrong).
    [[nodiscard]] base::Result<Item> item(std::size_t index) const;
    /// Its output alone, cheaper.
    [[nodiscard]] std::filesystem::path output_of(std::size_t index) const;
    [[nodiscard]] const std::string& scene_of(std::size_t index) const;
    /// The ffmpeg commands that make films of the sequences that `items` begin.
    [[nodiscard]] std::vector<std::string> films(std::span<const std::size_t> items) const;

    /// Indices of all items so that those of one scene lie together, and the frames of a sequence
    /// in a row.
    [[nodiscard]] std::vector<std::size_t> by_scene() const;

private:
    struct Place;
    [[nodiscard]] Place place_of(std::size_t index) const;
    [[nodiscard]] std::string label_of(const Place& place, std::string_view key) const;
    [[nodiscard]] std::filesystem::path output_of(const Place& place) const;
};

/// Shard `index` of `count` takes its own run of the items in by_scene(): disjoint, complete, and
/// of sizes that differ by one at most.
struct Shard {
    std::size_t index = 0;
    std::size_t count = 1;
};
[[nodiscard]] std::vector<std::size_t> items_of(const Job& job, const Shard& shard);

}  // namespace facet::batch
