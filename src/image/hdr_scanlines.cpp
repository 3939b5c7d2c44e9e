// Undoes the run lengths of Radiance pictures, new and old.
// SPDX-License-Identifier: MIT
#include "image/hdr_scanlines.h"

#include "image/checks.h"

#include <spdlog/fmt/fmt.h>

#include <cstring>

namespace facet::image::hdr {

base::Status Scanlines::next() {
    // New run lengths (Ward 1991, Graphics Gems II.5): 2, 2, and the width in the two bytes
    // left.
    if (width_ >= 8 && width_ < 32768 && file_.size() - at_ >= 4 && byte(0) == 2 && byte(1) == 2 &&
        byte(2) < 128) {
        if ((std::size_t{byte(2)} << 8 | byte(3)) != width_)
            return damaged(at_, "a scanline of another width",
                           fmt::format("{}", byte(2) << 8 | byte(3)));
        at_ += 4;
        for (std::size_t channel = 0; channel < 4; ++channel)
            if (auto read = read_plane(channel); !read) return read;
        return {};
    }
    return read_flat_or_old();
}

base::Status Scanlines::read_plane(std::size_t channel) {
    std::uint8_t* to = planes_.data() + channel * width_;
    std::size_t left = width_;
    while (left > 0) {
        if (file_.size() - at_ < 2) return damaged(at_, "the file is cut short");
        const std::size_t code = byte(0);
        const std::size_t count = code > 128 ? code - 128 : code;
        if (count == 0 || count > left)
            return damaged(at_, "a run that leaves its scanline", fmt::format("{}", count));
        if (code > 128) {
            std::memset(to, byte(1), count);
            at_ += 2;
        } else {
            if (file_.size() - at_ - 1 < count) return damaged(at_, "the file is cut short");
            std::memcpy(to, file_.data() + at_ + 1, count);
            at_ += 1 + count;
        }
        to += count;
        left -= count;
    }
    return {};
}

/// Pixels of 4 bytes; 1 1 1 n repeats the pixel before n times, and n of consecutive ones are
/// digits of base 256, lowest first (Ward 1991, the older run lengths).
base::Status Scanlines::read_flat_or_old() {
    std::size_t x = 0;
    unsigned shift = 0;
    while (x < width_) {
        if (file_.size() - at_ < 4) return damaged(at_, "the file is cut short");
        if (byte(0) == 1 && byte(1) == 1 && byte(2) == 1) {
            const std::size_t count = shift < 32 ? std::size_t{byte(3)} << shift : width_ + 1;
            if (x == 0 || count > width_ - x)
                return damaged(at_, "a run that leaves its scanline", fmt::format("{}", count));
            for (std::size_t channel = 0; channel < 4; ++channel) {
                std::uint8_t* to = planes_.data() + channel * width_ + x;
                std::memset(to, to[-1], count);
            }
            x += count;
            shift += 8;
        } else {
            for (std::size_t channel = 0; channel < 4; ++channel)
                planes_[channel * width_ + x] = byte(channel);
            ++x;
            shift = 0;
        }
        at_ += 4;
    }
    return {};
}

}  // namespace facet::image::hdr
