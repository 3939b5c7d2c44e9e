// The order in which a glTF document is checked: each step relies on those before.
// SPDX-License-Identifier: MIT
#include "scene/gltf/check.h"

#include "scene/gltf/schema.h"

namespace facet::scene::gltf {

void check_asset(Asset& asset, Depth depth, const base::Limits& limits, Problems& problems) {
    check_version(asset.json, problems);
    check_schema(asset.json, problems);
    check_extension_lists(asset.json, problems);
    read_buffers(asset, limits, problems);
    read_views(asset, problems);
    decode_views(asset, problems);
    read_accessors(asset, limits, problems);
    decode_primitives(asset, problems);
    check_buffer_use(asset, problems);
    check_accessor_uses(asset, problems);
    check_meshes(asset, problems);
    check_nodes(asset, problems);
    check_skins(asset, problems);
    check_animations(asset, problems);
    check_cameras(asset, problems);
    check_images(asset, depth, limits, problems);
    check_materials(asset, problems);
    if (depth == Depth::elements) check_elements(asset, problems);
}

}  // namespace facet::scene::gltf
