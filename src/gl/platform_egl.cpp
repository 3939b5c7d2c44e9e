// EGL without a window: on a hardware device, or on Mesa's surfaceless platform.
// SPDX-License-Identifier: MIT
#include "gl/platform.h"

#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <dlfcn.h>
#include <spdlog/fmt/fmt.h>

#include <array>
#include <string_view>

namespace facet::gl {
namespace {

constexpr const char* egl_package = "apt-get install libegl1 libegl-mesa0";
constexpr const char* driver_package = "apt-get install libgl1-mesa-dri";

/// The entry points of libEGL, looked up at run time so that the program starts where it is
/// missing.
struct Egl {
    PFNEGLGETPROCADDRESSPROC get_proc_address = nullptr;
    PFNEGLQUERYSTRINGPROC query_string = nullptr;
    PFNEGLINITIALIZEPROC initialize = nullptr;
    PFNEGLTERMINATEPROC terminate = nullptr;
    PFNEGLBINDAPIPROC bind_api = nullptr;
    PFNEGLCHOOSECONFIGPROC choose_config = nullptr;
    PFNEGLCREATECONTEXTPROC create_context = nullptr;
    PFNEGLDESTROYCONTEXTPROC destroy_context = nullptr;
    PFNEGLMAKECURRENTPROC make_current = nullptr;
    PFNEGLGETERRORPROC get_error = nullptr;
    PFNEGLGETPLATFORMDISPLAYEXTPROC get_platform_display = nullptr;
};

template <class F>
bool find(void* library, const char* name, F& function) {
    function = reinterpret_cast<F>(::dlsym(library, name));
    return function != nullptr;
}

tl::expected<Egl, Failure> load_egl() {
    void* library = ::dlopen("libEGL.so.1", RTLD_NOW | RTLD_LOCAL);
    if (library == nullptr)
        return tl::unexpected(Failure{"libEGL.so.1 is not installed", egl_package});
    Egl egl;
    const bool all = find(library, "eglGetProcAddress", egl.get_proc_address) &&
                     find(library, "eglQueryString", egl.query_string) &&
                     find(library, "eglInitialize", egl.initialize) &&
                     find(library, "eglTerminate", egl.terminate) &&
                     find(library, "eglBindAPI", egl.bind_api) &&
                     find(library, "eglChooseConfig", egl.choose_config) &&
                     find(library, "eglCreateContext", egl.create_context) &&
                     find(library, "eglDestroyContext", egl.destroy_context) &&
                     find(library, "eglMakeCurrent", egl.make_current) &&
                     find(library, "eglGetError", egl.get_error);
    if (!all) return tl::unexpected(Failure{"libEGL.so.1 is older than EGL 1.4", egl_package});
    egl.get_platform_display = reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(
        egl.get_proc_address("eglGetPlatformDisplayEXT"));
    if (egl.get_platform_display == nullptr)
        return tl::unexpected(Failure{"libEGL lacks EGL_EXT_platform_base", egl_package});
    return egl;
}

bool has_extension(const char* list, std::string_view name) {
    std::string_view rest = list == nullptr ? "" : list;
    while (!rest.empty()) {
        const std::size_t end = rest.find(' ');
        if (rest.substr(0, end) == name) return true;
        rest = end == std::string_view::npos ? "" : rest.substr(end + 1);
    }
    return false;
}

EGLContext create_core_context(const Egl& egl, EGLDisplay display, EGLConfig config) {
    EGLContext context = EGL_NO_CONTEXT;
    for (const EGLint minor : {5, 4, 3}) {
        const std::array<EGLint, 7> attributes = {EGL_CONTEXT_MAJOR_VERSION_KHR,
                                                  4,
                                                  EGL_CONTEXT_MINOR_VERSION_KHR,
                                                  minor,
                                                  EGL_CONTEXT_OPENGL_PROFILE_MASK_KHR,
                                                  EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT_KHR,
                                                  EGL_NONE};
        if (context == EGL_NO_CONTEXT)
            context = egl.create_context(display, config, EGL_NO_CONTEXT, attributes.data());
    }
    return context;
}

PlatformResult open_display(const Egl& egl, EGLDisplay display) {
    if (display == EGL_NO_DISPLAY || egl.initialize(display, nullptr, nullptr) != EGL_TRUE)
        return tl::unexpected(
            Failure{fmt::format("eglInitialize failed (0x{:x})", egl.get_error()), driver_package});
    const auto fail = [&](std::string reason) {
        egl.terminate(display);
        return tl::unexpected(Failure{std::move(reason), driver_package});
    };
    if (!has_extension(egl.query_string(display, EGL_EXTENSIONS), "EGL_KHR_surfaceless_context"))
        return fail("the driver lacks EGL_KHR_surfaceless_context");
    if (egl.bind_api(EGL_OPENGL_API) != EGL_TRUE) return fail("the driver has no desktop OpenGL");
    const std::array<EGLint, 3> wanted = {EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_NONE};
    EGLConfig config = nullptr;
    EGLint count = 0;
    if (egl.choose_config(display, wanted.data(), &config, 1, &count) != EGL_TRUE || count == 0)
        config = nullptr;  // EGL_KHR_no_config_context: drivers without configs take none
    const EGLContext context = create_core_context(egl, display, config);
    if (context == EGL_NO_CONTEXT)
        return fail(fmt::format("no core profile of GL 4.3 (0x{:x})", egl.get_error()));
    if (egl.make_current(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context) != EGL_TRUE) {
        egl.destroy_context(display, context);
        return fail("eglMakeCurrent failed without a surface");
    }
    return Context::Platform{"egl", egl.get_proc_address, [egl, display, context] {
                                 egl.make_current(display, EGL_NO_SURFACE, EGL_NO_SURFACE,
                                                  EGL_NO_CONTEXT);
                                 egl.destroy_context(display, context);
                                 egl.terminate(display);
                             }};
}

/// The first device that is not a software one and gives a context.
PlatformResult open_hardware(const Egl& egl) {
    const auto query_devices =
        reinterpret_cast<PFNEGLQUERYDEVICESEXTPROC>(egl.get_proc_address("eglQueryDevicesEXT"));
    const auto query_device_string = reinterpret_cast<PFNEGLQUERYDEVICESTRINGEXTPROC>(
        egl.get_proc_address("eglQueryDeviceStringEXT"));
    std::array<EGLDeviceEXT, 16> devices{};
    EGLint count = 0;
    if (query_devices == nullptr || query_device_string == nullptr ||
        query_devices(static_cast<EGLint>(devices.size()), devices.data(), &count) != EGL_TRUE)
        return tl::unexpected(Failure{"libEGL lists no devices", ""});
    Failure last{"no hardware device", "not needed: the software renderer is used"};
    for (EGLint i = 0; i < count; ++i) {
        EGLDeviceEXT device = devices[static_cast<std::size_t>(i)];
        if (has_extension(query_device_string(device, EGL_EXTENSIONS), "EGL_MESA_device_software"))
            continue;
        auto platform =
            open_display(egl, egl.get_platform_display(EGL_PLATFORM_DEVICE_EXT, device, nullptr));
        if (platform) return platform;
        last = platform.error();
    }
    return tl::unexpected(last);
}

}  // namespace

PlatformResult open_egl_device() {
    const auto egl = load_egl();
    if (!egl) return tl::unexpected(egl.error());
    const char* extensions = egl->query_string(EGL_NO_DISPLAY, EGL_EXTENSIONS);
    if (!has_extension(extensions, "EGL_EXT_platform_device") &&
        !has_extension(extensions, "EGL_EXT_device_base"))
        return tl::unexpected(Failure{"libEGL lacks EGL_EXT_platform_device", egl_package});
    return open_hardware(*egl);
}

PlatformResult open_egl_surfaceless() {
    const auto egl = load_egl();
    if (!egl) return tl::unexpected(egl.error());
    if (!has_extension(egl->query_string(EGL_NO_DISPLAY, EGL_EXTENSIONS),
                       "EGL_MESA_platform_surfaceless"))
        return tl::unexpected(Failure{"libEGL lacks EGL_MESA_platform_surfaceless", egl_package});
    return open_display(*egl, egl->get_platform_display(EGL_PLATFORM_SURFACELESS_MESA,
                                                        EGL_DEFAULT_DISPLAY, nullptr));
}

}  // namespace facet::gl
