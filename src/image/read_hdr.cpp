// Reads Radiance pictures (RGBE): new and old run lengths, flat, any order of axes, EXPOSURE
// undone. SPDX-License-Identifier: MIT
#include "base/text.h"
#include "image/bytes.h"
#include "image/checks.h"
#include "image/dispatch.h"
#include "image/hdr_scanlines.h"

#include <spdlog/fmt/fmt.h>

#include <array>
#include <charconv>
#include <cmath>
#include <cstring>
#include <string>
#include <utility>

namespace facet::image::hdr {
namespace {

constexpr std::size_t line_limit = 4096;
constexpr std::size_t header_limit = std::size_t{1} << 20;

struct Preamble {
    math::Extent size;
    bool rows_are_columns = false;  ///< the first axis named is X: a scanline runs down the picture
    bool flip_x = false;
    bool flip_y = false;
    bool has_format = false;
    double exposure = 1.0;
    std::array<double, 3> color_correction{1.0, 1.0, 1.0};
    std::vector<std::pair<std::string, std::string>> metadata;
    std::size_t pixels_at = 0;
};

base::Result<std::string_view> line_at(FileBytes file, std::size_t& at) {
    const std::string_view rest = text_of(file.subspan(at)).substr(0, line_limit);
    const std::size_t end = rest.find('\n');
    if (end == std::string_view::npos || at > header_limit)
        return damaged(at, "the header does not end");
    at += end + 1;
    return base::trimmed(rest.substr(0, end));
}

/// Positive and finite, or the picture would turn black or infinite.
std::optional<double> factor(std::string_view text) {
    const auto number = base::parse_number(base::trimmed(text));
    if (!number || !(*number > 1e-30) || !(*number < 1e30)) return std::nullopt;
    return number;
}

base::Status read_variable(std::string_view line, std::size_t at, Preamble& out) {
    const std::size_t equals = line.find('=');
    if (line.starts_with("#") || equals == std::string_view::npos) return {};
    const std::string_view key = line.substr(0, equals);
    const std::string_view value = base::trimmed(line.substr(equals + 1));
    if (key == "FORMAT") {
        if (value == "32-bit_rle_xyze") return unsupported("a picture in XYZE", "XYZE");
        if (value != "32-bit_rle_rgbe") return damaged(at, "unknown FORMAT=", std::string(value));
        out.has_format = true;
    } else if (key == "EXPOSURE") {  // may stand several times; the product counts
        const auto number = factor(value);
        if (!number) return damaged(at, "EXPOSURE is no positive number", std::string(value));
        out.exposure *= *number;
    } else if (key == "COLORCORR") {
        std::size_t channel = 0;
        for (const std::string_view word : base::split(value, ' ')) {
            if (base::trimmed(word).empty()) continue;
            const auto number = factor(word);
            if (!number || channel == 3)
                return damaged(at, "COLORCORR is not three positive numbers", std::string(value));
            out.color_correction[channel++] *= *number;
        }
    } else {
        out.metadata.emplace_back(key, value);
    }
    return {};
}

/// Takes "-Y" or "+X" and a count off the front of `text`; nothing where there is none.
struct Axis {
    char name = 0;
    bool is_negative = false;
    std::uint64_t count = 0;
};
std::optional<Axis> take_axis(std::string_view& text) {
    text = base::trimmed(text);
    if (text.size() < 4 || (text[0] != '-' && text[0] != '+')) return std::nullopt;
    if (text[1] != 'X' && text[1] != 'Y') return std::nullopt;
    Axis axis{text[1], text[0] == '-', 0};
    text = base::trimmed(text.substr(2));
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), axis.count);
    if (error != std::errc{}) return std::nullopt;
    text.remove_prefix(static_cast<std::size_t>(end - text.data()));
    return axis;
}

base::Status read_resolution(std::string_view line, std::size_t at, const base::Limits& limits,
                             Preamble& out) {
    std::string_view rest = line;
    const auto first = take_axis(rest);
    const auto second = first ? take_axis(rest) : std::nullopt;
    if (!second || first->name == second->name || !base::trimmed(rest).empty())
        return damaged(at, "the line with the resolution is malformed", std::string(line));
    out.rows_are_columns = first->name == 'X';
    const Axis& x = out.rows_are_columns ? *first : *second;
    const Axis& y = out.rows_are_columns ? *second : *first;
    if (auto checked = check_size({x.count, y.count}, 3 * sizeof(float), limits); !checked)
        return checked;
    out.flip_x = x.is_negative;
    out.flip_y = !y.is_negative;  // +Y counts from the bottom
    out.size = {static_cast<std::uint32_t>(x.count), static_cast<std::uint32_t>(y.count)};
    return {};
}

base::Result<Preamble> read_preamble(FileBytes file, const base::Limits& limits) {
    Preamble out;
    std::size_t at = 0;
    auto line = line_at(file, at);
    while (true) {
        const std::size_t start = at;
        line = line_at(file, at);
        if (!line) return tl::unexpected(line.error());
        if (line->empty()) break;
        if (auto read = read_variable(*line, start, out); !read)
            return tl::unexpected(read.error());
    }
    if (!out.has_format) return damaged(at, "the header has no FORMAT=32-bit_rle_rgbe");
    const std::size_t start = at;
    line = line_at(file, at);
    if (!line) return tl::unexpected(line.error());
    if (auto read = read_resolution(*line, start, limits, out); !read)
        return tl::unexpected(read.error());
    out.pixels_at = at;
    return out;
}

/// Factor by exponent byte: mantissa * 2^(e - 136) (Ward 1991); 0 for e = 0. Per channel, exposure
/// undone.
using ScaleTable = std::array<std::array<float, 3>, 256>;
ScaleTable scales(const Preamble& preamble) {
    ScaleTable table{};
    for (std::size_t e = 1; e < 256; ++e)
        for (std::size_t c = 0; c < 3; ++c)
            table[e][c] = static_cast<float>(
                std::ldexp(1.0 / (preamble.exposure * preamble.color_correction[c]),
                           static_cast<int>(e) - 136));
    return table;
}

/// Where a scanline's pixels go: the first, and the step to the next, in floats.
struct Target {
    float* first = nullptr;
    std::ptrdiff_t step = 0;
};
Target target(Image& image, const Preamble& preamble, std::uint32_t scanline) {
    const auto width = static_cast<std::ptrdiff_t>(image.size.width);
    const auto height = static_cast<std::ptrdiff_t>(image.size.height);
    std::ptrdiff_t x = preamble.rows_are_columns ? static_cast<std::ptrdiff_t>(scanline) : 0;
    std::ptrdiff_t y = preamble.rows_are_columns ? 0 : static_cast<std::ptrdiff_t>(scanline);
    if (preamble.flip_x) x = width - 1 - x;
    if (preamble.flip_y) y = height - 1 - y;
    const std::ptrdiff_t step =
        preamble.rows_are_columns ? (preamble.flip_y ? -width : width) : (preamble.flip_x ? -1 : 1);
    return {image.as<float>().data() + (y * width + x) * 3, step * 3};
}

void convert(const Scanlines& from, std::size_t count, const ScaleTable& table, Target to) {
    const std::uint8_t* r = from.plane(0);
    const std::uint8_t* g = from.plane(1);
    const std::uint8_t* b = from.plane(2);
    const std::uint8_t* e = from.plane(3);
    for (std::size_t i = 0; i < count; ++i, to.first += to.step) {
        const auto& scale = table[e[i]];
        to.first[0] = static_cast<float>(r[i]) * scale[0];
        to.first[1] = static_cast<float>(g[i]) * scale[1];
        to.first[2] = static_cast<float>(b[i]) * scale[2];
    }
}

}  // namespace

bool sniff(FileBytes file) {
    return starts_with(file, "#?RADIANCE") || starts_with(file, "#?RGBE");
}

base::Result<Header> read_header(FileBytes file, const base::Limits& limits) {
    const auto preamble = read_preamble(file, limits);
    if (!preamble) return tl::unexpected(preamble.error());
    return Header{tables::ImageFormat::hdr, preamble->size, 3, Sample::f32};
}

base::Result<Picture> read(FileBytes file, const base::Limits& limits,
                           base::Warnings& /*warnings*/) {
    auto preamble = read_preamble(file, limits);
    if (!preamble) return tl::unexpected(preamble.error());
    const std::uint32_t across =
        preamble->rows_are_columns ? preamble->size.height : preamble->size.width;
    const std::uint32_t scanline_count =
        preamble->rows_are_columns ? preamble->size.width : preamble->size.height;
    // The shortest file of so many scanlines: runs of 127 in new ones, one flat pixel in others
    // (old runs reach any length). Refuses a huge resolution line without its pixels before memory
    // is taken.
    if ((file.size() - preamble->pixels_at) / 4 < scanline_count)
        return damaged(file.size(), "the file is cut short");
    Image image(preamble->size, 3, Sample::f32);
    const ScaleTable table = scales(*preamble);
    Scanlines scanlines(file, preamble->pixels_at, across);
    for (std::uint32_t i = 0; i < scanline_count; ++i) {
        if (auto read = scanlines.next(); !read) return tl::unexpected(read.error());
        convert(scanlines, across, table, target(image, *preamble, i));
    }
    Picture picture = one_layer(tables::ImageFormat::hdr, std::move(image));
    picture.metadata = std::move(preamble->metadata);
    return picture;
}

}  // namespace facet::image::hdr
