// Where the program's own data lies.
// SPDX-License-Identifier: MIT
#include "base/resources.h"

#include <system_error>

namespace facet::base {
namespace fs = std::filesystem;

fs::path program_folder() {
    std::error_code error;
    return fs::read_symlink("/proc/self/exe", error).parent_path();
}

Result<fs::path> data_folder() {
    std::error_code error;
    const fs::path program = program_folder();
    // An installed program is PREFIX/bin; a build tree lies inside the sources, or knows where they
    // were.
    for (const fs::path& folder :
         {program / "../share/facet", program / "..", fs::path(FACET_SOURCE_FOLDER)})
        if (fs::is_directory(folder / "glsl/brdf", error) &&
            fs::is_directory(folder / "resources", error))
            return fs::weakly_canonical(folder, error);
    return fail({.code = ErrorCode::internal,
                 .file = program.string(),
                 .what = "the folders glsl/ and resources/ are not beside the program",
                 .remedy = "install Facet again, or run it from its build tree"});
}

}  // namespace facet::base
