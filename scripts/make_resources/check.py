# Reads a finished .glb back and holds it to glTF 2.0, from the header to every tangent.
# SPDX-License-Identifier: MIT
import io
import json
import struct

import numpy as np
from PIL import Image

COMPONENTS = {5123: ("<u2", 2), 5125: ("<u4", 4), 5126: ("<f4", 4)}
COUNTS = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4}
EXTENSIONS = {
    "KHR_lights_punctual",
    "KHR_materials_diffuse_transmission",
    "KHR_materials_emissive_strength",
    "KHR_materials_ior",
    "KHR_materials_volume",
    "KHR_materials_volume_scatter",
    "KHR_texture_transform",
}


def require(holds, claim):
    if not holds:
        raise ValueError(claim)


def split(data):
    magic, version, length = struct.unpack_from("<4sII", data)
    require((magic, version, length) == (b"glTF", 2, len(data)), "header")
    chunks, at = [], 12
    while at < len(data):
        size, kind = struct.unpack_from("<I4s", data, at)
        require(size % 4 == 0 and at + 8 + size <= len(data), "chunk bounds")
        chunks.append((kind, data[at + 8 : at + 8 + size]))
        at += 8 + size
    require([k for k, _ in chunks] == [b"JSON", b"BIN\0"], "chunks")
    return json.loads(chunks[0][1]), chunks[1][1]


def read_accessor(doc, blob, index):
    accessor = doc["accessors"][index]
    view = doc["bufferViews"][accessor["bufferView"]]
    dtype, size = COMPONENTS[accessor["componentType"]]
    width = COUNTS[accessor["type"]]
    require(view["byteOffset"] % 4 == 0 and "byteStride" not in view, f"accessor {index} alignment")
    require(
        accessor["count"] * width * size == view["byteLength"], f"accessor {index} fills its view"
    )
    values = np.frombuffer(blob, dtype, accessor["count"] * width, view["byteOffset"]).reshape(
        -1, width
    )
    if "min" in accessor:
        require(np.array_equal(np.float32(accessor["min"]), values.min(0)), f"accessor {index} min")
        require(np.array_equal(np.float32(accessor["max"]), values.max(0)), f"accessor {index} max")
    require(dtype != "<f4" or bool(np.isfinite(values).all()), f"accessor {index} finite")
    return values


def check_primitive(doc, blob, primitive, name):
    got = {key: read_accessor(doc, blob, i) for key, i in primitive["attributes"].items()}
    count = len(got["POSITION"])
    require(
        "min" in doc["accessors"][primitive["attributes"]["POSITION"]], f"{name}: POSITION bounds"
    )
    require(all(len(v) == count for v in got.values()), f"{name}: equal counts")
    require(
        bool(np.abs(np.linalg.norm(got["NORMAL"], axis=1) - 1).max() < 1e-5),
        f"{name}: unit normals",
    )
    indices = read_accessor(doc, blob, primitive["indices"]).reshape(-1, 3).astype(int)
    require(
        indices.max() == count - 1 and len(np.unique(indices)) == count,
        f"{name}: every vertex used",
    )
    corners = got["POSITION"].astype(float)[indices]
    face = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    require(
        bool((np.einsum("ij,ij->i", face, got["NORMAL"][indices].sum(1)) > 0).all()),
        f"{name}: winding agrees with normals",
    )
    if "TANGENT" in got:
        tangent = got["TANGENT"]
        require(
            bool(np.abs(np.linalg.norm(tangent[:, :3], axis=1) - 1).max() < 1e-5),
            f"{name}: unit tangents",
        )
        require(set(np.unique(tangent[:, 3])) <= {-1.0, 1.0}, f"{name}: handedness")
        require(
            bool(np.abs(np.einsum("ij,ij->i", tangent[:, :3], got["NORMAL"])).max() < 1e-4),
            f"{name}: square tangents",
        )
    material = doc["materials"][primitive["material"]]
    check_material(doc, material, got, name)
    if "KHR_materials_volume" in material.get("extensions", {}):
        check_closed(indices, name)
    return len(indices)


def check_closed(indices, name):
    """Every edge is walked once each way: the surface has an inside."""
    edges = np.concatenate([indices[:, [0, 1]], indices[:, [1, 2]], indices[:, [2, 0]]])
    walked = {tuple(edge) for edge in edges}
    require(len(walked) == len(edges), f"{name}: an edge is walked twice the same way")
    require(all((b, a) in walked for a, b in walked), f"{name}: has no hole")


def check_material(doc, material, attributes, name):
    pbr = material["pbrMetallicRoughness"]
    slots = [
        pbr.get("baseColorTexture"),
        pbr.get("metallicRoughnessTexture"),
        material.get("normalTexture"),
        material.get("occlusionTexture"),
    ]
    for slot in filter(None, slots):
        require(slot["index"] < len(doc["textures"]), f"{name}: texture index")
        require(f"TEXCOORD_{slot.get('texCoord', 0)}" in attributes, f"{name}: texture coordinates")
    require(
        "normalTexture" not in material or "TANGENT" in attributes,
        f"{name}: tangents for the normal map",
    )
    require(all(0 <= c <= 1 for c in pbr["baseColorFactor"]), f"{name}: base colour range")


def check(data):
    """Raises ValueError on the first breach. Returns what is in the file, in words."""
    doc, blob = split(data)
    require(doc["buffers"] == [{"byteLength": len(blob)}], "one buffer, all of the chunk")
    for view in doc["bufferViews"]:
        require(view["byteOffset"] + view["byteLength"] <= len(blob), "view inside buffer")
    require(
        set(doc.get("extensionsUsed", [])) <= EXTENSIONS and "extensionsRequired" not in doc,
        "extensions",
    )
    for image in doc.get("images", []):
        view = doc["bufferViews"][image["bufferView"]]
        with Image.open(
            io.BytesIO(blob[view["byteOffset"] : view["byteOffset"] + view["byteLength"]])
        ) as opened:
            require(opened.get_format_mimetype() == image["mimeType"], f"{image['name']}: type")
            opened.load()
    triangles = [
        sum(check_primitive(doc, blob, p, mesh["name"]) for p in mesh["primitives"])
        for mesh in doc["meshes"]
    ]
    nodes = doc["nodes"]
    require(
        sorted(doc["scenes"][0]["nodes"]) == list(range(len(nodes))), "every node in the scene once"
    )
    require(len({n["name"] for n in nodes}) == len(nodes), "names differ")
    require(any("camera" in n for n in nodes), "a camera")
    for node in nodes:
        require(
            abs(np.linalg.norm(node.get("rotation", [1])) - 1) < 1e-6,
            f"{node['name']}: unit rotation",
        )
    placed = sum(triangles[n["mesh"]] for n in nodes if "mesh" in n)
    counts = {key: len(doc.get(key, [])) for key in ("materials", "images")}
    return (
        f"{placed} triangles, {counts['materials']} materials, {counts['images']} images, "
        f"{len(data)} bytes"
    )
