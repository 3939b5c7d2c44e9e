// FACET_ASSERT: wrong calls by ourselves, never for input. On in dev and sanitizer builds.
// SPDX-License-Identifier: MIT
#pragma once

#ifdef FACET_ASSERTS
#include <cassert>
#undef NDEBUG
#define FACET_ASSERT(claim) assert(claim)
#else
#define FACET_ASSERT(claim) static_cast<void>(0)
#endif
