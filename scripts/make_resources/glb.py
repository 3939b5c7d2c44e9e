# Writes glTF 2.0 binaries: collects data, images, materials, meshes and nodes, and packs them.
# SPDX-License-Identifier: MIT
import io
import json
import struct

import numpy as np
from PIL import Image

FLOAT, UINT16, UINT32 = 5126, 5123, 5125
ARRAY_BUFFER, ELEMENT_ARRAY_BUFFER = 34962, 34963
LINEAR, LINEAR_MIPMAP_LINEAR, REPEAT, CLAMP = 9729, 9987, 10497, 33071
KINDS = {1: "SCALAR", 2: "VEC2", 3: "VEC3", 4: "VEC4"}


class Glb:
    """One file in the making. Every add_* returns the index that others refer to."""

    def __init__(self, copyright_line):
        self.json = {
            "asset": {
                "version": "2.0",
                "generator": "facet make_resources.py",
                "copyright": copyright_line,
            }
        }
        self.blob = bytearray()
        self.roots = []

    def _append(self, key, item):
        items = self.json.setdefault(key, [])
        items.append(item)
        return len(items) - 1

    def _use(self, extension):
        used = self.json.setdefault("extensionsUsed", [])
        if extension not in used:
            used.append(extension)

    def add_view(self, data, target=None):
        while len(self.blob) % 4:
            self.blob.append(0)
        view = {"buffer": 0, "byteOffset": len(self.blob), "byteLength": len(data)}
        if target:
            view["target"] = target
        self.blob += data
        return self._append("bufferViews", view)

    def add_attribute(self, array, with_bounds=False):
        """float32 [count, 2..4]. Bounds are those of the float32 values, as POSITION asks for."""
        array = np.ascontiguousarray(array, "<f4")
        accessor = {
            "bufferView": self.add_view(array.tobytes(), ARRAY_BUFFER),
            "componentType": FLOAT,
            "count": len(array),
            "type": KINDS[array.shape[1]],
        }
        if with_bounds:
            accessor["min"] = [float(x) for x in array.min(0)]
            accessor["max"] = [float(x) for x in array.max(0)]
        return self._append("accessors", accessor)

    def add_indices(self, indices, vertex_count):
        indices = np.asarray(indices).reshape(-1)
        small = vertex_count < 65535  # 65535 itself would restart the primitive
        data = np.ascontiguousarray(indices, "<u2" if small else "<u4").tobytes()
        return self._append(
            "accessors",
            {
                "bufferView": self.add_view(data, ELEMENT_ARRAY_BUFFER),
                "count": len(indices),
                "type": "SCALAR",
                "componentType": UINT16 if small else UINT32,
            },
        )

    def add_geometry(self, surface):
        """A shapes.Surface as a primitive without material; several meshes may share it."""
        attributes = {
            "POSITION": self.add_attribute(surface.positions, with_bounds=True),
            "NORMAL": self.add_attribute(surface.normals),
        }
        if surface.tangents is not None:
            attributes["TANGENT"] = self.add_attribute(surface.tangents)
        if surface.uv0 is not None:
            attributes["TEXCOORD_0"] = self.add_attribute(surface.uv0)
        if surface.uv1 is not None:
            attributes["TEXCOORD_1"] = self.add_attribute(surface.uv1)
        return {
            "attributes": attributes,
            "indices": self.add_indices(surface.indices, len(surface.positions)),
        }

    def add_mesh(self, name, geometry, material):
        return self._append(
            "meshes", {"name": name, "primitives": [dict(geometry, material=material)]}
        )

    def add_texture(self, name, pixels, jpeg_quality=None, wrap=REPEAT):
        """u8 or u16 [height, width], or u8 [height, width, 3]; PNG, or JPEG without chroma subsampling."""
        data = io.BytesIO()
        if jpeg_quality:
            Image.fromarray(pixels).save(
                data, "JPEG", quality=jpeg_quality, subsampling=0, optimize=True
            )
        else:
            Image.fromarray(pixels).save(data, "PNG", optimize=True)
        image = self._append(
            "images",
            {
                "name": name,
                "bufferView": self.add_view(data.getvalue()),
                "mimeType": "image/jpeg" if jpeg_quality else "image/png",
            },
        )
        sampler = {
            "magFilter": LINEAR,
            "minFilter": LINEAR_MIPMAP_LINEAR,
            "wrapS": wrap,
            "wrapT": wrap,
        }
        samplers = self.json.setdefault("samplers", [])
        if sampler not in samplers:
            samplers.append(sampler)
        return self._append(
            "textures", {"name": name, "source": image, "sampler": samplers.index(sampler)}
        )

    def texture_ref(self, texture, uv_set=0, transform=None, **more):
        """What a material slot holds. `transform` is KHR_texture_transform's object."""
        ref = dict({"index": texture}, **more)
        if uv_set:
            ref["texCoord"] = uv_set
        if transform:
            self._use("KHR_texture_transform")
            ref["extensions"] = {"KHR_texture_transform": transform}
        return ref

    def add_material(
        self,
        name,
        base=(1, 1, 1),
        metallic=0.0,
        roughness=1.0,
        base_map=None,
        orm_map=None,
        normal_map=None,
        occlusion_map=None,
        emissive_nit=None,
        height_map=None,
        height_m=0.0,
        extensions=None,
    ):
        """Maps are texture_ref objects. `emissive_nit` is linear RGB radiance, `height_m` how far
        white of the height map stands out; `extensions` are as they stand in the file."""
        surface = {
            "baseColorFactor": [*map(float, base), 1.0],
            "metallicFactor": float(metallic),
            "roughnessFactor": float(roughness),
        }
        material = {"name": name, "pbrMetallicRoughness": surface}
        if base_map:
            surface["baseColorTexture"] = base_map
        if orm_map:
            surface["metallicRoughnessTexture"] = orm_map
        if normal_map:
            material["normalTexture"] = normal_map
        if occlusion_map:
            material["occlusionTexture"] = occlusion_map
        if emissive_nit:
            peak = max(emissive_nit)
            material["emissiveFactor"] = [c / peak for c in emissive_nit]
            strength = {"KHR_materials_emissive_strength": {"emissiveStrength": peak}}
            extensions = dict(extensions or {}, **strength)
        if extensions:
            for extension in extensions:
                self._use(extension)
            material["extensions"] = extensions
        if height_map:
            height = {"texture": height_map, "scale_m": height_m}
            material["extras"] = {"facet": {"height": height}}
        return self._append("materials", material)

    def add_node(self, name, root=True, **parts):
        index = self._append("nodes", dict({"name": name}, **parts))
        if root:
            self.roots.append(index)
        return index

    def add_camera(self, name, eye, target, yfov_deg, aspect=16 / 9, near=0.05, far=100.0):
        camera = self._append(
            "cameras",
            {
                "name": name,
                "type": "perspective",
                "perspective": {
                    "yfov": float(np.radians(yfov_deg)),
                    "aspectRatio": aspect,
                    "znear": near,
                    "zfar": far,
                },
            },
        )
        return self.add_node(
            name, camera=camera, translation=[float(x) for x in eye], rotation=look_at(eye, target)
        )

    def add_light(self, name, light, **node):
        """`light` is KHR_lights_punctual's object, `node` where it stands."""
        self._use("KHR_lights_punctual")
        lights = self.json.setdefault("extensions", {}).setdefault(
            "KHR_lights_punctual", {"lights": []}
        )["lights"]
        lights.append(dict({"name": name}, **light))
        link = {"KHR_lights_punctual": {"light": len(lights) - 1}}
        return self.add_node(name, **node, extensions=link)

    def add_point_light(self, name, position, candela, color=(1, 1, 1), stands_in=False):
        light = {"type": "point", "color": list(color), "intensity": candela}
        if stands_in:
            light["extras"] = {"facet": {"stands_in": True}}
        return self.add_light(name, light, translation=list(position))

    def to_bytes(self, scene_name):
        self.json["scene"] = 0
        self.json["scenes"] = [{"name": scene_name, "nodes": self.roots}]
        while len(self.blob) % 4:
            self.blob.append(0)
        self.json["buffers"] = [{"byteLength": len(self.blob)}]
        text = json.dumps(self.json, separators=(",", ":")).encode()
        text += b" " * (-len(text) % 4)
        length = 12 + 8 + len(text) + 8 + len(self.blob)
        return (
            struct.pack("<4sII", b"glTF", 2, length)
            + struct.pack("<I4s", len(text), b"JSON")
            + text
            + struct.pack("<I4s", len(self.blob), b"BIN\0")
            + bytes(self.blob)
        )


def look_at(eye, target):
    """Quaternion x y z w that turns a camera's -z towards `target` with +y up."""
    back = np.subtract(eye, target).astype(float)
    back /= np.linalg.norm(back)
    right = np.cross([0.0, 1.0, 0.0], back)
    right /= np.linalg.norm(right)
    return quaternion_from_matrix(np.stack([right, np.cross(back, right), back], 1))


def quaternion_from_matrix(m):
    """Shepperd 1978: divides by the largest of the four components."""
    trace = np.array([m[0, 0], m[1, 1], m[2, 2], np.trace(m)])
    i = int(np.argmax(trace))
    if i == 3:
        q = np.array([m[2, 1] - m[1, 2], m[0, 2] - m[2, 0], m[1, 0] - m[0, 1], 1 + trace[3]])
    else:
        j, k = (i + 1) % 3, (i + 2) % 3
        q = np.zeros(4)
        q[i] = 1 - trace[3] + 2 * m[i, i]
        q[j], q[k], q[3] = m[j, i] + m[i, j], m[k, i] + m[i, k], m[k, j] - m[j, k]
    return [float(x) for x in q / np.linalg.norm(q)]
