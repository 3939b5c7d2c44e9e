// A GL context without a window: EGL on a device, EGL surfaceless, or OSMesa, all loaded at run
// time. SPDX-License-Identifier: MIT
#pragma once

#include "base/log.h"
#include "base/result.h"
#include "gl/api.h"

#include <memory>
#include <string>
#include <vector>

namespace facet::gl {

enum class Backend { automatic, egl, osmesa };

/// What became of one way to a context; `facet doctor` and the error of create() print it.
struct BackendReport {
    std::string name;  ///< "EGL device", "EGL surfaceless", "OSMesa"
    bool works = false;
    std::string renderer;  ///< GL_RENDERER, where it works
    std::string version;   ///< GL_VERSION, where it works
    std::string reason;    ///< why not, where it does not
    std::string remedy;    ///< the Debian package or setting that mends it
};

/// One current core-profile context of at least 4.3, on the calling thread. All GL objects must die
/// before it, and it before the log given to create().
class Context {
public:
    /// Tries, for `automatic`, EGL with a hardware device, EGL surfaceless, OSMesa, in that order.
    /// Errors: no_backend, with each one's reason and remedy.
    [[nodiscard]] static base::Result<Context> create(Backend backend, base::Log& log);
    /// The context that a window has made current on this thread, with the window's loader; the
    /// window outlives it. Errors: no_backend, naming what the driver lacks.
    [[nodiscard]] static base::Result<Context> adopt(Loader loader, base::Log& log);
    ~Context();
    Context(Context&&) noexcept;
    Context& operator=(Context&&) noexcept;

    [[nodiscard]] const Api& api() const noexcept;
    [[nodiscard]] const std::string& backend() const noexcept;   ///< "egl", "osmesa" or "window"
    [[nodiscard]] const std::string& renderer() const noexcept;  ///< GL_RENDERER
    [[nodiscard]] const std::string& version() const noexcept;   ///< GL_VERSION
    /// Whether the GL's memory is ours: reading back costs a copy and no wait.
    [[nodiscard]] bool is_software() const noexcept;

    /// Lets later draws read textures that are still attached, where the context has the call
    /// (4.5).
    void texture_barrier() const;
    /// Returns when every command given so far is complete.
    void finish() const { api().Finish(); }
    /// Errors: internal, naming `pass`, when GL has an error pending; limit_reached when out of
    /// memory.
    [[nodiscard]] base::Status check(const char* pass) const;

    struct Platform;  ///< what each way owns; in platform.h
    struct State;

private:
    explicit Context(std::unique_ptr<State> state);
    std::unique_ptr<State> state_;
};

/// Every way, tried in turn; none stays current.
[[nodiscard]] std::vector<BackendReport> probe_backends();

/// Environment variables of Mesa that have to stand before its libraries are loaded: a shader cache
/// of the program's own (facts: the cache's key lacks the vector width) and the number of threads
/// (0: Mesa's choice). What the user has set stays. Call once, before threads start.
void prepare_environment(unsigned thread_count);
/// The shader cache's folder, or "" where there is none.
[[nodiscard]] std::string shader_cache_folder();

}  // namespace facet::gl
