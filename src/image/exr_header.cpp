// Parses OpenEXR headers (OpenEXR File Layout, 3.1) with every length checked.
// SPDX-License-Identifier: MIT
#include "image/exr_header.h"

#include "image/bytes.h"
#include "image/checks.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <array>
#include <limits>
#include <string_view>

namespace facet::image::exr {
namespace {

constexpr std::size_t part_limit = 256;
constexpr std::size_t channel_limit = 1024;
constexpr std::uint32_t flag_tiled = 0x200;
constexpr std::uint32_t flag_deep = 0x800;
constexpr std::uint32_t flag_parts = 0x1000;

struct Attribute {
    std::string_view name;
    std::string_view type;
    FileBytes body;
    std::size_t offset = 0;
};

/// Bytes up to the next 0, which is passed over.
base::Result<std::string_view> text_at(FileBytes file, std::size_t& at) {
    const std::string_view rest = text_of(file.subspan(at)).substr(0, 256);
    const std::size_t end = rest.find('\0');
    if (end == std::string_view::npos) return damaged(at, "a name in the header does not end");
    at += end + 1;
    return rest.substr(0, end);
}

base::Result<Attribute> attribute_at(FileBytes file, std::size_t& at) {
    Attribute out;
    out.offset = at;
    const auto name = text_at(file, at);
    if (!name) return tl::unexpected(name.error());
    out.name = *name;
    if (out.name.empty()) return out;
    const auto type = text_at(file, at);
    if (!type) return tl::unexpected(type.error());
    out.type = *type;
    if (file.size() - at < 4) return damaged(at, "the header is cut short");
    const std::uint32_t length = little32(file, at);
    at += 4;
    if (length > file.size() - at)
        return damaged(at, "an attribute is longer than the file", fmt::format("{} bytes", length));
    out.body = file.subspan(at, length);
    at += length;
    return out;
}

base::Status read_channels(const Attribute& attribute, Part& out) {
    const FileBytes body = attribute.body;
    std::size_t at = 0;
    while (at < body.size() && byte_at(body, at) != 0) {
        const auto name = text_at(body, at);
        if (!name || body.size() - at < 16 || out.channels.size() == channel_limit)
            return damaged(attribute.offset, "the list of channels is malformed");
        Channel channel{std::string(*name), little32(body, at),
                        static_cast<std::int32_t>(little32(body, at + 8)),
                        static_cast<std::int32_t>(little32(body, at + 12))};
        at += 16;
        if (channel.type > 2 || channel.x_sampling < 1 || channel.y_sampling < 1)
            return damaged(attribute.offset, "a channel is malformed", channel.name);
        out.channels.push_back(std::move(channel));
    }
    return {};
}

base::Status read_attribute(const Attribute& attribute, Part& out) {
    const FileBytes body = attribute.body;
    const std::string_view name = attribute.name;
    if (name == "channels") return read_channels(attribute, out);
    if (name == "dataWindow" && body.size() == 16)
        for (std::size_t i = 0; i < 4; ++i)
            out.window[i] = static_cast<std::int32_t>(little32(body, i * 4));
    if (name == "compression" && body.size() == 1) out.compression = byte_at(body, 0);
    if (name == "tiles" && body.size() == 9) {
        out.tile[0] = little32(body, 0);
        out.tile[1] = little32(body, 4);
    }
    if (attribute.type != "string") return {};
    if (name == "type")
        out.type = text_of(body);
    else if (name == "name")
        out.name = text_of(body);
    else if (body.size() <= std::size_t{1} << 20)
        out.strings.emplace_back(name, text_of(body));
    return {};
}

std::uint64_t pixel_bytes(const Part& part) {
    return std::max<std::uint64_t>(part.channels.size(), 1) * sizeof(float);
}

base::Status check_window(Part& part, const base::Limits& limits) {
    const auto* w = part.window;
    // Offsets so far out wrap in 32-bit arithmetic on them.
    constexpr std::int32_t far = std::numeric_limits<std::int32_t>::max() / 2;
    if (std::ranges::any_of(part.window, [](std::int32_t v) { return v > far || v < -far; }) ||
        w[2] < w[0] || w[3] < w[1])
        return damaged(0, "the data window is empty or out of range",
                       fmt::format("{} {} to {} {}", w[0], w[1], w[2], w[3]));
    const StatedSize size{static_cast<std::uint64_t>(std::int64_t{w[2]} - w[0] + 1),
                          static_cast<std::uint64_t>(std::int64_t{w[3]} - w[1] + 1)};
    // Once for the pixels, once for the library's own lines or tiles.
    if (auto checked = check_size(size, pixel_bytes(part) * 2, limits); !checked) return checked;
    part.size = {static_cast<std::uint32_t>(size.width), static_cast<std::uint32_t>(size.height)};
    return {};
}

base::Status check_tiles(const Part& part) {
    const std::uint32_t side = std::max({part.size.width, part.size.height, 4096U});
    if (part.tile[0] == 0 || part.tile[1] == 0 || part.tile[0] > side || part.tile[1] > side)
        return damaged(0, "the size of the tiles makes no sense",
                       fmt::format("{}x{}", part.tile[0], part.tile[1]));
    return {};
}

/// The most that one stored byte can become, by compression: none, RLE, ZIPS, ZIP; the others'
/// bounds are unknown.
base::Status check_plausible(const Part& part, std::size_t file_bytes) {
    constexpr std::array<std::uint64_t, 4> ratios{1, 130, 1100, 1100};
    if (part.compression >= ratios.size()) return {};
    std::uint64_t bytes = 0;
    for (const Channel& channel : part.channels) bytes += channel.type == 1 ? 2 : 4;
    if (part.size.pixels() * bytes / ratios[part.compression] > file_bytes)
        return damaged(file_bytes, "the file is too short for its size in pixels",
                       fmt::format("{}x{}", part.size.width, part.size.height));
    return {};
}

base::Status check_part(Part& part, const base::Limits& limits, std::size_t file_bytes) {
    if (part.channels.empty()) return damaged(0, "the header has no channels");
    if (auto checked = check_window(part, limits); !checked) return checked;
    if (part.is_deep) return {};
    if (part.is_tiled)
        if (auto checked = check_tiles(part); !checked) return checked;
    return check_plausible(part, file_bytes);
}

/// What the reader does not do; only the first part must be readable.
base::Status check_supported(const Part& part) {
    if (part.is_deep) return unsupported("a deep EXR, which has no picture yet", "deep");
    if (std::ranges::any_of(part.channels, [](const Channel& c) {
            return c.x_sampling != 1 || c.y_sampling != 1 || c.name == "RY" || c.name == "BY";
        }))
        return unsupported("a luminance-chroma EXR", "subsampled channels");
    return {};
}

base::Result<Part> part_at(FileBytes file, std::size_t& at) {
    Part part;
    while (true) {
        const auto attribute = attribute_at(file, at);
        if (!attribute) return tl::unexpected(attribute.error());
        if (attribute->name.empty()) return part;
        if (auto read = read_attribute(*attribute, part); !read)
            return tl::unexpected(read.error());
    }
}

}  // namespace

base::Result<std::vector<Part>> read_parts(FileBytes file, const base::Limits& limits) {
    if (file.size() < 9) return damaged(file.size(), "the header is cut short");
    const std::uint32_t version = little32(file, 4);
    if ((version & 0xFF) != 2)
        return unsupported("an EXR of a version that is not known",
                           fmt::format("{}", version & 0xFF));
    const bool has_parts = (version & flag_parts) != 0;
    std::vector<Part> parts;
    std::size_t at = 8;
    std::uint64_t total_bytes = 0;
    while (parts.empty() || (has_parts && at < file.size() && byte_at(file, at) != 0)) {
        auto part = part_at(file, at);
        if (!part) return tl::unexpected(part.error());
        part->is_tiled = part->type == "tiledimage" || (version & flag_tiled) != 0;
        part->is_deep =
            part->type.starts_with("deep") || (part->type.empty() && (version & flag_deep) != 0);
        if (auto checked = check_part(*part, limits, file.size()); !checked)
            return tl::unexpected(checked.error());
        total_bytes += part->size.pixels() * pixel_bytes(*part);
        if (parts.size() == part_limit || total_bytes > limits.memory_bytes)
            return base::fail({.code = base::ErrorCode::limit_reached,
                               .where = "header",
                               .what = "too many parts, or too large ones together",
                               .found = fmt::format("{} bytes", total_bytes),
                               .remedy = "raise --max-memory, or keep fewer parts"});
        parts.push_back(std::move(*part));
    }
    if (auto checked = check_supported(parts.front()); !checked)
        return tl::unexpected(checked.error());
    return parts;
}

ChannelPlace place_of(const std::string& name) {
    const std::size_t dot = name.rfind('.');
    if (dot != std::string::npos) return {name.substr(0, dot), name.substr(dot + 1)};
    for (const std::string_view own : {"R", "G", "B", "A", "Y"})
        if (name == own) return {"", name};
    return {name, name};
}

}  // namespace facet::image::exr
