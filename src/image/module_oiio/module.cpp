// libfacet_oiio.so: pictures through OpenImageIO, for the formats that have no quick path of their
// own. SPDX-License-Identifier: MIT
#include "image/module_oiio/color.h"
#include "image/module_oiio/interface.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <exception>
#include <memory>
#include <string>
#include <vector>

namespace {

void say(FacetOiioMessage message, const std::string& text) {
    std::snprintf(message.text, message.capacity, "%s", text.c_str());
}

/// Runs `work`; whatever it throws becomes its message.
template <class Work>
int guarded(FacetOiioMessage message, const Work& work) noexcept {
    try {
        const std::string problem = work();
        if (problem.empty()) return 0;
        say(message, problem);
    } catch (const std::exception& exception) {
        std::snprintf(message.text, message.capacity, "%s", exception.what());
    } catch (...) {
        std::snprintf(message.text, message.capacity, "unknown exception");
    }
    return 1;
}

OIIO::TypeDesc type_of(std::uint32_t sample) {
    return sample == 0   ? OIIO::TypeDesc::UINT8
           : sample == 1 ? OIIO::TypeDesc::UINT16
                         : OIIO::TypeDesc::FLOAT;
}

/// An open picture and the memory file beneath it.
struct Input {
    OIIO::Filesystem::IOMemReader memory;
    std::unique_ptr<OIIO::ImageInput> image;
    Input(const void* bytes, std::size_t count)
        // The reader's signature lacks the const that its doing has.
        : memory(const_cast<void*>(bytes), count) {}
};

std::string open(const char* format, Input& input) {
    input.image = OIIO::ImageInput::create(format);
    if (!input.image || !input.image->supports("ioproxy"))
        return "OpenImageIO cannot read this format from memory";
    // Not through ImageInput::open(): given a proxy and a configuration, OpenImageIO 2.4 drops the
    // proxy.
    input.image->set_ioproxy(&input.memory);
    OIIO::ImageSpec config;
    OIIO::ImageSpec found;
    config.attribute("oiio:UnassociatedAlpha", 1);  // straight alpha is what Facet keeps
    if (input.image->open(std::string("picture.") + format, found, config)) return {};
    const std::string reason = input.image->geterror();
    return reason.empty() ? "OpenImageIO cannot open it" : reason;
}

std::uint32_t sample_of(const OIIO::ImageSpec& spec) {
    if (spec.format.basetype == OIIO::TypeDesc::UINT8) return 0;
    return spec.format.basetype == OIIO::TypeDesc::UINT16 ? 1 : 2;
}

int read_shape(const char* format, const void* bytes, std::size_t count, FacetOiioShape* shape,
               FacetOiioMessage message) {
    return guarded(message, [&]() -> std::string {
        Input input(bytes, count);
        if (std::string problem = open(format, input); !problem.empty()) return problem;
        const OIIO::ImageSpec& spec = input.image->spec();
        if (spec.width < 0 || spec.height < 0 || spec.nchannels < 0 || spec.depth > 1)
            return "a volume, or a negative size";
        *shape = {static_cast<std::uint32_t>(spec.width), static_cast<std::uint32_t>(spec.height),
                  static_cast<std::uint32_t>(spec.nchannels), sample_of(spec)};
        return {};
    });
}

int read_pixels(const char* format, const void* bytes, std::size_t count,
                const FacetOiioShape* shape, void* pixels, FacetOiioMessage message) {
    return guarded(message, [&]() -> std::string {
        Input input(bytes, count);
        if (std::string problem = open(format, input); !problem.empty()) return problem;
        const OIIO::ImageSpec& spec = input.image->spec();
        if (static_cast<std::uint32_t>(spec.width) != shape->width ||
            static_cast<std::uint32_t>(spec.height) != shape->height ||
            static_cast<std::uint32_t>(spec.nchannels) < shape->channels)
            return "the header changed between two looks";
        if (!input.image->read_image(0, 0, 0, static_cast<int>(shape->channels),
                                     type_of(shape->sample), pixels))
            return input.image->geterror();
        return {};
    });
}

/// A file in memory that can be read again while it is written: libtiff goes back to its first
/// directory to chain the second to it, and OpenImageIO's own IOVecOutput would hand it nothing.
class MemoryFile : public OIIO::Filesystem::IOVecOutput {
public:
    using IOVecOutput::IOVecOutput;
    std::size_t read(void* to, std::size_t count) override {
        const std::size_t got = pread(to, count, tell());
        m_pos += static_cast<std::int64_t>(got);
        return got;
    }
    std::size_t pread(void* to, std::size_t count, std::int64_t offset) override {
        const auto at = static_cast<std::size_t>(offset);
        if (offset < 0 || at >= m_buf.size()) return 0;
        const std::size_t got = std::min(count, m_buf.size() - at);
        std::memcpy(to, m_buf.data() + at, got);
        return got;
    }
};

int write(const char* format, const FacetOiioShape* shape, const void* pixels,
          const FacetOiioText* metadata, std::size_t metadata_count, FacetOiioSink sink,
          FacetOiioMessage message) {
    return guarded(message, [&]() -> std::string {
        const std::string name = std::string("picture.") + format;
        std::vector<unsigned char> bytes;
        MemoryFile memory(bytes);
        const auto output = OIIO::ImageOutput::create(name, &memory);
        if (!output || !output->supports("ioproxy")) return "cannot write this format to memory";
        OIIO::ImageSpec spec(static_cast<int>(shape->width), static_cast<int>(shape->height),
                             static_cast<int>(shape->channels), type_of(shape->sample));
        // First, so that no key can change how the pixels are stored. TIFF keeps those it has a tag
        // for.
        for (std::size_t i = 0; i < metadata_count; ++i)
            spec.attribute(metadata[i].key, metadata[i].text);
        if (shape->channels == 2 || shape->channels == 4) {
            spec.alpha_channel = static_cast<int>(shape->channels) - 1;
            spec.attribute("oiio:UnassociatedAlpha", 1);
        }
        spec.attribute("compression", "zip");
        spec.attribute("DateTime", "");  // else the time of writing, and no two files the same
        if (!output->open(name, spec) || !output->write_image(type_of(shape->sample), pixels) ||
            !output->close())
            return output->geterror();
        sink.take(sink.owner, bytes.data(), bytes.size());
        return {};
    });
}

const FacetOiioModule module_table{facet_oiio_version, read_shape, read_pixels, write,
                                   facet_oiio_display};

}  // namespace

extern "C" __attribute__((visibility("default"))) const FacetOiioModule* facet_oiio_module() {
    return &module_table;
}
