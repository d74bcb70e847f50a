# SPDX-License-Identifier: GPL-3.0-or-later
"""Armatures: their nodes and present pose for the engine, and its motions as Actions. Nothing else of the file changes."""

from __future__ import annotations

from typing import Any, NamedTuple

import bpy
import numpy as np
from mathutils import Matrix

from . import logic

OWN = "shigusa"  # of an Action that may be written anew: the search and the candidate that it is of


class Key(NamedTuple):
    """Values of a property: one a frame, or one in all."""

    bone: str
    path: str
    values: Any  # (frames, components)


class Skeleton(NamedTuple):
    """An armature as the engine gets it."""

    bones: list[str]  # parents first
    parents: list[int]  # of each bone, in `bones`; -1 for none
    nodes: list[dict[str, Any]]  # the object, then the bones
    controls: logic.ControlRig | None
    present: dict[str, list[Key]]  # of each bone of the armature that is not at rest, its pose
    followed: dict[str, tuple[int, Any]]  # of controls, once learnt: the bone that the parent follows, and how it lies in it


def _parts(matrix: Matrix) -> dict[str, list[float]]:
    place, turn, scale = matrix.decompose()
    return {"translation": list(place), "rotation": [turn.x, turn.y, turn.z, turn.w], "scale": list(scale)}


def _present(bone: Any) -> list[Key]:
    """What else of a bone is not at rest, held by one key, as another Action of the armature may have moved it since."""
    paths = ["location", "scale", {"QUATERNION": "rotation_quaternion", "AXIS_ANGLE": "rotation_axis_angle"}.get(
        bone.rotation_mode, "rotation_euler")]
    if max(abs(x) for row in bone.matrix_basis - Matrix() for x in row) < 1e-6:
        return []
    return [Key(bone.name, bone.path_from_id(path), np.array([list(getattr(bone, path))])) for path in paths]


def skeleton(armature: Any, depsgraph: Any) -> Skeleton:
    """The armature's bones, or those that a control rig moves, at rest and as Blender has them now."""
    bones = armature.data.bones
    posed = armature.evaluated_get(depsgraph)
    controls = logic.control_rig(set(bones.keys()))
    above = controls.bones if controls else {bone.name: bone.parent and bone.parent.name for bone in bones}
    names = list(above)
    number = {name: place for place, name in enumerate(names)}
    nodes: list[dict[str, Any]] = [{"name": armature.name, "parent": -1, **_parts(posed.matrix_world)}]
    for name, parent in above.items():
        rest, now = bones[name].matrix_local, posed.pose.bones[name].matrix
        if parent is not None:
            rest = bones[parent].matrix_local.inverted_safe() @ rest
            now = posed.pose.bones[parent].matrix.inverted_safe() @ now
        called = name[len(controls.prefix):] if controls else name
        node = {"name": called, "parent": 0 if parent is None else number[parent] + 1, **_parts(rest), "pose": _parts(now)}
        nodes.append(node)
    present = {bone.name: _present(bone) for bone in armature.pose.bones}
    return Skeleton(names, [-1 if parent is None else number[parent] for parent in above.values()], nodes, controls, present, {})


def constrained(armature: Any, found: Skeleton, humanoid: set[str]) -> list[str]:
    """The bones of `humanoid` whose constraints hold against keys."""
    bones = [armature.pose.bones[name] for name in found.bones if name in humanoid and found.controls is None]
    return [bone.name for bone in bones if any(not one.mute and one.influence > 0 for one in bone.constraints)]


def motion(found: Skeleton, character: Any, candidate: Any, fps: float) -> Any:
    """(frames, bones, 4, 4) of a candidate, in the armature, at a rate (Hz)."""
    nodes = candidate.nodes_at(fps, "file")
    return logic.in_armature(found.parents, character.about["nodes"], nodes.translations, nodes.rotations)


def _turns(bone: Any, bases: list[Matrix]) -> tuple[str, Any]:
    """The rotations of a bone as it keeps them, without jumps."""
    mode = bone.rotation_mode
    quaternions = [basis.to_quaternion() for basis in bases]
    for before, now in zip(quaternions, quaternions[1:]):
        now.make_compatible(before)
    if mode == "QUATERNION":
        return "rotation_quaternion", [list(turn) for turn in quaternions]
    if mode == "AXIS_ANGLE":
        turned = [turn.to_axis_angle() for turn in quaternions]
        return "rotation_axis_angle", [[angle, *axis] for axis, angle in turned]
    eulers = [bone.rotation_euler.copy()]
    for turn in quaternions:
        eulers.append(turn.to_euler(mode, eulers[-1]))
    return "rotation_euler", [list(euler) for euler in eulers[1:]]


def _key(bone: Any, bases: list[Matrix]) -> list[Key]:
    """A bone's rotation, its place, where it has one, and its scale, where that is not as now: limbs that IK stretches."""
    path, turns = _turns(bone, bases)
    keys = [Key(bone.name, bone.path_from_id(path), np.array(turns))]
    places = np.array([basis.translation for basis in bases])
    free = not (bone.bone.use_connect and bone.bone.parent)
    if free and (np.abs(places).max() > 1e-6 or any(bone.location)):
        keys.append(Key(bone.name, bone.path_from_id("location"), places))
    scales = np.array([basis.to_scale() for basis in bases])
    if np.abs(scales - np.array(bone.scale)).max() > 1e-5:
        keys.append(Key(bone.name, bone.path_from_id("scale"), scales))
    return keys


def direct_keys(armature: Any, found: Skeleton, frames: Any, humanoid: set[str]) -> list[Key]:
    """Keys of the bones that move, of the others of `humanoid` and of those that hold another pose than at rest."""
    keys: list[Key] = []
    local = frames.copy()
    for number, parent in enumerate(found.parents):
        if parent >= 0:
            local[:, number] = np.linalg.solve(frames[:, parent], frames[:, number])
    moved = np.abs(local - local[:1]).max((0, 2, 3)) > 1e-6
    for number, name in enumerate(found.bones):
        bone = armature.pose.bones[name]
        if not moved[number] and name not in humanoid:
            keys += found.present[name]
            continue
        parent, rest = found.parents[number], bone.bone
        bases = []
        for frame in frames:
            above = {}
            if parent >= 0:
                above = {"parent_matrix": Matrix(frame[parent].tolist()), "parent_matrix_local": rest.parent.matrix_local}
            bases.append(rest.convert_local_to_pose(Matrix(frame[number].tolist()), rest.matrix_local, invert=True, **above))
        keys += _key(bone, bases)
    return keys


def _learn(found: Skeleton, frames: Any, bone: str, parents: Any) -> tuple[int, Any] | None:
    """The measured bone above `bone`, or -1 for the armature, in which a control's parent lay still in all frames."""
    number = found.bones.index(bone)
    while number >= 0:
        number = found.parents[number]
        within = parents if number < 0 else np.linalg.solve(frames[:, number], parents)
        if np.ptp(within, axis=0).max() < 1e-5:
            return number, within[0]
    return None


def _control_bases(found: Skeleton, posed: Any, frames: Any, layer: Any) -> dict[str, list[Matrix]]:
    """The bases of a rig's controls in each frame: each is set where its bone is to be, those above first, as Blender
    evaluates the rig. Where parents of controls simply follow a bone, that is learnt, and not evaluated again."""
    assert found.controls is not None
    bases: dict[str, list[Matrix]] = {control: [] for step in found.controls.steps for control, _ in step}
    seen: dict[str, list[Any]] = {}
    bone_of = {control: bone for step in found.controls.steps for control, bone in step}
    offsets = {control: posed[bone].bone.matrix_local.inverted_safe() @ posed[control].bone.matrix_local
               for control, bone in bone_of.items()}
    for frame in frames:
        placed: dict[str, Matrix] = {}
        stale = True
        for step in found.controls.steps:
            for control in [control for control, _ in step]:
                above, told = posed[control].parent, {}
                if above is not None:
                    if above.name in placed:
                        parent = placed[above.name]
                    elif control in found.followed:
                        number, within = found.followed[control]
                        parent = Matrix((within if number < 0 else frame[number] @ within).tolist())
                    else:
                        if stale:
                            layer.update()
                            stale = False
                        parent = above.matrix.copy()
                        seen.setdefault(control, []).append(np.array(parent))
                    told = {"parent_matrix": parent, "parent_matrix_local": above.bone.matrix_local}
                placed[control] = Matrix(frame[found.bones.index(bone_of[control])].tolist()) @ offsets[control]
                bases[control].append(posed[control].bone.convert_local_to_pose(
                    placed[control], posed[control].bone.matrix_local, invert=True, **told))
            for control, _ in step:
                posed[control].matrix_basis = bases[control][-1]
            stale = True
    for control, parents in seen.items():
        learnt = _learn(found, frames, bone_of[control], np.array(parents))
        if learnt:
            found.followed[control] = learnt
    return bases


def control_keys(armature: Any, found: Skeleton, frames: Any, layer: Any) -> list[Key]:
    """Keys of a rig's controls, and of the switches that let limbs follow them."""
    controls, posed = found.controls, armature.pose.bones
    assert controls is not None
    used = [posed[control] for step in controls.steps for control, _ in step]
    before = [(control, control.matrix_basis.copy()) for control in used]
    switched = [(posed[bone], name, posed[bone][name]) for bone, name in controls.switches if name in posed[bone]]
    data = armature.animation_data_create()
    action, data.action = data.action, None
    try:
        for bone, name, value in switched:
            bone[name] = type(value)(1)
        armature.update_tag(refresh={"OBJECT", "DATA", "TIME"})
        layer.update()
        learnt = bool(found.followed)
        bases = _control_bases(found, posed, frames, layer)
        layer.update()
        ends = {name: frames[-1, number, :3, 3] for number, name in enumerate(found.bones)}
        if learnt and max(np.abs(np.array(posed[name].matrix)[:3, 3] - end).max() for name, end in ends.items()) > 1e-5:
            found.followed.clear()
            bases = _control_bases(found, posed, frames, layer)
    finally:
        for bone, name, value in switched:
            bone[name] = value
        for control, basis in before:
            control.matrix_basis = basis
        data.action = action
    keys = [Key(bone.name, f'{bone.path_from_id()}["{name}"]', np.array([[1.0]])) for bone, name, _ in switched]
    for control in used:
        keys += _key(control, bases[control.name])
    return keys + [key for bone, kept in found.present.items() if bone not in bases for key in kept]


def _curves(armature: Any, action: Any) -> Any:
    """The curves of an Action that the armature plays. 4.4 and newer, untested: those of its slot."""
    if not hasattr(action, "slots"):
        return action.fcurves
    slot = action.slots[0] if action.slots else action.slots.new(id_type="OBJECT", name=armature.name)
    armature.animation_data.action_slot = slot
    layer = action.layers[0] if action.layers else action.layers.new("Layer")
    strip = layer.strips[0] if layer.strips else layer.strips.new(type="KEYFRAME")
    return strip.channelbag(slot, ensure=True).fcurves


def write(armature: Any, keys: list[Key], start: int, name: str, mark: str) -> Any:
    """Makes the armature's Action of the keys, from a frame on. The add-on's own is written anew from there; another one,
    or one with a fake user, is kept beside a new one."""
    data = armature.animation_data_create()
    action = data.action
    if action is None or OWN not in action or action.use_fake_user:
        if action is not None:
            action.use_fake_user = True
        action = bpy.data.actions.new(name)
        data.action = action
    action[OWN], action.name = mark, name
    curves = _curves(armature, action)
    points: dict[tuple[str, int], Any] = {}
    groups: dict[str, str] = {}
    for curve in list(curves):
        before = np.array([list(point.co) for point in curve.keyframe_points if point.co[0] < start - 0.5])
        if len(before):
            points[curve.data_path, curve.array_index] = before
            groups[curve.data_path] = curve.group.name if curve.group else ""
        curves.remove(curve)
    for key in keys:
        groups[key.path] = key.bone
        for component, values in enumerate(key.values.T):
            before = points.get((key.path, component), np.zeros((0, 2)))
            points[key.path, component] = np.concatenate([before, np.stack([start + np.arange(len(values)), values], 1)])
    for (path, component), places in points.items():
        grouped = {} if hasattr(action, "slots") else {"action_group": groups[path]}
        curve = curves.new(path, index=component, **grouped)
        curve.keyframe_points.add(len(places))
        curve.keyframe_points.foreach_set("co", places.ravel())
        for point in curve.keyframe_points:
            point.interpolation = "LINEAR"
        curve.update()
    return action
