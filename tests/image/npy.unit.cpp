// Arrays for NumPy, byte by byte as numpy.lib.format describes them.
// SPDX-License-Identifier: MIT
#include "image/npy.h"

#include <gtest/gtest.h>

#include <cstring>
#include <string_view>

namespace facet::image {
namespace {

std::string_view text_of(const base::Bytes& bytes) {
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

TEST(Npy, HasAHeaderOfWholeBlocksAndTheNumbers) {
    Image image({3, 2}, 3, Sample::f32);
    for (std::size_t i = 0; i < 18; ++i) image.as<float>()[i] = static_cast<float>(i) * 0.5F;
    const base::Bytes bytes = encode_npy(image, NpyType::f32);
    const std::string_view text = text_of(bytes);
    EXPECT_EQ(text.substr(0, 8), std::string_view("\x93NUMPY\x01\x00", 8));
    const std::size_t length =
        static_cast<unsigned char>(text[8]) + 256U * static_cast<unsigned char>(text[9]);
    EXPECT_EQ((10 + length) % 64, 0U);
    EXPECT_EQ(text[10 + length - 1], '\n');
    EXPECT_NE(text.find("{'descr': '<f4', 'fortran_order': False, 'shape': (2, 3, 3), }"),
              std::string_view::npos);
    ASSERT_EQ(bytes.size(), 10 + length + 18 * sizeof(float));
    float last = 0.0F;
    std::memcpy(&last, bytes.data() + bytes.size() - sizeof last, sizeof last);
    EXPECT_EQ(last, 8.5F);
}

TEST(Npy, HoldsIdsAsWholeNumbers) {
    Image image({2, 1}, 1, Sample::f32);
    image.as<float>()[0] = 0.0F;
    image.as<float>()[1] = 70000.0F;
    const base::Bytes bytes = encode_npy(image, NpyType::u32);
    EXPECT_NE(text_of(bytes).find("'<u4', 'fortran_order': False, 'shape': (1, 2), }"),
              std::string_view::npos);
    std::uint32_t last = 0;
    std::memcpy(&last, bytes.data() + bytes.size() - sizeof last, sizeof last);
    EXPECT_EQ(last, 70000U);
}

}  // namespace
}  // namespace facet::image
