// Pictures that a program has written.
// SPDX-License-Identifier: MIT
#pragma once

#include "base/file.h"
#include "image/read.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <utility>

namespace facet::support {

/// Empty, and a failure of the test, where it cannot be read.
inline image::Image picture(const std::filesystem::path& path) {
    const auto bytes = base::read_file(path, 1U << 26U);
    EXPECT_TRUE(bytes) << path;
    if (!bytes) return {};
    base::Warnings warnings;
    auto image = image::decode(*bytes, {}, warnings);
    EXPECT_TRUE(image) << path;
    return image ? std::move(*image) : image::Image{};
}

}  // namespace facet::support
