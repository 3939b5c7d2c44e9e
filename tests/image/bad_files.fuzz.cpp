// Broken pictures collected from other projects, where they lie beside the sources: an error or a
// picture. SPDX-License-Identifier: MIT
#include "base/file.h"
#include "image/read.h"
#include "support/image_samples.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

namespace facet {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> files_of(const fs::path& folder) {
    std::vector<fs::path> out;
    std::error_code error;
    for (const auto& entry : fs::recursive_directory_iterator(folder, error))
        if (entry.is_regular_file()) out.push_back(entry.path());
    std::ranges::sort(out);
    return out;
}

base::Limits limits() {
    base::Limits out;
    out.memory_bytes = std::size_t{512} << 20;
    return out;
}

class BadFiles : public testing::TestWithParam<const char*> {};

TEST_P(BadFiles, give_an_error_or_a_whole_picture) {
    const auto files = files_of(fs::path(FACET_SOURCE_DIR) / "../shared/assets/bad" / GetParam());
    if (files.empty()) GTEST_SKIP() << "no such files here";
    for (const fs::path& path : files) {
        SCOPED_TRACE(path.filename().string());
        const auto bytes = base::read_file(path, limits().file_bytes);
        ASSERT_TRUE(bytes);
        base::Warnings warnings;
        const auto pixels = image::decode(*bytes, limits(), warnings);
        const auto picture = image::decode_picture(*bytes, limits());
        EXPECT_EQ(pixels.has_value(), picture.has_value());
        if (pixels) {
            EXPECT_EQ(pixels->bytes.size(),
                      pixels->sample_count() * image::sample_bytes(pixels->sample));
            continue;
        }
        const auto code = pixels.error().code;
        EXPECT_TRUE(code == base::ErrorCode::input_invalid ||
                    code == base::ErrorCode::feature_missing ||
                    code == base::ErrorCode::limit_reached)
            << base::to_line(pixels.error());
    }
}

INSTANTIATE_TEST_SUITE_P(collected, BadFiles, testing::Values("images", "exr"));

/// What none of them may be: a picture of the wrong bytes.
TEST(BadFiles, what_is_cut_short_or_contradicts_itself_is_no_picture) {
    const fs::path folder = fs::path(FACET_SOURCE_DIR) / "../shared/assets/bad/images";
    if (files_of(folder).empty()) GTEST_SKIP() << "no such files here";
    for (const char* name :
         {"derived/jpeg_truncated.jpg", "derived/jpeg_header_only.jpg",
          "derived/jpeg_zero_size.jpg", "derived/webp_truncated.webp",
          "derived/hdr_run_overflow.hdr", "derived/hdr_truncated_scanline.hdr",
          "derived/hdr_zero_count.hdr", "derived/hdr_huge_size.hdr", "derived/hdr_header_only.hdr",
          "derived/hdr_no_resolution.hdr", "derived/not_an_image.png", "derived/empty.png",
          "png-suite/xdtn0g01.png", "png-suite/xhdn0g08.png", "png-suite/xcsn0g01.png",
          "png-suite/xs1n0g01.png", "png-suite/xc1n0g08.png", "png-suite/xd0n2c08.png"}) {
        const auto bytes = base::read_file(folder / name, limits().file_bytes);
        ASSERT_TRUE(bytes) << name;
        EXPECT_FALSE(test::decoded(*bytes)) << name;
    }
}

}  // namespace
}  // namespace facet
