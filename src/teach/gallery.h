// The pictures of lessons, rendered.
// SPDX-License-Identifier: MIT
#pragma once

#include "base/log.h"
#include "image/image.h"
#include "teach/lesson.h"

#include <map>
#include <string>

namespace facet::teach {

/// A picture in a page.
struct Shot {
    math::Extent size;
    std::string data_uri;  ///< WebP, lossless
    std::string command;   ///< what renders it
};

/// Renders pictures, each once.
class Gallery {
public:
    explicit Gallery(base::Log& log) : log_(&log) {}
    /// Lives as long as the gallery. Errors: those of the renderer.
    [[nodiscard]] base::Result<const Shot*> shot(const Picture& picture);

private:
    base::Log* log_;
    std::map<std::string, Shot> shots_;
};

/// The command that renders the picture; with an AOV it is in a side file of STEM.png.
[[nodiscard]] std::string command_of(const Picture& picture);

}  // namespace facet::teach
