# SPDX-License-Identifier: MIT
"""Motions of a data set as files for other programs."""

from __future__ import annotations

import contextlib
import math
import os
import pathlib
import re
import shutil
import tempfile
import warnings
from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

import numpy as np

from ._library import InvalidValue, Unsupported
from .dataset import SPLITS, Array, Dataset, Motion

if TYPE_CHECKING:
    import pandas  # type: ignore[import]

_WHOLE = 1e-6  # rounding of a whole number of frames
_HUMANML3D_HZ = 20.0
_HUMANML3D_READ = 40  # frames: its usual readers leave out shorter motions
# HumanML3D's joints, the first 22 of SMPL: the node, or where a body has none, a share of the way between two others.
_JOINTS: dict[str, tuple[str, str, str, float]] = {
    "pelvis": ("hips", "", "", 0.0),
    "left_hip": ("left_upper_leg", "", "", 0.0),
    "right_hip": ("right_upper_leg", "", "", 0.0),
    "spine1": ("spine", "hips", "neck", 0.17),
    "left_knee": ("left_lower_leg", "", "", 0.0),
    "right_knee": ("right_lower_leg", "", "", 0.0),
    "spine2": ("chest", "hips", "neck", 0.47),
    "left_ankle": ("left_foot", "", "", 0.0),
    "right_ankle": ("right_foot", "", "", 0.0),
    "spine3": ("upper_chest", "hips", "neck", 0.72),
    "left_foot": ("left_toes", "", "", 0.0),
    "right_foot": ("right_toes", "", "", 0.0),
    "neck": ("neck", "", "", 0.0),
    "left_collar": ("left_shoulder", "neck", "left_upper_arm", 0.11),
    "right_collar": ("right_shoulder", "neck", "right_upper_arm", 0.11),
    "head": ("head", "", "", 0.0),
    "left_shoulder": ("left_upper_arm", "", "", 0.0),
    "right_shoulder": ("right_upper_arm", "", "", 0.0),
    "left_elbow": ("left_lower_arm", "", "", 0.0),
    "right_elbow": ("right_lower_arm", "", "", 0.0),
    "left_wrist": ("left_hand", "", "", 0.0),
    "right_wrist": ("right_hand", "", "", 0.0),
}
_TASK_COLUMNS = ["person", "character", "preset", "sex", "stature_m", "mass_kg", "seat_m", "status"]
_LISTS = {
    "penalties": "criteria", "parameters": "parameters", "action_start_s": "actions", "action_end_s": "actions",
    "action_verdict": "actions", "thing_mass_kg": "things",
}


def frames_at(duration: float, fps: float) -> int:
    """Frames of a motion (s) at a rate (Hz): the last one is the first at or after its end."""
    return max(1, math.ceil(duration * fps - _WHOLE) + 1)


def resampled(values: Array, duration: float, fps: float) -> Array:
    """Rows at equal times of a motion (s) at a rate (Hz), by cubic Hermite splines whose slope at a frame is that between
    its neighbours, and 0 at both ends. The last row is the motion's last."""
    last = len(values) - 1
    slopes = np.zeros_like(values)
    slopes[1:-1] = 0.5 * (values[2:] - values[:-2])
    at = np.arange(frames_at(duration, fps)) / fps / (duration / last)
    at[-1] = last
    before = np.minimum((at + _WHOLE).astype(int), last)
    after = np.minimum(before + 1, last)
    t = np.where((at - before < _WHOLE) | (before == last), 0.0, at - before).reshape((-1,) + (1,) * (values.ndim - 1))
    u = 1.0 - t
    made: Array = u * u * ((1 + 2 * t) * values[before] + t * slopes[before]) + t * t * (
        (1 + 2 * u) * values[after] - u * slopes[after]
    )
    return made


def axis_angles(quaternions: Array) -> Array:
    """(…, 3) rad: axis times angle, up to π, of unit quaternions (…, 4): x, y, z, w."""
    turns = np.where(quaternions[..., 3:] < 0.0, -quaternions, quaternions)
    sine = np.linalg.norm(turns[..., :3], axis=-1, keepdims=True)
    scale = np.divide(2.0 * np.arctan2(sine, turns[..., 3:]), sine, out=np.full_like(sine, 2.0), where=sine > 1e-12)
    made: Array = scale * turns[..., :3]
    return made


@contextlib.contextmanager
def _whole(folder: pathlib.Path) -> Iterator[pathlib.Path]:
    """A folder that gets its name once it is whole."""
    if folder.exists() and (not folder.is_dir() or any(folder.iterdir())):
        raise InvalidValue(f"{folder} is there and not empty: give a new folder")
    folder.parent.mkdir(parents=True, exist_ok=True)
    part = pathlib.Path(tempfile.mkdtemp(prefix=".shigusa-", dir=folder.parent))
    try:
        yield part
        part.chmod(0o755)
        os.replace(part, folder)
    except BaseException:
        shutil.rmtree(part)
        raise


def _file_of(motion: Motion, ending: str) -> str:
    """A folder for each thousand tasks, as folders of very many files are slow."""
    return f"motions/{motion.task // 1000:04}/{motion.id}.{ending}"


def _write_about(data: Dataset, folder: pathlib.Path, form: str, more: str) -> None:
    licence = f", licence {data.plan['licence']}" if data.plan.get("licence") else ""
    (folder / "README.md").write_text(
        f"# {data.plan.get('name') or 'Motions'}\n\n{len(data)} motions of a data set that shigusa made, as {form}. Plan "
        f"{data.digest} (SHA-256), seed {data.plan['seed']}{licence}.\nA motion's name is its task's number in the plan "
        f"and its rank among the task's motions.\n\n{more}\n"
    )


def _write_index(data: Dataset, folder: pathlib.Path, ending: str) -> None:
    """index.csv: a row a motion, with the numbers of its task and goals, penalties and parameters."""
    motions = data.motions
    names = [f"{task:06}-{rank}" for task, rank in motions.index]
    motions.insert(0, "motion", names)
    if ending:
        motions.insert(1, "file", [f"motions/{int(name[:-2]) // 1000:04}/{name}.{ending}" for name in names])
    if data.has_index:
        motions = motions.join(data.splits["by_person"].rename("split"), on="task")
    motions = motions.join(data.tasks[_TASK_COLUMNS], on="task")
    goals = data.goals
    wide = goals.assign(number=goals.groupby(level=0).cumcount() + 1).set_index("number", append=True).unstack()
    wide.columns = [f"goal{number}.{name}" for name, number in wide.columns]
    motions = motions.join(wide[sorted(wide.columns, key=lambda name: int(re.findall(r"\d+", name)[0]))], on="task")
    for name, axis in _LISTS.items():
        motions = motions.join(data._vectors(name, axis).add_prefix(f"{name}."))
    motions.to_csv(folder / "index.csv")


def to_csv(data: Dataset, folder: pathlib.Path, series: bool) -> int:
    if series and not data.series:
        raise Unsupported("the data set keeps no series")
    with _whole(folder) as part:
        _write_index(data, part, "csv" if series else "")
        for motion in data if series else ():
            path = part / _file_of(motion, "csv")
            path.parent.mkdir(parents=True, exist_ok=True)
            _series_of(motion).to_csv(path, index=False)
        _write_about(data, part, "CSV", "`index.csv` has a row a motion; empty is what is not there.")
    return len(data)


def _series_of(motion: Motion) -> pandas.DataFrame:
    """All series, a row a frame."""
    import pandas as pd  # pylint: disable=import-outside-toplevel

    names = motion.body.names
    turn = ("qx", "qy", "qz", "qw")
    axes: dict[str, tuple[list[str], tuple[str, ...]]] = {
        "angles": (names["joints"], ("",)), "torques": ([f"{name} torque" for name in names["joints"]], ("",)),
        "nodes": (names["nodes"], turn), "positions": (names["nodes"], ("x", "y", "z")), "root_m": (["root"], ("x", "y", "z")),
        "centre_of_mass": (["centre_of_mass"], ("x", "y", "z")), "pressure": (["pressure"], ("x", "z")),
        "contacts": ([f"{name} stands on" for name in names["feet"]], ("",)), "actions": (["action"], ("",)),
        "things": (names.get("things", []), ("x", "y", "z", *turn)),
    }
    parts = [pd.DataFrame({"time [s]": motion.times})]
    for series, (rows, ends) in axes.items():
        if series not in motion:
            continue
        unit = motion.body.units[series]
        titles = [
            f"{row}{'.' if end else ''}{end}" + (f" [{unit}]" if unit and not end.startswith("q") else "")
            for row in rows for end in ends
        ]
        values = motion[series].reshape(len(motion.times), -1)
        words = motion.body.words.get(series)
        parts.append(pd.DataFrame(np.array(words)[values] if words else values, columns=titles))
    return pd.concat(parts, axis=1)


_ABOUT_NPZ = """\
Each file of `motions/` is a NumPy archive with the keys of AMASS, on shigusa's own skeleton, which is not SMPL's: `poses`
(frames × 3·nodes: each node's turn in its parent, axis times angle, rad), `trans` (frames × 3: the first node in the world,
m), `gender`, `mocap_framerate` and `mocap_frame_rate` (Hz); in the place of `betas` are `joint_names`, `parents` and
`offsets` (nodes × 3, each in its parent, m). y is up, the body faces z at the start; AMASS has z up. A node is where its
parent is, plus the parent's turn, with those above it, times its offset. `index.csv` has a row a motion."""


def to_npz(data: Dataset, folder: pathlib.Path, fps: float) -> int:
    if not 1.0 <= fps <= 240.0:
        raise InvalidValue(f"fps is {fps}; allowed are 1 to 240")
    with _whole(folder) as part:
        for motion in data:
            path = part / _file_of(motion, "npz")
            path.parent.mkdir(parents=True, exist_ok=True)
            np.savez(path, **_npz(motion, fps))
        _write_index(data, part, "npz")
        _write_about(data, part, "npz", _ABOUT_NPZ)
    return len(data)


def _npz(motion: Motion, fps: float) -> dict[str, Any]:
    motion._need("nodes")
    turns = resampled(motion["nodes"].astype(np.float64), motion.duration, fps)
    turns /= np.linalg.norm(turns, axis=-1, keepdims=True)
    root = resampled(motion["root_m"].astype(np.float64), motion.duration, fps)
    about, person, goals = motion.about, motion.person, motion.goals
    return {
        "poses": axis_angles(turns).reshape(len(turns), -1).astype(np.float32),
        "trans": root.astype(np.float32),
        "gender": person["sex"],
        # AMASS's files have both
        "mocap_framerate": fps,
        "mocap_frame_rate": fps,
        "joint_names": motion.body.nodes,
        "parents": motion.body.parents,
        "offsets": motion["offsets_m"],
        "skeleton": "shigusa (not SMPL)",
        "up_axis": "y",
        "task": np.uint64(motion.task),
        "rank": np.uint64(motion.rank),
        "stature": person["stature_m"],
        "mass": person["mass_kg"],
        "duration": motion.duration,
        "score": about["score"],
        "verdict": about["verdict"],
        "words": about["words"],
        "goal_effectors": np.array(list(goals["effector"]), dtype=str),
        "goal_positions": goals[["position_m.x", "position_m.y", "position_m.z"]].to_numpy(),
        "goal_loads": goals["load_kg"].to_numpy(),
    }


def _sources(nodes: list[str]) -> list[tuple[int, int, float]]:
    """Of each joint of HumanML3D: two nodes and the share of the way between them; empty where a body has none."""
    made = []
    for node, start, end, share in _JOINTS.values():
        if node in nodes:
            made.append((nodes.index(node), nodes.index(node), 0.0))
        elif start in nodes and end in nodes:
            made.append((nodes.index(start), nodes.index(end), share))
        else:
            return []
    return made


def humanml3d_joints(motion: Motion) -> Array | None:
    """(frames, 22, 3) m at 20 Hz; None of a body without two arms and two legs."""
    sources = _sources(motion.body.nodes)
    if not sources:
        return None
    start, end, share = (np.array(part) for part in zip(*sources))
    places = resampled(motion.places, motion.duration, _HUMANML3D_HZ)
    joints: Array = places[:, start] + share[:, None] * (places[:, end] - places[:, start])
    return joints.astype(np.float32)


def _about_humanml3d(motions: int, short: int, least_frames: int) -> str:
    rows = "".join(
        f"| {joint} | {node} |" + (f" or {100 * share:.0f} % of the way from {start} to {end} |\n" if share else " |\n")
        for joint, (node, start, end, share) in _JOINTS.items()
    )
    held = f"; shorter ones hold their last pose up to {least_frames} frames" if least_frames else ""
    return (
        "As in HumanML3D: `new_joints/` has a file a motion, frames × 22 × 3 (m, 32-bit floats) at 20 frames a second;\n"
        "`texts/` its sentence as `caption#tokens#0.0#0.0`; `train.txt`, `val.txt` and `test.txt` the names of each part, no\n"
        "two of which share a person. y is up, the floor is at 0, people face z at the start, and their left is x. The last\n"
        "frame shows the motion's end. Its usual readers leave out motions of fewer than "
        f"{_HUMANML3D_READ} frames, {short} of these {motions}{held}.\n\nSentences are made from goals, loads and measured "
        "postures, not by people. Features (`new_joint_vecs`, `Mean.npy`, `Std.npy`) come by HumanML3D's own\n"
        f"`motion_representation`.\n\n| joint | shigusa's node | |\n|---|---|---|\n{rows}"
    )


def to_humanml3d(data: Dataset, folder: pathlib.Path, least_frames: int) -> int:
    splits = data.splits["by_person"]
    parts: dict[str, list[str]] = {split: [] for split in SPLITS}
    count, short = 0, 0
    with _whole(folder) as part:
        (part / "new_joints").mkdir()
        (part / "texts").mkdir()
        for motion in data:
            made = humanml3d_joints(motion)
            if made is None:
                continue
            joints = np.concatenate([made, np.repeat(made[-1:], max(0, least_frames - len(made)), axis=0)])
            np.save(part / f"new_joints/{motion.id}.npy", joints)
            text = caption(motion)
            (part / f"texts/{motion.id}.txt").write_text(f"{text}#{tokens(text)}#0.0#0.0\n")
            parts[splits[motion.task]].append(motion.id)
            count += 1
            short += len(joints) < _HUMANML3D_READ
        if count == 0:
            raise Unsupported("no motion is of a body with two arms and two legs, which HumanML3D's are of")
        if count < len(data):
            warnings.warn(f"{len(data) - count} motions of bodies without two arms and two legs are left out")
        for split, name in zip(SPLITS, ("train", "val", "test")):
            (part / f"{name}.txt").write_text("".join(f"{one}\n" for one in parts[split]))
        _write_about(data, part, "HumanML3D", _about_humanml3d(count, short, least_frames))
    return count


# Captions: heights as shares of the stature, directions (deg) from straight ahead.
_HEIGHTS = ((0.12, " down to the floor"), (0.5, " down"), (0.95, ""), (1.15, " up"), (math.inf, " high up"))
_AHEAD, _BESIDE, _BEHIND, _BACK = 20.0, 65.0, 115.0, 160.0
_OVER = 0.12  # m: nearer to the body's middle than this has no direction
_TOGETHER = 0.6  # m: hands that are nearer to each other reach as one
_LOAD_TOLD = 0.5  # kg
_REACHED = 0.01  # m: a goal missed by more is reached towards
_HANDS = ("left_hand", "right_hand")
_TOKENS = {
    "a": "a/DET", "the": "the/DET", "both": "both/DET", "and": "and/CCONJ", "with": "with/ADP", "to": "to/ADP", "in": "in/ADP",
    "towards": "towards/ADP", "person": "person/NOUN", "floor": "floor/NOUN", "front": "front/NOUN", "hand": "hand/NOUN",
    "hands": "hand/NOUN", "foot": "foot/NOUN", "knees": "knee/NOUN", "elbow": "elbow/NOUN", "kg": "kg/NOUN",
    "seated": "seated/ADJ", "straight": "straight/ADJ", "right": "right/ADJ", "left": "left/ADJ", "down": "down/ADV",
    "forward": "forward/ADV", "up": "up/ADV", "high": "high/ADV", "behind": "behind/ADV", "upright": "upright/ADV",
    "halfway": "halfway/ADV", "out": "out/ADV", "stands": "stand/VERB", "squats": "squat/VERB", "bends": "bend/VERB",
    "leans": "lean/VERB", "turns": "turn/VERB", "reaches": "reach/VERB", "moves": "move/VERB", "holding": "hold/VERB",
}


def _posture_verbs(words: list[str]) -> list[str]:
    seated = "sitting" in words
    straight = " with straight knees" if "straight knees" in words else ""
    said = {
        "bends forward": seated and "leaning" in words,
        "squats halfway down": "half squat" in words,
        "squats": "squat" in words,
        f"bends down{straight}": "stoop" in words,
        "leans": not seated and "leaning" in words,
        "bends the knees": not seated and "knees bent" in words,
        "turns left": "turned left" in words,
        "turns right": "turned right" in words,
    }
    verbs = [verb for verb, is_said in said.items() if is_said]
    return verbs or ([] if seated else ["stands upright"])


def _way_to(place: Array, stature: float) -> str:
    """Such as " down to the floor in front", " up to the left"."""
    way = next(words for height, words in _HEIGHTS if place[1] / stature < height)
    if math.hypot(place[0], place[2]) < _OVER:
        return way
    turn = math.degrees(math.atan2(place[0], place[2]))
    if abs(turn) < _BESIDE:
        way += " in front"
    if abs(turn) > _BEHIND:
        way += " behind"
    if _AHEAD < abs(turn) < _BACK:
        way += " to the left" if turn > 0.0 else " to the right"
    return way


def _load(kilograms: float) -> str:
    return "" if kilograms < _LOAD_TOLD else f", holding {kilograms:.0f} kg"


def goal_verbs(goals: pandas.DataFrame, stature: float, missed: bool) -> list[str]:
    """Such as "reaches down in front with the right hand, holding 5 kg"."""
    places = goals[["position_m.x", "position_m.y", "position_m.z"]].to_numpy()
    loads = goals["load_kg"].to_numpy()
    effectors = list(goals["effector"])
    both = len(effectors) == 2 and all(effector in _HANDS for effector in effectors)
    if both and np.linalg.norm(places[0] - places[1]) < _TOGETHER:
        return [f"reaches{_way_to(places.mean(axis=0), stature)} with both hands{_load(loads.sum())}"]
    verbs = []
    for effector, place, load in zip(effectors, places, loads):
        way, name = _way_to(place, stature), effector.replace("_", " ")
        if effector in _HANDS:
            verbs.append(f"reaches{' out' if missed and not way else ''}{way} with the {name}{_load(load)}")
        else:
            verbs.append(f"moves the {name}{way}")
    return verbs


def caption(motion: Motion) -> str:
    """Such as "a person squats, turns left and reaches down in front with the right hand, holding 5 kg"."""
    about, person = motion.about, motion.person
    verbs = _posture_verbs(about["words"].split(", "))
    verbs += goal_verbs(motion.goals, person["stature_m"], about["error_m"] > _REACHED)
    listed = verbs[0] if len(verbs) == 1 else f"{', '.join(verbs[:-1])} and {verbs[-1]}" if verbs else ""
    return f"a {'seated ' if math.isfinite(person['seat_m']) else ''}person {listed}"


def tokens(text: str) -> str:
    """The words of a caption, nouns and verbs in their plain forms: "a/DET person/NOUN squat/VERB"."""
    return " ".join(_TOKENS.get(word, f"{word}/NOUN") for word in re.findall("[a-zA-Z]+", text))
