# The Cornell box, 2 m wide, with an emitting lamp and a point light that stands in for it.
# SPDX-License-Identifier: MIT
from dataclasses import replace

import numpy as np

from . import shapes
from .glb import CLAMP, Glb
from .occlusion import cosine_rays, frames
from .pixels import to_bytes

# The box: 2 m on a side, floor at y = 0, open towards +z. Corner, edge along u, edge along v (see
# shapes.quad).
WALLS = {
    "floor": ((-1, 0, -1), (2, 0, 0), (0, 0, 2)),
    "ceiling": ((-1, 2, 1), (2, 0, 0), (0, 0, -2)),
    "back": ((-1, 2, -1), (2, 0, 0), (0, -2, 0)),
    "left": ((-1, 2, 1), (0, 0, -2), (0, -2, 0)),
    "right": ((1, 2, -1), (0, 0, 2), (0, -2, 0)),
}
# Reflectances of the usual paints, rounded: white, red, green (linear Rec.709).
PAINT = {"white": (0.73, 0.73, 0.73), "red": (0.62, 0.06, 0.05), "green": (0.14, 0.45, 0.09)}
# Half extents, middle and turn about y in degrees.
BOXES = {
    "tall_box": ((0.30, 0.60, 0.30), (-0.34, 0.60, -0.34), 18),
    "short_box": ((0.30, 0.30, 0.30), (0.36, 0.30, 0.32), -17),
}
# A dark board around the opening: no camera sees past the box, whatever the picture's aspect.
BOARD = (
    ((-9, 6, 1), (8, 0, 0), (0, -10, 0)),
    ((1, 6, 1), (8, 0, 0), (0, -10, 0)),
    ((-1, 6, 1), (2, 0, 0), (0, -4, 0)),
    ((-1, 0, 1), (2, 0, 0), (0, -4, 0)),
)
LAMP_HALF_M, LAMP_NIT = (0.30, 0.24), (17.0, 13.6, 9.6)


def box_faces(half):
    x, y, z = half
    return [
        ((-x, y, z), (2 * x, 0, 0), (0, -2 * y, 0)),
        ((x, y, -z), (-2 * x, 0, 0), (0, -2 * y, 0)),
        ((x, y, z), (0, 0, -2 * z), (0, -2 * y, 0)),
        ((-x, y, -z), (0, 0, 2 * z), (0, -2 * y, 0)),
        ((-x, y, -z), (2 * x, 0, 0), (0, 0, 2 * z)),
    ]


def hits_box(origin, direction, half, middle, turn):
    """Whether rays [n, r, 3] from origin [n, 3] hit an oriented box (slabs, Kay and Kajiya
    1986)."""
    o, d = ((origin - np.asarray(middle)) @ turn)[:, None], direction @ turn
    with np.errstate(divide="ignore", invalid="ignore"):
        a, b = (-np.asarray(half) - o) / d, (np.asarray(half) - o) / d
    near, far = np.minimum(a, b).max(-1), np.maximum(a, b).min(-1)
    return (near < far) & (far > 1e-4)  # also where a ray starts inside


def opening_seen(points, normals):
    """Share of the cosine-weighted hemisphere that leaves the box through its open front."""
    t, b = frames(normals)
    n, local = np.asarray(normals, np.float32), cosine_rays(900)
    d = (
        local[None, :, :1] * t[:, None]
        + local[None, :, 1:2] * b[:, None]
        + local[None, :, 2:] * n[:, None]
    )
    p = np.asarray(points, np.float32) + n * 1e-4
    with np.errstate(divide="ignore", invalid="ignore"):
        at = p[:, None] + d * ((1.0 - p[:, None, 2:]) / d[..., 2:])
    free = (d[..., 2] > 0) & (np.abs(at[..., 0]) < 1) & (np.abs(at[..., 1] - 1) < 1)
    for half, middle, degrees in BOXES.values():
        free &= ~hits_box(p, d, half, middle, shapes.rotation((0, 1, 0), degrees))
    return free.mean(1)


def outside_boxes(points):
    """Floor points under a box moved out past its nearest side, so that its edge does not darken
    the floor beside it."""
    for half, middle, degrees in BOXES.values():
        turn = shapes.rotation((0, 1, 0), degrees)
        local = (points - np.asarray(middle)) @ turn
        inside = (np.abs(local[:, 0]) < half[0]) & (np.abs(local[:, 2]) < half[2])
        depth = np.stack([half[0] - np.abs(local[:, 0]), half[2] - np.abs(local[:, 2])], 1)
        for axis, nearest in ((0, depth[:, 0] < depth[:, 1]), (2, depth[:, 0] >= depth[:, 1])):
            move = inside & nearest
            local[move, axis] = np.sign(local[move, axis]) * (half[axis] + 2e-3)
        points = local @ turn.T + np.asarray(middle)
    return points


def all_faces():
    """(node, paint, surface) of every quad, its texture coordinates 0..1."""
    paints = {"left": "red", "right": "green"}
    for name, (corner, u, v) in WALLS.items():
        yield name, paints.get(name, "white"), shapes.quad(corner, u, v)
    for name, (half, middle, degrees) in BOXES.items():
        for face in box_faces(half):
            yield name, "white", shapes.quad(*face).moved(
                middle, shapes.rotation((0, 1, 0), degrees)
            )


def mapped_faces(cell=64, across=4):
    """The faces by (node, paint), with coordinates in the occlusion atlas, and the atlas."""
    faces = list(all_faces())
    atlas = np.ones((-(-len(faces) // across) * cell, across * cell), np.float32)
    # One texel of margin repeats the face's edge.
    c = np.clip((np.arange(cell) - 0.5) / (cell - 2), 0, 1)
    u, v = (grid.reshape(-1, 1) for grid in np.meshgrid(c, c))
    parts = {}
    for i, (node, paint, face) in enumerate(faces):
        row, column = i // across * cell, i % across * cell
        corner, right, down = (face.positions[k] for k in range(3))
        points = corner + u * (right - corner) + v * (down - corner)
        if node == "floor":
            points = outside_boxes(points)
        seen = opening_seen(points, np.tile(face.normals[0], (cell * cell, 1)))
        atlas[row : row + cell, column : column + cell] = seen.reshape(cell, cell)
        texel = np.array([column, row]) + 1 + face.uv0 * (cell - 2)
        face.uv0 = texel / np.array(atlas.shape[::-1])
        parts.setdefault((node, paint), []).append(face)
    return parts, atlas


def add_plain(glb, name, faces, material):
    surface = shapes.joined([shapes.quad(*face) for face in faces])
    mesh = glb.add_mesh(name, glb.add_geometry(replace(surface, uv0=None)), material)
    glb.add_node(name, mesh=mesh)


def build(copyright_line):
    """Light from outside comes in by the front alone: the occlusion map says how much of it
    arrives where."""
    parts, atlas = mapped_faces()
    glb = Glb(copyright_line)
    yfov_deg = 2 * np.degrees(np.arctan(1.09 / 3.35))
    glb.add_camera("front", (0, 1, 4.35), (0, 1, 0), yfov_deg, aspect=1.0)
    occlusion = glb.texture_ref(glb.add_texture("occlusion", to_bytes(atlas), wrap=CLAMP))
    materials = {
        name: glb.add_material(name, color, roughness=0.9, occlusion_map=occlusion)
        for name, color in PAINT.items()
    }
    for (node, paint), faces in parts.items():
        geometry = glb.add_geometry(shapes.joined(faces))
        glb.add_node(node, mesh=glb.add_mesh(node, geometry, materials[paint]))
    add_plain(glb, "board", BOARD, glb.add_material("board", (0.14, 0.14, 0.14), roughness=0.9))
    x, z = LAMP_HALF_M
    lamp = glb.add_material("lamp", (0.78, 0.78, 0.78), emissive_nit=LAMP_NIT)
    add_plain(glb, "lamp", [((-x, 1.998, z), (2 * x, 0, 0), (0, 0, -2 * z))], lamp)
    # A stand-in for renderers that do not sample emitting meshes, which the reference leaves out:
    # the lamp's intensity straight down, area x radiance.
    peak = max(LAMP_NIT)
    tint = [c / peak for c in LAMP_NIT]
    glb.add_point_light("lamp_point", (0, 1.9, 0), 4 * x * z * peak, tint, stands_in=True)
    return glb.to_bytes("cornell")
