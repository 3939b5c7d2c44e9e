// Another run of this program beside it: how the studio renders pictures, so that what is saved is
// what the printed command gives, byte by byte. SPDX-License-Identifier: MIT
#pragma once

#include "base/result.h"

#include <optional>
#include <string>
#include <vector>

namespace facet::studio {

/// What a child left behind.
struct ChildEnd {
    int status = 0;       ///< exit status; 128 and more for a signal
    std::string message;  ///< the last line on its standard error
};

class Child {
public:
    /// Errors: temporary (no process can be had).
    [[nodiscard]] static base::Result<Child> start(const std::vector<std::string>& arguments);
    Child(Child&& other) noexcept;
    Child& operator=(Child&& other) noexcept;
    /// Ends it.
    ~Child();

    /// How it ended; nothing while it runs. Does not wait.
    [[nodiscard]] std::optional<ChildEnd> poll();

private:
    Child(int pid, int pipe) : pid_(pid), pipe_(pipe) {}
    void read();

    int pid_ = -1;
    int pipe_ = -1;
    std::string said_;
};

}  // namespace facet::studio
