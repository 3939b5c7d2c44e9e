// Opens libfacet_oiio.so and translates between its plain structs and ours.
// SPDX-License-Identifier: MIT
#include "image/oiio.h"

#include "base/resources.h"
#include "image/bytes.h"
#include "image/checks.h"
#include "image/module_oiio/interface.h"

#include <dlfcn.h>
#include <spdlog/fmt/fmt.h>

#include <array>
#include <filesystem>
#include <utility>

namespace facet::image::oiio {
namespace {

namespace fs = std::filesystem;
using Module = base::Result<const FacetOiioModule*>;

Module missing(std::string found) {
    return base::fail({.code = base::ErrorCode::feature_missing,
                       .file = "libfacet_oiio.so",
                       .what = "the module for this picture format is not there",
                       .found = std::move(found),
                       .remedy = "install Facet whole, with libopenimageio2.4, or use PNG or EXR"});
}

Module load() {
    std::string reason = "no such file";
    const fs::path program = base::program_folder();
    for (const fs::path& folder : {program, program / "../lib/facet"}) {
        const fs::path path = folder / "libfacet_oiio.so";
        std::error_code error;
        if (!fs::exists(path, error)) continue;
        void* const library = ::dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL);
        if (library == nullptr) {
            if (const char* text = ::dlerror()) reason = text;
            continue;
        }
        using Entry = const FacetOiioModule* (*)();
        const auto entry = reinterpret_cast<Entry>(::dlsym(library, "facet_oiio_module"));
        if (entry != nullptr && entry()->version == facet_oiio_version) return entry();
        reason = "of another version of Facet";
    }
    return missing(reason);
}

/// Opened once and left open: OpenImageIO's threads and tables do not survive being unloaded.
const Module& module() {
    static const Module loaded = load();
    return loaded;
}

/// Room for the module's reason.
struct Message {
    std::array<char, 512> text{};
    [[nodiscard]] FacetOiioMessage handle() { return {text.data(), text.size()}; }
};

const char* ending(tables::ImageFormat format) {
    // Keys of the table are themselves endings that OpenImageIO knows.
    return tables::row(format).key.data();
}

tl::unexpected<base::Error> failed(const Message& message) {
    return base::fail({.code = base::ErrorCode::input_invalid,
                       .what = "the picture cannot be decoded",
                       .found = message.text.data(),
                       .remedy = "export it again"});
}

Sample sample_of(const FacetOiioShape& shape) {
    return shape.sample == 0 ? Sample::u8 : shape.sample == 1 ? Sample::u16 : Sample::f32;
}

void take(void* owner, const void* bytes, std::size_t count) {
    append(*static_cast<base::Bytes*>(owner),
           std::span(static_cast<const std::byte*>(bytes), count));
}

base::Result<FacetOiioShape> shape_of(FileBytes file, tables::ImageFormat format,
                                      const base::Limits& limits) {
    if (!module()) return tl::unexpected(module().error());
    FacetOiioShape shape{};
    Message message;
    if ((*module())->read_shape(ending(format), file.data(), file.size(), &shape,
                                message.handle()) != 0)
        return failed(message);
    // Channels past the fourth are left out; all of them pass through OpenImageIO's buffers.
    if (auto checked =
            check_size({shape.width, shape.height}, std::uint64_t{shape.channels} * 8, limits);
        !checked)
        return tl::unexpected(checked.error());
    if (shape.channels == 0) return damaged(0, "the picture has no channels");
    shape.channels = std::min(shape.channels, 4U);
    return shape;
}

}  // namespace

base::Result<Header> read_header(FileBytes file, tables::ImageFormat format,
                                 const base::Limits& limits) {
    const auto shape = shape_of(file, format, limits);
    if (!shape) return tl::unexpected(shape.error());
    return Header{format, {shape->width, shape->height}, shape->channels, sample_of(*shape)};
}

base::Result<Picture> read(FileBytes file, tables::ImageFormat format, const base::Limits& limits) {
    const auto shape = shape_of(file, format, limits);
    if (!shape) return tl::unexpected(shape.error());
    Image image({shape->width, shape->height}, shape->channels, sample_of(*shape));
    Message message;
    if ((*module())->read_pixels(ending(format), file.data(), file.size(), &*shape,
                                 image.bytes.data(), message.handle()) != 0)
        return failed(message);
    return one_layer(format, std::move(image));
}

base::Result<base::Bytes> write(const Image& image, const WriteOptions& options) {
    if (!module()) return tl::unexpected(module().error());
    const FacetOiioShape shape{image.size.width, image.size.height, image.channels,
                               static_cast<std::uint32_t>(image.sample)};
    std::vector<FacetOiioText> metadata;
    for (const auto& [key, text] : options.metadata)
        metadata.push_back({key.c_str(), text.c_str()});
    base::Bytes out;
    Message message;
    if ((*module())->write(ending(options.format), &shape, image.bytes.data(), metadata.data(),
                           metadata.size(), {&out, take}, message.handle()) != 0)
        return base::fail({.code = base::ErrorCode::internal,
                           .what = "the picture cannot be written",
                           .found = message.text.data()});
    return out;
}

base::Status show(Image& linear, const std::string& display, const std::string& view) {
    if (!module()) return tl::unexpected(module().error());
    const FacetOiioShape shape{linear.size.width, linear.size.height, linear.channels, 2};
    Message message;
    if ((*module())->display(&shape, linear.as<float>().data(), display.c_str(), view.c_str(),
                             message.handle()) == 0)
        return {};
    return base::fail({.code = base::ErrorCode::usage,
                       .what = "OpenColorIO cannot show it",
                       .found = message.text.data(),
                       .remedy = "ocio:DISPLAY/VIEW with names of the configuration in OCIO"});
}

}  // namespace facet::image::oiio
