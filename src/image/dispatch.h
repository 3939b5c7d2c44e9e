// The codecs by format: the row of image_formats.def and its reader and writer, brought together.
// SPDX-License-Identifier: MIT
#pragma once

#include "base/file.h"
#include "base/limits.h"
#include "base/result.h"
#include "image/read.h"
#include "image/write.h"
#include "tables/image_formats.h"

#include <array>
#include <cstddef>
#include <span>

namespace facet::image {

using FileBytes = std::span<const std::byte>;

/// What a format is able to do. `read` keeps every layer and all metadata, values as stored.
struct Codec {
    bool (*sniff)(FileBytes file);
    base::Result<Header> (*read_header)(FileBytes file, const base::Limits& limits);
    base::Result<Picture> (*read)(FileBytes file, const base::Limits& limits,
                                  base::Warnings& warnings);
    base::Result<base::Bytes> (*write)(std::span<const Layer> layers, const WriteOptions& options);
};

/// A format NAME lives in namespace NAME: read_NAME.cpp and write_NAME.cpp define these four.
#define FORMAT(name, ...)                                                                        \
    namespace name {                                                                             \
    bool sniff(FileBytes file);                                                                  \
    base::Result<Header> read_header(FileBytes file, const base::Limits& limits);                \
    base::Result<Picture> read(FileBytes file, const base::Limits& limits,                       \
                               base::Warnings& warnings);                                        \
    base::Result<base::Bytes> write(std::span<const Layer> layers, const WriteOptions& options); \
    }
#include "tables/image_formats.def"

inline constexpr auto codecs = std::to_array<Codec>({
#define FORMAT(name, ...) {&name::sniff, &name::read_header, &name::read, &name::write},
#include "tables/image_formats.def"
});

[[nodiscard]] constexpr const Codec& codec(tables::ImageFormat format) {
    return codecs[static_cast<std::size_t>(format)];
}

}  // namespace facet::image
