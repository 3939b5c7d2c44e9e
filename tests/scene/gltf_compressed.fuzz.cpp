// Compressed geometry, mutated: whatever the streams hold, loading answers and nothing breaks.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <random>

#include "gltf_mutation.h"
#ifdef FACET_HAS_MESHOPT
#include "gltf_meshopt.h"
#endif
#ifdef FACET_HAS_DRACO
#include "gltf_draco.h"
#endif

namespace facet::test {
namespace {

/// The document itself, then `glb` with up to four bytes of its BIN chunk bent in each round.
void feed_bent_streams(const Document& d, std::uint32_t seed) {
    const std::string glb = d.glb();
    const auto loaded = load_text(glb);
    ASSERT_TRUE(loaded) << base::to_line(loaded.error());
    const std::size_t start = glb.size() - (d.bytes.size() + 3) / 4 * 4;
    std::mt19937 random(seed);
    const auto pick = [&](std::size_t below) { return static_cast<std::size_t>(random()) % below; };
    for (std::size_t round = 0; round < rounds() / 2; ++round) {
        SCOPED_TRACE(round);
        std::string bent = glb;
        for (std::size_t n = 1 + pick(4); n > 0; --n) {
            char& byte = bent[start + pick(bent.size() - start)];
            byte = static_cast<char>(
                pick(2) == 0 ? random() : static_cast<unsigned char>(byte) ^ (1U << pick(8)));
        }
        feed(bent);
        if (testing::Test::HasFatalFailure()) return;
    }
}

#ifdef FACET_HAS_MESHOPT

TEST(MeshoptFuzz, bent_streams_never_do_more_than_fail) {
    feed_bent_streams(packed_sheet("EXT_meshopt_compression"), 20240601);
}

TEST(MeshoptFuzz, hostile_numbers_never_do_more_than_fail) {
    feed_hostile_numbers(packed_sheet("KHR_meshopt_compression").finished());
}

#endif

#ifdef FACET_HAS_DRACO

TEST(DracoFuzz, bent_streams_never_do_more_than_fail) {
    feed_bent_streams(draco_document(draco::MESH_EDGEBREAKER_ENCODING, 10), 20240602);
    feed_bent_streams(draco_document(draco::MESH_SEQUENTIAL_ENCODING), 20240603);
}

TEST(DracoFuzz, hostile_numbers_never_do_more_than_fail) {
    feed_hostile_numbers(draco_document().finished());
}

#endif

}  // namespace
}  // namespace facet::test
