# The grids of spheres: roughness x metallic in one colour, and white for the furnace test.
# SPDX-License-Identifier: MIT
from dataclasses import replace

import numpy as np

from . import shapes
from .glb import Glb

SPACING = 1.12  # of neighbouring spheres, in diameters


def sphere_grid(name, copyright_line, base, columns, rows, segments, rings):
    """Spheres of 1 m diameter in the plane z = 0: roughness 0 to 1 from left to right, metallic 1
    to 0 downwards."""
    glb = Glb(copyright_line)
    high = SPACING * max(rows + 0.25, (columns + 0.25) * 9 / 16)  # of the picture, metres, at 16:9
    eye_m = 5 * high
    glb.add_camera(
        "front", (0, 0, eye_m), (0, 0, 0), np.degrees(2 * np.arctan(0.5 * high / eye_m)), far=1000.0
    )
    geometry = glb.add_geometry(replace(shapes.sphere(0.5, segments, rings), uv0=None))
    for row, metallic in enumerate(np.linspace(1, 0, rows)):
        for column, roughness in enumerate(np.linspace(0, 1, columns)):
            label = f"metallic_{metallic:.2f}_roughness_{roughness:.2f}"
            material = glb.add_material(label, base, metallic, roughness)
            glb.add_node(
                label,
                mesh=glb.add_mesh(label, geometry, material),
                translation=[
                    float((column - (columns - 1) / 2) * SPACING),
                    float(((rows - 1) / 2 - row) * SPACING),
                    0.0,
                ],
            )
    return glb.to_bytes(name)


def spheres(copyright_line):
    return sphere_grid("spheres", copyright_line, (0.80, 0.235, 0.085), 7, 5, 48, 24)


def furnace(copyright_line):
    return sphere_grid("furnace", copyright_line, (1, 1, 1), 6, 3, 40, 20)


def ball(copyright_line):
    """One ball of 1 m diameter: what lessons change one number of."""
    glb = Glb(copyright_line)
    high = 1.12
    eye_m = 5 * high
    glb.add_camera(
        "front", (0, 0, eye_m), (0, 0, 0), np.degrees(2 * np.arctan(0.5 * high / eye_m)), far=1000.0
    )
    geometry = glb.add_geometry(replace(shapes.sphere(0.5, 96, 48), uv0=None))
    material = glb.add_material("ball", (0.80, 0.235, 0.085), 0.0, 0.4)
    glb.add_node("ball", mesh=glb.add_mesh("ball", geometry, material))
    return glb.to_bytes("ball")
