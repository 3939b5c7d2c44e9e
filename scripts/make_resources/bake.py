# Where everything stands on the showcase's stage, and the occlusion it receives there.
# SPDX-License-Identifier: MIT
import numpy as np

from . import ball, shapes, stage
from .occlusion import Cylinder, Plane, Sphere, resized, visibility
from .pixels import mix

# Where each coat's ball stands: x, z of its plinth and the plinth's height, metres.
PLACES = {
    "gold": (0.0, -0.235, 0.235),
    "brushed_steel": (0.140, 0.115, 0.045),
    "red_lacquer": (-0.140, 0.115, 0.045),
    "clay": (-0.285, -0.170, 0.165),
    "glazed_ceramic": (-0.420, 0.160, 0.045),
    "worn_paint": (0.420, 0.160, 0.045),
    "weathered_copper": (0.285, -0.170, 0.165),
}
# Shows the cap and slants the band.
TILT = shapes.rotation((0, 0, 1), -16) @ shapes.rotation((1, 0, 0), 27)
REACH_M = 0.34  # at this distance a blocker takes half its part
DEEPEN = 1.6  # exponent on the stage's visibility: a studio lights from a few sides, not from all


def base_height(name):
    return stage.FLOOR_HEIGHT_M + PLACES[name][2]


def ball_center(name):
    x, z, _ = PLACES[name]
    return np.array([x, base_height(name) + ball.CENTER_M, z])


def ball_solids(name):
    x, z, _ = PLACES[name]
    y = base_height(name)
    return [
        Sphere(tuple(ball_center(name)), 0.99 * ball.RADIUS_M),
        Cylinder((x, z), 0.042, y, y + 0.034),
        Cylinder((x, z), 0.060, y, y + 0.010),
    ]


def plinth_solid(name):
    x, z, _ = PLACES[name]
    return Cylinder((x, z), stage.PLINTH_RADIUS_M, 0.0, base_height(name))


def solids(but_ball=None, but_plinth=None, floor=True):
    """Everything that can block light, but for the ball or plinth that is being baked."""
    found = [Plane(0.0)]
    if floor:
        found.append(Cylinder((0, 0), stage.FLOOR_RADIUS_M, 0.0, stage.FLOOR_HEIGHT_M))
    for name in PLACES:
        if name != but_plinth:
            found.append(plinth_solid(name))
        if name != but_ball:
            found += ball_solids(name)
    return found


def ball_occlusion(atlas, name):
    """Occlusion of one ball by texel: its own relief times what stands around it."""
    coarse = 128
    step = atlas.size // coarse
    pick = np.s_[step // 2 :: step, step // 2 :: step]
    points = atlas.p[pick].reshape(-1, 3) @ TILT.T * ball.RADIUS_M + ball_center(name)
    normals = atlas.p[pick].reshape(-1, 3) @ TILT.T
    x, z, _ = PLACES[name]
    y = base_height(name)
    foot = [Cylinder((x, z), 0.045, y, y + 0.034), Cylinder((x, z), 0.060, y, y + 0.010)]
    seen = visibility(
        points, shapes.unit(normals), solids(but_ball=name) + foot, REACH_M, bounce=0.25
    )
    return resized(seen.reshape(coarse, coarse), (atlas.size, atlas.size)) * mix(
        1.0, atlas.visible, 0.9
    )


def outside_drums(points, drums):
    """Moves points [n, 2] out of round footprints: texels under a drum repeat its rim."""
    for center, radius in drums:
        d = points - np.asarray(center)
        r = np.linalg.norm(d, axis=1, keepdims=True)
        points = np.where(
            r < radius + 5e-4,
            np.asarray(center) + d / np.maximum(r, 1e-9) * (radius + 5e-4),
            points,
        )
    return points


def flat_occlusion(size, middle, half, height, blockers, drums):
    """Occlusion of a horizontal rectangle, [size_v, size_u]."""
    u, v = ((np.arange(n) + 0.5) / n * 2 - 1 for n in size)
    x, z = np.meshgrid(middle[0] + u * half[0], middle[1] + v * half[1])
    flat = outside_drums(np.stack([x.ravel(), z.ravel()], 1), drums)
    points = np.stack([flat[:, 0], np.full(len(flat), height), flat[:, 1]], 1)
    up = np.tile([0.0, 1.0, 0.0], (len(points), 1))
    return visibility(points, up, blockers, REACH_M).reshape(x.shape) ** DEEPEN


def side_occlusion(center, radius, bottom, top, blockers, shape):
    """Occlusion of a drum's side, [height, around], first row on top."""
    angle, y = np.meshgrid(
        (np.arange(shape[1]) + 0.5) / shape[1] * 2 * np.pi,
        top + (bottom - top) * (np.arange(shape[0]) + 0.5) / shape[0],
    )
    normals = np.stack([np.sin(angle), 0 * y, np.cos(angle)], -1).reshape(-1, 3)
    points = normals * radius + np.stack(
        [np.full(y.size, center[0]), y.ravel(), np.full(y.size, center[1])], 1
    )
    return visibility(points, normals, blockers, REACH_M).reshape(shape) ** DEEPEN
