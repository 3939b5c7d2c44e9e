// facet doctor: what works on this machine, and what to do about what does not.
// SPDX-License-Identifier: MIT
#include "base/resources.h"
#include "base/text.h"
#include "cli/flags.h"
#include "gl/context.h"

#include <link.h>
#include <nlohmann/json.hpp>
#include <spdlog/fmt/fmt.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <system_error>
#include <thread>
#include <vector>

namespace facet::cli {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

/// The codec and driver libraries in this process, by the names their files really have: those hold
/// versions.
std::vector<std::string> loaded_libraries() {
    std::vector<std::string> paths;
    dl_iterate_phdr(
        [](dl_phdr_info* info, std::size_t, void* out) {
            static_cast<std::vector<std::string>*>(out)->emplace_back(info->dlpi_name);
            return 0;
        },
        &paths);
    std::vector<std::string> names;
    for (const std::string& path : paths) {
        std::error_code error;
        const std::string name = fs::canonical(path, error).filename().string();
        for (const std::string_view wanted :
             {"libpng", "libjpeg", "libwebp", "libOpenEXR", "libdeflate", "libspdlog", "libEGL",
              "libOSMesa", "libtinygltf", "libmeshoptimizer", "libdraco"})
            if (!error && name.starts_with(wanted)) names.push_back(name);
    }
    std::ranges::sort(names);
    names.erase(std::ranges::unique(names).begin(), names.end());
    return names;
}

/// Variables of the drivers and libraries that the user has set: they change what is drawn, or how
/// fast.
std::vector<std::string> driver_variables() {
    std::vector<std::string> out;
    for (char** entry = environ; entry != nullptr && *entry != nullptr; ++entry)
        for (const std::string_view prefix :
             {"LIBGL_", "MESA_", "GALLIUM_", "GALLIVM_", "LP_", "EGL_", "__EGL_", "__GLX_", "OIIO_",
              "OPENIMAGEIO_", "OMP_", "FACET_"})
            if (std::string_view(*entry).starts_with(prefix)) out.emplace_back(*entry);
    std::ranges::sort(out);
    return out;
}

Json limit_of(int resource) {
    rlimit limit{};
    if (::getrlimit(static_cast<__rlimit_resource>(resource), &limit) != 0 ||
        limit.rlim_cur == RLIM_INFINITY)
        return "unlimited";
    return limit.rlim_cur;
}

Json backend_objects(const std::vector<gl::BackendReport>& reports) {
    Json out = Json::array();
    for (const gl::BackendReport& r : reports)
        out.push_back({{"name", r.name},
                       {"works", r.works},
                       {"renderer", r.renderer},
                       {"version", r.version},
                       {"reason", r.reason},
                       {"remedy", r.remedy}});
    return out;
}

/// Where pictures that the fast path cannot read or write are handled; opened at need, so only
/// looked for.
Json module_object() {
    std::error_code error;
    for (const fs::path& folder : {base::program_folder(), base::program_folder() / "../lib/facet"})
        if (fs::exists(folder / "libfacet_oiio.so", error))
            return fs::weakly_canonical(folder / "libfacet_oiio.so", error).string();
    return nullptr;
}

Json examine() {
    const std::vector<std::string> variables = driver_variables();  // before we set one ourselves
    gl::prepare_environment(0);
    Json out{{"facet", 1}, {"version", FACET_VERSION}};
    out["backends"] = backend_objects(gl::probe_backends());
    out["threads"] = std::max(1U, std::thread::hardware_concurrency());
    const auto pages = static_cast<std::uint64_t>(::sysconf(_SC_PHYS_PAGES));
    out["memory_mib"] = pages * static_cast<std::uint64_t>(::sysconf(_SC_PAGE_SIZE)) >> 20;
    out["limits"] = {{"open_files", limit_of(RLIMIT_NOFILE)},
                     {"address_space", limit_of(RLIMIT_AS)},
                     {"file_size", limit_of(RLIMIT_FSIZE)}};
    const auto data = base::data_folder();
    out["data"] = data ? Json(data->string()) : Json(nullptr);
    out["oiio_module"] = module_object();
    out["shader_cache"] = gl::shader_cache_folder();
    out["libraries"] = loaded_libraries();
    out["environment"] = variables;
    return out;
}

std::string text_of(const Json& value) {
    return value.is_string() ? base::escaped(value.get<std::string>(), 400) : value.dump();
}

void print_backends(const Json& backends, Io& io) {
    for (const Json& b : backends) {
        if (b["works"].get<bool>()) {
            io.print(fmt::format("{:<16} works: {}, {}", text_of(b["name"]), text_of(b["renderer"]),
                                 text_of(b["version"])));
            continue;
        }
        io.print(fmt::format("{:<16} not here: {}", text_of(b["name"]), text_of(b["reason"])));
        if (!text_of(b["remedy"]).empty())
            io.print(fmt::format("{:<16} to mend it: {}", "", text_of(b["remedy"])));
    }
}

void print_text(const Json& report, Io& io) {
    print_backends(report["backends"], io);
    io.print(fmt::format("{:<16} {}", "threads", report["threads"].dump()));
    io.print(fmt::format("{:<16} {} MiB", "memory", report["memory_mib"].dump()));
    for (const auto& [name, value] : report["limits"].items())
        io.print(fmt::format("{:<16} {} {}", "limit", name, text_of(value)));
    io.print(fmt::format("{:<16} {}", "data",
                         report["data"].is_null()
                             ? "glsl/ and resources/ were not found; install Facet again"
                             : text_of(report["data"])));
    io.print(fmt::format("{:<16} {}", "TIFF and more",
                         report["oiio_module"].is_null()
                             ? "libfacet_oiio.so is not beside the program; build or install it"
                             : text_of(report["oiio_module"])));
    io.print(fmt::format("{:<16} {}", "shader cache",
                         report["shader_cache"] == ""
                             ? "none: FACET_CACHE is off, or HOME and XDG_CACHE_HOME are not set"
                             : text_of(report["shader_cache"])));
    for (const char* list : {"libraries", "environment"}) {
        std::vector<std::string> names;
        for (const Json& entry : report[list]) names.push_back(text_of(entry));
        if (!names.empty()) io.print(fmt::format("{:<16} {}", list, base::join(names, "  ")));
    }
}

base::Result<Exit> run_doctor(Io& io) {
    const Json report = examine();
    if (io.json)
        io.print_object(report);
    else
        print_text(report, io);
    const bool renders = std::ranges::any_of(report["backends"],
                                             [](const Json& b) { return b["works"].get<bool>(); });
    return renders && !report["data"].is_null() ? Exit::done : Exit::no_backend;
}

}  // namespace

void add_doctor(Declaration& command) { command.job = run_doctor; }

}  // namespace facet::cli
