// SHA-256, by Nettle.
// SPDX-License-Identifier: MIT
#include "base/hash.h"

#include "base/thread_pool.h"

#include <nettle/sha2.h>
#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

namespace facet::base {

struct Sha256::State {
    sha256_ctx context;
};

Sha256::Sha256() : state_(std::make_unique<State>()) { sha256_init(&state_->context); }
Sha256::~Sha256() = default;
Sha256::Sha256(Sha256&&) noexcept = default;
Sha256& Sha256::operator=(Sha256&&) noexcept = default;

void Sha256::add(std::span<const std::byte> bytes) {
    sha256_update(&state_->context, bytes.size(),
                  reinterpret_cast<const std::uint8_t*>(bytes.data()));
}

void Sha256::add_text(std::string_view text) {
    const std::string length = fmt::format("{}:", text.size());
    add(std::as_bytes(std::span(length)));
    add(std::as_bytes(std::span(text)));
}

std::string Sha256::hex() {
    std::array<std::uint8_t, SHA256_DIGEST_SIZE> digest{};
    sha256_digest(&state_->context, digest.size(), digest.data());
    std::string out;
    for (const std::uint8_t byte : digest) out += fmt::format("{:02x}", byte);
    return out;
}

std::string sha256_hex(std::span<const std::byte> bytes) {
    Sha256 hash;
    hash.add(bytes);
    return hash.hex();
}

std::string sha256_of_blocks(std::span<const std::byte> bytes, ThreadPool& pool) {
    constexpr std::size_t block_bytes = std::size_t{1} << 20U;
    std::vector<std::string> blocks((bytes.size() + block_bytes - 1) / block_bytes);
    pool.parallel_for(blocks.size(), [&](std::size_t i) {
        const std::size_t first = i * block_bytes;
        blocks[i] = sha256_hex(bytes.subspan(first, std::min(block_bytes, bytes.size() - first)));
    });
    Sha256 hash;
    for (const std::string& block : blocks) hash.add_text(block);
    return hash.hex();
}

}  // namespace facet::base
