// URIs of buffers and images, decoded once and strictly (RFC 3986, RFC 2397, RFC 4648).
// SPDX-License-Identifier: MIT
#include "scene/gltf/uri.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <optional>

namespace facet::scene::gltf {
namespace {

constexpr std::array<std::int8_t, 256> make_base64_table() {
    std::array<std::int8_t, 256> table{};
    table.fill(-1);
    constexpr std::string_view digits =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    for (std::size_t i = 0; i < digits.size(); ++i)
        table[static_cast<unsigned char>(digits[i])] = static_cast<std::int8_t>(i);
    return table;
}
constexpr auto base64_table = make_base64_table();

int digit_of(char c) { return base64_table[static_cast<unsigned char>(c)]; }

base::Result<base::Bytes> decode_base64(std::string_view text, std::size_t max_bytes) {
    if (text.size() % 4 != 0)
        return base::invalid("base64 is cut off", fmt::format("{} characters", text.size()));
    std::size_t padding = 0;
    while (padding < 2 && padding < text.size() && text[text.size() - 1 - padding] == '=')
        ++padding;
    const std::size_t size = text.size() / 4 * 3 - padding;
    if (size > max_bytes)
        return base::fail({.code = base::ErrorCode::limit_reached,
                           .what = "data URI too large",
                           .found = fmt::format("{} bytes, limit {}", size, max_bytes),
                           .remedy = "raise --max-memory"});
    base::Bytes bytes(size);
    std::size_t filled = 0;
    for (std::size_t at = 0; at < text.size(); at += 4) {
        std::uint32_t group = 0;
        for (std::size_t i = 0; i < 4; ++i) {
            const bool is_padding = at + i >= text.size() - padding;
            const int digit = is_padding ? 0 : digit_of(text[at + i]);
            if (digit < 0)
                return base::invalid(
                    "not base64",
                    fmt::format("character {:#04x} at {}",
                                static_cast<unsigned>(static_cast<unsigned char>(text[at + i])),
                                at + i));
            group = group << 6 | static_cast<std::uint32_t>(digit);
        }
        for (int shift = 16; shift >= 0 && filled < size; shift -= 8)
            bytes[filled++] = static_cast<std::byte>(group >> shift & 0xFFU);
    }
    return bytes;
}

std::optional<int> hex_digit(char c) {
    if (c >= '0' && c <= '9') return c - '0';
    if (c >= 'a' && c <= 'f') return c - 'a' + 10;
    if (c >= 'A' && c <= 'F') return c - 'A' + 10;
    return std::nullopt;
}

base::Result<std::string> percent_decoded(std::string_view uri) {
    std::string out;
    for (std::size_t i = 0; i < uri.size(); ++i) {
        if (uri[i] != '%') {
            out += uri[i];
            continue;
        }
        const auto high = i + 2 < uri.size() ? hex_digit(uri[i + 1]) : std::nullopt;
        const auto low = i + 2 < uri.size() ? hex_digit(uri[i + 2]) : std::nullopt;
        if (!high || !low)
            return base::invalid("broken % escape in a URI", std::string(uri.substr(i, 3)));
        out += static_cast<char>(*high * 16 + *low);
        i += 2;
    }
    return out;
}

/// Well-formed UTF-8: no overlong form, no surrogate, nothing above U+10FFFF (Unicode 15, table
/// 3-7).
bool is_utf8(std::string_view text) {
    for (std::size_t i = 0; i < text.size();) {
        const auto lead = static_cast<unsigned char>(text[i]);
        const std::size_t length = lead < 0x80       ? 1
                                   : lead >> 5 == 6  ? 2
                                   : lead >> 4 == 14 ? 3
                                   : lead >> 3 == 30 ? 4
                                                     : 0;
        if (length == 0 || length > text.size() - i) return false;
        std::uint32_t value = length == 1 ? lead : lead & (0xFFU >> (length + 1));
        for (std::size_t k = 1; k < length; ++k) {
            const auto next = static_cast<unsigned char>(text[i + k]);
            if (next >> 6 != 2) return false;
            value = value << 6 | (next & 0x3FU);
        }
        constexpr std::array<std::uint32_t, 5> smallest{0, 0, 0x80, 0x800, 0x10000};
        if (value < smallest[length] || value > 0x10FFFF || (value >= 0xD800 && value <= 0xDFFF))
            return false;
        i += length;
    }
    return true;
}

/// "http" of "http://x"; empty where there is no scheme. A single letter is a drive of Windows.
std::string_view scheme_of(std::string_view uri) {
    const std::size_t colon = uri.find(':');
    if (colon == std::string_view::npos || colon == 0) return {};
    const std::string_view scheme = uri.substr(0, colon);
    const bool is_scheme = std::isalpha(static_cast<unsigned char>(scheme[0])) != 0 &&
                           std::all_of(scheme.begin(), scheme.end(), [](unsigned char c) {
                               return std::isalnum(c) != 0 || c == '+' || c == '-' || c == '.';
                           });
    return is_scheme ? scheme : std::string_view{};
}

}  // namespace

bool is_data_uri(std::string_view uri) {
    constexpr std::string_view start = "data:";
    return uri.size() >= start.size() &&
           std::equal(start.begin(), start.end(), uri.begin(), [](char a, char b) {
               return a == static_cast<char>(std::tolower(static_cast<unsigned char>(b)));
           });
}

base::Result<DataUri> decode_data_uri(std::string_view uri, std::size_t max_bytes) {
    const std::size_t comma = uri.find(',');
    if (comma == std::string_view::npos)
        return base::invalid("data URI without a comma", std::string(uri.substr(0, 40)));
    std::string_view header = uri.substr(5, comma - 5);
    const std::string_view content = uri.substr(comma + 1);
    constexpr std::string_view encoding = ";base64";
    const bool is_base64 = header.ends_with(encoding);
    if (is_base64) header.remove_suffix(encoding.size());
    // After the media type come parameters of the form ;name=value, and nothing else.
    for (std::size_t at = header.find(';'); at != std::string_view::npos;) {
        const std::size_t end = std::min(header.find(';', at + 1), header.size());
        if (header.substr(at, end - at).find('=') == std::string_view::npos)
            return base::invalid("broken parameter of a data URI",
                                 std::string(header.substr(0, 80)));
        at = end == header.size() ? std::string_view::npos : end;
    }
    DataUri out{.mime = std::string(header.substr(0, header.find(';'))), .bytes = {}};
    if (is_base64) {
        auto bytes = decode_base64(content, max_bytes);
        if (!bytes) return tl::unexpected(bytes.error());
        out.bytes = std::move(*bytes);
        return out;
    }
    const auto text = percent_decoded(content);
    if (!text) return tl::unexpected(text.error());
    const auto* const first = reinterpret_cast<const std::byte*>(text->data());
    out.bytes.assign(first, first + text->size());
    return out;
}

base::Result<std::string> decode_relative_uri(std::string_view uri) {
    constexpr std::string_view gate = "--allow-read DIR if it may be read";
    const std::string shown(uri.substr(0, 200));
    if (uri.empty()) return base::invalid("empty URI", "");
    if (uri[0] == ':') return base::invalid("URI with an empty scheme", shown);
    if (const std::string_view scheme = scheme_of(uri); scheme.size() > 1 && scheme != "file")
        return base::invalid("the network is never used", shown, "download it beside the model");
    if (!scheme_of(uri).empty())
        return base::invalid("outside the model's folder", shown, std::string(gate));
    auto path = percent_decoded(uri);
    if (!path) return path;
    if (path->find('\0') != std::string::npos) return base::invalid("NUL in a URI", shown);
    if (!is_utf8(*path)) return base::invalid("URI is not UTF-8", shown);
    const char first = path->empty() ? '\0' : path->front();
    const bool is_foreign = first == '/' || first == '~' || path->find('\\') != std::string::npos ||
                            !scheme_of(*path).empty();
    if (is_foreign) return base::invalid("outside the model's folder", shown, std::string(gate));
    return path;
}

}  // namespace facet::scene::gltf
