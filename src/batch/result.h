// What became of an item: one line of a results file.
// SPDX-License-Identifier: MIT
#pragma once

#include "batch/job.h"
#include "render/render.h"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace facet::batch {

/// Where a picture was taken from, for data sets: OpenCV's and NeRF's numbers (docs/batch.md).
struct Shot {
    math::Extent size;
    double focal_x_px = 0.0;  ///< 0: orthographic
    double focal_y_px = 0.0;
    double ortho_height_m = 0.0;  ///< height of the view; 0: perspective
    math::Mat4 world_from_camera{1.0F};
};

struct ItemResult {
    std::size_t item = 0;
    std::string output;   ///< relative to the job's folder where it lies in it
    std::string scene;    ///< likewise
    std::string sha256;   ///< of the output; empty where there is none
    std::string input;    ///< hash of all that the picture depends on, beside the program
    std::string program;  ///< its version and build
    std::optional<base::Error> error;  ///< none: done
    std::vector<std::string> sides;    ///< AOVs in files of their own, as `output`
    render::Times ms;
    std::uint64_t peak_rss = 0;  ///< bytes, of the worker
    unsigned attempts = 1;
    double exposure = 0.0;
    base::Warnings warnings;
    std::optional<Shot> shot;
    std::vector<std::pair<std::string, std::string>> varied;

    [[nodiscard]] bool is_done() const { return !error; }
};

/// One line without its end, whatever stands in its texts.
[[nodiscard]] std::string to_line(const ItemResult& result);
[[nodiscard]] Json to_json(const ItemResult& result);

/// What a later run needs of a line. Errors: input_invalid (not such a line).
struct Record {
    std::size_t item = 0;
    std::string output;
    std::string sha256;
    std::string input;
    std::string program;
    bool is_done = false;
    std::vector<std::string> sides;
    Json json;  ///< the whole line
};
[[nodiscard]] base::Result<Record> parse_record(std::string_view line, const base::Limits& limits);

}  // namespace facet::batch
