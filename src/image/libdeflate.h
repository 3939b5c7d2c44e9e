// libdeflate's compressor and decompressor as owned objects.
// SPDX-License-Identifier: MIT
#pragma once

#include <libdeflate.h>

#include <memory>

namespace facet::image {

struct DecompressorEnd {
    void operator()(libdeflate_decompressor* d) const noexcept { libdeflate_free_decompressor(d); }
};
using Decompressor = std::unique_ptr<libdeflate_decompressor, DecompressorEnd>;

struct CompressorEnd {
    void operator()(libdeflate_compressor* c) const noexcept { libdeflate_free_compressor(c); }
};
using Compressor = std::unique_ptr<libdeflate_compressor, CompressorEnd>;

}  // namespace facet::image
