# A sitting hare: thick body, thin ears, one closed smooth surface, for light that goes through it.
# SPDX-License-Identifier: MIT
from dataclasses import replace

import numpy as np

from . import nets, shapes

# In centimetres; the hare looks along +z and sits on y = 0. Parts that have a twin stand at x > 0.
CM = 0.01  # in metres
EYE_RADIUS = 0.22
EAR_ROOT = np.array([0.66, 5.9, 1.1])
EAR_RIM, EAR_MIDDLE = 0.18, 0.32  # thickness
EAR_TURN = (
    shapes.rotation((0, 1, 0), -20)
    @ shapes.rotation((0, 0, 1), 13)
    @ shapes.rotation((1, 0, 0), 22)
)


def ellipsoid(p, middle, radii, lean_deg=0.0):
    """Distance to first order: 0 and of gradient 1 at the surface. Leans forwards above 0."""
    q = (p - np.asarray(middle)) @ shapes.rotation((1, 0, 0), lean_deg)
    k = q / np.asarray(radii)
    length = np.linalg.norm(k, axis=-1)
    return (length - 1) * length / np.maximum(np.linalg.norm(k / np.asarray(radii), axis=-1), 1e-6)


def rod(p, a, b, radius_a, radius_b):
    """From a to b, tapering, round at its ends."""
    a, b = np.asarray(a, float), np.asarray(b, float)
    along = np.clip((p - a) @ (b - a) / np.dot(b - a, b - a), 0, 1)
    middle = a + along[..., None] * (b - a)
    return np.linalg.norm(p - middle, axis=-1) - (radius_a + along * (radius_b - radius_a))


def blended(a, b, width):
    """A union whose seam is filled over `width` (Quilez 2013, "Smooth minimum", the cubic one)."""
    h = np.maximum(width - np.abs(a - b), 0) / width
    return np.minimum(a, b) - h**3 * width / 6


def ear(p):
    """A leaf, cupped to the front and bent backwards, thinner towards its rim."""
    x, y, z = np.moveaxis((p - EAR_ROOT) @ EAR_TURN.T, -1, 0)
    z = z - 0.34 * x**2 + 0.018 * np.maximum(y, 0) ** 2
    outline = ellipsoid(np.stack([x, y, 0 * z], -1), (0, 2.2, 0), (0.86, 2.5, 1.0))
    within = np.clip(-outline / 0.7, 0, 1)
    thickness = EAR_RIM + (EAR_MIDDLE - EAR_RIM) * within**2 * (3 - 2 * within)
    return np.hypot(np.maximum(outline, 0), z) - thickness / 2


def field(p):
    """Below 0 inside; a distance only near the surface."""
    aside = np.hypot(p[..., :1], 0.15)  # not |x|: twins meet without a crease
    q = np.concatenate([aside, p[..., 1:]], -1)
    out = ellipsoid(q, (0, 2.55, -1.0), (2.15, 2.45, 2.75), -12)
    out = blended(out, ellipsoid(q, (0, 2.9, 0.9), (1.55, 2.2, 1.5), -10), 1.2)  # chest
    out = blended(out, ellipsoid(q, (1.55, 1.75, -1.6), (1.05, 1.75, 1.85), 10), 0.8)  # haunch
    out = blended(out, ellipsoid(q, (1.7, 0.42, -0.2), (0.56, 0.44, 1.2)), 0.9)  # hind foot
    out = blended(out, rod(q, (0.72, 2.4, 1.75), (0.74, 0.62, 2.05), 0.66, 0.48), 0.8)  # foreleg
    out = blended(out, ellipsoid(q, (0.76, 0.40, 2.35), (0.50, 0.42, 0.72)), 0.4)  # paw
    out = blended(out, ellipsoid(q, (0, 1.75, -3.75), (0.85, 0.85, 0.8)), 0.5)  # tail
    head = ellipsoid(q, (0, 5.15, 1.75), (1.32, 1.35, 1.62), 18)
    head = blended(head, ellipsoid(q, (0.45, 4.72, 2.75), (0.66, 0.62, 0.72)), 0.8)  # cheek
    head = blended(head, ellipsoid(q, (0, 4.95, 3.15), (0.55, 0.5, 0.5)), 0.6)  # nose
    out = blended(out, head, 0.9)
    out = blended(out, ear(q), 0.5)
    return -blended(-out, p[..., 1] + 0.0 * out, 0.3)  # cut flat to stand on, the edge rounded


def eased(x, start, end):
    t = np.clip((x - start) / (end - start), 0, 1)
    return t * t * (3 - 2 * t)


def lattice(columns, levels, slices):
    """Corners [columns, levels, slices, 3], drawn together about the ears, which are thin along z."""
    x, y, z = np.meshgrid(
        np.linspace(-1, 1, columns),
        np.interp(np.linspace(0, 1, levels), (0, 0.42, 1), (-0.3, 5.5, 10.5)),
        np.linspace(-1, 1, slices),
        indexing="ij",
    )
    ears, above = eased(y, 4.3, 5.3), eased(y, 6.4, 7.2)  # above: of the head
    x = x * (2.75 - 0.45 * above)
    up = y - EAR_ROOT[1]
    aside = np.clip(np.abs(x) - EAR_ROOT[0] - 0.23 * up, -1.1, 1.1)
    along = EAR_ROOT[2] - 0.404 * up - 0.018 * up**2 - 0.364 * aside + 0.36 * aside**2
    middle = -0.4 * (1 - ears) + ears * along
    even = 1 - 0.72 * ears + 0.5 * above
    z = z * (even + (1 - even) * z**2)
    return np.stack([x, y, middle + z * (4.7 - 3.9 * above)], -1)


def surface():
    """In metres, closed."""
    out = nets.surface(field, lattice(42, 68, 48), 0.05, 12)
    return shapes.Surface(out.positions * CM, out.normals, out.indices)


def eyes():
    """Two beads, more than half sunk in, in metres."""
    skin = nets.drawn_onto(field, np.array([[1.02, 5.5, 2.72]]), 0.5)
    at = (skin - 0.4 * EYE_RADIUS * shapes.unit(nets.gradient(field, skin)))[0]
    bead = replace(shapes.sphere(EYE_RADIUS, 18, 10), uv0=None)
    pair = [bead.moved(at * (side, 1, 1)) for side in (1, -1)]
    both = shapes.joined(pair)
    return shapes.Surface(both.positions * CM, both.normals, both.indices)
