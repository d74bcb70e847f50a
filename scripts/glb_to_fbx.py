# SPDX-License-Identifier: MIT
# Blender runs this for scripts/glb_to_fbx.
import json
import struct
import sys

import bpy
import numpy

source, target = sys.argv[sys.argv.index("--") + 1 :]


def rate(path):
    """Frames a second of the first animation, which is the motion that was added."""
    with open(path, "rb") as file:
        magic, _, _, length, _ = struct.unpack("<4sIIII", file.read(20))
        if magic != b"glTF":
            sys.exit(f"{path} is no GLB")
        gltf = json.loads(file.read(length))
    if not gltf.get("animations"):
        sys.exit(f"{path} holds no animation")
    times = [gltf["accessors"][sampler["input"]] for sampler in gltf["animations"][0]["samplers"]]
    longest = max(times, key=lambda accessor: accessor["count"])
    return max(1, round((longest["count"] - 1) / max(longest["max"][0] - longest["min"][0], 1e-9)))


# the Blender of Debian 12 asks its newer NumPy for a name that is gone
if not hasattr(numpy, "bool"):
    numpy.bool = bool
bpy.ops.wm.read_factory_settings(use_empty=True)
bpy.context.scene.render.fps = rate(source)
bpy.ops.import_scene.gltf(filepath=source, guess_original_bind_pose=False)
# joints that a motion leaves alone rest, and are not where another animation of the file has them
for item in bpy.data.objects:
    if item.animation_data:
        item.animation_data.action = None
        for track in item.animation_data.nla_tracks:
            track.mute = True
    for bone in item.pose.bones if item.pose else ():
        bone.matrix_basis.identity()
bpy.ops.export_scene.fbx(filepath=target, add_leaf_bones=False, bake_anim_use_nla_strips=False, bake_anim_simplify_factor=0.0)
