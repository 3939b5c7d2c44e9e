// What the program says to a person in a language: one file a language, resources/texts/LANG.json.
// SPDX-License-Identifier: MIT
#pragma once

#include "base/result.h"

#include <map>
#include <string>
#include <string_view>

namespace facet::base {

/// Texts by key ("studio.open"). A key that the language lacks is said in English; one that English
/// lacks too is said as it stands.
class Texts {
public:
    /// `language` is "en" or "ru". Errors: usage (no such language), internal (no such file, not
    /// JSON).
    [[nodiscard]] static Result<Texts> load(std::string_view language);

    /// Lives as long as this.
    [[nodiscard]] const char* operator()(std::string_view key) const;
    /// As above, or `otherwise` where the key is in no file.
    [[nodiscard]] std::string_view or_else(std::string_view key, std::string_view otherwise) const;
    [[nodiscard]] bool has(std::string_view key) const { return texts_.contains(key); }
    [[nodiscard]] const std::string& language() const { return language_; }

private:
    std::string language_;
    std::map<std::string, std::string, std::less<>> texts_;
    mutable std::map<std::string, std::string, std::less<>> unknown_;
};

/// The languages there are.
inline constexpr std::string_view languages[] = {"en", "ru"};

}  // namespace facet::base
