#!/usr/bin/env python3
# Fits linearly transformed cosines to the GGX lobe and writes src/brdf/ltc_ggx.inl. Takes some minutes; needs NumPy.
# SPDX-License-Identifier: MIT
"""Heitz, Dupuy, Hill & Neubelt 2016, "Real-Time Polygonal-Light Shading with Linearly Transformed Cosines", ACM TOG
35(4): for each roughness and view angle the matrix M whose transformed cosine is nearest to D V cos(theta_l) of GGX
with Smith's height-correlated masking and F = 1, both normalised; error to the third power, over samples of both.

    scripts/fit_ltc.py [--size 32] [--compare ../shared/assets/ltc]
"""
import argparse
from pathlib import Path

import numpy as np

ALPHA_MIN = 2.5e-3  # roughness 0.05: the least that lights which are points are drawn with
SIDE = 32           # samples a side, of the lobe and of the cosine each


def grid():
    u = (np.arange(SIDE) + 0.5) / SIDE
    a, b = np.meshgrid(u, u)
    return a.ravel(), b.ravel()


U1, U2 = grid()


def smith_lambda(z, alpha):
    t2 = np.maximum(1.0 - z * z, 0.0) / np.maximum(z * z, 1e-12)
    return 0.5 * (np.sqrt(1.0 + alpha * alpha * t2) - 1.0)


def lobe(view, light, alpha):
    """D V cos(theta_l), and the density of visible normals, reflected."""
    h = view + light
    h /= np.linalg.norm(h, axis=1, keepdims=True)
    d = alpha**2 / (np.pi * ((h[:, 2] ** 2) * (alpha**2 - 1.0) + 1.0) ** 2)
    up = light[:, 2] > 0.0
    lv, ll = smith_lambda(view[2], alpha), smith_lambda(light[:, 2], alpha)
    value = np.where(up, d / (1.0 + lv + ll) / (4.0 * view[2]), 0.0)
    density = d / (1.0 + lv) / (4.0 * view[2])
    return value, density


def visible_normals(view, alpha):
    """Heitz 2018, JCGT 7(4), Listing 1."""
    v = np.array([alpha * view[0], alpha * view[1], view[2]])
    v /= np.linalg.norm(v)
    t1 = np.array([-v[1], v[0], 0.0])
    length = np.linalg.norm(t1)
    t1 = t1 / length if length > 1e-9 else np.array([1.0, 0.0, 0.0])
    t2 = np.cross(v, t1)
    r, phi = np.sqrt(U1), 2.0 * np.pi * U2
    p1, p2 = r * np.cos(phi), r * np.sin(phi)
    s = 0.5 * (1.0 + v[2])
    p2 = (1.0 - s) * np.sqrt(np.maximum(1.0 - p1 * p1, 0.0)) + s * p2
    p3 = np.sqrt(np.maximum(1.0 - p1 * p1 - p2 * p2, 0.0))
    n = p1[:, None] * t1 + p2[:, None] * t2 + p3[:, None] * v
    h = np.stack([alpha * n[:, 0], alpha * n[:, 1], np.maximum(n[:, 2], 0.0)], 1)
    return h / np.linalg.norm(h, axis=1, keepdims=True)


COSINE = np.stack([np.sqrt(U1) * np.cos(2 * np.pi * U2), np.sqrt(U1) * np.sin(2 * np.pi * U2), np.sqrt(1.0 - U1)], 1)


class Fit:
    def __init__(self, view, alpha):
        self.view, self.alpha = view, alpha
        h = visible_normals(view, alpha)
        self.light = 2.0 * (h @ view)[:, None] * h - view
        value, density = lobe(view, self.light, alpha)
        weight = value / density
        self.norm = weight.mean()
        mean = (weight[:, None] * self.light).sum(0)
        mean[1] = 0.0
        z = mean / np.linalg.norm(mean)
        if view[2] > 0.9999:
            z = np.array([0.0, 0.0, 1.0])
        self.frame = np.stack([np.array([z[2], 0.0, -z[0]]), np.array([0.0, 1.0, 0.0]), z], 1)
        self.value, self.density = value / self.norm, density

    def matrix(self, p):
        return self.frame @ np.array([[p[0], 0, p[2]], [0, p[1], 0], [0, 0, 1.0]])

    def transformed(self, inverse, determinant, light):
        """Value, which is its own density, of the transformed cosine."""
        w = light @ inverse.T
        length2 = (w * w).sum(1)
        return np.maximum(w[:, 2], 0.0) * determinant / (np.pi * length2**2)

    def error(self, p):
        if p[0] < 1e-7 or p[1] < 1e-7:
            return 1e30
        m = self.matrix(p)
        inverse = np.linalg.inv(m)
        determinant = abs(np.linalg.det(inverse))
        mine = self.transformed(inverse, determinant, self.light)
        error = np.abs(self.value - mine) ** 3 / (self.density + mine + 1e-30)
        other = COSINE @ m.T
        other /= np.linalg.norm(other, axis=1, keepdims=True)
        mine = self.transformed(inverse, determinant, other)
        value, density = lobe(self.view, other, self.alpha)
        return error.mean() + (np.abs(value / self.norm - mine) ** 3 / (density + mine + 1e-30)).mean()


def nelder_mead(f, start, step, rounds):
    n = len(start)
    points = [np.array(start)] + [np.array(start) + step * np.eye(n)[i] * max(abs(start[i]), 0.05) for i in range(n)]
    values = [f(p) for p in points]
    for _ in range(rounds):
        order = np.argsort(values)
        points, values = [points[i] for i in order], [values[i] for i in order]
        if abs(values[-1] - values[0]) < 1e-6 * (abs(values[0]) + 1e-12):
            break
        middle = sum(points[:-1]) / n
        reflected = 2.0 * middle - points[-1]
        value = f(reflected)
        if value < values[0]:
            far = 3.0 * middle - 2.0 * points[-1]
            further = f(far)
            points[-1], values[-1] = (far, further) if further < value else (reflected, value)
        elif value < values[-2]:
            points[-1], values[-1] = reflected, value
        else:
            near = 0.5 * (middle + points[-1])
            value = f(near)
            if value < values[-1]:
                points[-1], values[-1] = near, value
            else:
                for i in range(1, n + 1):
                    points[i] = 0.5 * (points[0] + points[i])
                    values[i] = f(points[i])
    best = int(np.argmin(values))
    return points[best]


def table(size):
    out = np.zeros((size, size, 4))
    first = (1.0, 1.0, 0.0)  # of the roughness at hand, seen from above
    for i in reversed(range(size)):  # roughness, from where the lobe is nearly a cosine
        alpha = max((i / (size - 1)) ** 2, ALPHA_MIN)
        p = first
        for j in range(size):  # sqrt(1 - cos theta)
            cosine = max(1.0 - (j / (size - 1)) ** 2, 1e-3)
            fit = Fit(np.array([np.sqrt(1.0 - cosine**2), 0.0, cosine]), alpha)
            if j == 0:
                same = nelder_mead(lambda q: fit.error((q[0], q[0], 0.0)), (p[0],), 0.1, 100)
                p = first = (same[0], same[0], 0.0)
            else:
                p = tuple(nelder_mead(fit.error, p, 0.1, 200))
            inverse = np.linalg.inv(fit.matrix(p))
            inverse /= inverse[1, 1]
            out[j, i] = inverse[0, 0], inverse[0, 2], inverse[2, 0], inverse[2, 2]
        print(f"roughness {i / (size - 1):.3f}", flush=True)
    return out


def write(path, values):
    rows = [f"    {{{', '.join(f'{x:#.6g}F' for x in cell)}}}," for cell in values.reshape(-1, 4)]
    path.write_text(
        "// Written by scripts/fit_ltc.py; do not edit. [sqrt(1 - n.v)][roughness]: elements (0, 0), (0, 2), (2, 0), (2, 2)\n"
        "// of the inverse matrix over its element (1, 1).\n" + "\n".join(rows) + "\n")


def compare(values, folder):
    theirs = np.load(folder / "ltc_1.npy")[..., [0, 2, 1, 3]]  # ours is by rows, theirs by columns
    at = np.linspace(0, theirs.shape[0] - 1, values.shape[0])
    low = np.floor(at).astype(int)
    high, part = np.minimum(low + 1, theirs.shape[0] - 1), at - low
    rows = theirs[low] * (1 - part)[:, None, None] + theirs[high] * part[:, None, None]
    both = rows[:, low] * (1 - part)[None, :, None] + rows[:, high] * part[None, :, None]
    # Smooth and grazing cells are fitted with another least width.
    off = np.abs(values - both)[:-2, 6:]
    print("median and largest difference by element:", np.median(off, (0, 1)), off.max((0, 1)))


def main():
    options = argparse.ArgumentParser()
    options.add_argument("--size", type=int, default=32)
    options.add_argument("--compare", type=Path)
    options = options.parse_args()
    values = table(options.size)
    if options.compare:
        compare(values, options.compare)
    write(Path(__file__).parent.parent / "src/brdf/ltc_ggx.inl", values)


if __name__ == "__main__":
    main()
