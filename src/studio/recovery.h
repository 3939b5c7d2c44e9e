// Unsaved work, kept beside the desktop's other state so that a crash loses nothing.
// SPDX-License-Identifier: MIT
#pragma once

#include "base/result.h"
#include "studio/document.h"

#include <filesystem>
#include <optional>
#include <string>

namespace facet::studio {

/// `{"facet": 1, "scene": ..., "settings": {key: [texts]}}`.
[[nodiscard]] std::string recovery_text(const Document& document);
/// Errors: input_invalid (not JSON, unknown key, a value that its setting does not take).
[[nodiscard]] base::Result<Document> parse_recovery(std::string_view text);

/// Work that an earlier session left unsaved.
struct Recovered {
    std::filesystem::path file;
    Document document;
};

/// One file for this process, written at every step of work.
class Recovery {
public:
    /// `folder`: where the files lie; empty: nothing is kept.
    explicit Recovery(std::filesystem::path folder);

    /// Errors: as base::write_file_atomically.
    [[nodiscard]] base::Status keep(const Document& document);
    /// Takes the file away. What nobody drops stays: however a session ends, its work is kept.
    void drop();
    /// The newest work of a process that is no more.
    [[nodiscard]] std::optional<Recovered> find() const;

private:
    std::filesystem::path folder_;
    std::filesystem::path own_;
};

}  // namespace facet::studio
