// Reads a JSON object member by member: the first thing wrong with it is kept, with its pointer.
// SPDX-License-Identifier: MIT
#pragma once

#include "base/result.h"
#include "tables/describe.h"

#include <nlohmann/json.hpp>

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace facet::teach {

using Json = nlohmann::ordered_json;

/// A text in every language, or one for all.
struct Localized {
    std::map<std::string, std::string, std::less<>> texts;  ///< by language; "" is for all
    [[nodiscard]] const std::string& in(std::string_view language) const;
    [[nodiscard]] bool empty() const { return texts.empty(); }
    /// Whether every language of base::languages has its text.
    [[nodiscard]] bool is_complete() const;
};

class Fields {
public:
    /// `json` outlives this.
    Fields(const Json& json, std::string pointer);

    [[nodiscard]] const std::string& pointer() const { return pointer_; }
    [[nodiscard]] std::string pointer_to(std::string_view key) const;

    /// Null where there is no such member; it counts as known from now on.
    [[nodiscard]] const Json* find(std::string_view key);
    /// The members of an object or the elements of an array under `key`; none where it is not
    /// there.
    [[nodiscard]] const Json& object(std::string_view key);
    [[nodiscard]] const Json& array(std::string_view key);
    [[nodiscard]] double number(std::string_view key, double otherwise, tables::Range range);
    [[nodiscard]] bool flag(std::string_view key, bool otherwise);
    [[nodiscard]] std::string text(std::string_view key, std::string_view otherwise);
    [[nodiscard]] Localized label(std::string_view key);
    [[nodiscard]] std::vector<std::string> texts(std::string_view key);

    [[nodiscard]] bool is_known(std::string_view key) const;

    /// Keeps an error of the member `key`, unless there is one already.
    void refuse(std::string_view key, std::string what, std::string found, std::string remedy = {});
    void keep(const base::Error& error, std::string_view key);
    /// The first error; a member that nothing asked for is one.
    [[nodiscard]] base::Status finish();

private:
    const Json& json_;
    std::string pointer_;
    std::vector<std::string> known_;
    std::optional<base::Error> error_;
};

}  // namespace facet::teach
