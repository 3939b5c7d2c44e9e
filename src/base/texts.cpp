// What the program says to a person in a language.
// SPDX-License-Identifier: MIT
#include "base/texts.h"

#include "base/file.h"
#include "base/resources.h"
#include "base/text.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <vector>

namespace facet::base {
namespace {

constexpr std::size_t most_bytes = std::size_t{4} << 20;

using Map = std::map<std::string, std::string, std::less<>>;

Status add(const std::filesystem::path& path, Map& texts) {
    const auto text = read_text_file(path, most_bytes);
    if (!text) return tl::unexpected(text.error());
    const auto json = nlohmann::json::parse(*text, nullptr, false);
    if (!json.is_object())
        return fail({.code = ErrorCode::internal,
                     .file = path.string(),
                     .what = "is not a JSON object",
                     .remedy = "install Facet again"});
    for (const auto& [key, value] : json.items())
        if (value.is_string()) texts[key] = value.get<std::string>();
    return {};
}

}  // namespace

Result<Texts> Texts::load(std::string_view language) {
    const std::vector<std::string> known(std::begin(languages), std::end(languages));
    if (std::find(known.begin(), known.end(), language) == known.end())
        return fail({.code = ErrorCode::usage,
                     .file = "--lang",
                     .what = "no such language",
                     .found = std::string(language),
                     .remedy = suggestion(language, known)});
    const auto folder = data_folder();
    if (!folder) return tl::unexpected(folder.error());
    Texts out;
    out.language_ = language;
    const auto texts = *folder / "resources" / "texts";
    if (auto added = add(texts / "en.json", out.texts_); !added)
        return tl::unexpected(added.error());
    if (language == "en") return out;
    if (auto added = add(texts / (out.language_ + ".json"), out.texts_); !added)
        return tl::unexpected(added.error());
    return out;
}

const char* Texts::operator()(std::string_view key) const {
    if (const auto found = texts_.find(key); found != texts_.end()) return found->second.c_str();
    return unknown_.emplace(key, key).first->second.c_str();
}

std::string_view Texts::or_else(std::string_view key, std::string_view otherwise) const {
    const auto found = texts_.find(key);
    return found == texts_.end() ? otherwise : std::string_view(found->second);
}

}  // namespace facet::base
