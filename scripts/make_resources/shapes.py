# Triangle surfaces: lathes, quads and spheres, with normals, tangents and coordinates.
# SPDX-License-Identifier: MIT
from dataclasses import dataclass
from typing import Optional

import numpy as np


@dataclass
class Surface:
    """Arrays of equal length; tangents' w is the handedness, bitangent = w cross(n, t), towards
    smaller v."""

    positions: np.ndarray
    normals: np.ndarray
    indices: np.ndarray
    uv0: Optional[np.ndarray] = None
    uv1: Optional[np.ndarray] = None
    tangents: Optional[np.ndarray] = None

    def moved(self, offset=(0, 0, 0), rotation=None):
        turn = np.eye(3) if rotation is None else rotation
        tangents = self.tangents
        if tangents is not None:
            tangents = np.concatenate([tangents[:, :3] @ turn.T, tangents[:, 3:]], 1)
        return Surface(
            self.positions @ turn.T + np.asarray(offset, float),
            self.normals @ turn.T,
            self.indices,
            self.uv0,
            self.uv1,
            tangents,
        )


def joined(surfaces):
    """One surface of several; all must have the same attributes."""
    starts = np.cumsum([0] + [len(s.positions) for s in surfaces])
    parts = {}
    for key in ("positions", "normals", "uv0", "uv1", "tangents"):
        values = [getattr(s, key) for s in surfaces]
        parts[key] = None if values[0] is None else np.concatenate(values)
    indices = np.concatenate([s.indices + start for s, start in zip(surfaces, starts)])
    return Surface(indices=indices, **parts)


def unit(v):
    return v / np.maximum(np.linalg.norm(v, axis=-1, keepdims=True), 1e-20)


def grid_indices(rows, columns):
    """Two triangles a cell of a [rows, columns] grid of vertices, counter-clockwise seen with rows
    going down and columns going right."""
    i = (np.arange(rows - 1)[:, None] * columns + np.arange(columns - 1)).ravel()
    a, b, c, d = i, i + columns, i + columns + 1, i + 1
    return np.stack([np.stack([a, b, c], 1), np.stack([a, c, d], 1)], 1).reshape(-1, 3)


def pruned(surface):
    """Without the triangles that have no area, such as a lathe has at its poles, and the vertices
    only they name."""
    p = surface.positions[surface.indices]
    area = np.linalg.norm(np.cross(p[:, 1] - p[:, 0], p[:, 2] - p[:, 0]), axis=1)
    indices = surface.indices[area > 1e-14]
    used = np.unique(indices)
    renumber = np.zeros(len(surface.positions), int)
    renumber[used] = np.arange(len(used))
    return Surface(
        surface.positions[used], surface.normals[used], renumber[indices], surface.uv0[used]
    )


def with_tangents(surface):
    """Tangents along +u of uv0 by angle-free averaging over triangles (Lengyel 2001), which equals
    the exact one on the smooth parametrisations used here."""
    p, t = surface.positions[surface.indices], surface.uv0[surface.indices]
    e1, e2 = p[:, 1] - p[:, 0], p[:, 2] - p[:, 0]
    d1, d2 = t[:, 1] - t[:, 0], t[:, 2] - t[:, 0]
    det = d1[:, 0] * d2[:, 1] - d1[:, 1] * d2[:, 0]
    safe = np.where(np.abs(det) > 1e-20, det, 1.0)[:, None]
    du = np.where(np.abs(det)[:, None] > 1e-20, (e1 * d2[:, 1:] - e2 * d1[:, 1:]) / safe, 0)
    dv = np.where(np.abs(det)[:, None] > 1e-20, (e2 * d1[:, :1] - e1 * d2[:, :1]) / safe, 0)
    tangent, bitangent = np.zeros_like(surface.positions), np.zeros_like(surface.positions)
    for corner in range(3):
        np.add.at(tangent, surface.indices[:, corner], unit(du))
        np.add.at(bitangent, surface.indices[:, corner], -unit(dv))
    n = surface.normals
    tangent -= n * np.sum(n * tangent, 1, keepdims=True)
    lost = np.linalg.norm(tangent, axis=1) < 1e-6  # a pole, where every direction is as good
    tangent[lost] = np.cross(
        n[lost], np.where(np.abs(n[lost, :1]) < 0.9, [[1.0, 0, 0]], [[0, 1.0, 0]])
    )
    tangent = unit(tangent)
    w = np.where(np.sum(np.cross(n, tangent) * bitangent, 1) < 0, -1.0, 1.0)
    surface.tangents = np.concatenate([tangent, w[:, None]], 1)
    return surface


def lathe(profile, normals, segments, v):
    """Turns a profile [rows, 2] of (radius, height), walked from top to bottom with the solid on
    the inner side, about the y axis. u goes once around, v is given by row. The seam's vertices are
    doubled."""
    angle = np.linspace(0, 2 * np.pi, segments + 1)
    angle[-1] = 0.0  # the seam closes exactly
    u = np.linspace(0, 1, segments + 1)
    sin, cos = np.sin(angle), np.cos(angle)

    def turned(p):
        return np.stack(
            [p[:, :1] * sin, np.broadcast_to(p[:, 1:], (len(p), len(u))), p[:, :1] * cos], 2
        )

    positions, turned_normals = turned(profile).reshape(-1, 3), turned(normals).reshape(-1, 3)
    uv = np.stack(np.broadcast_arrays(u[None, :], np.asarray(v)[:, None]), 2).reshape(-1, 2)
    return pruned(Surface(positions, unit(turned_normals), grid_indices(len(profile), len(u)), uv))


def sphere(radius, segments, rings):
    theta = np.linspace(0, np.pi, rings + 1)
    profile = np.stack([np.sin(theta), np.cos(theta)], 1)
    profile[[0, -1], 0] = 0.0
    return lathe(profile * radius, profile, segments, np.linspace(0, 1, rings + 1))


def quad(corner, edge_u, edge_v, divisions=(1, 1)):
    """A parallelogram from `corner` (top left) along edge_u (right) and edge_v (down); it faces
    cross(edge_v, edge_u)."""
    columns, rows = divisions
    u, v = np.linspace(0, 1, columns + 1), np.linspace(0, 1, rows + 1)
    uv = np.stack(np.meshgrid(u, v), 2).reshape(-1, 2)
    positions = (
        np.asarray(corner, float)
        + uv[:, :1] * np.asarray(edge_u, float)
        + uv[:, 1:] * np.asarray(edge_v, float)
    )
    normal = unit(np.cross(edge_v, edge_u).astype(float))
    return Surface(
        positions, np.tile(normal, (len(uv), 1)), grid_indices(rows + 1, columns + 1), uv
    )


def rotation(axis, degrees):
    """Rodrigues' rotation matrix."""
    x, y, z = unit(np.asarray(axis, float))
    k = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    a = np.radians(degrees)
    return np.eye(3) + np.sin(a) * k + (1 - np.cos(a)) * (k @ k)
