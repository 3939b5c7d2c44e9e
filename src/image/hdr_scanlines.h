// The scanlines of a Radiance picture: run lengths undone, bytes by channel.
// SPDX-License-Identifier: MIT
#pragma once

#include "base/result.h"
#include "image/dispatch.h"

#include <cstdint>
#include <vector>

namespace facet::image::hdr {

/// Scanlines of RGBE, one after another from byte `at` of the file, each `width` long.
class Scanlines {
public:
    Scanlines(FileBytes file, std::size_t at, std::size_t width)
        : file_(file), at_(at), width_(width), planes_(width * 4) {}

    /// R, G, B or E (0 to 3) of the scanline that next() read; until the next call.
    [[nodiscard]] const std::uint8_t* plane(std::size_t channel) const {
        return planes_.data() + channel * width_;
    }
    /// Errors: input_invalid at the offset of a run that leaves its scanline, or of the file's end.
    [[nodiscard]] base::Status next();

private:
    [[nodiscard]] base::Status read_plane(std::size_t channel);
    [[nodiscard]] base::Status read_flat_or_old();
    [[nodiscard]] std::uint8_t byte(std::size_t ahead) const {
        return std::to_integer<std::uint8_t>(file_[at_ + ahead]);
    }

    FileBytes file_;
    std::size_t at_;
    std::size_t width_;
    std::vector<std::uint8_t> planes_;
};

}  // namespace facet::image::hdr
