// The way to OpenImageIO: a shared object of its own, opened at first need.
// SPDX-License-Identifier: MIT
#pragma once

#include "base/result.h"
#include "image/dispatch.h"

#include <string>

namespace facet::image::oiio {

/// As Codec's functions, for any `format` that OpenImageIO knows by its file ending.
/// Errors: feature_missing when the module is not there.
[[nodiscard]] base::Result<Header> read_header(FileBytes file, tables::ImageFormat format,
                                               const base::Limits& limits);
[[nodiscard]] base::Result<Picture> read(FileBytes file, tables::ImageFormat format,
                                         const base::Limits& limits);
[[nodiscard]] base::Result<base::Bytes> write(const Image& image, const WriteOptions& options);

/// Encodes linear Rec.709, f32 [height, width, 4], in place for a display and a view of the
/// OpenColorIO configuration that the variable OCIO names; empty: its defaults. Alpha stays.
/// Errors: usage (no such view), feature_missing.
[[nodiscard]] base::Status show(Image& linear, const std::string& display, const std::string& view);

}  // namespace facet::image::oiio
