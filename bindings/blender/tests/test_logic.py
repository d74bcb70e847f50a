# SPDX-License-Identifier: GPL-3.0-or-later
"""Of the add-on, what needs no Blender. SHIGUSA_LIBRARY names the C library."""
import pathlib
import sys
import unittest

import numpy as np

HERE = pathlib.Path(__file__).resolve().parent
sys.path[:0] = [str(HERE.parent), str(HERE.parents[1] / "python")]
import logic  # noqa: E402
import shigusa  # noqa: E402

ARP = {"root.x", "c_root_master.x", "c_hand_fk.l", *logic.AUTO_RIG_PRO.bones} | {
    control for step in logic.AUTO_RIG_PRO.steps for control, _ in step}


class Logic(unittest.TestCase):
    def test_control_rigs_are_known_by_their_bones(self):
        self.assertIsNone(logic.control_rig({"hips", "spine", "hand.L"}))
        self.assertEqual(logic.control_rig(ARP).name, "Auto-Rig Pro")
        # of a rig without a third spine bone the neck hangs on the second
        some = logic.control_rig(ARP - {"spine_03.x", "c_spine_03.x"})
        self.assertEqual(some.bones["neck.x"], "spine_02.x")
        self.assertNotIn("c_spine_03.x", [control for step in some.steps for control, _ in step])

    def test_tables_name_only_measured_bones_and_no_control_twice(self):
        for rig in (logic.RIGIFY, logic.AUTO_RIG_PRO):
            pairs = [pair for step in rig.steps for pair in step]
            self.assertLessEqual({bone for _, bone in pairs}, set(rig.bones))
            self.assertEqual(len({control for control, _ in pairs}), len(pairs))
            seen = set()
            for bone, above in rig.bones.items():  # those above come first
                self.assertTrue(above is None or above in seen, bone)
                seen.add(bone)

    def test_auto_rig_pro_is_a_person(self):
        """Its table, with joints of a person."""
        height = {"root": 0.95, "spine_01": 1.05, "spine_02": 1.17, "spine_03": 1.3, "neck": 1.45, "head": 1.53, "shoulder": 1.41,
                  "arm_stretch": 1.4, "forearm_stretch": 1.4, "hand": 1.4, "thigh_stretch": 0.9, "leg_stretch": 0.5,
                  "foot": 0.08, "toes_01": 0.02}
        aside = {"shoulder": 0.03, "arm_stretch": 0.17, "forearm_stretch": 0.44, "hand": 0.7, "thigh_stretch": 0.09,
                 "leg_stretch": 0.09, "foot": 0.09, "toes_01": 0.09}
        at, nodes = {}, [{"name": "rig", "parent": -1}]
        for bone, above in logic.AUTO_RIG_PRO.bones.items():
            kind, side = bone.rsplit(".", 1)
            ahead = {"toes_01": 0.12}.get(kind, 0.0)
            at[bone] = np.array([aside.get(kind, 0.0) * (-1 if side == "r" else 1), -ahead, height[kind]])
            parent = list(logic.AUTO_RIG_PRO.bones).index(above) + 1 if above else 0
            nodes.append({"name": bone, "parent": parent, "translation": list(at[bone] - at.get(above, 0))})
        about = shigusa.Character.of_nodes(nodes, "arp").about
        for bone, name in (("left_hand", "hand.l"), ("right_upper_leg", "thigh_stretch.r"), ("hips", "root.x"), ("head", "head.x")):
            self.assertEqual(about["humanoid"][bone], name)

    def test_places_come_back(self):
        placement = {"unit_m": 0.01, "origin": [3, 4, 5], "left": [1, 0, 0], "up": [0, 0, 1], "ahead": [0, -1, 0]}
        place = logic.to_engine(placement, [3, 104, 25])
        np.testing.assert_allclose(place, [0, 0.2, -1])
        np.testing.assert_allclose(logic.to_host(placement, place), [3, 104, 25])

    def test_nodes_chain_to_the_armature(self):
        half = np.sqrt(0.5)
        about = [{"file_node": 0}, {"file_node": 2, "scale": [1, 1, 1]}, {"file_node": 1}]
        translations = np.array([[[9, 9, 9], [0, 2, 0], [0, 0, 1]]], float)
        rotations = np.array([[[0, 0, 0, 1], [0, 0, 0, 1], [half, 0, 0, half]]], float)  # the upper one turned about x
        frames = logic.in_armature([-1, 0], about, translations, rotations)
        np.testing.assert_allclose(frames[0, 0, :3, 3], [0, 0, 1])
        np.testing.assert_allclose(frames[0, 1, :3, 3], [0, 0, 3], atol=1e-12)

    def test_pictures_show_both_figures(self):
        drawn = logic.picture(np.array([[0, 0], [0, 1.0]]), np.array([[0, 0], [1.0, 0.5]]), [(0, 1)], 128)
        self.assertEqual(drawn.shape, (128, 128, 4))
        colours = {tuple(np.round(colour[:3], 2)) for row in drawn for colour in row if colour[3] == 1}
        self.assertIn((0.5, 0.5, 0.5), colours)
        self.assertIn((1.0, 0.62, 0.2), colours)
        self.assertEqual(drawn[0, 0, 3], 0)


if __name__ == "__main__":
    unittest.main()
