// What crosses the border to libfacet_oiio.so: C functions over plain structs, no exceptions, no
// C++ types. SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

extern "C" {

/// Size and sample of a picture; sample: 0 u8, 1 u16, 2 f32.
struct FacetOiioShape {
    std::uint32_t width;
    std::uint32_t height;
    std::uint32_t channels;
    std::uint32_t sample;
};

/// Text for the caller to keep; `capacity` bytes with the 0 at the end.
struct FacetOiioMessage {
    char* text;
    std::size_t capacity;
};

/// One line of metadata; both end with 0.
struct FacetOiioText {
    const char* key;
    const char* text;
};

/// Where writing puts its bytes, called once.
struct FacetOiioSink {
    void* owner;
    void (*take)(void* owner, const void* bytes, std::size_t count);
};

/// Everything that the module does. `format` is a file ending ("tiff"). Each function returns 0, or
/// 1 with the reason in `message`.
struct FacetOiioModule {
    std::uint32_t version;
    int (*read_shape)(const char* format, const void* bytes, std::size_t count,
                      FacetOiioShape* shape, FacetOiioMessage message);
    /// `pixels` holds width * height * channels samples of `shape`.
    int (*read_pixels)(const char* format, const void* bytes, std::size_t count,
                       const FacetOiioShape* shape, void* pixels, FacetOiioMessage message);
    int (*write)(const char* format, const FacetOiioShape* shape, const void* pixels,
                 const FacetOiioText* metadata, std::size_t metadata_count, FacetOiioSink sink,
                 FacetOiioMessage message);
    /// Encodes linear Rec.709, f32, in place for a display and a view of the configuration that the
    /// variable OCIO names; empty: its defaults.
    int (*display)(const FacetOiioShape* shape, float* pixels, const char* display,
                   const char* view, FacetOiioMessage message);
};

/// Changes whenever a struct above does.
inline constexpr std::uint32_t facet_oiio_version = 2;

/// The module's one entry point, by its name for dlsym.
const FacetOiioModule* facet_oiio_module();
}
