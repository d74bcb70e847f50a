# SPDX-License-Identifier: GPL-3.0-or-later
"""Run by Blender without a window (scripts/test_addon), with the add-on installed: distances are of Blender's own
evaluation."""
import math
import os
import sys
import tomllib
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


def auto_rig_pro():
    """A stand-in for a rig of Auto-Rig Pro: its measured bones, by its names, copy its FK controls."""
    table = panel().logic.AUTO_RIG_PRO
    at = {"root": (0, 0.95, 0), "spine_01": (0, 1.05, 0), "spine_02": (0, 1.17, 0), "spine_03": (0, 1.3, 0), "neck": (0, 1.45, 0),
          "head": (0, 1.53, 0.02), "shoulder": (0.03, 1.41, 0), "arm_stretch": (0.17, 1.4, 0), "forearm_stretch": (0.44, 1.4, 0),
          "hand": (0.7, 1.4, 0), "thigh_stretch": (0.09, 0.9, 0), "leg_stretch": (0.09, 0.5, 0.01), "foot": (0.09, 0.08, 0),
          "toes_01": (0.09, 0.02, 0.12)}
    armature = bpy.data.objects.new("arp", bpy.data.armatures.new("arp"))
    bpy.context.scene.collection.objects.link(armature)
    bpy.context.view_layer.objects.active = armature
    bpy.ops.object.mode_set(mode="EDIT")
    controls = {bone: control for step in table.steps for control, bone in step}
    for bone, above in table.bones.items():
        kind, side = bone.rsplit(".", 1)
        right, up, ahead = at[kind]
        for name, parent in ((controls[bone], controls.get(above, "c_root_master.x")), (bone, above)):
            made = armature.data.edit_bones.new(name)
            made.head = (right * (-1 if side == "r" else 1), -ahead, up)
            made.tail = made.head + Vector((0, 0.02, 0.08)) * (1 if name == bone else 1.5)
            if parent is not None:
                if parent not in armature.data.edit_bones:
                    root = armature.data.edit_bones.new(parent)
                    root.head, root.tail = (0, 0, 0.95), (0, 0.3, 0.95)
                made.parent = armature.data.edit_bones[parent]
    for limb in ("hand", "foot"):
        for side in "lr":
            made = armature.data.edit_bones.new(f"c_{limb}_ik.{side}")
            made.tail = (0, 0.1, 0)
    bpy.ops.object.mode_set(mode="OBJECT")
    for bone, control in controls.items():
        copied = armature.pose.bones[bone].constraints.new("COPY_TRANSFORMS")
        copied.target, copied.subtarget = armature, control
    for limb in ("hand", "foot"):
        for side in "lr":
            armature.pose.bones[f"c_{limb}_ik.{side}"]["ik_fk_switch"] = 0.0
    return armature


def imported(name):
    if "bool" not in vars(numpy):  # Debian's importer asks its newer NumPy for a name that is gone
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
        # halfway each bone is where the engine has it
        frames = panel().rig.motion(panel().state.skeleton, panel().state.character, panel().state.shown, 24.0)
        half = heads(armature, 11 + len(frames) // 2)
        astray = max(
            (half[bone].translation - armature.matrix_world @ Vector(frames[len(frames) // 2, number, :3, 3])).length
            for number, bone in enumerate(panel().state.skeleton.bones))
        self.assertLess(astray, BOUND)
        begun = heads(armature, 11)
        # of control rigs what follows them: IK's poles and handles stay
        seen = [name for name in start if name.startswith(("DEF-", "ORG-")) or not prefix()]
        away = max((begun[name].translation - start[name].translation).length for name in seen)
        turned = max(turn(begun[name], start[name]) for name in seen)
        self.assertLess(away, BOUND)
        self.assertLess(turned, 2e-3)
        self.assertEqual(panel().logic.ends(panel().state.shown), ["right hand: " + joint[len(prefix()):]])
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

    def test_auto_rig_pros_table(self):
        def pose(armature):
            for side, sign in (("l", 1), ("r", -1)):
                arm = armature.pose.bones[f"c_arm_fk.{side}"]
                arm.rotation_mode = "XYZ"
                arm.rotation_euler = (0.2, sign * 0.9, 0)
        self.both(auto_rig_pro, pose)

    @unittest.skipUnless(SHARED, "there is no ../shared")
    def test_imported_files(self):
        for name in ("lab0_CesiumMan.glb", "KayKit_Knight.glb", "mannequiny.glb",
                     "VRM-Addon-for-Blender__armature_transform.vrm"):
            with self.subTest(name):
                self.both(lambda: imported(name))


def refused(operator, **settings):
    """The words by which an operator refuses; Blender raises what it reports as an error."""
    try:
        operator(**settings)
    except RuntimeError as wrong:
        return str(wrong)
    return ""


class Use(unittest.TestCase):
    def setUp(self):
        empty_file()

    def found(self, *ahead_across_up):
        armature = metarig()
        empty = goal(armature, "right_hand", *(ahead_across_up or (0.25, 0.12, 0.45)))
        bpy.ops.shigusa.find()
        return armature, empty

    def test_sliders_change_the_motion_and_keep_the_hand(self):
        armature, empty = self.found()
        bpy.ops.shigusa.apply(candidate=0)
        last = int(armature.animation_data.action.frame_range[1])
        before = heads(armature, last)
        sliders = bpy.context.scene.shigusa_sliders
        self.assertAlmostEqual(sliders.squat_deg, panel().state.parameters["squat_deg"]["value"], 4)
        sliders.squat_deg = 75
        after = heads(armature)
        self.assertGreater((after["spine"].translation - before["spine"].translation).length, 0.1)
        self.assertLess((after[end_bone()].translation - empty.location).length, BOUND)
        self.assertEqual(len(bpy.data.actions), 1)
        sliders.squat_deg = panel().state.parameters["squat_deg"]["value"]
        again = heads(armature)
        self.assertLess((again["spine"].translation - before["spine"].translation).length, BOUND)
        # another candidate has its own values
        bpy.ops.shigusa.apply(candidate=1)
        value = panel().state.parameters["squat_deg"]["value"]
        self.assertAlmostEqual(bpy.context.scene.shigusa_sliders.squat_deg, value, 4)

    def test_both_hands_and_a_foot(self):
        armature = metarig()
        empties = {
            effector: goal(armature, effector, *place) for effector, place in
            {"right_hand": (0.25, 0.1, 0.6), "left_hand": (0.2, -0.2, 0.5), "left_foot": (0.2, -0.1, 0.1)}.items()}
        self.assertEqual(bpy.ops.shigusa.find(), {"FINISHED"})
        bpy.ops.shigusa.apply(candidate=0)
        end = heads(armature, int(armature.animation_data.action.frame_range[1]))
        for effector, empty in empties.items():
            self.assertLess((end[end_bone(effector)].translation - empty.location).length, BOUND, effector)

    def test_a_goal_begins_where_the_hand_is(self):
        armature = metarig()
        armature.matrix_world = MOVED
        for effector, bone in (("left_hand", "f_middle.01.L"), ("right_foot", "foot.R"), ("left_foot", "foot.L")):
            bpy.ops.shigusa.goal(effector=effector)
            empty = getattr(bpy.context.scene.shigusa, effector)
            self.assertLess((empty.location - heads(armature)[bone].translation).length, BOUND, effector)

    def test_a_goal_out_of_reach_ends_near_and_says_so(self):
        armature, empty = self.found(2.0, 0.1, 0.5)
        self.assertEqual(panel().state.result.status, "unreachable")
        words = " ".join(panel().logic.remarks(panel().state.result[0]))
        self.assertIn("out of reach", panel().state.message)
        self.assertRegex(words, r"right hand ends [0-9.]+ m from its goal")
        self.assertEqual(bpy.ops.shigusa.apply(candidate=0), {"FINISHED"})
        end = heads(armature, int(armature.animation_data.action.frame_range[1]))
        off = (end[end_bone()].translation - empty.location).length
        self.assertAlmostEqual(off * 1000, panel().state.result[0].about["reached"][0]["error_mm"], delta=0.1)

    def test_the_frames_are_whole_at_the_scenes_rate(self):
        bpy.context.scene.render.fps, bpy.context.scene.render.fps_base = 30, 1.001
        armature, _ = self.found()
        bpy.ops.shigusa.apply(candidate=0)
        seconds = panel().state.shown.times[-1]
        action = armature.animation_data.action
        frames = {point.co[0] for curve in action.fcurves for point in curve.keyframe_points}
        self.assertEqual(frames, set(range(1, 2 + math.ceil(seconds * 30 / 1.001 - 1e-9))))

    def test_an_action_that_was_there_is_kept(self):
        armature = metarig()
        armature.pose.bones["spine.006"].keyframe_insert("rotation_quaternion", frame=1)
        own = armature.animation_data.action
        goal(armature, "right_hand", 0.25, 0.12, 0.45)
        bpy.ops.shigusa.find()
        bpy.ops.shigusa.apply(candidate=0)
        bpy.ops.shigusa.apply(candidate=1)
        self.assertEqual(len(bpy.data.actions), 2)
        self.assertTrue(own.use_fake_user)
        self.assertEqual({len(curve.keyframe_points) for curve in own.fcurves}, {1})

    def test_the_next_search_goes_on_from_the_present_pose(self):
        armature, empty = self.found()
        bpy.ops.shigusa.apply(candidate=0)
        last = int(armature.animation_data.action.frame_range[1])
        middle, start = heads(armature, last // 2), heads(armature, last)
        empty.location.z += 0.3
        bpy.context.view_layer.update()
        bpy.ops.shigusa.find()
        bpy.ops.shigusa.apply(candidate=0)
        begun = heads(armature, last)
        self.assertLess(max((begun[name].translation - start[name].translation).length for name in start), BOUND)
        end = heads(armature, int(armature.animation_data.action.frame_range[1]))
        self.assertLess((end[end_bone()].translation - empty.location).length, BOUND)
        # in the same Action, which still has what came before
        self.assertEqual(len(bpy.data.actions), 1)
        again = heads(armature, last // 2)
        self.assertLess(max((again[name].translation - middle[name].translation).length for name in middle), BOUND)

    def test_an_action_with_a_fake_user_is_not_written_anew(self):
        armature, _ = self.found()
        bpy.ops.shigusa.apply(candidate=0)
        kept = armature.animation_data.action
        kept.use_fake_user = True
        bpy.ops.shigusa.apply(candidate=1)
        self.assertIsNot(armature.animation_data.action, kept)
        self.assertEqual(len(bpy.data.actions), 2)

    def test_mistakes_are_told_in_words(self):
        self.assertIn("choose an armature", refused(bpy.ops.shigusa.find))
        metarig()
        self.assertIn("there is no goal", refused(bpy.ops.shigusa.find))
        self.assertEqual(len(panel().state.result), 0)
        bpy.context.object.data.pose_position = "REST"
        self.assertIn("rest position", refused(bpy.ops.shigusa.find))
        bpy.context.object.data.pose_position = "POSE"
        # a rate that the engine does not have
        goal(bpy.context.object, "right_hand", 0.2, 0.1, 0.5)
        bpy.context.scene.render.fps = 1000
        bpy.ops.shigusa.find()
        self.assertIn("240", refused(bpy.ops.shigusa.apply, candidate=0))
        # a deleted goal is none
        bpy.data.objects.remove(bpy.context.scene.shigusa.right_hand)
        self.assertIn("there is no goal", refused(bpy.ops.shigusa.find))

    def test_a_rope_is_no_person(self):
        bpy.ops.object.armature_add()
        rope = bpy.context.object
        bpy.ops.object.mode_set(mode="EDIT")
        for _ in range(12):
            bpy.ops.armature.extrude_move(TRANSFORM_OT_translate={"value": (0.1, 0, 1)})
        bpy.ops.object.mode_set(mode="OBJECT")
        bpy.context.scene.shigusa.right_hand = bpy.data.objects.new("there", None)
        bpy.context.scene.collection.objects.link(bpy.context.scene.shigusa.right_hand)
        words = refused(bpy.ops.shigusa.find)
        self.assertIn("Armature is not understood as a person: no left leg", words)
        self.assertIn("no left leg", refused(bpy.ops.shigusa.goal, effector="left_hand"))
        self.assertIsNone(rope.animation_data)

    def test_constraints_are_told(self):
        armature = metarig()
        armature.pose.bones["forearm.R"].constraints.new("COPY_ROTATION")
        goal(armature, "right_hand", 0.25, 0.12, 0.45)
        bpy.ops.shigusa.find()
        self.assertIn("forearm.R", panel().state.message)

    def test_a_cancelled_search_has_no_result(self):
        armature = metarig()
        found = panel().rig.skeleton(armature, bpy.context.evaluated_depsgraph_get())
        search = panel().logic.Search(panel().engine, found.nodes, "it", {"right_hand": [-0.3, -0.4, 0.9]}, evaluations=10_000_000)
        search.start()
        search.cancel()
        search.join(20)
        self.assertFalse(search.is_alive())
        self.assertIsNone(search.result)
        self.assertEqual(search.failure, "")

    def test_the_armature_may_be_gone(self):
        armature, _ = self.found()
        armature.data.bones["hand.L"].name = "paw"
        self.assertIn("other bones", refused(bpy.ops.shigusa.apply, candidate=0))
        bpy.data.objects.remove(armature)
        self.assertIn("is gone", refused(bpy.ops.shigusa.apply, candidate=0))

    def test_both_manifests_have_the_librarys_version(self):
        addon = sys.modules["shigusa_blender"]
        with open(os.path.join(os.path.dirname(addon.__file__), "blender_manifest.toml"), "rb") as file:
            manifest = tomllib.load(file)
        self.assertEqual(manifest["version"], panel().engine.__version__)
        self.assertEqual(".".join(map(str, addon.bl_info["version"])), manifest["version"])
        self.assertEqual(manifest["license"], ["SPDX:GPL-3.0-or-later"])

    def test_it_is_taken_off(self):
        self.found()
        bpy.ops.shigusa.apply(candidate=0)
        bpy.ops.preferences.addon_disable(module="shigusa_blender")
        self.assertFalse([name for name in dir(bpy.types.Scene) if "shigusa" in name])
        self.assertFalse([name for name in dir(bpy.types) if name.startswith("SHIGUSA")])
        bpy.ops.preferences.addon_enable(module="shigusa_blender")


if __name__ == "__main__":
    unittest.main(argv=["test_addon", *(sys.argv[sys.argv.index("--") + 1:] if "--" in sys.argv else [])])
