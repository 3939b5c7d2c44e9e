// libjpeg-turbo's headers, which lack what they need: <cstdio> must come before them, and jerror.h
// after. SPDX-License-Identifier: MIT
#pragma once

// clang-format off
#include <cstddef>
#include <cstdio>
#include <jpeglib.h>
#include <jerror.h>
// clang-format on
