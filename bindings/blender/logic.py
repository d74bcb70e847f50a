# SPDX-License-Identifier: GPL-3.0-or-later
"""The add-on's part that needs no Blender: which bones the engine gets, how its motions come back, the search, names and
pictures. Matrices are 4 × 4 and act on columns."""

from __future__ import annotations

import re
import threading
from typing import Any, NamedTuple

import numpy as np

STATUS = {
    "unreachable": "out of reach: the motion ends as near as it can",
    "unsteady": "no motion that somebody can make was found",
}
EFFECTORS = ("right_hand", "left_hand", "right_foot", "left_foot")


class ControlRig(NamedTuple):
    """A rig whose bones follow controls. Bones are measured, controls are keyed."""

    name: str
    prefix: str  # of the measured bones, left out of the names that the engine gets
    bones: dict[str, str | None]  # measured bone -> the measured bone above it
    steps: list[list[tuple[str, str]]]  # (control, measured bone) that can be set at once, those above first
    switches: list[tuple[str, str]]  # (control, property) that is 1 where limbs follow these controls


def _rig(name: str, prefix: str, sides: str, bones: str, steps: list[str], switches: str) -> ControlRig:
    """A rig of pairs of words, each with {} for both sides of it."""

    def pairs(text: str) -> list[tuple[str, str]]:
        told = [pair.split("<") for pair in text.split()]
        return [(a.format(side), b.format(side)) for a, b in told for side in (sides if "{}" in a else sides[:1])]

    measured = {prefix + bone: prefix + above if above else None for bone, above in pairs(bones)}
    stepped = [[(control, prefix + bone) for control, bone in pairs(step)] for step in steps]
    return ControlRig(name, prefix, measured, stepped, pairs(switches))


RIGIFY = _rig(
    "Rigify", "ORG-", "LR",
    "spine< spine.001<spine spine.002<spine.001 spine.003<spine.002 spine.004<spine.003 spine.005<spine.004"
    " spine.006<spine.005 shoulder.{}<spine.003 upper_arm.{}<shoulder.{} forearm.{}<upper_arm.{} hand.{}<forearm.{}"
    " f_middle.01.{}<hand.{} f_middle.02.{}<f_middle.01.{} f_middle.03.{}<f_middle.02.{} thigh.{}<spine shin.{}<thigh.{}"
    " foot.{}<shin.{} toe.{}<foot.{} heel.02.{}<foot.{}",
    ["torso<spine", "spine_fk.001<spine.001 spine_fk.002<spine.002",
     "spine_fk<spine spine_fk.003<spine.003 tweak_spine<spine tweak_spine.001<spine.001 tweak_spine.002<spine.002"
     " tweak_spine.003<spine.003",
     "neck<spine.004 shoulder.{}<shoulder.{} thigh_fk.{}<thigh.{} shin_fk.{}<shin.{}",
     "head<spine.006 upper_arm_fk.{}<upper_arm.{} forearm_fk.{}<forearm.{} foot_fk.{}<foot.{}",
     "hand_fk.{}<hand.{} toe_fk.{}<toe.{}"],
    "upper_arm_parent.{}<IK_FK thigh_parent.{}<IK_FK",
)
# by its published names; tried on a stand-in alone
AUTO_RIG_PRO = _rig(
    "Auto-Rig Pro", "", "lr",
    "root.x< spine_01.x<root.x spine_02.x<spine_01.x spine_03.x<spine_02.x neck.x<spine_03.x head.x<neck.x"
    " shoulder.{}<spine_03.x arm_stretch.{}<shoulder.{} forearm_stretch.{}<arm_stretch.{} hand.{}<forearm_stretch.{}"
    " thigh_stretch.{}<root.x leg_stretch.{}<thigh_stretch.{} foot.{}<leg_stretch.{} toes_01.{}<foot.{}",
    ["c_root_master.x<root.x", "c_root.x<root.x", "c_spine_01.x<spine_01.x", "c_spine_02.x<spine_02.x",
     "c_spine_03.x<spine_03.x", "c_neck.x<neck.x c_shoulder.{}<shoulder.{} c_thigh_fk.{}<thigh_stretch.{}",
     "c_head.x<head.x c_arm_fk.{}<arm_stretch.{} c_leg_fk.{}<leg_stretch.{}",
     "c_forearm_fk.{}<forearm_stretch.{} c_foot_fk.{}<foot.{}", "c_hand_fk.{}<hand.{} c_toes_fk.{}<toes_01.{}"],
    "c_hand_ik.{}<ik_fk_switch c_foot_ik.{}<ik_fk_switch",
)


def control_rig(names: set[str]) -> ControlRig | None:
    """The rig that has these bones, with only what is there of it; None of one that is keyed bone by bone."""
    for rig, told in ((RIGIFY, ("ORG-spine", "torso", "hand_fk.L")), (AUTO_RIG_PRO, ("root.x", "c_root_master.x", "c_hand_fk.l"))):
        if names.issuperset(told):
            bones: dict[str, str | None] = {}
            for bone, above in rig.bones.items():
                while above is not None and above not in names:
                    above = rig.bones[above]
                if bone in names:
                    bones[bone] = above
            head = [bone for bone in ("ORG-spine.006", "ORG-spine.005") if bone in names][:1]
            steps = [[(control, head[0] if control == "head" and head else bone) for control, bone in step] for step in rig.steps]
            kept = [[pair for pair in step if pair[0] in names and pair[1] in names] for step in steps]
            return rig._replace(bones=bones, steps=kept, switches=[one for one in rig.switches if one[0] in names])
    return None


def to_engine(placement: dict[str, Any], place: Any) -> list[float]:
    """A place of Blender's world where goals are given: metres, y up, ahead is z."""
    from_origin = np.asarray(place, float) - placement["origin"]
    return [float(placement["unit_m"] * from_origin @ np.asarray(placement[axis])) for axis in ("left", "up", "ahead")]


def to_host(placement: dict[str, Any], place: Any) -> list[float]:
    """The contrary of to_engine."""
    axes = np.array([placement[axis] for axis in ("left", "up", "ahead")])
    return [float(x) for x in np.asarray(placement["origin"]) + np.asarray(place) @ axes / placement["unit_m"]]


def start_place(about: dict[str, Any], effector: str, place_of_bone: Any) -> list[float]:
    """Where an effector is in Blender's world; `place_of_bone`: the place of a bone's head by its name."""
    for place in about["places"]:
        if place["effector"] == effector:
            return to_host(about["placement"], place["start_m"])
    return [float(x) for x in place_of_bone(about["humanoid"][effector])]


def matrices(translations: Any, rotations: Any, scales: Any) -> Any:
    """(…, 4, 4) of (…, 3), of quaternions x, y, z, w (…, 4) and of (…, 3)."""
    x, y, z, w = np.moveaxis(np.asarray(rotations), -1, 0)
    rows = [
        [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
        [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
        [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)],
    ]
    turn = np.stack([np.stack(row, -1) for row in rows], -2) * np.asarray(scales)[..., None, :]
    made = np.zeros((*turn.shape[:-2], 4, 4))
    made[..., :3, :3] = turn
    made[..., :3, 3] = translations
    made[..., 3, 3] = 1
    return made


def in_armature(parents: list[int], about_nodes: list[dict[str, Any]], translations: Any, rotations: Any) -> Any:
    """(frames, bones, 4, 4) in the armature, of node tracks in their parents. The file's node 0 is the armature's object,
    and node i + 1 is bone i, whose parent is bone parents[i], or -1."""
    place = {node["file_node"]: number for number, node in enumerate(about_nodes) if node.get("file_node", -1) >= 0}
    made = np.zeros((len(translations), len(parents), 4, 4))
    for bone, parent in enumerate(parents):
        node = place[bone + 1]
        own = matrices(translations[:, node], rotations[:, node], about_nodes[node].get("scale", [1, 1, 1]))
        made[:, bone] = own if parent < 0 else made[:, parent] @ own
    return made


def title(candidate: Any) -> str:
    """How a candidate is called: the words of its last posture."""
    return str(candidate.about["final_posture"]["words"])


def remarks(candidate: Any) -> list[str]:
    """Why the body could not make it, and what is left to each goal that it does not reach."""
    left = [one for one in candidate.about["reached"] if one["error_mm"] > 0.1]
    return [
        *(f"{one['effector'].replace('_', ' ')} ends {one['error_mm'] / 1000:.2g} m from its goal" for one in left),
        *(re.sub(r"_|(?<=[a-z])\.(?=[a-z])", " ", reason) for reason in candidate.reasons[:1]),
    ]


def ends(candidate: Any) -> list[str]:
    """Which bone comes to each goal."""
    return [f"{one['effector'].replace('_', ' ')}: {one['joint']}" for one in candidate.about["reached"]]


def sliders(candidate: Any) -> dict[str, dict[str, Any]]:
    """The parameters that a person can read: angles and shares, and not the weights of joints."""
    return {name: one for name, one in candidate.parameters().items() if one["kind"] != "weight"}


def picture(starts: Any, ends: Any, bones: list[tuple[int, int]], size: int = 128) -> Any:
    """Figures of lines, the last posture before the first: (size, size, 4), the lowest row first. `starts`, `ends`:
    (places, 2) right and up; `bones`: pairs of places, the same one twice for a head."""
    both = np.concatenate([starts, ends])
    low, high = both.min(0), both.max(0)
    scale = 0.88 * size / max(float((high - low).max()), 1e-6)
    made = np.zeros((size, size, 4), np.float32)
    grid = np.stack(np.meshgrid(np.arange(size) + 0.5, np.arange(size) + 0.5), -1)
    for places, colour, width in ((starts, (0.5, 0.5, 0.5), 0.012), (ends, (1.0, 0.62, 0.2), 0.02)):
        drawn = (np.asarray(places) - (low + high) / 2) * scale + size / 2
        near = np.full((size, size), 1e9)
        for a, b in bones:
            along = drawn[b] - drawn[a]
            share = np.clip((grid - drawn[a]) @ along / max(float(along @ along), 1e-9), 0, 1)
            head = 0.035 * size if a == b else 0.0
            near = np.minimum(near, np.linalg.norm(grid - drawn[a] - share[..., None] * along, axis=-1) - head)
        ink = np.clip(width * size - near + 0.5, 0, 1)[..., None]
        made = made * (1 - ink) + np.array([*colour, 1.0], np.float32) * ink
    return made


def refusal(wrong: Exception, name: str) -> str:
    """The engine's words, in which an armature is a file."""
    return str(wrong).replace(f"{name}.glb: ", f"{name} is not understood as a person: ")


class Search(threading.Thread):
    """A search in a thread of its own: `share` tells how far it is, cancel() ends it without a result."""

    def __init__(self, engine: Any, nodes: list[dict[str, Any]], name: str, goals: dict[str, Any], **task: Any) -> None:
        super().__init__(daemon=True)
        self._arguments = (engine, nodes, name, goals, task)
        self.share = 0.0
        self.cancelled = False
        self.character: Any = None
        self.result: Any = None
        self.failure = ""

    def cancel(self) -> None:
        self.cancelled = True

    def _tell(self, share: float, _evaluations: int, _best: float) -> bool:
        self.share = share
        return not self.cancelled

    def run(self) -> None:
        engine, nodes, name, goals, task = self._arguments
        try:
            self.character = engine.Character.of_nodes(nodes, name)
            placement = self.character.about["placement"]
            places = {effector: to_engine(placement, place) for effector, place in goals.items()}
            found = engine.reach(self.character, places, progress=self._tell, **task)
            if not self.cancelled:
                self.result = found
        except engine.Failure as wrong:
            self.failure = refusal(wrong, name)
        except Exception as wrong:  # pylint: disable=broad-except  # a thread would end in silence
            self.failure = repr(wrong)


def figure(parents: list[int], nodes: list[dict[str, Any]], about: dict[str, Any], frames: Any) -> Any:
    """The picture of a motion: (frames, bones, 4, 4) in the armature, of nodes as in_armature has them."""
    person = set(about["humanoid"].values())
    kept = [number for number in range(len(parents)) if nodes[number + 1]["name"] in person]
    pairs = []
    for number in kept:
        above = parents[number]
        while above >= 0 and above not in kept:
            above = parents[above]
        pairs.append((kept.index(number), kept.index(above) if above >= 0 else kept.index(number)))
    root = nodes[0]
    placed = matrices(root["translation"], np.array(root["rotation"]), np.array(root["scale"])) @ frames[[0, -1]][:, kept]
    axes = np.array([about["placement"][axis] for axis in ("left", "up", "ahead")])
    left, up, ahead = np.moveaxis(placed[..., :3, 3] @ axes.T, -1, 0)
    shown = np.stack([0.8 * left + 0.6 * ahead, up], -1)
    named = {nodes[number + 1]["name"]: place for place, number in enumerate(kept)}
    neck, head = (named.get(about["humanoid"].get(bone, "")) for bone in ("neck", "head"))
    if neck is not None and head is not None:
        pairs.append((len(kept), len(kept)))
        along = shown[:, head] - shown[:, neck]
        top = shown[:, head] + 0.05 * np.ptp(up) * along / np.maximum(np.linalg.norm(along, axis=-1, keepdims=True), 1e-9)
        shown = np.concatenate([shown, top[:, None]], 1)
    return picture(shown[0], shown[1], pairs)
