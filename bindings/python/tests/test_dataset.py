# SPDX-License-Identifier: MIT
"""shigusa.dataset beside what the program makes (SHIGUSA_BINARY), without the project's folder."""
import json
import os
import pathlib
import shutil
import subprocess
import tempfile
import unittest

import matplotlib
import numpy as np
import pandas

import shigusa
import shigusa.dataset
from shigusa import _dataset_export as export

matplotlib.use("agg")
SERIES = ["angles", "torques", "nodes", "positions", "centre_of_mass", "pressure", "contacts"]
BOX = {"box_m": [[-0.5, 0.1, 0.2], [0.3, 1.7, 0.6]]}
BESIDE = {"beside": {"goal": 0, "offset_m": [0.3, 0.1, 0]}}
PLAN = {
    "version": 1, "name": "Ten reaches", "licence": "CC0-1.0", "seed": 7, "tasks": 10, "shard_tasks": 4, "motions": "all",
    "series": SERIES,
    "task": {
        "character": {"choice": [
            {"source": "human", "sex": {"choice": ["female", "male"]}, "stature_m": {"percentile": [5, 95]}},
            {"source": "human", "seat_m": 0.45},
        ]},
        "goals": {"choice": [
            [{"effector": "right_hand", "position_m": BOX, "load_kg": {"uniform": [0, 6]}}],
            [{"effector": "right_hand", "position_m": BOX}, {"effector": "left_hand", "position_m": BESIDE}],
        ]},
        "candidates": 2, "evaluations": 150,
    },
}
HALF_BODY = {
    **PLAN, "tasks": 2, "shard_tasks": 2, "series": ["angles"],
    "task": {"character": {"source": "half_body"}, "goals": [{"effector": "right_hand", "position_m": BOX}],
             "candidates": 2, "evaluations": 100},
}
WORK = {
    "version": 1, "seed": 5, "tasks": 1, "series": ["angles", "nodes", "actions", "things"],
    "task": {
        "version": 2, "candidates": 1, "evaluations": 64,
        "things": {"cup": {"shape": "cylinder", "size_m": [0.08, 0.1, 0.08], "mass_kg": 0.4, "position_m": [-0.3, 1, 0.35]}},
        "actions": [{"grasp": "cup"}, {"wait_s": 0.2}, {"place": "cup", "position_m": [-0.1, 1.1, 0.4]}],
    },
}
BINARY = os.environ.get("SHIGUSA_BINARY", "")


def setUpModule():
    if os.access(BINARY, os.X_OK):
        return
    if os.environ.get("SHIGUSA_STRICT"):
        raise AssertionError(f"SHIGUSA_BINARY is {BINARY!r}, which is no program")
    raise unittest.SkipTest("SHIGUSA_BINARY names no program to make a data set by")


def made(folder, plan, merged=True):
    folder.mkdir()
    path = folder.with_suffix(".json")
    path.write_text(json.dumps(plan))
    commands = [["dataset", path, "--out", folder]] + ([["dataset", "merge", folder]] if merged else [])
    for command in commands:
        subprocess.run([BINARY, *command], check=True, capture_output=True)
    return shigusa.dataset.open(folder)


class WithData(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.work = tempfile.TemporaryDirectory()
        cls.folder = pathlib.Path(cls.work.name)
        cls.data = made(cls.folder / "data", PLAN)

    @classmethod
    def tearDownClass(cls):
        cls.work.cleanup()


class Reading(WithData):
    def test_tables_have_a_row_for_each_task_goal_and_motion(self):
        data = self.data
        self.assertEqual((data.version, data.plan["name"], data.series), (1, "Ten reaches", SERIES))
        self.assertIn("y up", data.axes)
        self.assertRegex(repr(data), r"Ten reaches: 10 tasks, \d+ motions, 3 shards")
        self.assertEqual(list(data.tasks.index), list(range(10)))
        self.assertEqual(data.tasks["motions"].sum(), len(data.motions))
        self.assertEqual(set(data.tasks["sex"]), {"female", "male"})
        self.assertTrue(data.goals.index.isin(data.tasks.index).all())
        self.assertTrue(data.motions.index.is_unique)
        self.assertEqual(len(data.missed[data.missed["error_m"] > 0.01]) > 0, (data.tasks["status"] == "unreachable").any())
        body = data[0].body
        self.assertEqual(body.units["torques"], "N m")
        self.assertEqual(body.shapes["angles"], (61, len(body.joints)))
        score = (data.penalties.notna() & (data.penalties >= 0)).any(axis=1)
        self.assertTrue(score.all())
        self.assertTrue(data.parameters.index.equals(data.motions.index))

    def test_columns_are_read_by_slices_across_shards(self):
        with self.assertRaisesRegex(shigusa.InvalidValue, "motions of 2 bodies: give one of human-"):
            self.data.column("angles")  # who sits has no feet to stand on
        data = self.data.select(body=self.data[0].body.name)
        self.assertLess(len(data), len(self.data))
        angles = data.column("angles")
        self.assertEqual(angles.shape, (len(data), 61, len(data[0].body.joints)))
        every = np.asarray(angles)
        np.testing.assert_array_equal(angles[1:5], every[1:5])
        np.testing.assert_array_equal(angles[-1], every[-1])
        np.testing.assert_array_equal(angles[np.array([4, 0, 4])], every[[4, 0, 4]])
        self.assertEqual(angles[:0].shape, (0, *every.shape[1:]))
        np.testing.assert_array_equal(angles[1:5, -1], every[1:5, -1])
        np.testing.assert_array_equal(angles[:, :, 4], every[:, :, 4])
        self.assertEqual(angles[2, 0, 4], every[2, 0, 4])
        for number, motion in enumerate(data):
            np.testing.assert_array_equal(motion.angles, every[number])
        with self.assertRaisesRegex(LookupError, "has no column 'speed'; it has .*angles"):
            data.column("speed")

    def test_a_motion_is_a_whole(self):
        motion = self.data[2]
        self.assertEqual(motion.times.shape, (61,))
        self.assertEqual(motion.times[-1], motion.duration)
        self.assertEqual(repr(self.data.motion(motion.task, motion.rank)), repr(motion))
        self.assertEqual(motion.torques.shape, motion.angles.shape)
        # the skeleton of turns and offsets is where the positions are
        turned = shigusa.dataset.forward_kinematics(
            motion["nodes"], motion["root_m"], motion["offsets_m"], motion.body.parents
        )
        np.testing.assert_allclose(turned, motion["positions"], atol=2e-6)
        goal = motion.goals[["position_m.x", "position_m.y", "position_m.z"]].to_numpy()[0]
        hand = motion.places[-1, motion.body.nodes.index("right_hand_grip")]
        self.assertAlmostEqual(np.linalg.norm(hand - goal), motion.about["error_m"], delta=0.05)

    def test_selects(self):
        data = self.data
        possible = data.select(verdict="possible")
        self.assertEqual(set(possible.motions["verdict"]), {"possible"})
        self.assertEqual(len(possible), (data.motions["verdict"] == "possible").sum())
        self.assertEqual(len(data.select(verdict="impossible")), len(data))
        parts = [data.select(split=split) for split in ("train", "validation", "test")]
        self.assertEqual(sum(len(part) for part in parts), len(data))
        self.assertEqual(sum(len(part.tasks) for part in parts), 10)
        some = data.select(tasks=range(4, 6)).select(most=2)
        self.assertEqual(list(some.tasks.index), [4, 5])
        self.assertEqual([motion.task for motion in some], [4, 4])
        self.assertEqual(list(some.splits.index), [4, 5])
        self.assertEqual(some.column("torques", some[0].body.name).shape[0], 2)
        for wrong in ({"verdict": "good"}, {"split": "tests"}, {"by": "day"}):
            with self.assertRaisesRegex(shigusa.InvalidValue, "allowed are"):
                data.select(**wrong)
        with self.assertRaisesRegex(LookupError, "no body 'horse'"):
            data.select(body="horse")

    def test_what_is_damaged_is_refused(self):
        with self.assertRaisesRegex(LookupError, "has no shards"):
            shigusa.dataset.open(self.folder)
        copy = self.folder / "damaged"
        shutil.copytree(self.folder / "data", copy)
        shard = copy / "shard-000001.h5"
        whole = shard.read_bytes()
        shard.write_bytes(whole[:100])
        with self.assertRaisesRegex(shigusa.InvalidValue, "shard-000001.h5 is no shard of version 1"):
            shigusa.dataset.open(copy)
        shard.write_bytes(whole[:9000])
        with self.assertRaisesRegex(shigusa.InvalidValue, "shard-000001.h5 is damaged"):
            len(shigusa.dataset.open(copy))
        shard.write_bytes(whole.replace(self.data.digest.encode(), b"0" * 64))
        with self.assertRaisesRegex(shigusa.InvalidValue, "of different plans"):
            shigusa.dataset.open(copy)
        shard.unlink()
        with self.assertRaisesRegex(shigusa.InvalidValue, "merge them again"):
            shigusa.dataset.open(copy).select(split="train")

    def test_plots(self):
        data = self.data
        self.assertEqual(data.plot().shape, (2, 3))
        ax = matplotlib.pyplot.subplots()[1]
        self.assertIs(data.plot_goals(ax, "above"), ax)
        self.assertIn("ahead", ax.get_ylabel())
        self.assertEqual(len(data.plot_people().collections), 2)
        counts = [int(text.get_text().split(" of ")[1]) for text in data.plot_styles().texts]
        self.assertEqual(sum(counts), data.tasks["status"].isin(["reached", "unsteady"]).sum())
        self.assertIn("median", data.plot_scores().get_legend().get_texts()[0].get_text())
        self.assertEqual(sum(bool(ax.lines) for ax in data.plot_motions(5).flat), 5)
        self.assertGreater(len(data[0].plot().lines), 60)
        empty = data.select(most=0)
        for plot in (empty.plot, empty.plot_scores, empty.plot_motions):
            plot()
        with self.assertRaisesRegex(shigusa.InvalidValue, "allowed are front, side, above"):
            data.plot_goals(view="back")
        matplotlib.pyplot.close("all")


class Exports(WithData):
    def test_npz_is_the_motion_on_its_own_skeleton(self):
        out = self.folder / "npz"
        self.assertEqual(self.data.to_npz(out), len(self.data))
        for motion in self.data:
            with np.load(out / f"motions/0000/{motion.id}.npz") as made:
                frames = int(np.ceil(motion.duration * 60.0 - 1e-6)) + 1
                self.assertEqual(made["poses"].shape, (frames, 3 * len(motion.body.nodes)))
                self.assertEqual(made["mocap_framerate"], 60.0)
                self.assertEqual(str(made["gender"]), motion.person["sex"])
                vectors = made["poses"].astype(float).reshape(frames, -1, 3)
                angle = np.linalg.norm(vectors, axis=-1, keepdims=True)
                self.assertLessEqual(angle.max(), np.pi + 1e-6)
                turns = np.concatenate([np.sinc(angle / (2 * np.pi)) * vectors / 2, np.cos(angle / 2)], axis=-1)
                places = shigusa.dataset.forward_kinematics(turns, made["trans"], made["offsets"], made["parents"])
                for frame, stored in ((0, 0), (-1, -1)):
                    np.testing.assert_allclose(places[frame], motion["positions"][stored], atol=1e-5)
                self.assertEqual(list(made["goal_effectors"]), list(motion.goals["effector"]))
        again = self.folder / "again"
        self.data.to_npz(again)
        for path in out.rglob("*.*"):
            if path.is_file():
                self.assertEqual(path.read_bytes(), (again / path.relative_to(out)).read_bytes(), path)
        with self.assertRaisesRegex(shigusa.InvalidValue, "not empty"):
            self.data.to_npz(out)
        with self.assertRaisesRegex(shigusa.InvalidValue, "allowed are 1 to 240"):
            self.data.to_npz(self.folder / "fast", fps=1000)
        self.assertFalse((self.folder / "fast").exists())

    def test_humanml3d_has_its_joints_frames_and_sentences(self):
        out = self.folder / "humanml3d"
        self.assertEqual(self.data.to_humanml3d(out, least_frames=30), len(self.data))
        for motion in self.data:
            joints = np.load(out / f"new_joints/{motion.id}.npy")
            frames = int(np.ceil(motion.duration * 20.0 - 1e-6)) + 1
            self.assertEqual((joints.shape, joints.dtype), ((max(30, frames), 22, 3), np.dtype("f4")))
            knee = motion["positions"][:, motion.body.nodes.index("left_lower_leg")]
            np.testing.assert_array_equal(joints[0, 4], knee[0])
            np.testing.assert_array_equal(joints[-1, 4], knee[-1])
            # a frame of 20 Hz lies between stored ones, a fortieth of a second at most apart
            seconds = np.arange(frames)[:-1] / 20.0
            between = np.stack([np.interp(seconds, motion.times, axis) for axis in knee.T], axis=1)
            np.testing.assert_allclose(joints[: frames - 1, 4], between, atol=2e-3)
            text = (out / f"texts/{motion.id}.txt").read_text()
            self.assertRegex(text, r"^a (seated )?person .*#a/DET (seated/ADJ )?person/NOUN .*#0\.0#0\.0\n$")
        named = [line for part in ("train", "val", "test") for line in (out / f"{part}.txt").read_text().split()]
        self.assertEqual(sorted(named), [motion.id for motion in self.data])
        self.assertIn(f"fewer than 40 frames, {len(self.data)} of these", (out / "README.md").read_text())

    def test_frames_at_a_rate_lie_on_a_curve_through_the_stored_ones(self):
        times = np.linspace(0.0, 1.23, 61)[:, None]
        made = export.resampled(times**2, 1.23, 24.0)
        wanted = (np.arange(31)[:, None] / 24.0) ** 2
        # a parabola between neighbours, but for the first and the last interval; the end is the motion's own
        np.testing.assert_allclose(made[1:-2], wanted[1:-2], atol=1e-12)
        self.assertEqual((len(made), made[0, 0], made[-1, 0]), (31, 0.0, 1.23**2))

    def test_csv_has_all_numbers(self):
        out = self.folder / "csv"
        self.data.to_csv(out, series=True)
        table = pandas.read_csv(out / "index.csv", float_precision="round_trip").set_index(["task", "rank"])
        pandas.testing.assert_series_equal(table["score"], self.data.motions["score"], check_exact=True)
        bow = self.data.parameters.columns[0]
        np.testing.assert_array_equal(table[f"parameters.{bow}"], self.data.parameters[bow])
        two = self.data.goals.groupby(level=0).size()
        self.assertEqual(set(table["goal2.effector"].dropna()), {"left_hand"} if (two == 2).any() else set())
        self.assertEqual(set(table["split"]), set(self.data.splits["by_person"]))
        first = pandas.read_csv(out / table["file"].iloc[0])
        self.assertEqual(len(first), 61)
        name = self.data[0].body.joints[4]
        np.testing.assert_allclose(first[f"{name} [rad]"], self.data[0].angles[:, 4], rtol=1e-6)
        feet = [(motion.id, foot) for motion in self.data for foot in motion.body.names["feet"]]
        standing = pandas.read_csv(out / f"motions/0000/{feet[0][0]}.csv")
        self.assertLessEqual(set(standing[f"{feet[0][1]} stands on"]), {"air", "sole", "forefoot"})

    def test_captions_tell_of_hands_that_are_near_each_other_as_one(self):
        def verbs(*goals, missed=False):
            rows = [(hand, *place, load) for hand, place, load in goals]
            names = ["effector", "position_m.x", "position_m.y", "position_m.z", "load_kg"]
            return export.goal_verbs(pandas.DataFrame(rows, columns=names), 1.7, missed)

        self.assertEqual(
            verbs(("right_hand", (-0.27, 0.6, 0.5), 2), ("left_hand", (0.27, 0.8, 0.5), 3)),
            ["reaches down in front with both hands, holding 5 kg"],
        )
        self.assertEqual(
            verbs(("right_hand", (-0.4, 1.7, 0.5), 2), ("left_hand", (0.4, 0.1, -0.5), 0)),
            ["reaches up in front to the right with the right hand, holding 2 kg",
             "reaches down to the floor behind to the left with the left hand"],
        )
        self.assertEqual(
            verbs(("left_foot", (0.2, 0.1, 0), 0), ("right_hand", (0, 1.2, 0.1), 0), missed=True),
            ["moves the left foot down to the floor to the left", "reaches out with the right hand"],
        )
        self.assertEqual(export._posture_verbs(["stoop", "straight knees"]), ["bends down with straight knees"])
        self.assertEqual(
            export.tokens("a person squats, turns left and reaches up with both hands, holding 5 kg"),
            "a/DET person/NOUN squat/VERB turn/VERB left/ADJ and/CCONJ reach/VERB up/ADV with/ADP both/DET hand/NOUN "
            "hold/VERB kg/NOUN",
        )

    def test_without_the_series_or_the_index_a_sentence_tells_what_to_do(self):
        bare = made(self.folder / "bare", HALF_BODY, merged=False)
        with self.assertRaisesRegex(NotImplementedError, "keeps no nodes: make the plan again"):
            bare.to_npz(self.folder / "none")
        with self.assertRaisesRegex(LookupError, "dataset merge"):
            bare.to_humanml3d(self.folder / "none")
        self.assertEqual(bare.to_csv(self.folder / "bare_csv"), len(bare))
        self.assertNotIn("split", pandas.read_csv(self.folder / "bare_csv/index.csv"))
        half = {**HALF_BODY, "series": ["positions"]}
        with self.assertRaisesRegex(NotImplementedError, "two arms and two legs"):
            made(self.folder / "half", half).to_humanml3d(self.folder / "none")
        self.assertFalse((self.folder / "none").exists())

    def test_a_piece_of_work_has_its_actions_and_things(self):
        data = made(self.folder / "work", WORK)
        motion = data[0]
        self.assertEqual(motion.body.names["actions"], ["1 grasp cup", "2 wait_s", "3 place cup"])
        self.assertEqual(motion["things"].shape, (241, 1, 7))
        np.testing.assert_allclose(motion["things"][-1, 0, :3], [-0.1, 1.1, 0.4], atol=1e-3)
        self.assertEqual(data.to_npz(self.folder / "work_npz"), 1)
        self.assertEqual(data.to_csv(self.folder / "work_csv", series=True), 1)
        motion.plot()


if __name__ == "__main__":
    unittest.main()
