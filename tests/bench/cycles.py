# The peer of `facet render --reference`: one glTF under one HDRI with Cycles, and the seconds that the render takes.
# SPDX-License-Identifier: MIT
# blender -b --factory-startup -P tests/bench/cycles.py -- MODEL HDRI OUT.exr SPP DISTANCE X Y Z
# is the picture of facet render MODEL --env HDRI --size 512x512 --fov 30 --background none --no-file-lights
#   --camera "orbit:azimuth=35,elevation=15,distance=DISTANCE,target=X Y Z" --reference SPP -o OUT.exr
# Needs Debian's blender; nothing else here does.
import builtins
import math
import sys
import time

import numpy

for name in ("bool", "int", "float", "object"):  # Blender 3.4's importer names what numpy 1.24 dropped
    if name not in numpy.__dict__:
        setattr(numpy, name, getattr(builtins, name))

import bpy
import mathutils

model, hdri, out, spp = sys.argv[sys.argv.index("--") + 1 :][:4]
distance, *target = map(float, sys.argv[sys.argv.index("--") + 5 :])

bpy.ops.wm.read_factory_settings(use_empty=True)
bpy.ops.import_scene.gltf(filepath=model)
for thing in [o for o in bpy.data.objects if o.type in ("LIGHT", "CAMERA")]:
    bpy.data.objects.remove(thing)

scene = bpy.context.scene
scene.render.engine = "CYCLES"
scene.cycles.samples = int(spp)
scene.cycles.use_adaptive_sampling = False
scene.cycles.use_denoising = False
scene.cycles.pixel_filter_type = "BOX"
scene.cycles.filter_width = 1.0
scene.cycles.sample_clamp_indirect = 0
scene.cycles.blur_glossy = 0
scene.render.resolution_x = scene.render.resolution_y = 512
scene.render.film_transparent = True
scene.render.image_settings.file_format = "OPEN_EXR"
scene.render.image_settings.color_depth = "32"
scene.render.filepath = out

scene.world = bpy.data.worlds.new("world")
scene.world.use_nodes = True
nodes, links = scene.world.node_tree.nodes, scene.world.node_tree.links
environment, mapping, place = map(
    nodes.new, ("ShaderNodeTexEnvironment", "ShaderNodeMapping", "ShaderNodeTexCoord")
)
environment.image = bpy.data.images.load(hdri)
mapping.inputs["Rotation"].default_value = (0, 0, math.radians(-90))
links.new(place.outputs["Generated"], mapping.inputs[0])
links.new(mapping.outputs[0], environment.inputs[0])
links.new(environment.outputs[0], nodes["Background"].inputs[0])


def turned(v):
    """glTF's y up to Blender's z up."""
    return mathutils.Vector((v[0], -v[2], v[1]))


azimuth, elevation = math.radians(35), math.radians(15)
towards = (
    math.sin(azimuth) * math.cos(elevation),
    math.sin(elevation),
    math.cos(azimuth) * math.cos(elevation),
)
eye = turned([t + d * distance for t, d in zip(target, towards)])
camera = bpy.data.objects.new("camera", bpy.data.cameras.new("camera"))
camera.data.sensor_fit, camera.data.angle = "VERTICAL", math.radians(30)
camera.location = eye
camera.rotation_euler = (turned(target) - eye).to_track_quat("-Z", "Y").to_euler()
scene.collection.objects.link(camera)
scene.camera = camera

start = time.time()
bpy.ops.render.render(write_still=True)
print(f"seconds {time.time() - start:.2f}")
