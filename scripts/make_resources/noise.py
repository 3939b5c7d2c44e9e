# Noise of three dimensions, seeded, without tables: gradient, fractal and cellular.
# SPDX-License-Identifier: MIT
import numpy as np


def hash3(x, y, z, seed):
    """32 well-mixed bits of three integer coordinates (xxHash's avalanche, Collet 2012)."""
    with np.errstate(over="ignore"):
        h = (
            x.astype(np.uint32) * np.uint32(0x9E3779B1)
            ^ y.astype(np.uint32) * np.uint32(0x85EBCA77)
            ^ z.astype(np.uint32) * np.uint32(0xC2B2AE3D)
        ) + np.uint32(seed * 0x27D4EB2F & 0xFFFFFFFF)
        h = (h ^ (h >> np.uint32(15))) * np.uint32(0x85EBCA77)
        h = (h ^ (h >> np.uint32(13))) * np.uint32(0xC2B2AE3D)
        return h ^ (h >> np.uint32(16))


def unit_float(bits):
    return (bits >> np.uint32(8)).astype(np.float32) * np.float32(1 / (1 << 24))


def wrapped(cell, period):
    return cell if period is None else np.mod(cell, period)


def perlin(p, seed, period=None):
    """Gradient noise in about -1..1 (Perlin 2002, "Improving Noise"). p is [..., 3]; `period`
    (integer) makes it repeat along every axis."""
    p = np.asarray(p, np.float32)
    cell = np.floor(p).astype(np.int64)
    f = p - cell.astype(np.float32)
    fade = f * f * f * (f * (f * 6 - 15) + 10)
    total = np.zeros(p.shape[:-1], np.float32)
    for corner in np.ndindex(2, 2, 2):
        c = wrapped(cell + np.array(corner), period)
        bits = hash3(c[..., 0], c[..., 1], c[..., 2], seed)
        d = f - np.array(corner, np.float32)
        # A gradient of three independent bytes; not unit length, which only varies the contrast a
        # little.
        dot = sum(
            d[..., i] * ((bits >> np.uint32(8 * i) & np.uint32(255)).astype(np.float32) / 127.5 - 1)
            for i in range(3)
        )
        weight = np.ones_like(total)
        for i in range(3):
            weight *= fade[..., i] if corner[i] else 1 - fade[..., i]
        total += weight * dot
    return total * np.float32(1.3)


def fbm(p, seed, octaves=5, gain=0.5, period=None):
    """Sum of octaves of perlin, each twice as fine and `gain` as strong; in about -1..1."""
    p = np.asarray(p, np.float32)
    total, amplitude, norm = 0, 1.0, 0.0
    for octave in range(octaves):
        scale = 1 << octave
        total = total + amplitude * perlin(
            p * scale, seed + octave * 101, period and period * scale
        )
        norm += amplitude
        amplitude *= gain
    return total / norm


def worley(p, seed, period=None):
    """Cellular noise (Worley 1996): distances to the nearest and the second nearest feature point,
    and a random number 0..1 of the nearest one's cell. One point a cell of side 1."""
    p = np.asarray(p, np.float32)
    cell = np.floor(p).astype(np.int64)
    near = np.full(p.shape[:-1], 9.0, np.float32)
    second, owner = near.copy(), np.zeros_like(near)
    for offset in np.ndindex(3, 3, 3):
        c = cell + (np.array(offset) - 1)
        h = wrapped(c, period)
        d2 = np.zeros_like(near)
        for i in range(3):
            jitter = unit_float(hash3(h[..., 0], h[..., 1], h[..., 2], seed + 17 * i))
            d2 += (c[..., i].astype(np.float32) + jitter - p[..., i]) ** 2
        closer = d2 < near
        second = np.where(closer, near, np.minimum(second, d2))
        owner = np.where(
            closer, unit_float(hash3(h[..., 0], h[..., 1], h[..., 2], seed + 71)), owner
        )
        near = np.minimum(near, d2)
    return np.sqrt(near), np.sqrt(second), owner


def smoothstep(low, high, x):
    t = np.clip((x - low) / (high - low), 0, 1)
    return t * t * (3 - 2 * t)


def tile_points(size, cells):
    """The texel centres of a size x size tile as points of a plane that repeats every `cells`
    units."""
    c = (np.arange(size, dtype=np.float32) + 0.5) / size * cells
    y, x = np.meshgrid(c, c, indexing="ij")
    return np.stack([x, y, np.full_like(x, 0.37)], -1)
