# Three hares of skin, wax and jade, the mean way of light in them rising, lit from behind and across a bar.
# SPDX-License-Identifier: MIT
import json
from dataclasses import replace
from pathlib import Path

import numpy as np

from . import hare, shapes
from .glb import Glb, look_at

# From left to right; each has the values of the preset of its name.
MATERIALS = ("skin", "wax", "jade")
PRESETS = Path(__file__).resolve().parents[2] / "resources" / "materials"
SPACING_M = 0.106
TURN_DEG = 38  # of the hares, to the right: one flank and both ears are seen
# Its shadow is the edge to look at: sharp on the floor, ever softer on skin, wax and jade. Above the picture.
BAR_M = {"at": (0.0, 0.243, 0.20), "half_length": 0.45, "radius": 0.006}
KEY = {"from": (-0.35, 0.62, 0.55), "lux": 2.2}
BACK = {"at": (0.02, 0.34, -0.50), "candela": 2.1}


def volume(preset):
    """glTF's extensions of a preset that scatters light."""
    return {
        "KHR_materials_ior": {"ior": preset["ior"]},
        "KHR_materials_diffuse_transmission": {
            "diffuseTransmissionFactor": preset["diffuse_transmission"]
        },
        "KHR_materials_volume": {
            "thicknessFactor": preset["thickness_m"],
            "attenuationColor": preset["attenuation_color"],
            "attenuationDistance": preset["attenuation_distance_m"],
        },
        "KHR_materials_volume_scatter": {"multiscatterColorFactor": preset["scatter_color"]},
    }


def add_hares(glb):
    body, eyes = glb.add_geometry(hare.surface()), glb.add_geometry(hare.eyes())
    bead = glb.add_material("bead", (0.01, 0.01, 0.01), 0.0, 0.05)
    half = np.radians(TURN_DEG) / 2
    turn = [0.0, float(np.sin(half)), 0.0, float(np.cos(half))]
    for i, name in enumerate(MATERIALS):
        preset = json.loads((PRESETS / f"{name}.json").read_text())
        material = glb.add_material(
            name,
            preset["base_color"],
            preset["metallic"],
            preset["roughness"],
            extensions=volume(preset),
        )
        place = {"translation": [(i - 1) * SPACING_M, 0.0, 0.0], "rotation": turn}
        glb.add_node(f"{name}_hare", mesh=glb.add_mesh(f"{name}_hare", body, material), **place)
        glb.add_node(f"{name}_eyes", mesh=glb.add_mesh(f"{name}_eyes", eyes, bead), **place)


def stage():
    """A floor that rises behind in a round."""
    front, back, height, round_m = 0.7, -0.75, 0.8, 0.35
    angle = np.linspace(0, np.pi / 2, 17)
    middle = np.array([round_m, back + round_m])  # y, z
    arc = middle + round_m * np.stack([-np.cos(angle), -np.sin(angle)], 1)
    normals = np.stack([np.cos(angle), np.sin(angle)], 1)
    profile = np.concatenate([[[height, back]], arc[::-1], [[0.0, front]]])
    normals = np.concatenate([[[0.0, 1.0]], normals[::-1], [[1.0, 0.0]]])
    x = np.array([-1.1, 1.1])
    positions = np.stack(
        np.broadcast_arrays(x[None, :], profile[:, :1], profile[:, 1:]), 2
    ).reshape(-1, 3)
    turned = np.stack(
        np.broadcast_arrays(0 * x[None, :], normals[:, :1], normals[:, 1:]), 2
    ).reshape(-1, 3)
    return shapes.Surface(positions, turned, shapes.grid_indices(len(profile), 2))


def bar():
    angle = np.linspace(0, 2 * np.pi, 25)
    ring = np.stack([np.cos(angle), np.sin(angle)], 1)
    flat = np.array([[1.0, 0.0], [1.0, 0.0]])
    profile = np.array([[BAR_M["radius"], 1.0], [BAR_M["radius"], -1.0]])
    tube = shapes.lathe(profile * [1, BAR_M["half_length"]], flat, len(ring) - 1, [0, 1])
    return replace(tube, uv0=None).moved(BAR_M["at"], shapes.rotation((0, 0, 1), 90))


def build(copyright_line):
    glb = Glb(copyright_line)
    glb.add_camera("front", (0.0, 0.165, 0.98), (0.004, 0.046, 0.0), 10.3)
    add_hares(glb)
    plain = glb.add_material("plain", (0.22, 0.22, 0.22), 0.0, 0.9)
    glb.add_node("stage", mesh=glb.add_mesh("stage", glb.add_geometry(stage()), plain))
    glb.add_node("bar", mesh=glb.add_mesh("bar", glb.add_geometry(bar()), plain))
    glb.add_light(
        "key",
        {"type": "directional", "color": [1.0, 0.96, 0.9], "intensity": KEY["lux"]},
        rotation=look_at(KEY["from"], (0, 0, 0)),
    )
    cone = {"innerConeAngle": 0.35, "outerConeAngle": 0.6}
    glb.add_light(
        "back",
        {"type": "spot", "color": [1.0, 1.0, 1.0], "intensity": BACK["candela"], "spot": cone},
        translation=list(BACK["at"]),
        rotation=look_at(BACK["at"], (0, 0.05, 0)),
    )
    return glb.to_bytes("subsurface")
