// A glTF document that is written: its JSON in the file's own order, and its buffers.
// SPDX-License-Identifier: MIT
#pragma once

#include "base/file.h"
#include "base/result.h"
#include "scene/gltf/asset.h"

#include <nlohmann/json.hpp>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace facet::scene::gltf {

using OrderedJson = nlohmann::ordered_json;

/// Another file that the document names.
struct SideFile {
    std::string path;  ///< relative to the document's folder, decoded
    base::Bytes bytes;
};

struct Document {
    OrderedJson json;
    base::Bytes bin;  ///< of a GLB; what is added to it goes at its end
    bool has_bin = false;
    base::Bytes later_chunks;  ///< of a GLB, as they stand
    std::vector<SideFile> new_files;
};

/// From a sound asset. Errors: internal (the text that was sound is not).
[[nodiscard]] base::Result<Document> document_of(const Asset& asset);

/// The element of an array, made with what is before it where it is missing.
[[nodiscard]] OrderedJson& array_at(OrderedJson& object, const std::string& key);
/// Adds `extension` to extensionsUsed.
void use_extension(OrderedJson& json, std::string_view extension);
/// A float as the shortest decimals that read back to it.
[[nodiscard]] OrderedJson shortest(float value);
[[nodiscard]] OrderedJson shortest(const math::Vec3& value);

/// Adds bytes to the BIN as a buffer view; its index.
[[nodiscard]] std::size_t append_view(Document& document, std::span<const std::byte> bytes);

/// The bytes of a .glb. Errors: limit_reached (4 GiB).
[[nodiscard]] base::Result<base::Bytes> glb_bytes(const Document& document);
/// The text of a .gltf.
[[nodiscard]] base::Bytes gltf_bytes(const Document& document);

/// Moves every buffer and image into the BIN. Errors: feature_missing (a buffer without bytes, a
/// picture of a kind that a GLB does not hold).
[[nodiscard]] base::Status pack(Asset& asset, Document& document);
/// Moves the BIN into a file beside, called `name`.
void unpack(Document& document, const std::string& name);
/// The files that the document names by relative URI. Errors: as read_uri.
[[nodiscard]] base::Result<std::vector<SideFile>> named_files(Asset& asset,
                                                              const Document& document);

}  // namespace facet::scene::gltf
