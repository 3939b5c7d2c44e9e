// A window with a GL context, by GLFW.
// SPDX-License-Identifier: MIT
#include "studio/window.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <dlfcn.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>

namespace facet::studio {
namespace {

constexpr const char* library_name = "libglfw.so.3";
constexpr const char* package = "apt-get install libglfw3, or --offscreen";

tl::unexpected<base::Error> no_window(std::string what, std::string found, std::string remedy) {
    return base::fail({.code = base::ErrorCode::no_backend,
                       .file = "studio",
                       .what = std::move(what),
                       .found = std::move(found),
                       .remedy = std::move(remedy)});
}

}  // namespace

/// GLFW's entry points, by their own names.
struct Window::Glfw {
#define FUNCTION(name) decltype(&::glfw##name) name = nullptr;
#include "studio/glfw.def"

    [[nodiscard]] bool load() {
        void* library = ::dlopen(library_name, RTLD_NOW | RTLD_LOCAL);
        if (library == nullptr) return false;
        bool all = true;
#define FUNCTION(name)                                                       \
    name = reinterpret_cast<decltype(name)>(::dlsym(library, "glfw" #name)); \
    all = all && name != nullptr;
#include "studio/glfw.def"
        return all;
    }
};

struct Window::Impl {
    Glfw glfw;
    GLFWwindow* window = nullptr;
    Input* input = nullptr;  ///< while poll() runs
    MouseQueue mouse;
    math::Vec2 pointer{};  ///< as of the last event, in the window's units

    ~Impl() {
        if (window != nullptr) glfw.DestroyWindow(window);
        if (glfw.Terminate != nullptr) glfw.Terminate();
    }
    static Impl& of(GLFWwindow* window);
    void listen();
    void read_state(Input& out);
    /// A place of the mouse in pixels: it comes in other units where the desktop scales windows.
    [[nodiscard]] math::Vec2 in_pixels(math::Vec2 place) const;
    [[nodiscard]] std::string error() const {
        const char* text = nullptr;
        glfw.GetError(&text);
        return text == nullptr ? "" : text;
    }
};

Window::Impl& Window::Impl::of(GLFWwindow* window) {
    // Callbacks get no pointer but the window's; GLFW is asked for the one that is kept there.
    using Getter = decltype(&::glfwGetWindowUserPointer);
    static const auto user_pointer = reinterpret_cast<Getter>(
        ::dlsym(::dlopen(library_name, RTLD_NOW | RTLD_NOLOAD), "glfwGetWindowUserPointer"));
    return *static_cast<Impl*>(user_pointer(window));
}

void Window::Impl::listen() {
    glfw.SetWindowUserPointer(window, this);
    glfw.SetMouseButtonCallback(window, [](GLFWwindow* w, int button, int action, int) {
        Impl& self = of(w);
        if (self.input == nullptr || button < 0 || button > 2) return;
        self.mouse.push(static_cast<std::size_t>(button), action == GLFW_PRESS,
                        self.in_pixels(self.pointer));
    });
    // Asked for its place, GLFW tells where the mouse is by now, not where it was at an event.
    glfw.SetCursorPosCallback(window, [](GLFWwindow* w, double x, double y) {
        of(w).pointer = {static_cast<float>(x), static_cast<float>(y)};
    });
    glfw.SetScrollCallback(window, [](GLFWwindow* w, double, double y) {
        if (Input* in = of(w).input) in->wheel += static_cast<float>(y);
    });
    glfw.SetKeyCallback(window, [](GLFWwindow* w, int key, int, int action, int mods) {
        Input* in = of(w).input;
        if (in == nullptr || key < 0 || key >= static_cast<int>(key_count)) return;
        const auto i = static_cast<std::size_t>(key);
        in->keys[i] = action != GLFW_RELEASE;
        if (action == GLFW_RELEASE) return;
        in->typed_keys[i] = true;
        // What was held with it may be let go before the frame sees it.
        if ((mods & GLFW_MOD_CONTROL) != 0) in->typed_keys[GLFW_KEY_LEFT_CONTROL] = true;
        if ((mods & GLFW_MOD_SHIFT) != 0) in->typed_keys[GLFW_KEY_LEFT_SHIFT] = true;
        if ((mods & GLFW_MOD_ALT) != 0) in->typed_keys[GLFW_KEY_LEFT_ALT] = true;
    });
    glfw.SetCharCallback(window, [](GLFWwindow* w, unsigned letter) {
        if (Input* in = of(w).input) in->text.push_back(static_cast<char32_t>(letter));
    });
    glfw.SetDropCallback(window, [](GLFWwindow* w, int count, const char** paths) {
        if (Input* in = of(w).input) in->dropped.assign(paths, paths + count);
    });
    glfw.SetWindowCloseCallback(window, [](GLFWwindow* w) {
        if (Input* in = of(w).input) in->wants_close = true;
    });
    glfw.SetWindowFocusCallback(window, [](GLFWwindow* w, int focused) {
        Impl& self = of(w);
        if (self.input == nullptr || focused != 0) return;
        self.input->keys.reset();  // their release goes to somebody else
        self.input->buttons = {};
        self.mouse.clear();
    });
}

math::Vec2 Window::Impl::in_pixels(math::Vec2 place) const {
    int width_px = 0;
    int width = 0;
    glfw.GetFramebufferSize(window, &width_px, nullptr);
    glfw.GetWindowSize(window, &width, nullptr);
    return width > 0 ? place * (static_cast<float>(width_px) / static_cast<float>(width)) : place;
}

void Window::Impl::read_state(Input& out) {
    int width = 0;
    int height = 0;
    float scale = 1.0F;
    double x = 0.0;
    double y = 0.0;
    glfw.GetFramebufferSize(window, &width, &height);
    glfw.GetWindowContentScale(window, &scale, nullptr);
    glfw.GetCursorPos(window, &x, &y);
    out.window_px = {static_cast<std::uint32_t>(std::max(0, width)),
                     static_cast<std::uint32_t>(std::max(0, height))};
    out.scale = std::isfinite(scale) && scale > 0.0F ? std::clamp(scale, 0.5F, 4.0F) : 1.0F;
    mouse.advance(out, in_pixels({static_cast<float>(x), static_cast<float>(y)}));
}

Window::Window(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
Window::Window(Window&&) noexcept = default;
Window& Window::operator=(Window&&) noexcept = default;
Window::~Window() = default;

base::Result<Window> Window::open(math::Extent points, const std::string& title) {
    auto impl = std::make_unique<Impl>();
    Glfw& glfw = impl->glfw;
    if (!glfw.load()) {
        glfw.Terminate = nullptr;
        return no_window("a window needs GLFW", "libglfw.so.3 is not installed", package);
    }
    if (glfw.Init() != GLFW_TRUE) {
        const std::string reason = impl->error();
        glfw.Terminate = nullptr;
        return no_window("there is no display to open a window on", reason,
                         "set DISPLAY, or --offscreen");
    }
    for (const int minor : {5, 3}) {
        glfw.WindowHint(GLFW_CONTEXT_VERSION_MAJOR, 4);
        glfw.WindowHint(GLFW_CONTEXT_VERSION_MINOR, minor);
        glfw.WindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
        glfw.WindowHint(GLFW_SCALE_TO_MONITOR, GLFW_TRUE);
        glfw.WindowHint(GLFW_DEPTH_BITS, 0);
        glfw.WindowHint(GLFW_STENCIL_BITS, 0);
        impl->window =
            glfw.CreateWindow(static_cast<int>(points.width), static_cast<int>(points.height),
                              title.c_str(), nullptr, nullptr);
        if (impl->window != nullptr) break;
    }
    if (impl->window == nullptr)
        return no_window("the display gives no window with GL 4.3", impl->error(),
                         "apt-get install libgl1-mesa-dri libglx-mesa0, or --offscreen");
    glfw.MakeContextCurrent(impl->window);
    glfw.SwapInterval(1);
    impl->listen();
    return Window(std::move(impl));
}

void Window::poll(Input& input, double wait_s) {
    input.next_frame();
    impl_->input = &input;
    if (wait_s > 0.0 && impl_->mouse.is_empty())
        impl_->glfw.WaitEventsTimeout(wait_s);
    else
        impl_->glfw.PollEvents();
    impl_->input = nullptr;
    impl_->read_state(input);
}

void Window::swap() { impl_->glfw.SwapBuffers(impl_->window); }
void Window::set_title(const std::string& title) {
    impl_->glfw.SetWindowTitle(impl_->window, title.c_str());
}
gl::Loader Window::loader() const {
    return reinterpret_cast<gl::Loader>(impl_->glfw.GetProcAddress);
}
void Window::wake() const { impl_->glfw.PostEmptyEvent(); }

void Window::share_clipboard() {
    ImGuiIO& io = ImGui::GetIO();
    io.ClipboardUserData = impl_.get();
    io.SetClipboardTextFn = [](void* user, const char* text) {
        const auto* impl = static_cast<Impl*>(user);
        impl->glfw.SetClipboardString(impl->window, text);
    };
    io.GetClipboardTextFn = [](void* user) {
        const auto* impl = static_cast<Impl*>(user);
        return impl->glfw.GetClipboardString(impl->window);
    };
}

}  // namespace facet::studio
