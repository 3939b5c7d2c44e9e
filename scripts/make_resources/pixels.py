# From numbers to texels: sRGB, packed occlusion-roughness-metallic maps, normal maps.
# SPDX-License-Identifier: MIT
import numpy as np


def to_bytes(x):
    return np.clip(np.asarray(x) * 255 + 0.5, 0, 255).astype(np.uint8)


def srgb(linear):
    """IEC 61966-2-1 encoding of linear [..., 3], as bytes."""
    x = np.clip(linear, 0, 1)
    return to_bytes(
        np.where(x <= 0.0031308, x * 12.92, 1.055 * np.power(np.maximum(x, 1e-9), 1 / 2.4) - 0.055)
    )


def orm(occlusion, roughness, metallic):
    return to_bytes(np.stack(np.broadcast_arrays(occlusion, roughness, metallic), -1))


def normal_bytes(slope_u, slope_up):
    """Tangent-space normal of a height's slopes along +u and towards the top of the image; +Y is
    up."""
    n = np.stack([-slope_u, -slope_up, np.ones_like(slope_u)], -1)
    return to_bytes(n / np.linalg.norm(n, axis=-1, keepdims=True) * 0.5 + 0.5)


def tile_slopes(height, texel_m):
    """Slopes of a height map in metres that repeats in both directions."""
    slope_u = (np.roll(height, -1, 1) - np.roll(height, 1, 1)) / (2 * texel_m)
    slope_down = (np.roll(height, -1, 0) - np.roll(height, 1, 0)) / (2 * texel_m)
    return slope_u, -slope_down


def mix(a, b, t):
    """a and b colours or numbers, t [...] the share of b."""
    a, b, t = np.asarray(a, np.float32), np.asarray(b, np.float32), np.asarray(t, np.float32)
    if a.ndim and a.shape[-1] == 3 or b.ndim and b.shape[-1] == 3:
        t = t[..., None]
    return a + (b - a) * t
