// How far a long work has come: said by who works, shown by who called.
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <string_view>

namespace facet::base {

/// `done` in [0, 1]; `what` says it in numbers ("32 of 256 samples"). May be called from the thread
/// that works only.
using Progress = std::function<void(double done, std::string_view what)>;

}  // namespace facet::base
