# Height maps: a ring of hammered bronze that stands on cobbles; both meshes are smooth.
# SPDX-License-Identifier: MIT
import numpy as np

from . import shapes
from .glb import Glb
from .noise import fbm, smoothstep, tile_points, worley
from .pixels import mix, srgb

RING_M, TUBE_M = 0.17, 0.075  # radii of the ring and of its tube
DENTS = (8, 3)  # tiles of the dents' map around the ring and around the tube


def torus(segments, rings):
    """Around the z axis. u goes once around it, v once around the tube."""
    u, v = np.meshgrid(np.linspace(0, 1, segments + 1), np.linspace(0, 1, rings + 1))
    u, v = u.ravel(), v.ravel()
    around, across = 2 * np.pi * (u % 1), -2 * np.pi * (v % 1)
    out = np.stack([np.cos(around), np.sin(around), np.zeros_like(u)], 1)
    normals = out * np.cos(across)[:, None] + [0, 0, 1] * np.sin(across)[:, None]
    indices = shapes.grid_indices(rings + 1, segments + 1)
    return shapes.Surface(out * RING_M + normals * TUBE_M, normals, indices, np.stack([u, v], 1))


def codes(height):
    """Height 0 to 1 as 16 bits: a slope in 8 would be stairs."""
    return np.round(np.clip(height, 0, 1) * 65535).astype(np.uint16)


def stones(size):
    """Height, 0 to 1, and colour of cobbles."""
    at = tile_points(size, 9)
    near, second, owner = worley(at, 5, 9)
    stone = smoothstep(0.03, 0.4, second - near)
    grain = fbm(at * 4, 11, octaves=4, period=36)
    height = stone * (0.78 + 0.16 * owner) + 0.05 * grain * stone + 0.03 * (1 + grain)
    color = mix(mix((0.23, 0.2, 0.17), (0.42, 0.38, 0.33), owner), (0.3, 0.31, 0.34), owner * 7 % 1)
    return height, mix((0.07, 0.055, 0.04), color * (1 + 0.25 * grain)[..., None], stone)


def dents(size):
    near, _, _ = worley(tile_points(size, 4), 23, 4)
    return smoothstep(0, 0.75, near)


def build(copyright_line):
    glb = Glb(copyright_line)
    glb.add_camera("front", (0.75, 0.62, 1.3), (0, 0.19, 0), 27)
    height, color = stones(256)
    cobbles = glb.add_material(
        "cobbles",
        base_map=glb.texture_ref(glb.add_texture("stones_color", srgb(color), 90)),
        roughness=0.75,
        height_map=glb.texture_ref(glb.add_texture("stones_height", codes(height))),
        height_m=0.03,
    )
    bronze = glb.add_material(
        "bronze",
        (0.83, 0.56, 0.36),
        1.0,
        0.28,
        height_map=glb.texture_ref(
            glb.add_texture("dents_height", codes(dents(64))), transform={"scale": list(DENTS)}
        ),
        height_m=0.008,
    )
    floor = shapes.quad((-0.8, 0, -0.8), (1.6, 0, 0), (0, 0, 1.6), (8, 8))
    ring = torus(64, 24).moved((0, 0.028 + RING_M + TUBE_M, 0), shapes.rotation((0, 1, 0), 24))
    for name, surface, material in (("cobbles", floor, cobbles), ("ring", ring, bronze)):
        geometry = glb.add_geometry(surface)
        glb.add_node(name, mesh=glb.add_mesh(name, geometry, material))
    return glb.to_bytes("relief")
