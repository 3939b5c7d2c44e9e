// What the ways to a context have in common; inside gl/ only.
// SPDX-License-Identifier: MIT
#pragma once

#include "base/result.h"
#include "gl/api.h"
#include "gl/context.h"

#include <functional>
#include <memory>
#include <string>

namespace facet::gl {

/// A current context and how to end it.
struct Context::Platform {
    std::string backend;
    Loader loader = nullptr;
    std::function<void()> end;
};

/// Why a way failed, and what mends it.
struct Failure {
    std::string reason;
    std::string remedy;
};
using PlatformResult = tl::expected<Context::Platform, Failure>;

[[nodiscard]] PlatformResult open_egl_device();
[[nodiscard]] PlatformResult open_egl_surfaceless();
[[nodiscard]] PlatformResult open_osmesa();

}  // namespace facet::gl
