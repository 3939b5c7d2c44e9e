#!/usr/bin/env python3
# Computes the albedo of the sheen lobe, src/brdf/sheen_charlie.inl: fit_sheen.py > src/brdf/sheen_charlie.inl (10 s).
# SPDX-License-Identifier: MIT
# Estevez & Kulla 2017, "Production Friendly Microfacet Sheen BRDF": Eq. 2 for D, Table 1 and Eq. 3 for Lambda, as
# glsl/brdf/d_charlie.glsl and lambda_charlie.glsl have them. Gauss-Legendre over the cube root of n.l, which is dense at
# grazing angles, and the midpoint rule over the azimuth; error below 1e-5.
import numpy as np

COSINES, ROUGHNESSES = 32, 16
LEAST_ROUGHNESS = 0.07  # glsl/brdf/model/layers.glsl


def curve(x, blend):
    a, b, c, d, e = (low + (high - low) * blend for low, high in
                     ((21.5473, 25.3245), (3.82987, 3.32435), (0.19823, 0.16801), (-1.97760, -1.27393), (-4.32054, -4.85967)))
    return a / (1 + b * np.maximum(x, 1e-12) ** c) + d * x + e


def smith(cosine, alpha):
    blend = (1 - alpha) ** 2
    return np.where(cosine < 0.5, np.exp(curve(cosine, blend)),
                    np.exp(2 * curve(0.5, blend) - curve(1 - cosine, blend)))


def albedo(n_dot_v, roughness):
    alpha = roughness * roughness
    nodes, weights = np.polynomial.legendre.leggauss(200)
    root = (nodes + 1) / 2
    n_dot_l = (root**3)[:, None]
    azimuth = ((np.arange(128) + 0.5) / 128 * 2 * np.pi)[None, :]
    share = (weights / 2 * 3 * root**2)[:, None] * 2 * np.pi / 128
    across = np.sqrt(1 - n_dot_l**2)
    h = np.stack(np.broadcast_arrays(np.sqrt(1 - n_dot_v**2) + across * np.cos(azimuth), across * np.sin(azimuth),
                                     n_dot_v + n_dot_l))
    n_dot_h = h[2] / np.sqrt((h * h).sum(0))
    d = (2 + 1 / alpha) * np.maximum(1 - n_dot_h**2, 0) ** (0.5 / alpha) / (2 * np.pi)
    v = 1 / ((1 + smith(np.float64(n_dot_v), alpha) + smith(n_dot_l, alpha)) * 4 * n_dot_v * n_dot_l)
    return float((d * v * n_dot_l * share).sum())


def main():
    print("// Written by scripts/fit_sheen.py; do not edit. [root of roughness][root of n.v]")
    for row in range(ROUGHNESSES):
        roughness = LEAST_ROUGHNESS + (1 - LEAST_ROUGHNESS) * (row / (ROUGHNESSES - 1)) ** 2
        values = [albedo(max((column / (COSINES - 1)) ** 2, 1e-3), roughness) for column in range(COSINES)]
        print("    {" + ", ".join(f"{x:.5f}F" for x in values) + "},")


if __name__ == "__main__":
    main()
