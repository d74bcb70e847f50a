# SPDX-License-Identifier: MIT
"""The package as it is installed, without the project's folder."""
import base64
import html.parser
import json
import math
import pathlib
import signal
import tempfile
import threading
import unittest

import numpy as np

import shigusa

GOAL = {"right_hand": (-0.2, 0.6, 0.45)}
CUP = {"cup": {"shape": "cylinder", "size_m": [0.08, 0.1, 0.08], "mass_kg": 0.3, "position_m": [-0.2, 0.9, 0.4]}}
# a box of 8 points, packed by Draco
BOX = base64.b64decode(
    "RFJBQ08CAgEAAAAMCAEAAQIAAgMEBQYEBgcAAwUABQQBBwYBBgIABAcABwEDAgYDBgUBAwAJAwAABAIEAAEECQQAAgABAJqZmb4AAAAAzcxM"
    "vpqZmb6amdk/zcxMvpqZmT6amdk/zcxMvpqZmT4AAAAAzcxMvpqZmb4AAAAAmpmZPpqZmT4AAAAAmpmZPpqZmT6amdk/mpmZPpqZmb6amdk/"
    "mpmZPgABAQEBAQFAAQAAAAAAAAAAAAAAgD8AAAAAAAAAAAAAAAAAAIA/AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAAAAAA"
    "AAAAAAAAAIA/AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAAAAAAAAAAAAAAAIA/AAAAAAAAAAAAAAAA"
)


class Frame(html.parser.HTMLParser):
    """The page within an iframe, as a browser finds it."""

    def __init__(self, text):
        super().__init__()
        self.tags = []
        self.feed(text)
        (attributes,) = self.tags
        self.page, self.sandbox = attributes["srcdoc"], attributes["sandbox"]

    def handle_starttag(self, tag, attributes):
        self.tags.append(dict(attributes))


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
            for ending in ("bvh", "csv", "npz", "svg", "glb", "html"):
                path = pathlib.Path(folder) / f"reach.{ending}"
                self.result[0].save(path)
                self.assertGreater(path.stat().st_size, 1000)
            scored = shigusa.score(pathlib.Path(folder) / "reach.bvh", cost=True)
            self.assertIn("cost", scored)
            self.result.save(pathlib.Path(folder) / "all.glb")
        with self.assertRaisesRegex(shigusa.Failure, "png"):
            self.result[0].export("png")

    def test_takes_arrays_and_tells_what_it_is(self):
        best = shigusa.reach("human", {"right_hand": np.array(GOAL["right_hand"])}, seed=np.int64(3))[0]
        np.testing.assert_array_equal(best.angles, self.result[0].angles)
        self.assertEqual(repr(shigusa.Character("human")), "<shigusa.Character human: 45 degrees of freedom>")
        self.assertRegex(repr(self.result), "<shigusa.Result reached, . candidates>")
        self.assertRegex(repr(best), r"<shigusa.Candidate possible, score 0\.\d+, 0\.\d+ s>")

    def test_notebooks_show_moving_figures(self):
        self.assertEqual(self.result[1].export("html").count(b"<canvas"), 1)
        self.assertEqual(self.result.export("html").count(b"<canvas"), len(self.result))
        for shown, figures in ((self.result, len(self.result)), (self.result[0], 1)):
            frame = Frame(shown._repr_html_())
            self.assertEqual(frame.page.count("<canvas"), figures)
            self.assertTrue(frame.page.endswith(shown.export("html").decode().partition("</head>")[2]))
            self.assertEqual(frame.sandbox, "allow-scripts")

    def test_frame(self):
        frame = self.result[0].to_frame(fps=30)
        np.testing.assert_array_equal(frame["angles"].to_numpy()[-1], self.result[0].angles[-1])

    def test_given_angles(self):
        known = shigusa.motion("human", self.result[0].angles, 1.0 / self.result[0].times[1])
        self.assertEqual(known.verdict, "possible")
        with self.assertRaises(ValueError):
            shigusa.motion("human", np.zeros(3))


class Costs(unittest.TestCase):
    def test_of_candidates_and_frames(self):
        result = shigusa.reach(goals=GOAL, seed=3, cost=True)
        rows = result.costs()
        self.assertEqual(list(rows.index), list(range(1, len(result) + 1)))
        self.assertEqual(rows["reba"][1], result[0].cost["reba"]["worst"])
        frame = result[0].cost_frame()
        np.testing.assert_allclose(frame.index, result[0].times)
        sides = frame[["reba.left", "reba.right"]].max(axis=1)
        self.assertEqual(sides.max(), rows["reba"][1])
        self.assertAlmostEqual(np.trapz(sides, frame.index) / frame.index[-1], rows["reba_mean"][1])
        self.assertAlmostEqual(frame["l5s1.compression [N]"].max(), rows["compression_n"][1])
        self.assertTrue(math.isnan(rows["lifting_index"][1]))
        own = shigusa.motion("human", result[0].angles, 1.0 / result[0].times[1], {"cost": True})
        np.testing.assert_allclose(own.cost_frame()["l5s1.moment [N m]"], frame["l5s1.moment [N m]"], rtol=0.05)

    def test_of_a_lift(self):
        work = shigusa.reach(actions=[{"grasp": "cup"}, {"place": "cup", "position_m": [-0.3, 1.2, 0.4]}], things=CUP)
        index = work.costs()["lifting_index"][1]
        self.assertEqual(index, work[0].cost["niosh"][0]["lifting_index"])
        self.assertGreater(index, 0.0)

    def test_are_of_tasks_that_ask_for_them(self):
        best = shigusa.reach(goals=GOAL, seed=3)[0]
        for of in (lambda: best.cost, best.cost_frame):
            with self.assertRaisesRegex(LookupError, "cost=True"):
                of()


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


def skinned(packed):
    """A glTF file of a person whose mesh, a box at the hips, Draco packed."""
    nodes = shigusa.Character("human").about["nodes"]
    told = [{"name": node["name"], "translation": node["offset"], "rotation": node["rotation"]} for node in nodes]
    for number, node in enumerate(nodes):
        if node["parent"] >= 0:
            told[node["parent"]].setdefault("children", []).append(number)
    columns = {"POSITION": ("VEC3", 5126), "JOINTS_0": ("VEC4", 5121), "WEIGHTS_0": ("VEC4", 5126)}
    draco = {"bufferView": 0, "attributes": {name: number for number, name in enumerate(columns)}}
    primitive = {
        "attributes": draco["attributes"], "indices": 3, "extensions": {"KHR_draco_mesh_compression": draco},
    }
    accessors = [{"count": 8, "type": kind, "componentType": number} for kind, number in columns.values()]
    file = {
        "asset": {"version": "2.0"}, "nodes": told + [{"mesh": 0, "skin": 0}], "skins": [{"joints": [*range(len(told))]}],
        "meshes": [{"primitives": [primitive]}], "bufferViews": [{"buffer": 0, "byteLength": len(packed)}],
        "accessors": accessors + [{"count": 36, "type": "SCALAR", "componentType": 5125}],
        "buffers": [{"uri": "data:;base64," + base64.b64encode(packed).decode(), "byteLength": len(packed)}],
    }
    return json.dumps(file)


class PackedMeshes(unittest.TestCase):
    def test_draco_is_read(self):
        doubts = []
        for packed in (BOX, BOX[:40] + bytes(len(BOX) - 40)):
            with tempfile.TemporaryDirectory() as folder:
                path = pathlib.Path(folder) / "person.gltf"
                path.write_text(skinned(packed))
                doubts.append(" ".join(shigusa.Character(path).about["doubts"]))
        self.assertNotIn("mesh", doubts[0])
        self.assertIn("Draco's attribute 0", doubts[1])


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


class Criteria(unittest.TestCase):
    def setUp(self):
        self.human = shigusa.Character("human")
        self.knees = [self.human.joint_names.index(f"{side}_knee.flexion") for side in ("left", "right")]

    def bent(self, angles):
        return angles[..., self.knees].max(axis=(-2, -1))

    def test_own_ones_change_what_is_chosen(self):
        shapes = set()

        def knees(motions):
            shapes.add(motions.angles.shape[1:])
            self.assertEqual(motions.torques.shape, motions.angles.shape)
            self.assertEqual(motions.centre_of_mass.shape, motions.angles.shape[:2] + (3,))
            self.assertEqual(motions.effectors.shape, motions.angles.shape[:2] + (1, 3))
            self.assertGreater(motions.frame_time, 0)
            return self.bent(motions.angles)

        low = {"right_hand": (-0.2, 0.3, 0.45)}
        without = shigusa.reach(self.human, low, seed=3)
        own = shigusa.Criterion("sore_knees", knees, weight=3.0, scale=math.pi / 2)
        result = shigusa.reach(self.human, low, seed=3, own_criteria=[own])
        self.assertLess(self.bent(result[0].angles), 0.7 * self.bent(without[0].angles))
        told = result[0].about["criteria"]["sore_knees"]
        self.assertAlmostEqual(told, min(self.bent(result[0].angles) / (math.pi / 2), 1.0), places=6)
        self.assertEqual(shapes, {result[0].angles.shape})
        self.assertGreater(len(result[0].edit(squat_deg=30).angles), 0)

    def test_what_they_raise_is_raised(self):
        for values, error in [
            (lambda motions: motions.nothing, AttributeError), (lambda motions: [1.0], shigusa.InvalidValue),
            (lambda motions: "many", ValueError),
        ]:
            with self.subTest(error=error), self.assertRaises(error):
                shigusa.reach(self.human, GOAL, evaluations=200, own_criteria=[shigusa.Criterion("own", values)])
        with self.assertRaises(shigusa.InvalidValue):
            shigusa.reach(self.human, GOAL, own_criteria=[shigusa.Criterion("low_back", lambda motions: [])])

    def test_ctrl_c_within_one_ends_the_search(self):
        before = signal.signal(signal.SIGINT, signal.default_int_handler)
        self.addCleanup(signal.signal, signal.SIGINT, before)

        def interrupted(motions):
            signal.raise_signal(signal.SIGINT)
            return np.zeros(len(motions.angles))

        with self.assertRaises(KeyboardInterrupt):
            shigusa.reach(self.human, GOAL, own_criteria=[shigusa.Criterion("own", interrupted)])


class NodesOfHosts(unittest.TestCase):
    def test_are_a_person_who_starts_from_their_pose(self):
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder, "person.glb")
            shigusa.reach(goals=GOAL, evaluations=200)[0].save(path)
            described = shigusa.Character(path).about["nodes"]
        nodes = []
        for node in described:
            rest = node.get("rest", node)
            nodes.append({"name": node["name"], "parent": node["parent"], "translation": rest["offset"],
                          "rotation": rest["rotation"], "scale": rest.get("scale", [1, 1, 1])})
        rig = shigusa.Character.of_nodes(nodes, "rig")
        first = shigusa.reach(rig, GOAL, seed=3)[0]
        told = first.nodes_at(None, "file")
        for node, about in enumerate(rig.about["nodes"]):
            if about["file_node"] < len(nodes):
                nodes[about["file_node"]]["pose"] = {"translation": told.translations[-1, node],
                                                     "rotation": told.rotations[-1, node]}
        posed = shigusa.reach(shigusa.Character.of_nodes(nodes, "rig"), {"right_hand": (-0.2, 1.2, 0.4)}, seed=3)[0]
        again = posed.nodes_at(None, "file")
        np.testing.assert_allclose(again.rotations[0], told.rotations[-1], atol=2e-3)
        with self.assertRaisesRegex(shigusa.InvalidValue, "ring"):
            shigusa.Character.of_nodes([{"name": "a", "parent": 1}, {"name": "b", "parent": 0}])


if __name__ == "__main__":
    unittest.main()
