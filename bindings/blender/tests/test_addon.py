# SPDX-License-Identifier: GPL-3.0-or-later
"""Run by Blender without a window (scripts/test_addon), with the add-on installed: distances are of Blender's own
evaluation."""
import math
import os
import sys
import unittest

import bpy
import numpy
from mathutils import Euler, Matrix, Vector

SHARED = os.environ.get("SHIGUSA_SHARED", "")
MOVED = Matrix.LocRotScale(Vector((1.5, -0.7, 0.3)), Euler((0, 0, 0.7)), Vector((0.9, 0.9, 0.9)))
BOUND = 1e-4  # m
# joints of a person of 1.7 m, right side (centimetres: right, up, ahead) and the joint above
MIXAMO = {
    "Hips": (0, 95, 0, ""), "Spine": (0, 105, -1, "Hips"), "Spine1": (0, 116, -2, "Spine"), "Spine2": (0, 128, -2, "Spine1"),
    "Neck": (0, 145, -2, "Spine2"), "Head": (0, 153, 0, "Neck"), "HeadTop_End": (0, 171, 0, "Head"),
    "{}Shoulder": (4, 140, -1, "Spine2"), "{}Arm": (17, 140, -3, "{}Shoulder"), "{}ForeArm": (44, 140, -4, "{}Arm"),
    "{}Hand": (70, 140, -3, "{}ForeArm"), "{}HandMiddle1": (79, 140, -2, "{}Hand"), "{}HandMiddle2": (83, 140, -2, "{}HandMiddle1"),
    "{}HandMiddle3": (86, 140, -2, "{}HandMiddle2"), "{}UpLeg": (9, 91, 0, "Hips"), "{}Leg": (9, 50, 1, "{}UpLeg"),
    "{}Foot": (9, 9, -2, "{}Leg"), "{}ToeBase": (9, 2, 12, "{}Foot"), "{}Toe_End": (9, 2, 19, "{}ToeBase"),
}


def empty_file():
    bpy.ops.wm.read_homefile(use_empty=True)
    bpy.context.scene.render.fps = 24


def metarig():
    bpy.ops.object.armature_human_metarig_add()
    return bpy.context.object


def rigify():
    meta = metarig()
    bpy.ops.pose.rigify_generate()
    rig = next(one for one in bpy.data.objects if one.type == "ARMATURE" and one != meta)
    bpy.data.objects.remove(meta)
    bpy.context.view_layer.objects.active = rig
    return rig


def mixamo():
    """As an FBX comes in: centimetres, y up, below an object of scale 0.01 that is turned."""
    armature = bpy.data.objects.new("Armature", bpy.data.armatures.new("Armature"))
    bpy.context.scene.collection.objects.link(armature)
    bpy.context.view_layer.objects.active = armature
    armature.matrix_world = Matrix.LocRotScale(None, Euler((math.pi / 2, 0, 0)), Vector((0.01, 0.01, 0.01)))
    bpy.ops.object.mode_set(mode="EDIT")
    made = {}
    for joint, (right, up, ahead, above) in MIXAMO.items():
        for side, sign in (("Left", 1), ("Right", -1)) if "{}" in joint else (("", 1),):
            bone = armature.data.edit_bones.new("mixamorig:" + joint.format(side))
            bone.head = (sign * right, up, ahead)
            bone.tail = bone.head + Vector((0, 0, 4) if "Foot" in joint else (0, 4, 0))
            bone.parent = made.get(above.format(side))
            made[joint.format(side)] = bone
    bpy.ops.object.mode_set(mode="OBJECT")
    return armature


def imported(name):
    if not hasattr(numpy, "bool"):  # Debian's importer asks its newer NumPy for a name that is gone
        numpy.bool = bool
    bpy.ops.import_scene.gltf(filepath=os.path.join(SHARED, "characters", name), guess_original_bind_pose=False)
    armature = next(one for one in bpy.data.objects if one.type == "ARMATURE")
    bpy.context.view_layer.objects.active = armature
    return armature


def panel():
    return sys.modules["shigusa_blender.panel"]


def heads(armature, frame=None):
    """World matrices of all bones, as Blender evaluates them."""
    if frame is not None:
        bpy.context.scene.frame_set(frame)
    posed = armature.evaluated_get(bpy.context.evaluated_depsgraph_get())
    return {bone.name: posed.matrix_world @ bone.matrix for bone in posed.pose.bones}


def turn(a, b):
    """Angle between two orientations, rad."""
    angle = a.to_quaternion().rotation_difference(b.to_quaternion()).angle
    return min(angle, 2 * math.pi - angle)


def left(armature):
    """All that a file holds, without the keys of Actions."""
    kept = {
        name: sorted(one.name for one in getattr(bpy.data, name))
        for name in dir(bpy.data) if isinstance(getattr(bpy.data, name), bpy.types.bpy_prop_collection)
    }
    kept["rest"] = [tuple(map(tuple, bone.matrix_local)) for bone in armature.data.bones]
    kept["bones"] = [
        (bone.name, bone.rotation_mode, len(bone.constraints), sorted(bone.keys())) for bone in armature.pose.bones]
    kept["switches"] = [(bone.name, bone[key]) for bone in armature.pose.bones for key in bone.keys() if key == "IK_FK"]
    kept["placed"] = tuple(map(tuple, armature.matrix_world))
    scene = bpy.context.scene
    kept["scene"] = (scene.frame_current, scene.frame_start, scene.frame_end, scene.render.fps, armature.mode)
    return kept


def goal(armature, effector, ahead, across, up):
    """A goal by the add-on's button, moved to shares of the stature: ahead of and beside the hips, above the floor."""
    bpy.ops.shigusa.goal(effector=effector)
    empty = getattr(bpy.context.scene.shigusa, effector)
    about = panel().engine.Character.of_nodes(
        panel().rig.skeleton(armature, bpy.context.evaluated_depsgraph_get()).nodes, "it").about
    tall = about["stature_m"]
    empty.location = panel().logic.to_host(about["placement"], [-across * tall, up * tall, ahead * tall])
    bpy.context.view_layer.update()
    return empty


def prefix():
    return panel().state.skeleton.controls.prefix if panel().state.skeleton.controls else ""


def end_bone(effector="right_hand"):
    """The bone that a goal holds of."""
    told = panel().state.result[0].about["reached"]
    return prefix() + next(one["joint"] for one in told if one["effector"] == effector)


class Rigs(unittest.TestCase):
    def reach(self, make, pose, moved):
        empty_file()
        armature = make()
        if moved:
            armature.matrix_world = MOVED @ armature.matrix_world
        pose(armature)
        bpy.context.scene.frame_set(11)
        empty = goal(armature, "right_hand", 0.25, 0.12, 0.52)
        start, before = heads(armature), left(armature)
        self.assertEqual(bpy.ops.shigusa.find(), {"FINISHED"})
        self.assertEqual(left(armature), before)
        self.assertEqual(heads(armature), start)
        self.assertGreaterEqual(len(panel().state.result), 1)
        for number in range(len(panel().state.result) - 1, -1, -1)[-2:]:
            self.assertEqual(bpy.ops.shigusa.apply(candidate=number), {"FINISHED"})
            self.reached(armature, empty, start)
        bpy.context.scene.frame_set(11)
        after = left(armature)
        self.assertEqual([name for name in after["actions"] if name not in before["actions"]], [armature.animation_data.action.name])
        after["actions"] = before["actions"]
        before["switches"] = [(bone, 1.0) for bone, _ in before["switches"]]  # keyed: limbs follow FK
        self.assertEqual(after, before)
        return armature, empty, start

    def reached(self, armature, empty, start):
        first, last = armature.animation_data.action.frame_range
        self.assertEqual((first, last), (11, round(last)))
        self.assertGreater(last, 20)
        joint = end_bone()
        end = heads(armature, int(last))
        off = (end[joint].translation - empty.location).length
        self.assertLess(off, BOUND)
        # the hand came from elsewhere
        self.assertGreater((start[joint].translation - empty.location).length, 0.05)
        feet = [prefix() + one["joint"] for one in panel().state.shown.about["contacts"]]
        self.assertIn(len(feet), (1, 2))  # CesiumMan stands on one
        slid = max(
            (heads(armature, frame)[foot].translation - start[foot].translation).length
            for frame in range(11, int(last) + 1) for foot in feet)
        self.assertLess(slid, BOUND)
        begun = heads(armature, 11)
        # of control rigs what follows them: IK's poles and handles stay
        seen = [name for name in start if name.startswith(("DEF-", "ORG-")) or not prefix()]
        away = max((begun[name].translation - start[name].translation).length for name in seen)
        turned = max(turn(begun[name], start[name]) for name in seen)
        self.assertLess(away, BOUND)
        self.assertLess(turned, 2e-3)
        print(f"  {armature.name}: hand {1000 * off:.4f} mm, feet {1000 * slid:.4f} mm, first frame {1000 * away:.4f} mm, "
              f"{turned:.5f} rad, {int(last) - 10} frames, {panel().logic.title(panel().state.shown)}")

    def both(self, make, pose=lambda armature: None):
        for moved in (False, True):
            with self.subTest(moved=moved):
                self.reach(make, pose, moved)

    def test_meta_rig(self):
        def pose(armature):
            armature.pose.bones["upper_arm.R"].rotation_quaternion = Euler((0.5, 0, 0.3)).to_quaternion()
            armature.pose.bones["f_index.02.L"].rotation_mode = "XYZ"
            armature.pose.bones["f_index.02.L"].rotation_euler = (0.6, 0, 0)
            armature.pose.bones["spine.002"].rotation_mode = "ZXY"
        self.both(metarig, pose)

    def test_generated_rig(self):
        def pose(armature):
            armature.pose.bones["hand_ik.R"].location = (0.05, 0.1, -0.2)
            armature.pose.bones["torso"].location = (0, 0.02, -0.04)
        self.both(rigify, pose)

    def test_mixamo(self):
        def pose(armature):
            for side, sign in (("Left", 1), ("Right", -1)):
                armature.pose.bones[f"mixamorig:{side}Arm"].rotation_mode = "AXIS_ANGLE"
                armature.pose.bones[f"mixamorig:{side}Arm"].rotation_axis_angle = (1.2, 0, 0, -sign)
        self.both(mixamo, pose)

    @unittest.skipUnless(SHARED, "there is no ../shared")
    def test_imported_files(self):
        for name in ("lab0_CesiumMan.glb", "KayKit_Knight.glb", "mannequiny.glb"):
            with self.subTest(name):
                self.both(lambda: imported(name))


if __name__ == "__main__":
    bpy.ops.preferences.addon_enable(module="rigify")
    bpy.ops.preferences.addon_enable(module="shigusa_blender")
    unittest.main(argv=["test_addon", *(sys.argv[sys.argv.index("--") + 1:] if "--" in sys.argv else [])])
