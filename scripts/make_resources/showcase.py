# The showcase: seven material balls on plinths, with the occlusion of the whole stage baked into its maps.
# SPDX-License-Identifier: MIT
import numpy as np

from . import ball, coats, shapes, stage
from .glb import CLAMP, Glb
from .occlusion import Cylinder, Plane, Sphere, resized, visibility
from .pixels import mix, normal_bytes, orm, srgb, tile_slopes, to_bytes

# Where each coat's ball stands: x, z of its plinth and the plinth's height, metres.
PLACES = {"gold": (0.0, -0.235, 0.235), "brushed_steel": (0.140, 0.115, 0.045), "red_lacquer": (-0.140, 0.115, 0.045),
          "clay": (-0.285, -0.170, 0.165), "glazed_ceramic": (-0.420, 0.160, 0.045), "worn_paint": (0.420, 0.160, 0.045),
          "weathered_copper": (0.285, -0.170, 0.165)}
TILT = shapes.rotation((0, 0, 1), -16) @ shapes.rotation((1, 0, 0), 27)  # shows the cap and slants the band
REACH_M = 0.34            # at this distance a blocker takes half its part
DEEPEN = 1.6              # exponent on the stage's visibility: a studio lights from a few sides, not from all
JPEG = 90
AO_TOP, AO_SIDE = 96, 48  # texels of a plinth's top (square) and of its side's height in the atlas


def base_height(name):
    return stage.FLOOR_HEIGHT_M + PLACES[name][2]


def ball_center(name):
    x, z, _ = PLACES[name]
    return np.array([x, base_height(name) + ball.CENTER_M, z])


def ball_solids(name):
    x, z, _ = PLACES[name]
    y = base_height(name)
    return [Sphere(tuple(ball_center(name)), 0.99 * ball.RADIUS_M),
            Cylinder((x, z), 0.042, y, y + 0.034), Cylinder((x, z), 0.060, y, y + 0.010)]


def plinth_solid(name):
    x, z, _ = PLACES[name]
    return Cylinder((x, z), stage.PLINTH_RADIUS_M, 0.0, base_height(name))


def solids(but_ball=None, but_plinth=None, floor=True):
    """Everything that can block light, but for the ball or plinth that is being baked."""
    found = [Plane(0.0)]
    if floor:
        found.append(Cylinder((0, 0), stage.FLOOR_RADIUS_M, 0.0, stage.FLOOR_HEIGHT_M))
    for name in PLACES:
        if name != but_plinth:
            found.append(plinth_solid(name))
        if name != but_ball:
            found += ball_solids(name)
    return found


def bake_ball(atlas, name):
    """Occlusion of one ball by texel: its own relief times what stands around it."""
    coarse = 128
    step = atlas.size // coarse
    pick = np.s_[step // 2::step, step // 2::step]
    points = atlas.p[pick].reshape(-1, 3) @ TILT.T * ball.RADIUS_M + ball_center(name)
    normals = atlas.p[pick].reshape(-1, 3) @ TILT.T
    x, z, _ = PLACES[name]
    y = base_height(name)
    foot = [Cylinder((x, z), 0.045, y, y + 0.034), Cylinder((x, z), 0.060, y, y + 0.010)]
    seen = visibility(points, shapes.unit(normals), solids(but_ball=name) + foot, REACH_M, bounce=0.25)
    return resized(seen.reshape(coarse, coarse), (atlas.size, atlas.size)) * mix(1.0, atlas.visible, 0.9)


def outside_drums(points, drums):
    """Moves points [n, 2] out of the round footprints, so that texels under a drum repeat its rim."""
    for center, radius in drums:
        d = points - np.asarray(center)
        r = np.linalg.norm(d, axis=1, keepdims=True)
        points = np.where(r < radius + 5e-4, np.asarray(center) + d / np.maximum(r, 1e-9) * (radius + 5e-4), points)
    return points


def bake_flat(size, middle, half, height, blockers, drums):
    """Occlusion of a horizontal rectangle, [size_v, size_u]."""
    u, v = ((np.arange(n) + 0.5) / n * 2 - 1 for n in size)
    x, z = np.meshgrid(middle[0] + u * half[0], middle[1] + v * half[1])
    flat = outside_drums(np.stack([x.ravel(), z.ravel()], 1), drums)
    points = np.stack([flat[:, 0], np.full(len(flat), height), flat[:, 1]], 1)
    return visibility(points, np.tile([0.0, 1.0, 0.0], (len(points), 1)), blockers, REACH_M).reshape(x.shape) ** DEEPEN


def bake_side(center, radius, bottom, top, blockers, shape):
    """Occlusion of a drum's side, [height, around], first row on top."""
    angle, y = np.meshgrid((np.arange(shape[1]) + 0.5) / shape[1] * 2 * np.pi, top + (bottom - top) * (np.arange(shape[0]) + 0.5) / shape[0])
    normals = np.stack([np.sin(angle), 0 * y, np.cos(angle)], -1).reshape(-1, 3)
    points = normals * radius + np.stack([np.full(y.size, center[0]), y.ravel(), np.full(y.size, center[1])], 1)
    return visibility(points, normals, blockers, REACH_M).reshape(shape) ** DEEPEN


def add_balls(glb, profile):
    geometry = glb.add_geometry(ball.surface(profile).moved(rotation=TILT))
    atlases = {}
    for name, coat_of, size in coats.COATS:
        atlas = atlases.setdefault(size, ball.Atlas(profile, size))
        coat = coat_of(atlas)
        unused = ~atlas.strip & ~(atlas.discs[0] | atlas.discs[1])
        maps = {"orm_map": orm(bake_ball(atlas, name), coat.roughness, coat.metallic)}
        flat = np.ndim(coat.base) == 1
        if not flat:
            maps["base_map"] = srgb(coat.base)
        if coat.height is not None:
            maps["normal_map"] = normal_bytes(*atlas.slopes(coat.height))
        for key, texels in maps.items():
            texels[unused] = texels[0, 0]
            maps[key] = glb.texture_ref(glb.add_texture(f"{name}_{key[:-4]}", texels, JPEG))
        material = glb.add_material(name, coat.base if flat else (1, 1, 1), 1.0, 1.0,
                                    occlusion_map=maps["orm_map"], **maps)
        glb.add_node(name, mesh=glb.add_mesh(name, geometry, material), scale=[ball.RADIUS_M] * 3,
                     translation=[float(c) for c in ball_center(name)])


def add_feet(glb):
    """One foot for all: what hides it is the ball above and the plinth below, the same everywhere."""
    foot = ball.foot()
    rows = 64
    front = np.flatnonzero(foot.uv0[:, 0] == 0)  # one line down the profile
    line, v = (foot.positions[front], foot.normals[front]), foot.uv0[front, 1]
    at = (np.arange(rows) + 0.5) / rows
    points, normals = (np.stack([np.interp(at, v, a[:, i]) for i in range(3)], 1) for a in line)
    floor = -ball.CENTER_M
    seen = visibility(points * ball.RADIUS_M, shapes.unit(normals),
                      [Sphere((0, 0, 0), 0.99 * ball.RADIUS_M), Cylinder((0, 0), 0.038, floor, floor + 0.03),
                       Cylinder((0, 0), stage.PLINTH_RADIUS_M, -1.0, floor)], REACH_M, bounce=0.1)
    texture = glb.add_texture("foot_occlusion", to_bytes(np.repeat(seen[:, None], 4, 1)), wrap=CLAMP)
    material = glb.add_material("foot", (0.052, 0.053, 0.056), 0.0, 0.38, occlusion_map=glb.texture_ref(texture))
    mesh = glb.add_mesh("foot", glb.add_geometry(foot), material)
    for name in PLACES:
        glb.add_node(f"{name}_foot", mesh=mesh, scale=[ball.RADIUS_M] * 3, translation=[float(c) for c in ball_center(name)])


def plinth_atlas():
    """Occlusion of all plinths, [rows, 4 tops wide]; and the rectangle of each top and side in it."""
    width, places = 4 * AO_TOP, {}
    pixels = np.ones((2 * AO_TOP + len(PLACES) * AO_SIDE, width), np.float32)
    for i, name in enumerate(PLACES):
        x, z, _ = PLACES[name]
        half = stage.PLINTH_RADIUS_M * 1.02
        row, column = i // 4 * AO_TOP, i % 4 * AO_TOP
        pixels[row:row + AO_TOP, column:column + AO_TOP] = bake_flat(
            (AO_TOP, AO_TOP), (x, z), (half, half), base_height(name), solids(but_plinth=name), [((x, z), 0.058)])
        side = 2 * AO_TOP + i * AO_SIDE
        pixels[side:side + AO_SIDE] = bake_side((x, z), stage.PLINTH_RADIUS_M, stage.FLOOR_HEIGHT_M, base_height(name),
                                                solids(but_plinth=name), (AO_SIDE, width))
        places[name] = (row, column, side, half)
    return pixels, places


def add_plinths(glb):
    pixels, places = plinth_atlas()
    height, width = pixels.shape
    occlusion = glb.texture_ref(glb.add_texture("plinth_occlusion", to_bytes(pixels), wrap=CLAMP), uv_set=1)
    base, roughness = stage.terrazzo(768)
    base_map = glb.add_texture("terrazzo_base", srgb(base), JPEG)
    orm_map = glb.add_texture("terrazzo_orm", orm(1.0, roughness, 0.0), 85)
    for i, (name, (x, z, tall)) in enumerate(PLACES.items()):
        row, column, side, half = places[name]

        def top_uv1(px, pz):
            return np.stack([(column + (px / half + 1) / 2 * AO_TOP) / width, (row + (pz / half + 1) / 2 * AO_TOP) / height], 1)

        def side_uv1(around, up):
            inner = np.clip((1 - up) * AO_SIDE, 0.5, AO_SIDE - 0.5)  # texel centres: rows of neighbours stay out
            return np.stack([around, (side + inner) / height], 1)

        # The same slab for all, cut elsewhere for each; quarter turns, so that the side still closes.
        cut = {"offset": [round(0.37 * i % 1, 4), round(0.61 * i % 1, 4)], "rotation": round(i % 4 * np.pi / 2, 6)}
        material = glb.add_material(f"terrazzo_{i}", base_map=glb.texture_ref(base_map, transform=cut),
                                    orm_map=glb.texture_ref(orm_map, transform=cut), occlusion_map=occlusion)
        drum = stage.drum(stage.PLINTH_RADIUS_M, tall, stage.PLINTH_BEVEL_M, stage.TERRAZZO_M, 80, top_uv1, side_uv1, 2)
        glb.add_node(f"{name}_plinth", mesh=glb.add_mesh(f"{name}_plinth", glb.add_geometry(drum), material),
                     translation=[x, stage.FLOOR_HEIGHT_M, z])


def add_floor(glb):
    size, strip = 512, 32
    half = stage.FLOOR_RADIUS_M * 1.01
    drums = [((x, z), stage.PLINTH_RADIUS_M) for x, z, _ in PLACES.values()]
    seen = np.ones((size + strip, size), np.float32)
    seen[:size] = resized(bake_flat((384, 384), (0, 0), (half, half), stage.FLOOR_HEIGHT_M, solids(floor=False), drums), (size, size))
    seen[size:] = bake_side((0, 0), stage.FLOOR_RADIUS_M, 0.0, stage.FLOOR_HEIGHT_M, solids(floor=False), (strip, size))
    occlusion = glb.texture_ref(glb.add_texture("floor_occlusion", to_bytes(seen), wrap=CLAMP), uv_set=1)

    def top_uv1(x, z):
        return np.stack([(x / half + 1) / 2, (z / half + 1) / 2 * size / (size + strip)], 1)

    def side_uv1(around, up):
        return np.stack([around, (size + np.clip((1 - up) * strip, 1.0, strip - 0.5)) / (size + strip)], 1)

    drum = stage.drum(stage.FLOOR_RADIUS_M, stage.FLOOR_HEIGHT_M, stage.FLOOR_BEVEL_M, stage.TILE_M, 160, top_uv1, side_uv1, 6)
    base, roughness, height = stage.concrete(1024)
    material = glb.add_material(
        "concrete", base_map=glb.texture_ref(glb.add_texture("concrete_base", srgb(base), JPEG)),
        orm_map=glb.texture_ref(glb.add_texture("concrete_orm", orm(1.0, roughness, 0.0), 85)),
        normal_map=glb.texture_ref(glb.add_texture("concrete_normal", normal_bytes(*tile_slopes(height, stage.TILE_M / 1024)), 88)),
        occlusion_map=occlusion)
    glb.add_node("floor", mesh=glb.add_mesh("floor", glb.add_geometry(drum), material))


def add_backdrop(glb):
    surface, extent = stage.backdrop()
    half = stage.BACKDROP_HALF_M
    seen = bake_flat((256, 208), (0, 0), half, 0.0, solids()[1:], [((0, 0), stage.FLOOR_RADIUS_M)])
    occlusion = glb.texture_ref(glb.add_texture("backdrop_occlusion", to_bytes(seen), wrap=CLAMP), uv_set=1)
    paint = glb.texture_ref(glb.add_texture("backdrop_paint", srgb(stage.backdrop_paint(512, extent)), JPEG, wrap=CLAMP))
    material = glb.add_material("backdrop", roughness=0.92, base_map=paint, occlusion_map=occlusion)
    glb.add_node("backdrop", mesh=glb.add_mesh("backdrop", glb.add_geometry(surface), material))


def build(copyright_line):
    glb = Glb(copyright_line)
    glb.add_camera("hero", (0.0, 0.60, 1.60), (0.0, 0.228, 0.0), 28)
    glb.add_camera("close", (0.52, 0.40, 1.06), (0.285, 0.235, 0.05), 26)
    add_balls(glb, ball.Profile())
    add_feet(glb)
    add_plinths(glb)
    add_floor(glb)
    add_backdrop(glb)
    return glb.to_bytes("showcase")
