// OSMesa: Mesa's renderer into plain memory; works where there is neither EGL nor a device file.
// SPDX-License-Identifier: MIT
#include "gl/platform.h"

#include <dlfcn.h>

#include <memory>

namespace facet::gl {
namespace {

// From GL/osmesa.h (Mesa 10.0's attribute interface), so that building needs no OSMesa headers.
constexpr int OSMESA_FORMAT = 0x22;
constexpr int OSMESA_RGBA = 0x1908;
constexpr int OSMESA_DEPTH_BITS = 0x30;
constexpr int OSMESA_PROFILE = 0x33;
constexpr int OSMESA_CORE_PROFILE = 0x34;
constexpr int OSMESA_CONTEXT_MAJOR_VERSION = 0x36;
constexpr int OSMESA_CONTEXT_MINOR_VERSION = 0x37;

using CreateContext = void* (*)(const int* attributes, void* share);
using MakeCurrent = unsigned char (*)(void* context, void* buffer, GLenum type, int width,
                                      int height);
using DestroyContext = void (*)(void* context);

constexpr const char* package = "apt-get install libosmesa6";

}  // namespace

PlatformResult open_osmesa() {
    // RTLD_LOCAL: its gl* names must not be seen by other libraries that look for libGL's.
    void* library = nullptr;
    for (const char* name : {"libOSMesa.so.8", "libOSMesa.so.6", "libOSMesa.so"})
        if (library == nullptr) library = ::dlopen(name, RTLD_NOW | RTLD_LOCAL);
    if (library == nullptr) return tl::unexpected(Failure{"libOSMesa is not installed", package});
    const auto create =
        reinterpret_cast<CreateContext>(::dlsym(library, "OSMesaCreateContextAttribs"));
    const auto make_current = reinterpret_cast<MakeCurrent>(::dlsym(library, "OSMesaMakeCurrent"));
    const auto destroy = reinterpret_cast<DestroyContext>(::dlsym(library, "OSMesaDestroyContext"));
    const auto loader = reinterpret_cast<Loader>(::dlsym(library, "OSMesaGetProcAddress"));
    if (create == nullptr || make_current == nullptr || destroy == nullptr || loader == nullptr)
        return tl::unexpected(
            Failure{"libOSMesa lacks the functions of Mesa 10 and later", package});
    void* context = nullptr;
    for (const int minor : {5, 4, 3}) {
        const int attributes[] = {OSMESA_FORMAT,
                                  OSMESA_RGBA,
                                  OSMESA_DEPTH_BITS,
                                  0,
                                  OSMESA_PROFILE,
                                  OSMESA_CORE_PROFILE,
                                  OSMESA_CONTEXT_MAJOR_VERSION,
                                  4,
                                  OSMESA_CONTEXT_MINOR_VERSION,
                                  minor,
                                  0};
        if (context == nullptr) context = create(attributes, nullptr);
    }
    if (context == nullptr)
        return tl::unexpected(Failure{"OSMesa gives no core profile of GL 4.3",
                                      "apt-get install libgl1-mesa-dri libosmesa6"});
    // The picture OSMesa insists on; everything is drawn into framebuffer objects instead.
    auto pixel = std::make_shared<unsigned>(0);
    if (make_current(context, pixel.get(), 0x1401 /* GL_UNSIGNED_BYTE */, 1, 1) == 0) {
        destroy(context);
        return tl::unexpected(Failure{"OSMesaMakeCurrent failed", package});
    }
    // The library stays loaded: its worker threads may outlive the context by a moment.
    return Context::Platform{"osmesa", loader, [destroy, context, pixel] { destroy(context); }};
}

}  // namespace facet::gl
