// The studio without a display, worked by a script. SPDX-License-Identifier: MIT
#pragma once

#include "support/process.h"
#include "support/temporary_folder.h"

#include <string>
#include <vector>

namespace facet::test {

/// Opens `scene` in a window of that size in `folder` and does `script`; `options` are the
/// command's.
inline support::Ran run_script(const support::TemporaryFolder& folder, const std::string& scene,
                               const std::string& window, const std::string& script,
                               const std::vector<std::string>& options) {
    folder.write("script.txt", script);
    std::vector<std::string> all{"studio", scene,  "--offscreen", "--window",
                                 window,   "--do", "script.txt"};
    all.insert(all.end(), options.begin(), options.end());
    return support::facet(all, {.folder = folder.path()});
}

}  // namespace facet::test
