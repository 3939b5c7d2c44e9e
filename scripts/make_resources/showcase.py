# The showcase: seven material balls on plinths, the whole stage's occlusion in its maps.
# SPDX-License-Identifier: MIT
from dataclasses import replace

import numpy as np

from . import ball, bake, coats, shapes, stage
from .glb import CLAMP, Glb
from .occlusion import Cylinder, Sphere, resized, visibility
from .pixels import normal_bytes, orm, srgb, tile_slopes, to_bytes

JPEG = 90  # quality of the maps that are not flat or tiny
AO_TOP, AO_SIDE = 96, 48  # texels of a plinth's top (square) and of its side's height in the atlas


def add_balls(glb, profile):
    geometry = glb.add_geometry(ball.surface(profile).moved(rotation=bake.TILT))
    atlases = {}
    for name, coat_of, size in coats.COATS:
        atlas = atlases.setdefault(size, ball.Atlas(profile, size))
        coat = coat_of(atlas)
        unused = ~atlas.strip & ~(atlas.discs[0] | atlas.discs[1])
        maps = {"orm_map": orm(bake.ball_occlusion(atlas, name), coat.roughness, coat.metallic)}
        flat = np.ndim(coat.base) == 1
        if not flat:
            maps["base_map"] = srgb(coat.base)
        if coat.height is not None:
            maps["normal_map"] = normal_bytes(*atlas.slopes(coat.height))
        for key, texels in maps.items():
            texels[unused] = texels[0, 0]
            maps[key] = glb.texture_ref(glb.add_texture(f"{name}_{key[:-4]}", texels, JPEG))
        material = glb.add_material(
            name, coat.base if flat else (1, 1, 1), 1.0, 1.0, occlusion_map=maps["orm_map"], **maps
        )
        glb.add_node(
            name,
            mesh=glb.add_mesh(name, geometry, material),
            scale=[ball.RADIUS_M] * 3,
            translation=[float(c) for c in bake.ball_center(name)],
        )


def add_feet(glb):
    """One foot for all: it is hidden by its ball and its plinth, the same everywhere."""
    foot = ball.foot()
    rows = 64
    front = np.flatnonzero(foot.uv0[:, 0] == 0)  # one line down the profile
    line, v = (foot.positions[front], foot.normals[front]), foot.uv0[front, 1]
    at = (np.arange(rows) + 0.5) / rows
    points, normals = (np.stack([np.interp(at, v, a[:, i]) for i in range(3)], 1) for a in line)
    floor = -ball.CENTER_M
    seen = visibility(
        points * ball.RADIUS_M,
        shapes.unit(normals),
        [
            Sphere((0, 0, 0), 0.99 * ball.RADIUS_M),
            Cylinder((0, 0), 0.038, floor, floor + 0.03),
            Cylinder((0, 0), stage.PLINTH_RADIUS_M, -1.0, floor),
        ],
        bake.REACH_M,
        bounce=0.1,
    )
    texture = glb.add_texture(
        "foot_occlusion", to_bytes(np.repeat(seen[:, None], 4, 1)), wrap=CLAMP
    )
    material = glb.add_material(
        "foot", (0.052, 0.053, 0.056), 0.0, 0.38, occlusion_map=glb.texture_ref(texture)
    )
    mesh = glb.add_mesh("foot", glb.add_geometry(replace(foot, tangents=None)), material)
    for name in bake.PLACES:
        glb.add_node(
            f"{name}_foot",
            mesh=mesh,
            scale=[ball.RADIUS_M] * 3,
            translation=[float(c) for c in bake.ball_center(name)],
        )


def plinth_atlas():
    """Occlusion of all plinths, [rows, 4 tops wide], and where in it each has its top and side."""
    width, places = 4 * AO_TOP, {}
    pixels = np.ones((2 * AO_TOP + len(bake.PLACES) * AO_SIDE, width), np.float32)
    for i, name in enumerate(bake.PLACES):
        x, z, _ = bake.PLACES[name]
        half = stage.PLINTH_RADIUS_M * 1.02
        row, column = i // 4 * AO_TOP, i % 4 * AO_TOP
        pixels[row : row + AO_TOP, column : column + AO_TOP] = bake.flat_occlusion(
            (AO_TOP, AO_TOP),
            (x, z),
            (half, half),
            bake.base_height(name),
            bake.solids(but_plinth=name),
            [((x, z), 0.058)],
        )
        side = 2 * AO_TOP + i * AO_SIDE
        pixels[side : side + AO_SIDE] = bake.side_occlusion(
            (x, z),
            stage.PLINTH_RADIUS_M,
            stage.FLOOR_HEIGHT_M,
            bake.base_height(name),
            bake.solids(but_plinth=name),
            (AO_SIDE, width),
        )
        places[name] = (row, column, side, half)
    return pixels, places


def add_plinth(glb, index, name, rectangle, atlas_shape, maps):
    """`rectangle` is the plinth's place in the occlusion atlas, as plinth_atlas gives it."""
    x, z, tall = bake.PLACES[name]
    row, column, side, half = rectangle
    height, width = atlas_shape

    def top_uv1(px, pz):
        u, v = ((p / half + 1) / 2 * AO_TOP for p in (px, pz))
        return np.stack([(column + u) / width, (row + v) / height], 1)

    def side_uv1(around, up):
        # Texel centres at most: the neighbours' rows stay out.
        inner = np.clip((1 - up) * AO_SIDE, 0.5, AO_SIDE - 0.5)
        return np.stack([around, (side + inner) / height], 1)

    # The same slab for all, cut elsewhere for each; quarter turns, so that the side still closes.
    offset = [round(0.37 * index % 1, 4), round(0.61 * index % 1, 4)]
    cut = {"offset": offset, "rotation": round(index % 4 * np.pi / 2, 6)}
    material = glb.add_material(
        f"terrazzo_{index}",
        base_map=glb.texture_ref(maps["base"], transform=cut),
        orm_map=glb.texture_ref(maps["orm"], transform=cut),
        occlusion_map=glb.texture_ref(maps["occlusion"], uv_set=1),
    )
    size = (stage.PLINTH_RADIUS_M, tall, stage.PLINTH_BEVEL_M)
    drum = replace(stage.drum(size, stage.TERRAZZO_M, 80, 2, top_uv1, side_uv1), tangents=None)
    mesh = glb.add_mesh(f"{name}_plinth", glb.add_geometry(drum), material)
    glb.add_node(f"{name}_plinth", mesh=mesh, translation=[x, stage.FLOOR_HEIGHT_M, z])


def add_plinths(glb):
    pixels, places = plinth_atlas()
    base, roughness = stage.terrazzo(768)
    maps = {
        "base": glb.add_texture("terrazzo_base", srgb(base), JPEG),
        "orm": glb.add_texture("terrazzo_orm", orm(1.0, roughness, 0.0), 85),
        "occlusion": glb.add_texture("plinth_occlusion", to_bytes(pixels), wrap=CLAMP),
    }
    for index, name in enumerate(bake.PLACES):
        add_plinth(glb, index, name, places[name], pixels.shape, maps)


def floor_surface(size, strip):
    """The floor and its occlusion, [size + strip, size]: the top, then the side."""
    half = stage.FLOOR_RADIUS_M * 1.01
    drums = [((x, z), stage.PLINTH_RADIUS_M) for x, z, _ in bake.PLACES.values()]
    blockers, high = bake.solids(floor=False), stage.FLOOR_HEIGHT_M
    top = bake.flat_occlusion((384, 384), (0, 0), (half, half), high, blockers, drums)
    side = bake.side_occlusion((0, 0), stage.FLOOR_RADIUS_M, 0.0, high, blockers, (strip, size))

    def top_uv1(x, z):
        return np.stack([(x / half + 1) / 2, (z / half + 1) / 2 * size / (size + strip)], 1)

    def side_uv1(around, up):
        down = np.clip((1 - up) * strip, 1.0, strip - 0.5)
        return np.stack([around, (size + down) / (size + strip)], 1)

    measures = (stage.FLOOR_RADIUS_M, high, stage.FLOOR_BEVEL_M)
    drum = stage.drum(measures, stage.TILE_M, 160, 6, top_uv1, side_uv1)
    return drum, np.concatenate([resized(top, (size, size)), side])


def add_floor(glb):
    drum, seen = floor_surface(512, 32)
    base, roughness, height = stage.concrete(1024)
    normals = normal_bytes(*tile_slopes(height, stage.TILE_M / 1024))
    occlusion = glb.add_texture("floor_occlusion", to_bytes(seen), wrap=CLAMP)
    material = glb.add_material(
        "concrete",
        base_map=glb.texture_ref(glb.add_texture("concrete_base", srgb(base), JPEG)),
        orm_map=glb.texture_ref(glb.add_texture("concrete_orm", orm(1.0, roughness, 0.0), 85)),
        normal_map=glb.texture_ref(glb.add_texture("concrete_normal", normals, 88)),
        occlusion_map=glb.texture_ref(occlusion, uv_set=1),
    )
    glb.add_node("floor", mesh=glb.add_mesh("floor", glb.add_geometry(drum), material))


def add_backdrop(glb):
    surface, extent = stage.backdrop()
    half = stage.BACKDROP_HALF_M
    seen = bake.flat_occlusion(
        (256, 208), (0, 0), half, 0.0, bake.solids()[1:], [((0, 0), stage.FLOOR_RADIUS_M)]
    )
    occlusion = glb.texture_ref(
        glb.add_texture("backdrop_occlusion", to_bytes(seen), wrap=CLAMP), uv_set=1
    )
    paint = glb.texture_ref(
        glb.add_texture("backdrop_paint", srgb(stage.backdrop_paint(512, extent)), JPEG, wrap=CLAMP)
    )
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
