// What a scene's picture depends on: its file, and those that it names.
// SPDX-License-Identifier: MIT
#include "base/hash.h"
#include "scene/gltf/gltf.h"
#include "scene/gltf/uri.h"

namespace facet::scene::gltf {

std::string content_hash(base::Bytes file, Origin origin, const base::Limits& limits) {
    base::Sha256 hash;
    hash.add_text({reinterpret_cast<const char*>(file.data()), file.size()});
    Problems none;
    auto asset = open_asset(std::move(file), std::move(origin), limits, none);
    if (!asset) return hash.hex();  // the file alone says why there will be no picture
    for (const char* const array : {"buffers", "images"})
        for (std::size_t i = 0; i < count_at(asset->json, array); ++i) {
            const std::string uri = string_at(*element_at(asset->json, array, i), "uri");
            if (uri.empty() || is_data_uri(uri)) continue;
            const auto bytes = read_uri(*asset, uri, limits.file_bytes);
            hash.add_text(uri);
            hash.add_text(bytes ? std::string_view(reinterpret_cast<const char*>(bytes->data()),
                                                   bytes->size())
                                : bytes.error().what);
        }
    return hash.hex();
}

}  // namespace facet::scene::gltf
