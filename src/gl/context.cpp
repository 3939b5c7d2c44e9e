// A GL context without a window.
// SPDX-License-Identifier: MIT
#include "gl/context.h"

#include "base/cache_folder.h"
#include "gl/platform.h"

#include <array>
#include <cstdlib>
#include <filesystem>
#include <string_view>

namespace facet::gl {
namespace {

#ifdef FACET_GL_DEBUG
constexpr bool debug_build = true;
#else
constexpr bool debug_build = false;
#endif

struct Way {
    const char* name;
    Backend backend;
    PlatformResult (*open)();
};
constexpr std::array ways = {Way{"EGL device", Backend::egl, open_egl_device},
                             Way{"EGL surfaceless", Backend::egl, open_egl_surfaceless},
                             Way{"OSMesa", Backend::osmesa, open_osmesa}};

void APIENTRY on_debug_message(GLenum, GLenum type, GLuint, GLenum severity, GLsizei,
                               const GLchar* message, const void* user) {
    if (severity == GL_DEBUG_SEVERITY_NOTIFICATION) return;
    auto& log = *const_cast<base::Log*>(static_cast<const base::Log*>(user));
    log.write(type == GL_DEBUG_TYPE_ERROR ? base::LogLevel::warn : base::LogLevel::debug,
              std::string("gl: ") + message);
}

}  // namespace

struct Context::State {
    Platform platform;
    Api api;
    PFNGLTEXTUREBARRIERPROC texture_barrier = nullptr;  ///< null below 4.5
    std::string renderer;
    std::string version;

    ~State() {
        if (platform.end) platform.end();
    }

    /// Fills the table and the strings, or says what is missing.
    Failure describe() {
        if (const char* missing = load(api, platform.loader))
            return {std::string("the driver lacks ") + missing, "update Mesa to 20 or later"};
        const auto text = [&](GLenum name) {
            return std::string(reinterpret_cast<const char*>(api.GetString(name)));
        };
        texture_barrier =
            reinterpret_cast<PFNGLTEXTUREBARRIERPROC>(platform.loader("glTextureBarrier"));
        renderer = text(GL_RENDERER);
        version = text(GL_VERSION);
        return {};
    }

    void send_messages(base::Log& log) const {
        if (!debug_build && !log.shows(base::LogLevel::debug)) return;
        api.Enable(GL_DEBUG_OUTPUT);
        api.Enable(GL_DEBUG_OUTPUT_SYNCHRONOUS);
        api.DebugMessageCallback(on_debug_message, &log);
    }
};

Context::Context(std::unique_ptr<State> state) : state_(std::move(state)) {}
Context::~Context() = default;
Context::Context(Context&&) noexcept = default;
Context& Context::operator=(Context&&) noexcept = default;

base::Result<Context> Context::create(Backend backend, base::Log& log) {
    std::string reasons;
    std::string remedy;
    for (const Way& way : ways) {
        if (backend != Backend::automatic && backend != way.backend) continue;
        Failure failure;
        if (auto platform = way.open()) {
            auto state = std::make_unique<State>();
            state->platform = std::move(*platform);
            failure = state->describe();
            if (failure.reason.empty()) {
                state->send_messages(log);
                log.debug("{}: {}, {}", way.name, state->renderer, state->version);
                return Context(std::move(state));
            }
        } else {
            failure = platform.error();
        }
        log.debug("{}: {}", way.name, failure.reason);
        reasons += (reasons.empty() ? "" : "; ") + std::string(way.name) + ": " + failure.reason;
        remedy = failure.remedy;
    }
    return base::fail({.code = base::ErrorCode::no_backend,
                       .what = "no usable GL backend",
                       .found = reasons,
                       .remedy = remedy});
}

base::Result<Context> Context::adopt(Loader loader, base::Log& log) {
    auto state = std::make_unique<State>();
    state->platform = {"window", loader, {}};
    if (const Failure failure = state->describe(); !failure.reason.empty())
        return base::fail({.code = base::ErrorCode::no_backend,
                           .what = "the window's GL cannot be used",
                           .found = failure.reason,
                           .remedy = failure.remedy});
    state->send_messages(log);
    log.debug("window: {}, {}", state->renderer, state->version);
    return Context(std::move(state));
}

const Api& Context::api() const noexcept { return state_->api; }
const std::string& Context::backend() const noexcept { return state_->platform.backend; }
const std::string& Context::renderer() const noexcept { return state_->renderer; }
const std::string& Context::version() const noexcept { return state_->version; }

bool Context::is_software() const noexcept {
    return state_->renderer.find("llvmpipe") != std::string::npos ||
           state_->renderer.find("softpipe") != std::string::npos;
}

void Context::texture_barrier() const {
    if (state_->texture_barrier != nullptr) state_->texture_barrier();
}

base::Status Context::check(const char* pass) const {
    const GLenum error = state_->api.GetError();
    if (error == GL_NO_ERROR) return {};
    const bool memory = error == GL_OUT_OF_MEMORY;
    return base::fail({.code = memory ? base::ErrorCode::limit_reached : base::ErrorCode::internal,
                       .where = pass,
                       .what = memory ? "GL is out of memory" : "GL reports an error",
                       .found = fmt::format("0x{:x}", error),
                       .remedy = memory ? "a smaller --size, or fewer AOVs" : ""});
}

std::vector<BackendReport> probe_backends() {
    std::vector<BackendReport> reports;
    for (const Way& way : ways) {
        BackendReport report{.name = way.name};
        Failure failure;
        if (auto platform = way.open()) {
            Context::State state;
            state.platform = std::move(*platform);
            failure = state.describe();
            report.works = failure.reason.empty();
            report.renderer = state.renderer;
            report.version = state.version;
        } else {
            failure = platform.error();
        }
        report.reason = failure.reason;
        report.remedy = failure.remedy;
        reports.push_back(std::move(report));
    }
    return reports;
}

std::string shader_cache_folder() {
    const char* const of_user = std::getenv("MESA_SHADER_CACHE_DIR");
    if (of_user != nullptr && *of_user != '\0') return of_user;
    const std::filesystem::path cache = base::cache_folder();
    return cache.empty() ? "" : (cache / "shaders").string();
}

void prepare_environment(unsigned thread_count) {
    // Mesa makes the last folder of the path only, and complains by itself where it finds none.
    const std::string folder = shader_cache_folder();
    std::error_code error;
    if (!folder.empty()) std::filesystem::create_directories(folder, error);
    if (folder.empty() || error)
        ::setenv("MESA_SHADER_CACHE_DISABLE", "true", 0);
    else
        ::setenv("MESA_SHADER_CACHE_DIR", folder.c_str(), 0);
    if (thread_count > 0) ::setenv("LP_NUM_THREADS", std::to_string(thread_count).c_str(), 0);
}

}  // namespace facet::gl
