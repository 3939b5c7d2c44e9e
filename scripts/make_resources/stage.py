# The showcase's stage: painted backdrop, concrete floor, terrazzo plinths, with their maps.
# SPDX-License-Identifier: MIT
import numpy as np

from . import shapes
from .noise import fbm, smoothstep, tile_points, worley
from .pixels import mix

TILE_M = 0.5  # side of one repeat of the concrete
TERRAZZO_M = 0.24  # and of the terrazzo
FLOOR_RADIUS_M, FLOOR_HEIGHT_M, FLOOR_BEVEL_M = 0.74, 0.045, 0.010
PLINTH_RADIUS_M, PLINTH_BEVEL_M = 0.108, 0.005
BACKDROP_HALF_M = (1.6, 1.3)  # half extents in x and z of the backdrop's occlusion map


def drum(measures, tile_m, segments, rings, top_uv1, side_uv1):
    """An upright drum standing on y = 0, without bottom; `measures` are its radius, height and
    bevel in metres. Its top is mapped flat, its side unrolled, both in units of tile_m in uv0;
    top_uv1(x, z) and side_uv1(around, height) give uv1."""
    radius, height, bevel = measures
    arc = np.linspace(0, np.pi / 2, 5)
    circle = np.stack([np.sin(arc), np.cos(arc)], 1)
    corner = np.array([radius - bevel, height - bevel]) + bevel * circle

    def turned(profile, normals):
        down = np.concatenate([[0], np.cumsum(np.linalg.norm(np.diff(profile, axis=0), axis=1))])
        return shapes.lathe(profile, normals, segments, down)

    radii = np.linspace(0, radius - bevel, rings)
    # The top takes the first half of the bevel, the side the rest, so that the map's seam hides on
    # the edge.
    top = turned(
        np.concatenate([np.stack([radii[:-1], np.full(rings - 1, height)], 1), corner[:3]]),
        np.concatenate([np.tile([0.0, 1.0], (rings - 1, 1)), circle[:3]]),
    )
    heights = np.linspace(height - bevel, 0, 3)[1:]
    side = turned(
        np.concatenate([corner[2:], np.stack([np.full(2, radius), heights], 1)]),
        np.concatenate([circle[2:], np.tile([1.0, 0.0], (2, 1))]),
    )
    x, z = top.positions[:, 0], top.positions[:, 2]
    top.uv1, top.uv0 = top_uv1(x, z), np.stack([x, z], 1) / tile_m
    turns = round(2 * np.pi * radius / tile_m)  # whole repeats, so that the seam closes
    around = side.uv0[:, 0]
    side.uv1 = side_uv1(around, side.positions[:, 1] / height)
    side.uv0 = np.stack([around * turns, side.uv0[:, 1] / tile_m], 1)
    return shapes.joined([shapes.with_tangents(top), shapes.with_tangents(side)])


def backdrop():
    """A sweep: flat floor, a quarter circle, a wall; uv0 covers it once, uv1 is the occlusion
    map's."""
    front, bend, radius, top, half_width = 2.6, -0.95, 1.1, 3.4, 4.5
    arc = np.linspace(0, np.pi / 2, 33)
    floor = np.stack([np.linspace(front, bend, 25), np.zeros(25)], 1)
    curve = np.stack([bend - radius * np.sin(arc), radius * (1 - np.cos(arc))], 1)[1:]
    wall = np.stack([np.full(9, bend - radius), np.linspace(radius, top, 10)[1:]], 1)
    line = np.concatenate([floor, curve, wall])[::-1]  # walked downwards, as rows of a grid
    normal = np.concatenate(
        [
            np.tile([0.0, 1.0], (25, 1)),
            np.stack([np.sin(arc), np.cos(arc)], 1)[1:],
            np.tile([1.0, 0.0], (9, 1)),
        ]
    )[::-1]
    length = np.concatenate([[0], np.cumsum(np.linalg.norm(np.diff(line, axis=0), axis=1))])
    x = np.linspace(-half_width, half_width, 19)
    shape = (len(line), len(x))

    def across(values):
        return np.broadcast_to(values[:, None], shape).ravel()

    positions = np.stack(
        [np.broadcast_to(x, shape).ravel(), across(line[:, 1]), across(line[:, 0])], 1
    )
    normals = np.stack([np.zeros(len(positions)), across(normal[:, 1]), across(normal[:, 0])], 1)
    uv0 = np.stack([positions[:, 0] / (2 * half_width) + 0.5, across(length / length[-1])], 1)
    uv1 = np.stack(
        [
            positions[:, 0] / (2 * BACKDROP_HALF_M[0]) + 0.5,
            positions[:, 2] / (2 * BACKDROP_HALF_M[1]) + 0.5,
        ],
        1,
    )
    # On the wall the map's edge repeats, which says unoccluded.
    return shapes.Surface(positions, normals, shapes.grid_indices(*shape), uv0, uv1), (
        half_width,
        length[-1],
    )


def backdrop_paint(size, extent):
    """Linear colour of the hand-rolled backdrop: slate, lighter in a soft pool behind the group."""
    c = (np.arange(size) + 0.5) / size
    u, v = np.meshgrid(c, c)
    x, y = (u - 0.5) * 2 * extent[0], v * extent[1]
    p = np.stack([x, y, 0 * x], -1)
    pool = np.exp(-((x / 1.05) ** 2 + ((y - 0.53 * extent[1]) / 1.0) ** 2))
    mottle = fbm(p * 1.3, 201, 6, gain=0.55)
    tone = np.clip(0.10 + 0.84 * pool + 0.16 * mottle, 0, 1)
    return mix((0.030, 0.037, 0.043), (0.185, 0.205, 0.218), tone)


def concrete(size):
    """Honed concrete by texel: linear base colour, roughness, height in metres; repeats every
    TILE_M."""
    cloud = fbm(tile_points(size, 3), 211, 7, gain=0.66, period=3)
    sand = fbm(tile_points(size, 56), 212, 3, gain=0.7, period=56)
    near, _, owner = worley(tile_points(size, 26), 213, period=26)
    pore = smoothstep(0.02 + 0.10 * owner**4, 0.0, near - 0.07 * owner**6) * (owner > 0.35)
    stain = smoothstep(
        0.05, 0.45, fbm(tile_points(size, 2) + np.float32([0, 0, 5]), 214, 6, gain=0.6, period=2)
    )
    near, second, shade = worley(tile_points(size, 40) + 0.2 * sand[..., None], 215, period=40)
    pebble = smoothstep(0.30, 0.22, near) * (shade > 0.55)
    base = mix(
        (0.215, 0.209, 0.199), (0.365, 0.356, 0.340), np.clip(0.5 + 1.0 * cloud + 0.22 * sand, 0, 1)
    )
    base = mix(
        base, mix((0.13, 0.13, 0.13), (0.40, 0.38, 0.35), (shade - 0.55) / 0.45), 0.20 * pebble
    )
    base = base * (1 - 0.16 * stain - 0.42 * pore)[..., None]
    roughness = np.clip(
        0.56 + 0.16 * cloud + 0.06 * sand - 0.10 * stain - 0.06 * pebble + 0.25 * pore, 0.3, 1
    )
    return base, roughness, 0.00010 * sand - 0.0011 * pore + 0.00035 * cloud


def terrazzo(size):
    """Ground and sealed terrazzo by texel: linear base colour, roughness; repeats every
    TERRAZZO_M."""
    warp = np.stack(
        [
            fbm(tile_points(size, 24) + np.float32([0, 0, 3 * i]), 221 + i, 2, period=24)
            for i in range(3)
        ],
        -1,
    )
    base = mix(
        (0.600, 0.585, 0.555),
        (0.665, 0.652, 0.625),
        0.5 + fbm(tile_points(size, 20), 224, 4, period=20),
    )
    stones = np.array(
        [
            (0.66, 0.64, 0.60),
            (0.40, 0.395, 0.385),
            (0.52, 0.455, 0.38),
            (0.26, 0.262, 0.262),
            (0.47, 0.375, 0.315),
            (0.59, 0.56, 0.515),
        ],
        np.float32,
    )
    polished = np.zeros((size, size))
    for cells, seed, share in ((52, 226, 0.42), (27, 225, 0.34)):
        near, second, owner = worley(tile_points(size, cells) + 0.22 * warp, seed, period=cells)
        chosen = owner < share
        gap = 0.05 + 0.24 * np.mod(owner * 37.7, 1)
        stone = smoothstep(gap, gap + 0.035, second - near) * chosen
        base = mix(base, stones[(owner * 991.7).astype(int) % len(stones)], stone)
        polished = np.maximum(polished, stone)
    return base, mix(0.52, 0.40, polished)
