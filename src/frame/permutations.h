// Programs made at first need and kept by their key.
// SPDX-License-Identifier: MIT
#pragma once

#include "gl/shader.h"

#include <map>

namespace facet::frame {

/// Key has operator<; `make` builds the program of a key. Addresses stay valid.
template <class Key>
class Permutations {
public:
    template <class Make>
    base::Result<const gl::Program*> get(const Key& key, Make&& make) {
        if (const auto found = programs_.find(key); found != programs_.end()) return &found->second;
        auto program = make(key);
        if (!program) return tl::unexpected(program.error());
        return &programs_.emplace(key, std::move(*program)).first->second;
    }

private:
    std::map<Key, gl::Program> programs_;
};

}  // namespace facet::frame
