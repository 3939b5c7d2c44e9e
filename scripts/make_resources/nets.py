# Closed triangle surfaces of fields: Gibson's surface nets on a bent lattice, drawn onto the field.
# SPDX-License-Identifier: MIT
import numpy as np

from .shapes import Surface, unit

STEP = 1e-4  # of the differences that make gradients, in the field's units of length


def gradient(field, p):
    steps = STEP * np.eye(3)
    return np.stack([field(p + s) - field(p - s) for s in steps], -1) / (2 * STEP)


def drawn_onto(field, p, most):
    """Points moved along the gradient onto the field's surface, at most `most` a step."""
    for _ in range(8):
        g = gradient(field, p)
        step = field(p)[:, None] * g / np.maximum(np.sum(g * g, 1, keepdims=True), 1e-6)
        length = np.linalg.norm(step, axis=1, keepdims=True)
        p = p - step * np.minimum(1, most / np.maximum(length, 1e-12))
    return p


def crossings(corners, value):
    """For every cell of the lattice the mean of where its edges cross 0, and how many do."""
    cells = tuple(n - 1 for n in value.shape)
    total, count = np.zeros((*cells, 3)), np.zeros(cells)
    inside = value < 0
    for axis in range(3):
        a = tuple(slice(0, -1) if i == axis else slice(None) for i in range(3))
        b = tuple(slice(1, None) if i == axis else slice(None) for i in range(3))
        crosses = inside[a] != inside[b]
        share = value[a] / np.where(crosses, value[a] - value[b], 1)
        at = corners[a] + share[..., None] * (corners[b] - corners[a])
        others = [i for i in range(3) if i != axis]
        for first in (0, 1):  # the four edges of a cell along this axis
            for second in (0, 1):
                part = [slice(None)] * 3
                for i, start in zip(others, (first, second)):
                    part[i] = slice(start, start + cells[i])
                part = tuple(part)
                total += np.where(crosses[part][..., None], at[part], 0)
                count += crosses[part]
    return total, count


def quads(value, number):
    """Four cells around every edge that crosses 0, [n, 4], counter-clockwise seen from outside."""
    inside, out = value < 0, []
    for axis in range(3):
        u, v = (axis + 1) % 3, (axis + 2) % 3
        a = tuple(slice(0, -1) if i == axis else slice(1, -1) for i in range(3))
        b = tuple(slice(1, None) if i == axis else slice(1, -1) for i in range(3))
        for leaves in (True, False):  # along the axis
            where = np.argwhere((inside[a] if leaves else ~inside[a]) & (inside[b] != inside[a]))
            where[:, [u, v]] += 1
            around = []
            for du, dv in ((0, 0), (-1, 0), (-1, -1), (0, -1)):
                cell = where.copy()
                cell[:, u] += du
                cell[:, v] += dv
                around.append(number[tuple(cell.T)])
            quad = np.stack(around, 1)
            out.append(quad if leaves else quad[:, ::-1])
    return np.concatenate(out)


def surface(field, corners, most, passes):
    """The surface of `field` within a lattice of corners [x, y, z, 3]; vertices are spread evenly by `passes`
    rounds of smoothing along it. `most` is about half a cell."""
    value = field(corners)
    total, count = crossings(corners, value)
    number = np.full(count.shape, -1)
    used = count > 0
    number[used] = np.arange(np.count_nonzero(used))
    points = total[used] / count[used][:, None]
    faces = quads(value, number)
    points = drawn_onto(field, points, most)
    ends = np.concatenate([np.stack([faces[:, i], faces[:, (i + 1) % 4]], 1) for i in range(4)])
    ends = np.concatenate([ends, ends[:, ::-1]])
    neighbours = np.bincount(ends[:, 0], minlength=len(points))[:, None]
    for _ in range(passes):
        mean = np.stack(
            [np.bincount(ends[:, 0], points[ends[:, 1], i], len(points)) for i in range(3)], 1
        )
        move = mean / neighbours - points
        n = unit(gradient(field, points))
        points = points + 0.5 * (move - n * np.sum(n * move, 1, keepdims=True))
        points = drawn_onto(field, points, most)
    # Each quad is cut along its shorter diagonal.
    p = points[faces]
    short = np.linalg.norm(p[:, 0] - p[:, 2], axis=1) <= np.linalg.norm(p[:, 1] - p[:, 3], axis=1)
    cut = np.where(short[:, None], [[0, 1, 2, 0, 2, 3]], [[1, 2, 3, 1, 3, 0]])
    indices = np.take_along_axis(faces, cut, 1).reshape(-1, 3)
    return Surface(points, unit(gradient(field, points)), indices)
