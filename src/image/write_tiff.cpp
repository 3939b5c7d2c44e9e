// Writes TIFF through OpenImageIO.
// SPDX-License-Identifier: MIT
#include "image/checks.h"
#include "image/dispatch.h"
#include "image/oiio.h"

namespace facet::image::tiff {

base::Result<base::Bytes> write(std::span<const Layer> layers, const WriteOptions& options) {
    const auto image = with_integer_depth(layers.front().image,
                                          options.depth == Depth::u16 ? Sample::u16 : Sample::u8);
    if (!image) return tl::unexpected(image.error());
    return oiio::write(*image, options);
}

}  // namespace facet::image::tiff
