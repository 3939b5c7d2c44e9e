// Writes OpenEXR: one part of scanlines, every layer, half or float, metadata as string attributes.
// SPDX-License-Identifier: MIT
#include "base/assert.h"
#include "image/bytes.h"
#include "image/checks.h"
#include "image/dispatch.h"

#include <Imath/half.h>
#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfIO.h>
#include <OpenEXR/ImfOutputFile.h>
#include <OpenEXR/ImfStandardAttributes.h>
#include <OpenEXR/ImfStringAttribute.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>

namespace facet::image::exr {
namespace {

class MemoryOutput : public Imf::OStream {
public:
    MemoryOutput() : Imf::OStream("memory") {}
    void write(const char from[], int count) override {
        const auto bytes = std::as_bytes(std::span(from, static_cast<std::size_t>(count)));
        // The offset table is written twice: the second time over the first.
        if (at_ + bytes.size() > bytes_.size()) bytes_.resize(at_ + bytes.size());
        std::ranges::copy(bytes, bytes_.begin() + static_cast<std::ptrdiff_t>(at_));
        at_ += bytes.size();
    }
    std::uint64_t tellp() override { return at_; }
    void seekp(std::uint64_t position) override { at_ = static_cast<std::size_t>(position); }
    base::Bytes take() { return std::move(bytes_); }

private:
    base::Bytes bytes_;
    std::size_t at_ = 0;
};

/// Half has 11 bits: too few for a distance, a place or a number.
bool needs_float(const Layer& layer) {
    return layer.name == "depth" || layer.name == "position" || layer.name.ends_with("_id");
}

/// Finite stays finite: what half cannot hold becomes its largest, 65504.
std::vector<half> to_half(const Image& image) {
    const auto values = image.as<float>();
    std::vector<half> out(values.size());
    for (std::size_t i = 0; i < values.size(); ++i) {
        const float v = values[i];
        out[i] = std::isfinite(v) ? half(std::clamp(v, -65504.0F, 65504.0F)) : half(v);
    }
    return out;
}

std::string channel_name(const Layer& layer, std::size_t channel) {
    const std::string& own = layer.channels[channel];
    return layer.name.empty() ? own : layer.name + "." + own;
}

void add_metadata(Imf::Header& header, const WriteOptions& options) {
    for (const auto& [key, text] : options.metadata)
        if (!key.empty() && key.size() < 256 && header.find(key.c_str()) == header.end())
            header.insert(key, Imf::StringAttribute(text));
}

Imf::Header make_header(math::Extent size, const WriteOptions& options) {
    Imf::Header header(static_cast<int>(size.width), static_cast<int>(size.height));
    header.compression() = options.fast ? Imf::NO_COMPRESSION : Imf::ZIP_COMPRESSION;
    Imf::addWhiteLuminance(header, 1.0F);  // R = G = B = 1 is 1 nit
    add_metadata(header, options);
    return header;
}

/// Channel of the header and slice of the pixels, for each channel of a layer.
void add_layer(const Layer& layer, const void* pixels, Imf::PixelType type, Imf::Header& header,
               Imf::FrameBuffer& buffer) {
    const std::size_t count = layer.channels.size();
    const std::size_t bytes = type == Imf::HALF ? sizeof(half) : sizeof(float);
    for (std::size_t c = 0; c < count; ++c) {
        const std::string name = channel_name(layer, c);
        header.channels().insert(name, Imf::Channel(type));
        // The library takes a pointer to non-const for reading too.
        char* const first = const_cast<char*>(static_cast<const char*>(pixels)) + c * bytes;
        buffer.insert(
            name, Imf::Slice(type, first, count * bytes, count * bytes * layer.image.size.width));
    }
}

}  // namespace

base::Result<base::Bytes> write(std::span<const Layer> layers, const WriteOptions& options) {
    const math::Extent size = layers.front().image.size;
    for (const Layer& layer : layers)
        if (layer.image.sample != Sample::f32 || layer.image.size != size ||
            layer.image.channels != layer.channels.size())
            return base::fail({.code = base::ErrorCode::internal,
                               .what = "the layers of an EXR do not fit together",
                               .found = layer.name});
    Imf::Header header = make_header(size, options);
    Imf::FrameBuffer buffer;
    std::vector<std::vector<half>> halves;  // alive until the pixels are written
    for (const Layer& layer : layers) {
        const bool as_half = options.depth == Depth::half && !needs_float(layer);
        if (as_half) halves.push_back(to_half(layer.image));
        const void* const pixels =
            as_half ? static_cast<const void*>(halves.back().data()) : layer.image.bytes.data();
        add_layer(layer, pixels, as_half ? Imf::HALF : Imf::FLOAT, header, buffer);
    }
    MemoryOutput stream;
    {
        Imf::OutputFile file(stream, header, 0);
        file.setFrameBuffer(buffer);
        file.writePixels(static_cast<int>(size.height));
    }  // its end writes the offset table
    return stream.take();
}

}  // namespace facet::image::exr
