// Writing pictures of any format through its codec.
// SPDX-License-Identifier: MIT
#include "image/write.h"

#include "image/checks.h"
#include "image/dispatch.h"

#include <exception>
#include <new>

namespace facet::image {
namespace {

base::Result<base::Bytes> write_with(const Codec& codec, std::span<const Layer> layers,
                                     const WriteOptions& options) {
    try {
        return codec.write(layers, options);
    } catch (const std::bad_alloc&) {
        return base::fail({.code = base::ErrorCode::limit_reached,
                           .what = "out of memory while encoding a picture",
                           .found = {},
                           .remedy = "write a smaller picture"});
    } catch (const std::exception& problem) {
        return base::fail({.code = base::ErrorCode::internal,
                           .what = "the picture cannot be encoded",
                           .found = problem.what()});
    }
}

}  // namespace

base::Result<base::Bytes> encode(const Image& image, const WriteOptions& options) {
    const Picture picture = one_layer(options.format, image);
    return write_with(codec(options.format), picture.layers, options);
}

base::Result<base::Bytes> encode_exr(std::span<const Layer> layers, const WriteOptions& options) {
    return write_with(codec(tables::ImageFormat::exr), layers, options);
}

}  // namespace facet::image
