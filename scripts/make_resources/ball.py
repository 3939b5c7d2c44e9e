# The material ball: a sphere with a raised band, two grooves and a sunk cap, on a turned foot.
# SPDX-License-Identifier: MIT
import numpy as np

from . import shapes
from .noise import smoothstep
from .occlusion import cosine_rays

RADIUS_M = 0.1
CENTER_M = 0.124  # of the ball above its plinth
CAP_DEG, TAIL_DEG = 19.5, 150.0  # where the strip chart hands over to the two disc charts
STRIP_SHARE = 704 / 1024  # of the atlas' height; the discs share the rest
DISC_DEG = 33.0  # angle from the pole at the disc charts' edge


def relief(theta_deg):
    """Height above the unit sphere by angle from the ball's axis."""
    t = np.asarray(theta_deg, float)

    def step(at, width):
        return smoothstep(at - width / 2, at + width / 2, t)

    cap = -0.034 * (1 - step(22.5, 2.6)) + 0.010 * (step(23.2, 2.2) - step(28.0, 2.6))
    band = 0.030 * (step(80.2, 2.4) - step(103.8, 2.4)) * (1 - 0.25 * ((t - 92) / 12) ** 2)
    grooves = -0.036 * ((step(74.6, 2.0) - step(79.4, 2.0)) + (step(104.6, 2.0) - step(109.4, 2.0)))
    return cap + band + grooves


class Profile:
    """The relief's curve, finely sampled: points and normals [n, 2] as (radius, height), arc length
    from the pole."""

    def __init__(self, samples=6000):
        self.theta = np.linspace(0, 180, samples)
        r, t = 1 + relief(self.theta), np.radians(self.theta)
        self.points = np.stack([r * np.sin(t), r * np.cos(t)], 1)
        self.points[[0, -1], 0] = 0
        d = np.gradient(self.points, axis=0)
        self.normals = np.stack([-d[:, 1], d[:, 0]], 1)
        self.normals[0], self.normals[-1] = (0, 1), (0, -1)
        self.normals /= np.linalg.norm(self.normals, axis=1, keepdims=True)
        self.arc = np.concatenate(
            [[0], np.cumsum(np.linalg.norm(np.diff(self.points, axis=0), axis=1))]
        )
        blurred = np.convolve(
            np.pad(relief(self.theta), 150, "edge"),
            np.hanning(301) / np.hanning(301).sum(),
            "valid",
        )
        turn = np.unwrap(np.arctan2(self.normals[:, 1], self.normals[:, 0]))
        self.curvature = np.abs(np.gradient(turn) / np.gradient(self.arc))  # 1 on a sphere
        self.edge = (
            relief(self.theta) - blurred
        )  # positive on what sticks out, negative in what is sunk
        self.visible = self._visibility()

    def _visibility(self, rays=512, steps=96):
        """What the relief leaves of the hemisphere, by angle; a ray that dips below the relief is
        blocked."""
        pick = np.arange(0, len(self.theta), 6)
        p = np.stack([self.points[pick, 0], self.points[pick, 1], 0 * pick], 1)
        n = np.stack([self.normals[pick, 0], self.normals[pick, 1], 0 * pick], 1)
        t = np.stack([-n[:, 1], n[:, 0], n[:, 2]], 1)
        local = cosine_rays(rays)
        d = (
            local[None, :, :1] * t[:, None]
            + local[None, :, 1:2] * np.float32([0, 0, 1])
            + local[None, :, 2:] * n[:, None]
        )
        hit = np.zeros(d.shape[:2], bool)
        for s in np.geomspace(0.004, 0.5, steps):
            q = (p + n * 0.002)[:, None] + d * s
            r = np.linalg.norm(q, axis=-1)
            hit |= r < 1 + np.interp(
                np.degrees(np.arccos(np.clip(q[..., 1] / r, -1, 1))), self.theta, relief(self.theta)
            )
        return np.interp(np.arange(len(self.theta)), pick, 1 - hit.mean(1))

    def at(self, theta_deg, values):
        return np.interp(theta_deg, self.theta, values)

    def rows(self, start, end, count):
        """`count` angles from start to end, closer where the curve bends."""
        turn = self.curvature * np.gradient(self.arc)
        inside = (self.theta >= start) & (self.theta <= end)
        weight = np.cumsum((turn + 0.0011) * inside)
        return np.interp(np.linspace(0, 1, count), weight / weight[-1], self.theta).clip(start, end)


def disc_center(which):
    """Centre and radius of a disc chart in texture coordinates: 0 the cap, 1 the tail."""
    side = 1 - STRIP_SHARE
    return np.array([side * (0.5 + which), STRIP_SHARE + side / 2]), side * 0.48


def strip_v(profile, theta):
    start, end = profile.at(CAP_DEG, profile.arc), profile.at(TAIL_DEG, profile.arc)
    # Half a percent of margin, so that filtering at the ends stays in the chart.
    return (0.005 + 0.99 * (profile.at(theta, profile.arc) - start) / (end - start)) * STRIP_SHARE


def surface(profile, segments=80):
    """The unit ball about +y, with atlas coordinates and tangents."""

    def part(theta, v):
        at = [
            np.stack([profile.at(theta, a[:, i]) for i in (0, 1)], 1)
            for a in (profile.points, profile.normals)
        ]
        return shapes.lathe(at[0], shapes.unit(at[1]), segments, v)

    pieces = []
    body = profile.rows(CAP_DEG, TAIL_DEG, 60)
    pieces.append(part(body, strip_v(profile, body)))
    for which, theta in ((0, np.linspace(0, CAP_DEG, 5)), (1, np.linspace(TAIL_DEG, 180, 5))):
        piece = part(theta, theta)
        middle, radius = disc_center(which)
        ring = np.abs(piece.uv0[:, 1] - 180 * which) / DISC_DEG * radius
        angle = piece.uv0[:, 0] * 2 * np.pi
        piece.uv0 = middle + ring[:, None] * np.stack(
            [np.sin(angle), np.cos(angle) * (1 - 2 * which)], 1
        )
        pieces.append(piece)
    return shapes.joined([shapes.with_tangents(p) for p in pieces])


class Atlas:
    """The ball's surface by texel: `p` [size, size, 3] on the relief, `n` its normals, `theta` in
    degrees, and the size of a texel along u and v in ball radii. Texels outside every chart
    continue their chart."""

    def __init__(self, profile, size):
        self.profile, self.size = profile, size
        c = (np.arange(size) + 0.5) / size
        u, v = np.meshgrid(c, c)
        self.strip = v < STRIP_SHARE
        v_of_theta = strip_v(profile, profile.theta)
        theta, phi = np.interp(v, v_of_theta, profile.theta), u * 2 * np.pi
        step_u = 2 * np.pi * np.interp(theta, profile.theta, profile.points[:, 0]) / size
        texel = (profile.at(TAIL_DEG, profile.arc) - profile.at(CAP_DEG, profile.arc)) / (
            0.99 * STRIP_SHARE * size
        )
        self.discs = []
        for which in (0, 1):
            middle, radius = disc_center(which)
            here = ~self.strip & (
                (u < (1 - STRIP_SHARE)) if which == 0 else (u >= (1 - STRIP_SHARE))
            )
            x, z = (u - middle[0]) / radius, (v - middle[1]) / radius * (1 - 2 * which)
            angle = np.minimum(np.hypot(x, z), 1.5) * DISC_DEG
            theta, phi = np.where(here, abs(180 * which - angle), theta), np.where(
                here, np.arctan2(x, z), phi
            )
            self.discs.append(here)
        disc_texel = np.radians(DISC_DEG) / (disc_center(0)[1] * size)
        self.step_u, self.step_v = np.where(self.strip, step_u, disc_texel), np.where(
            self.strip, texel, disc_texel
        )
        self.theta, self.phi = theta.astype(np.float32), phi.astype(np.float32)
        r, h = (profile.at(theta, profile.points[:, i]) for i in (0, 1))
        nr, nh = (profile.at(theta, profile.normals[:, i]) for i in (0, 1))
        self.p = np.stack([r * np.sin(phi), h, r * np.cos(phi)], -1).astype(np.float32)
        self.n = np.stack([nr * np.sin(phi), nh, nr * np.cos(phi)], -1).astype(np.float32)
        self.arc = profile.at(theta, profile.arc).astype(np.float32)
        self.relief = relief(theta).astype(np.float32)
        self.edge = profile.at(theta, profile.edge).astype(np.float32)
        self.curvature = profile.at(theta, profile.curvature).astype(np.float32)
        self.visible = profile.at(theta, profile.visible).astype(np.float32)

    def slopes(self, height):
        """Slopes of a height in ball radii along u and towards the top, per chart."""
        around = (np.roll(height, -1, 1) - np.roll(height, 1, 1)) / (2 * self.step_u)
        plain = np.gradient(height, axis=1) / self.step_u
        down = np.gradient(height, axis=0) / self.step_v
        return np.where(self.strip, around, plain), -down


def foot():
    """The foot about +y in ball radii, standing at -CENTER: surface with uv0 = (around, down the
    profile)."""
    bottom = -CENTER_M / RADIUS_M
    key = np.array(
        [
            [0.34, -0.90],
            [0.47, -0.865],
            [0.505, -0.875],
            [0.515, -0.90],
            [0.50, -0.925],
            [0.45, -0.95],
            [0.415, -0.99],
            [0.405, -1.03],
            [0.42, -1.075],
            [0.47, -1.115],
            [0.56, -1.145],
            [0.615, -1.16],
            [0.635, -1.18],
            [0.64, -1.20],
            [0.635, bottom + 0.012],
            [0.62, bottom],
        ]
    )
    d = np.gradient(key, axis=0)
    normals = shapes.unit(np.stack([-d[:, 1], d[:, 0]], 1))
    arc = np.concatenate([[0], np.cumsum(np.linalg.norm(np.diff(key, axis=0), axis=1))])
    return shapes.with_tangents(shapes.lathe(key, normals, 48, arc / arc[-1]))
