# SPDX-License-Identifier: MIT
"""The package as it is installed, without the project's folder."""
import pathlib
import signal
import tempfile
import threading
import unittest

import numpy as np

import shigusa

GOAL = {"right_hand": (-0.2, 0.6, 0.45)}
CUP = {"cup": {"shape": "cylinder", "size_m": [0.08, 0.1, 0.08], "mass_kg": 0.3, "position_m": [-0.2, 0.9, 0.4]}}


class Reach(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.result = shigusa.reach("human", goals=GOAL, seed=3)

    def test_is_a_sequence_of_candidates(self):
        self.assertEqual(self.result.status, "reached")
        self.assertGreater(len(self.result), 1)
        scores = [candidate.score for candidate in self.result]
        self.assertEqual(scores, sorted(scores))
        self.assertEqual(self.result[0].verdict, "possible")
        self.assertEqual(len(self.result[1:]), len(self.result) - 1)
        with self.assertRaises(IndexError):
            self.result[99]

    def test_series_are_tables_of_float64(self):
        best = self.result[0]
        frames = len(best.times)
        self.assertEqual(best.angles.shape, (frames, len(best.joint_names)))
        self.assertEqual(best.angles.dtype, np.float64)
        self.assertEqual(best.torques.shape, best.angles.shape)
        self.assertEqual(best.centre_of_mass.shape, (frames, 3))
        hand, about = best.table("effectors")
        self.assertEqual(about["names"], ["right_hand"])
        np.testing.assert_allclose(hand[-1, 0], GOAL["right_hand"], atol=1e-5)
        whole, _ = best.table("angles", fps=24)
        self.assertLess(len(whole), frames)
        np.testing.assert_array_equal(whole[-1], best.angles[-1])
        nodes = best.nodes
        np.testing.assert_allclose(np.linalg.norm(nodes.rotations, axis=2), 1.0, atol=1e-12)
        self.assertEqual(nodes.translations.shape, (frames, len(nodes.names), 3))

    def test_arrays_outlive_their_result(self):
        angles = shigusa.reach(goals=GOAL, seed=3)[0].angles
        np.testing.assert_array_equal(angles, self.result[0].angles)
        with self.assertRaises(ValueError):
            angles[0, 0] = 1.0

    def test_same_numbers_on_any_number_of_threads(self):
        one = shigusa.reach(goals=GOAL, seed=3, threads=1)
        four = shigusa.reach(goals=GOAL, seed=3, threads=4)
        for a, b, c in zip(one, four, self.result):
            np.testing.assert_array_equal(a.angles, b.angles)
            np.testing.assert_array_equal(a.angles, c.angles)

    def test_edits_and_restores(self):
        edited = self.result[0].edit(squat_deg=80)
        self.assertEqual(edited.parameters()["squat_deg"]["value"], 80.0)
        self.assertGreater(np.abs(edited.angles - self.result[0].angles).max(), 0.1)
        again = shigusa.Result.restore(self.result.summary)
        np.testing.assert_array_equal(again[0].angles, self.result[0].angles)

    def test_files(self):
        with tempfile.TemporaryDirectory() as folder:
            for ending in ("bvh", "csv", "npz", "svg", "glb"):
                path = pathlib.Path(folder) / f"reach.{ending}"
                self.result[0].save(path)
                self.assertGreater(path.stat().st_size, 1000)
            scored = shigusa.score(pathlib.Path(folder) / "reach.bvh", cost=True)
            self.assertIn("cost", scored)
        self.assertIn("<svg", self.result[0]._repr_html_())
        with self.assertRaisesRegex(shigusa.Failure, "png"):
            self.result[0].export("png")

    def test_takes_arrays_and_tells_what_it_is(self):
        best = shigusa.reach("human", {"right_hand": np.array(GOAL["right_hand"])}, seed=np.int64(3))[0]
        np.testing.assert_array_equal(best.angles, self.result[0].angles)
        self.assertEqual(repr(shigusa.Character("human")), "<shigusa.Character human: 45 degrees of freedom>")
        self.assertRegex(repr(self.result), "<shigusa.Result reached, . candidates>")
        self.assertRegex(repr(best), r"<shigusa.Candidate possible, score 0\.\d+, 0\.\d+ s>")

    def test_frame(self):
        frame = self.result[0].to_frame(fps=30)
        np.testing.assert_array_equal(frame["angles"].to_numpy()[-1], self.result[0].angles[-1])

    def test_given_angles(self):
        known = shigusa.motion("human", self.result[0].angles, 1.0 / self.result[0].times[1])
        self.assertEqual(known.verdict, "possible")
        with self.assertRaises(ValueError):
            shigusa.motion("human", np.zeros(3))


class Work(unittest.TestCase):
    def test_actions_and_things(self):
        made = shigusa.reach(actions=[{"grasp": "cup"}, {"place": "cup", "position_m": [-0.3, 1.2, 0.4]}], things=CUP)
        self.assertEqual(made.status, "reached")
        cup, about = made[0].table("things")
        self.assertEqual(about["names"], ["cup"])
        np.testing.assert_allclose(cup[-1, 0, :3], [-0.3, 1.2, 0.4], atol=1e-3)
        self.assertIn("squat_deg", made[0].parameters(action=2))
        self.assertEqual(len(made[0].edit(action=2).about["actions"]), 2)

    def test_many_tasks_in_one_call(self):
        made = shigusa.reach_all("human", [{"goals": GOAL}, {"goals": {"tail": (0, 0, 0)}}, {"goals": GOAL, "seed": 3}])
        self.assertEqual([type(one).__name__ for one in made], ["Result", "Failure", "Result"])
        np.testing.assert_array_equal(made[2][0].angles, shigusa.reach(goals=GOAL, seed=3)[0].angles)


class Failures(unittest.TestCase):
    def test_are_exceptions_with_the_librarys_sentence(self):
        with self.assertRaisesRegex(LookupError, "did you mean 'right_hand'"):
            shigusa.reach(goals={"right_hnd": (0, 1, 0.4)})
        for place in ("up", (0.1, 1.0), (0.1, 1.0, float("nan")), (0.1, 1.0, {1})):
            with self.assertRaisesRegex(shigusa.InvalidValue, "three numbers|finite|no number"):
                shigusa.reach(goals={"right_hand": place})
        with self.assertRaisesRegex(ValueError, "stature"):
            shigusa.Character("human", stature_m=170)
        with self.assertRaises(FileNotFoundError):
            shigusa.Character("nobody.vrm")
        with self.assertRaisesRegex(LookupError, "there is no series"):
            shigusa.reach(goals=GOAL)[0].table("speed")

    def test_progress_ends_a_search(self):
        def stop(*_):
            raise RuntimeError("enough")

        with self.assertRaisesRegex(RuntimeError, "enough"):
            shigusa.reach(goals=GOAL, evaluations=30000, progress=stop)
        seen = []
        made = shigusa.reach(goals=GOAL, evaluations=30000, progress=lambda *told: seen.append(told) or False)
        self.assertEqual(len(seen), 1)
        self.assertGreater(len(made), 0)

    def test_ctrl_c_ends_a_search(self):
        # a shell's background jobs begin with it ignored
        before = signal.signal(signal.SIGINT, signal.default_int_handler)
        self.addCleanup(signal.signal, signal.SIGINT, before)
        timer = threading.Timer(0.2, lambda: signal.raise_signal(signal.SIGINT))
        timer.start()
        with self.assertRaises(KeyboardInterrupt):
            shigusa.reach(goals=GOAL, evaluations=1000000)
        timer.join()

    def test_other_threads_go_on(self):
        ticks = 0
        done = threading.Event()

        def search():
            shigusa.reach(goals=GOAL, evaluations=20000)
            done.set()

        thread = threading.Thread(target=search)
        thread.start()
        while not done.wait(0.001):
            ticks += 1
        thread.join()
        self.assertGreater(ticks, 20)


if __name__ == "__main__":
    unittest.main()
