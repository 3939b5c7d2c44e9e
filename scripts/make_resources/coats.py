# What the seven material balls are made of: maps computed over the ball's surface.
# SPDX-License-Identifier: MIT
from dataclasses import dataclass

import numpy as np

from .noise import fbm, perlin, smoothstep, worley
from .pixels import mix

# F0 of metals, linear Rec.709 (Lagarde 2011, "Feeding a physically based shading model", table of
# metals; steel as iron).
GOLD, STEEL, COPPER = (1.0, 0.71, 0.29), (0.56, 0.57, 0.58), (0.95, 0.64, 0.54)


@dataclass
class Coat:
    """base is linear [..., 3] or one colour; the rest [...] or numbers; height in ball radii, None
    where smooth."""

    base: object
    roughness: object
    metallic: object
    height: object = None


def around(atlas, along, across):
    """Points whose noise forms streaks that run around the ball's axis."""
    return np.stack([atlas.arc * along, across * np.cos(atlas.phi), across * np.sin(atlas.phi)], -1)


def softened(a, roughness):
    """Roughness widened where the relief turns within a pixel, or its highlights would sparkle: the
    variance of the normal is added to alpha^2 (Kaplanyan et al. 2016, "Filtering distributions of
    normals"). The pixel is that of the hero view at 1280x720, 1/90 of the radius."""
    spread = np.minimum(0.5 * ((a.curvature - 1) / 90) ** 2, 0.03)
    return ((np.asarray(roughness, np.float32) ** 4 + spread) ** 0.25).astype(np.float32)


def scratches(a, count, seed):
    """0..1: straight scores in loose groups of parallels, as arcs where planes cut the ball."""
    draw = np.random.default_rng(seed)
    found = np.zeros(a.p.shape[:2], np.float32)
    for _ in range(count):
        middle, towards = draw.normal(size=3), draw.normal(size=3)
        middle /= np.linalg.norm(middle)
        for _ in range(draw.integers(1, 5)):
            at = middle + draw.normal(size=3) * 0.045
            across = np.cross(at, towards + draw.normal(size=3) * 0.10)
            across /= np.linalg.norm(across)
            along = np.cross(across, at)
            reach, width = draw.uniform(0.04, 0.24), draw.uniform(0.0035, 0.0065)
            offset = a.p - np.float32(at)
            score = smoothstep(width, 0.3 * width, np.abs(offset @ np.float32(across)))
            score *= smoothstep(reach, 0.6 * reach, np.abs(offset @ np.float32(along))) * (
                offset @ np.float32(at) > -0.2
            )
            found = np.maximum(found, score)
    return found


def gold(a):
    """Polished by hand: smudges and hairlines in the roughness only."""
    smudge = smoothstep(-0.1, 0.6, fbm(a.p * 2.3, 11, 5))
    hairline = smoothstep(0.42, 0.62, fbm(around(a, 60, 2.0), 12, 3))
    return Coat(GOLD, softened(a, 0.085 + 0.10 * smudge + 0.05 * hairline), 1.0)


def brushed_steel(a):
    """Turned on a lathe and brushed: fine streaks around the axis, in roughness and in slope."""
    fine = (
        perlin(around(a, 95, 2.2), 21)
        + 0.7 * perlin(around(a, 47, 1.3), 22)
        + 0.5 * perlin(around(a, 19, 0.8), 23)
    )
    stain = fbm(a.p * 1.8, 24, 4)
    roughness = 0.30 + 0.055 * fine + 0.05 * stain
    tone = (1 + 0.035 * fine + 0.04 * stain)[..., None]
    return Coat(
        np.float32(STEEL) * tone, softened(a, np.clip(roughness, 0.17, 0.5)), 1.0, fine * 0.00062
    )


def red_lacquer(a):
    """Deep and glossy, the grooves laid out in hammered gold leaf."""
    leaf = smoothstep(-0.012, -0.020, a.relief + 0.003 * fbm(a.p * 9, 31, 3))
    leaf = np.where(a.theta < 40, 0, leaf)
    depth = fbm(a.p * 1.6, 32, 4)
    red = mix((0.30, 0.008, 0.007), (0.40, 0.016, 0.010), 0.5 + 0.5 * depth)
    base = mix(red, (0.98, 0.74, 0.33), leaf)
    # No relief on the lacquer itself: eight bits of normal are too few for what a mirror shows.
    hammered = 0.0030 * fbm(a.p * 22, 34, 3) * leaf
    return Coat(base, softened(a, mix(0.055 + 0.02 * depth, 0.26, leaf)), leaf, hammered)


def clay(a):
    """Terracotta off the wheel: throwing lines, grit, pits and a bloom of lime."""
    warped = a.arc + 0.02 * fbm(a.p * 2.0, 41, 3)
    lines = perlin(np.stack([warped * 26, 0.7 * np.cos(a.phi), 0.7 * np.sin(a.phi)], -1), 42)
    grit, tone = fbm(a.p * 34, 43, 4, gain=0.65), fbm(a.p * 2.6, 44, 6, gain=0.6)
    near, _, owner = worley(a.p * 15, 45)
    pit = smoothstep(0.24, 0.08, near) * (owner > 0.72)
    base = mix(
        (0.33, 0.105, 0.048), (0.50, 0.205, 0.105), np.clip(0.5 + 0.75 * tone + 0.10 * grit, 0, 1)
    )
    lime = smoothstep(0.12, 0.55, fbm(a.p * 3.7, 46, 6, gain=0.62)) * 0.42
    base = mix(base, (0.60, 0.45, 0.36), lime) * (1 - 0.45 * pit)[..., None]
    grog = smoothstep(0.16, 0.10, worley(a.p * 24, 47)[0])
    base = mix(base, (0.20, 0.075, 0.04), grog * 0.55)
    height = 0.0042 * lines + 0.0034 * grit - 0.009 * pit + 0.002 * tone
    return Coat(base, np.clip(0.84 + 0.10 * grit + 0.06 * lime, 0.7, 1), 0.0, height)


def glazed_ceramic(a):
    """White glaze that breaks to brown where it runs thin over edges; iron specks and a fine
    crackle."""
    wobble = a.p + 0.05 * np.stack([fbm(a.p * 4, 51 + i, 3) for i in range(3)], -1)
    near, second, _ = worley(wobble * 4.2, 54)
    crackle = smoothstep(0.030, 0.004, second - near) * smoothstep(
        -0.5, 0.35, fbm(a.p * 1.7, 55, 3)
    )
    thin = smoothstep(0.0035, 0.0105, a.edge + 0.0035 * fbm(a.p * 8, 56, 4))
    speck_near, _, owner = worley(a.p * 11, 57)
    speck = smoothstep(0.05, 0.0, speck_near - 0.19 * owner**5)
    base = mix((0.76, 0.735, 0.68), (0.82, 0.80, 0.755), 0.5 + 0.5 * fbm(a.p * 1.5, 58, 3))
    base = mix(base, (0.47, 0.42, 0.36), 0.42 * crackle)
    base = mix(base, (0.30, 0.135, 0.055), 0.85 * thin)
    base = mix(base, (0.07, 0.042, 0.027), 0.9 * speck)
    roughness = 0.075 + 0.03 * fbm(a.p * 3, 59, 3) + 0.12 * crackle + 0.16 * speck + 0.06 * thin
    return Coat(base, softened(a, roughness), 0.0)


def worn_paint(a):
    """Blue enamel over primer over steel, chipped where it sticks out, rust creeping from the
    chips."""
    wear = a.edge * 66 + 0.95 * fbm(a.p * 2.0, 61, 4) + 0.62 * fbm(a.p * 8, 62, 6, gain=0.6)
    near, second, owner = worley(a.p * 10 + 0.25 * fbm(a.p * 20, 63, 2)[..., None], 64)
    wear = wear + 0.26 * (owner - 0.5)  # flakes come off whole
    scratch = scratches(a, 22, 65) * smoothstep(-0.25, 0.1, fbm(a.p * 9, 66, 3))
    bare = np.maximum(smoothstep(0.565, 0.60, wear), 0.9 * scratch)
    primer = smoothstep(0.475, 0.50, wear)
    rust = (
        smoothstep(0.10, 0.45, fbm(a.p * 6, 67, 5, gain=0.6) + 0.35 * smoothstep(0.78, 0.57, wear))
        * bare
    )
    fade = fbm(a.p * 1.3, 68, 4)
    paint = mix((0.012, 0.075, 0.225), (0.022, 0.120, 0.320), 0.5 + 0.6 * fade)
    grime = smoothstep(-0.004, -0.013, a.edge + 0.003 * fbm(a.p * 12, 69, 4)) * 0.65
    base = mix(paint, (0.030, 0.026, 0.022), grime)
    base = mix(base, (0.42, 0.40, 0.36), primer)
    base = mix(base, (0.50, 0.505, 0.51), bare)
    base = mix(
        base, mix((0.11, 0.032, 0.012), (0.30, 0.105, 0.032), 0.5 + fbm(a.p * 14, 70, 3)), rust
    )
    gloss = 0.23 + 0.08 * fbm(a.p * 5, 71, 4) + 0.35 * grime
    roughness = mix(
        mix(mix(gloss, 0.62, primer), 0.34 + 0.1 * fbm(around(a, 40, 2), 72, 3), bare), 0.85, rust
    )
    height = (
        -0.0045 * primer
        - 0.0050 * bare
        + 0.0016 * rust * fbm(a.p * 40, 73, 3)
        + 0.0007 * fbm(a.p * 12, 74, 2)
    )
    return Coat(base, np.clip(roughness, 0.1, 1), bare * (1 - rust), height)


def weathered_copper(a):
    """Copper gone brown, green where rain stays: in hollows and in drifts over the open surface."""
    drift = fbm(a.p * 2.2 + np.float32([0, 3, 0]), 81, 6, gain=0.58)
    amount = -a.edge * 42 + 1.25 * drift + 0.35 * fbm(a.p * 10, 82, 4, gain=0.6) + 0.05
    patina = smoothstep(0.03, 0.22, amount)
    tarnish = smoothstep(-0.55, 0.10, amount)
    metal = mix(COPPER, (0.40, 0.185, 0.115), tarnish)
    crust = fbm(a.p * 7, 83, 6, gain=0.65)
    green = mix((0.085, 0.255, 0.205), (0.27, 0.48, 0.40), np.clip(0.5 + 0.8 * crust, 0, 1))
    base = mix(metal, green, patina)
    roughness = mix(0.20 + 0.20 * tarnish + 0.05 * crust, 0.88, patina)
    return Coat(
        base, roughness, 1 - patina, patina * (0.004 + 0.0055 * fbm(a.p * 26, 84, 4, gain=0.6))
    )


COATS = (
    ("gold", gold, 512),
    ("brushed_steel", brushed_steel, 1024),
    ("red_lacquer", red_lacquer, 1024),
    ("clay", clay, 1024),
    ("glazed_ceramic", glazed_ceramic, 1024),
    ("worn_paint", worn_paint, 1024),
    ("weathered_copper", weathered_copper, 1024),
)
