# Ambient visibility by casting rays at spheres, upright cylinders and horizontal planes.
# SPDX-License-Identifier: MIT
from dataclasses import dataclass

import numpy as np

GOLDEN_ANGLE = np.pi * (3 - np.sqrt(5))


@dataclass
class Sphere:
    center: tuple
    radius: float

    def hit(self, origin, direction):
        """Distance along each ray, inf where missed. Rays start outside."""
        o = origin - np.float32(self.center)
        b = np.einsum("pk,prk->pr", o, direction)
        c = np.sum(o * o, -1)[:, None] - np.float32(self.radius) ** 2
        root = b * b - c
        with np.errstate(invalid="ignore"):
            t = -b - np.sqrt(root)
        return np.where((root > 0) & (t > 0), t, np.inf)


@dataclass
class Cylinder:
    """Upright and solid, from bottom to top."""

    center: tuple  # x z
    radius: float
    bottom: float
    top: float

    def hit(self, origin, direction):
        ox, oz = origin[:, :1] - np.float32(self.center[0]), origin[:, 2:] - np.float32(
            self.center[1]
        )
        dx, dy, dz = direction[..., 0], direction[..., 1], direction[..., 2]
        a = dx * dx + dz * dz
        b, c = ox * dx + oz * dz, ox * ox + oz * oz - np.float32(self.radius) ** 2
        root = b * b - a * c
        with np.errstate(invalid="ignore", divide="ignore"):
            span = np.sqrt(np.maximum(root, 0))
            enter, leave = (-b - span) / a, (-b + span) / a
            t0, t1 = (self.bottom - origin[:, 1:2]) / dy, (self.top - origin[:, 1:2]) / dy
            near = np.maximum(enter, np.minimum(t0, t1))
            far = np.minimum(leave, np.maximum(t0, t1))
        return np.where((root > 0) & (near < far) & (near > 0), near, np.inf)


@dataclass
class Plane:
    """The half space below `height`."""

    height: float

    def hit(self, origin, direction):
        with np.errstate(divide="ignore"):
            t = (self.height - origin[:, 1:2]) / direction[..., 1]
        return np.where((direction[..., 1] < 0) & (t > 0), t, np.inf)


def cosine_rays(count):
    """Directions about +z in equal shares of the cosine-weighted hemisphere, [count, 3]."""
    i = np.arange(count) + 0.5
    radius, angle = np.sqrt(i / count), i * GOLDEN_ANGLE
    return np.stack(
        [radius * np.cos(angle), radius * np.sin(angle), np.sqrt(1 - radius**2)], 1
    ).astype(np.float32)


def frames(normals):
    """Two unit vectors square to each normal (Duff et al. 2017)."""
    n = np.asarray(normals, np.float32)
    sign = np.where(n[:, 2] >= 0, np.float32(1), np.float32(-1))
    a = -1 / (sign + n[:, 2])
    b = n[:, 0] * n[:, 1] * a
    return (
        np.stack([1 + sign * n[:, 0] ** 2 * a, sign * b, -sign * n[:, 0]], 1),
        np.stack([b, sign + n[:, 1] ** 2 * a, -n[:, 1]], 1),
    )


def visibility(points, normals, solids, reach_m, bounce=0.0, rays=256, block=4096):
    """Share of the cosine-weighted hemisphere that sees light, 0..1. A blocker at distance t takes
    1 / (1 + (t / reach_m)^2) of its part: what lies far off is itself lit, and stands for bounced
    light together with `bounce`, the share that a near blocker gives back."""
    local = cosine_rays(rays)
    out = np.empty(len(points), np.float32)
    for start in range(0, len(points), block):
        p = np.asarray(points[start : start + block], np.float32)
        n = np.asarray(normals[start : start + block], np.float32)
        t, b = frames(n)
        direction = (
            local[None, :, :1] * t[:, None]
            + local[None, :, 1:2] * b[:, None]
            + local[None, :, 2:] * n[:, None]
        )
        nearest = np.full(direction.shape[:2], np.inf, np.float32)
        for solid in solids:
            nearest = np.minimum(nearest, solid.hit(p + n * np.float32(2e-5), direction))
        blocked = (1 - bounce) / (1 + (nearest / np.float32(reach_m)) ** 2)
        out[start : start + block] = 1 - blocked.mean(1)
    return out


def resized(array, shape):
    """Bilinear, by texel centres, edges clamped."""
    rows, columns = (
        np.clip((np.arange(n) + 0.5) * m / n - 0.5, 0, m - 1) for n, m in zip(shape, array.shape)
    )
    r0, c0 = np.floor(rows).astype(int), np.floor(columns).astype(int)
    r1, c1 = np.minimum(r0 + 1, array.shape[0] - 1), np.minimum(c0 + 1, array.shape[1] - 1)
    fr, fc = (rows - r0)[:, None], (columns - c0)[None]
    top = array[np.ix_(r0, c0)] * (1 - fc) + array[np.ix_(r0, c1)] * fc
    bottom = array[np.ix_(r1, c0)] * (1 - fc) + array[np.ix_(r1, c1)] * fc
    return top * (1 - fr) + bottom * fr
