// Texts that are cut off, bent and stirred.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <random>
#include <string>
#include <string_view>

namespace facet::support {

/// Calls `take` with 3000 texts near `text`, the same ones for one seed; `signs` are put in.
template <class Take>
void mutate(std::string_view text, std::string_view signs, std::uint32_t seed, const Take& take) {
    std::mt19937 random(seed);
    for (int round = 0; round < 3000; ++round) {
        std::string bent(text);
        for (std::size_t edits = random() % 6 + 1; edits > 0 && !bent.empty(); --edits) {
            const std::size_t at = random() % bent.size();
            switch (random() % 5) {
                case 0:
                    bent[at] = static_cast<char>(random() & 0xFFU);
                    break;
                case 1:
                    bent.insert(at, 1, signs[random() % signs.size()]);
                    break;
                case 2:
                    bent.erase(at, random() % 20 + 1);
                    break;
                case 3:
                    bent.insert(at, bent.substr(random() % bent.size(), random() % 60));
                    break;
                default:
                    if (random() % 8 == 0) bent.resize(at);
            }
        }
        take(bent);
    }
}

}  // namespace facet::support
