// Reads TIFF through OpenImageIO.
// SPDX-License-Identifier: MIT
#include "image/bytes.h"
#include "image/dispatch.h"
#include "image/oiio.h"

#include <string_view>

namespace facet::image::tiff {

bool sniff(FileBytes file) {
    using namespace std::string_view_literals;
    for (const std::string_view magic : {"II*\0"sv, "MM\0*"sv, "II+\0"sv, "MM\0+"sv})
        if (starts_with(file, magic)) return true;
    return false;
}

base::Result<Header> read_header(FileBytes file, const base::Limits& limits) {
    return oiio::read_header(file, tables::ImageFormat::tiff, limits);
}

base::Result<Picture> read(FileBytes file, const base::Limits& limits,
                           base::Warnings& /*warnings*/) {
    return oiio::read(file, tables::ImageFormat::tiff, limits);
}

}  // namespace facet::image::tiff
