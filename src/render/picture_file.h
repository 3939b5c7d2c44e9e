// A picture's file: what can be said of it before it is rendered, and writing it.
// SPDX-License-Identifier: MIT
#pragma once

#include "image/write.h"
#include "render/render.h"

#include <filesystem>
#include <string>
#include <vector>

namespace facet::render {

struct PictureFile {
    std::filesystem::path path;
    tables::ImageFormat format = tables::ImageFormat::png;
    image::Depth depth = image::Depth::u8;

    /// Request::want_linear of what goes into it.
    [[nodiscard]] bool holds_radiance() const { return tables::row(format).scene_linear; }
};

/// The format by the ending of `output`, and its depth. Errors: usage (no such format, a depth or a
/// comparison that it cannot hold).
[[nodiscard]] base::Result<PictureFile> plan_file(const tables::Settings& settings,
                                                  const std::filesystem::path& output);

/// The picture's own file. Errors: input_invalid (--strict), those of encoding.
[[nodiscard]] base::Result<base::Bytes> encode_picture(const PictureFile& file,
                                                       const Request& request,
                                                       const Rendered& rendered);

struct Written {
    std::string sha256;                        ///< of the picture's file
    std::vector<std::filesystem::path> sides;  ///< AOVs in files of their own
};

/// Encodes and writes; the picture's own file last, so that it stands for all. Errors: usage (the
/// output is one of the files read), those of encode_picture() and of writing.
[[nodiscard]] base::Result<Written> write_picture(const PictureFile& file, const Request& request,
                                                  Rendered& rendered);

}  // namespace facet::render
