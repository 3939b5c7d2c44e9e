// SHA-256: what tells whether a file is still the one that it was.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <string_view>

namespace facet::base {

class ThreadPool;

/// SHA-256 (FIPS 180-4) of what it is fed.
class Sha256 {
public:
    Sha256();
    ~Sha256();
    Sha256(Sha256&&) noexcept;
    Sha256& operator=(Sha256&&) noexcept;

    void add(std::span<const std::byte> bytes);
    /// A text with its length before it, so that "ab" "c" is not "a" "bc".
    void add_text(std::string_view text);
    /// 64 digits; begins anew.
    [[nodiscard]] std::string hex();

private:
    struct State;
    std::unique_ptr<State> state_;
};

[[nodiscard]] std::string sha256_hex(std::span<const std::byte> bytes);
/// SHA-256 of the SHA-256 of each MiB: several at a time, the same for any number of threads.
[[nodiscard]] std::string sha256_of_blocks(std::span<const std::byte> bytes, ThreadPool& pool);

}  // namespace facet::base
