// URIs of buffers and images: what kind they are, decoded once and strictly.
// SPDX-License-Identifier: MIT
#pragma once

#include "base/file.h"
#include "base/result.h"

#include <cstddef>
#include <string>
#include <string_view>

namespace facet::scene::gltf {

[[nodiscard]] bool is_data_uri(std::string_view uri);

struct DataUri {
    std::string mime;
    base::Bytes bytes;
};
/// `data:[mime][;name=value];base64,…`, or percent-encoded without `;base64`. Errors: input_invalid
/// (no comma, a wrong character and where, bad padding); limit_reached when the decoded bytes would
/// exceed `max_bytes`, before any is decoded.
[[nodiscard]] base::Result<DataUri> decode_data_uri(std::string_view uri, std::size_t max_bytes);

/// The relative path that `uri` names, percent-decoded exactly once. `+` stays `+`. Errors:
/// input_invalid for a scheme (the network is never used), an absolute path, a backslash, a leading
/// `~`, a broken escape, NUL, invalid UTF-8. Whether the path leaves the folder is
/// base::read_file_beneath's to judge.
[[nodiscard]] base::Result<std::string> decode_relative_uri(std::string_view uri);

}  // namespace facet::scene::gltf
