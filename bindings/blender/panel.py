# SPDX-License-Identifier: GPL-3.0-or-later
"""Operators, sliders and the panel. Results live here, beside the file: an Action is all that is left in it."""

import time
from typing import Any

import bpy
import bpy.utils.previews

from . import logic, rig, shigusa as engine


class State:
    """The last search, and which of its candidates is applied."""

    def __init__(self) -> None:
        self.search: logic.Search | None = None  # that runs
        self.token = str(time.time_ns())
        self.message = ""
        self.armature = ""  # its name
        self.skeleton: rig.Skeleton | None = None
        self.start = 1  # frame
        self.fps = 24.0
        self.character: Any = None
        self.result: Any = ()
        self.chosen = -1  # place in `result`
        self.shown: Any = None  # the chosen one, as the sliders have it
        self.parameters: dict[str, dict[str, Any]] = {}


state = State()
pictures: Any = None
slider_class: Any = None


def _armature(context: Any) -> Any:
    """The armature of the settings, else the active one."""
    chosen = context.scene.shigusa.armature
    active = context.object
    return chosen or (active if active is not None and active.type == "ARMATURE" else None)


def _goals(context: Any) -> dict[str, Any]:
    depsgraph = context.evaluated_depsgraph_get()
    told = {effector: getattr(context.scene.shigusa, effector) for effector in logic.EFFECTORS}
    return {
        effector: list(goal.evaluated_get(depsgraph).matrix_world.translation)
        for effector, goal in told.items() if goal is not None and goal.name in context.scene.objects
    }


class SHIGUSA_PG_settings(bpy.types.PropertyGroup):
    armature: bpy.props.PointerProperty(
        type=bpy.types.Object, name="Armature", description="Who moves; when empty, the active armature",
        poll=lambda _, one: one.type == "ARMATURE")
    right_hand: bpy.props.PointerProperty(type=bpy.types.Object, name="Right hand", description="Where it goes")
    left_hand: bpy.props.PointerProperty(type=bpy.types.Object, name="Left hand", description="Where it goes")
    right_foot: bpy.props.PointerProperty(type=bpy.types.Object, name="Right foot", description="Where its ankle goes")
    left_foot: bpy.props.PointerProperty(type=bpy.types.Object, name="Left foot", description="Where its ankle goes")
    candidates: bpy.props.IntProperty(name="Candidates", description="Different motions to be found", default=4, min=1, max=12)
    seed: bpy.props.IntProperty(name="Seed", description="Another seed finds other motions", default=1, min=0)


class SHIGUSA_OT_goal(bpy.types.Operator):
    """Add an empty where the hand or foot is now, to be moved where it shall go"""

    bl_idname = "shigusa.goal"
    bl_label = "Add a goal"
    bl_options = {"REGISTER", "UNDO"}
    effector: bpy.props.EnumProperty(items=[(one, one, "") for one in logic.EFFECTORS], options={"SKIP_SAVE"})

    @classmethod
    def poll(cls, context: Any) -> bool:
        return _armature(context) is not None

    def execute(self, context: Any) -> set[str]:
        armature = _armature(context)
        found = rig.skeleton(armature, context.evaluated_depsgraph_get())
        try:
            about = engine.Character.of_nodes(found.nodes, armature.name).about
        except engine.Failure as wrong:
            self.report({"ERROR"}, logic.refusal(wrong, armature.name))
            return {"CANCELLED"}
        prefix = found.controls.prefix if found.controls else ""
        empty = bpy.data.objects.new(f"{armature.name} {self.effector.replace('_', ' ')}", None)
        empty.empty_display_type, empty.empty_display_size = "SPHERE", 0.05 / about["placement"]["unit_m"]
        empty.location = logic.start_place(
            about, self.effector, lambda bone: armature.matrix_world @ armature.pose.bones[prefix + bone].head)
        context.scene.collection.objects.link(empty)
        setattr(context.scene.shigusa, self.effector, empty)
        return {"FINISHED"}


class SHIGUSA_OT_find(bpy.types.Operator):
    """Search motions from the present pose to the goals; Esc ends the search"""

    bl_idname = "shigusa.find"
    bl_label = "Find"

    @classmethod
    def poll(cls, context: Any) -> bool:
        return state.search is None

    def _begin(self, context: Any) -> bool:
        armature, goals = _armature(context), _goals(context)
        wrong = ""
        if armature is None:
            wrong = "choose an armature"
        elif armature.library is not None:
            wrong = f"{armature.name} is linked from another file: make a library override of it first"
        elif armature.mode == "EDIT" or armature.data.pose_position == "REST":
            wrong = f"{armature.name} shows its rest position: leave edit mode, and choose Pose Position"
        elif not goals:
            wrong = "there is no goal: add an empty for a hand or a foot, and move it"
        if wrong:
            self.report({"ERROR"}, wrong)
            return False
        scene = context.scene
        state.__init__()  # type: ignore[misc]
        state.armature, state.start = armature.name, scene.frame_current
        state.fps = scene.render.fps / scene.render.fps_base
        state.skeleton = rig.skeleton(armature, context.evaluated_depsgraph_get())
        settings = scene.shigusa
        state.search = logic.Search(
            engine, state.skeleton.nodes, armature.name, goals, candidates=settings.candidates, seed=settings.seed)
        return True

    def _end(self, context: Any) -> set[str]:
        search, state.search = state.search, None
        assert search is not None
        if search.result is None:
            state.message = search.failure or "cancelled"
            self.report({"ERROR"} if search.failure else {"INFO"}, state.message)
            return {"CANCELLED"}
        state.character, state.result = search.character, search.result
        armature = bpy.data.objects.get(state.armature)
        held = rig.constrained(armature, state.skeleton, _person()) if armature else []
        words = [logic.STATUS.get(state.result.status, "")]
        words.append("constraints hold against the motion: " + ", ".join(held) if held else "")
        state.message = "; ".join(word for word in words if word)
        _draw_pictures()
        return {"FINISHED"}

    def execute(self, context: Any) -> set[str]:
        if not self._begin(context):
            return {"CANCELLED"}
        state.search.run()
        return self._end(context)

    def invoke(self, context: Any, _event: Any) -> set[str]:
        if not self._begin(context):
            return {"CANCELLED"}
        state.search.start()
        self._timer = context.window_manager.event_timer_add(0.1, window=context.window)
        context.window_manager.modal_handler_add(self)
        return {"RUNNING_MODAL"}

    def modal(self, context: Any, event: Any) -> set[str]:
        search = state.search
        if search is not None and event.type == "ESC":
            search.cancel()
        if event.type != "TIMER":
            return {"PASS_THROUGH"}
        _redraw(context)
        if search is not None and search.is_alive():
            return {"PASS_THROUGH"}
        context.window_manager.event_timer_remove(self._timer)
        return self._end(context) if search is not None else {"CANCELLED"}


class SHIGUSA_OT_cancel(bpy.types.Operator):
    """End the search"""

    bl_idname = "shigusa.cancel"
    bl_label = "Cancel"

    def execute(self, _context: Any) -> set[str]:
        if state.search is not None:
            state.search.cancel()
        return {"FINISHED"}


class SHIGUSA_OT_apply(bpy.types.Operator):
    """Make this motion the armature's Action"""

    bl_idname = "shigusa.apply"
    bl_label = "Apply"
    bl_options = {"REGISTER", "UNDO"}
    candidate: bpy.props.IntProperty(min=0, options={"SKIP_SAVE"})

    @classmethod
    def poll(cls, context: Any) -> bool:
        return len(state.result) > 0

    def execute(self, context: Any) -> set[str]:
        if self.candidate >= len(state.result):
            self.report({"ERROR"}, f"there are {len(state.result)} candidates")
            return {"CANCELLED"}
        _choose(self.candidate)
        for name in state.parameters:
            context.scene.shigusa_sliders.property_unset(name)
        if not _play(context):
            self.report({"ERROR"}, state.message)
            return {"CANCELLED"}
        return {"FINISHED"}


def _person() -> set[str]:
    """The bones that are a person's."""
    return set(state.character.about["humanoid"].values())


def _play(context: Any) -> bool:
    """Writes the shown candidate's Action."""
    armature = bpy.data.objects.get(state.armature)
    if armature is None:
        state.message = f"the armature {state.armature} is gone"
        return False
    if set(state.skeleton.present) != set(armature.pose.bones.keys()):
        state.message = f"{state.armature} has other bones now: press Find again"
        return False
    try:
        frames = rig.motion(state.skeleton, state.character, state.shown, state.fps)
    except engine.Failure as wrong:  # such as of a rate that is out of range
        state.message = str(wrong)
        return False
    if state.skeleton.controls:
        keys = rig.control_keys(armature, state.skeleton, frames, context.view_layer)
    else:
        keys = rig.direct_keys(armature, state.skeleton, frames, _person())
    rig.write(armature, keys, state.start, f"Reach: {logic.title(state.shown)}", f"{state.token} {state.chosen}")
    context.scene.frame_set(context.scene.frame_current)
    return True


def _replay(sliders: Any) -> bool:
    """Shows the chosen candidate by the sliders' values."""
    values = {name: getattr(sliders, name) for name in state.parameters}
    changed = {name: value for name, value in values.items() if abs(value - state.parameters[name]["value"]) > 1e-5}
    try:
        state.shown = state.result[state.chosen].edit(changed) if changed else state.result[state.chosen]
    except engine.Failure as wrong:
        state.message = str(wrong)
        return False
    return True


def _slid(sliders: Any, context: Any) -> None:
    if _replay(sliders):
        _play(context)


def _choose(number: int) -> None:
    """Makes the sliders of a candidate, whose values are their defaults."""
    global slider_class
    _drop_sliders()
    state.chosen, state.shown = number, state.result[number]
    state.parameters = logic.sliders(state.shown)
    properties = {}
    for name, one in state.parameters.items():
        words = name[: -len("_deg")] if name.endswith("_deg") else name
        properties[name] = bpy.props.FloatProperty(
            name=words.replace("_", " ").capitalize() + (" °" if one["unit"] == "deg" else ""),
            description=one.get("sentence", "").rstrip("."), default=one["value"], min=one["low"], max=one["high"],
            precision=1 if one["unit"] == "deg" else 3, options={"SKIP_SAVE"}, update=_slid)
    slider_class = type("SHIGUSA_PG_sliders", (bpy.types.PropertyGroup,), {"__annotations__": properties})
    bpy.utils.register_class(slider_class)
    bpy.types.Scene.shigusa_sliders = bpy.props.PointerProperty(type=slider_class)


def _drop_sliders() -> None:
    global slider_class
    if slider_class is not None:
        del bpy.types.Scene.shigusa_sliders
        bpy.utils.unregister_class(slider_class)
        slider_class = None


def _draw_pictures() -> None:
    pictures.clear()
    found = state.skeleton
    for number, candidate in enumerate(state.result):
        frames = rig.motion(found, state.character, candidate, 10.0)
        drawn = logic.figure(found.parents, found.nodes, state.character.about, frames)
        made = pictures.new(str(number))
        made.image_size = made.icon_size = drawn.shape[:2]
        made.image_pixels_float = made.icon_pixels_float = drawn.ravel().tolist()


def _redraw(context: Any) -> None:
    for window in context.window_manager.windows:
        for area in window.screen.areas:
            if area.type == "VIEW_3D":
                area.tag_redraw()


class SHIGUSA_PT_panel(bpy.types.Panel):
    bl_idname = "SHIGUSA_PT_panel"
    bl_label = "Natural motion"
    bl_space_type = "VIEW_3D"
    bl_region_type = "UI"
    bl_category = "Shigusa"

    def draw(self, context: Any) -> None:
        layout, settings = self.layout, context.scene.shigusa
        column = layout.column(align=True)
        for name in ("armature", *logic.EFFECTORS):
            split = column.split(factor=0.36)
            split.label(text=settings.bl_rna.properties[name].name)
            row = split.row(align=True)
            row.prop(settings, name, text="")
            if name in logic.EFFECTORS and getattr(settings, name) is None:
                row.operator("shigusa.goal", text="", icon="ADD").effector = name
        column = layout.column(align=True)
        column.prop(settings, "candidates")
        column.prop(settings, "seed")
        if state.search is not None:
            row = layout.row()
            row.label(text=f"Searching: {100 * state.search.share:.0f} %")
            row.operator("shigusa.cancel", icon="X")
            return
        layout.operator("shigusa.find", icon="VIEWZOOM")
        if state.message:
            _lines(layout, state.message, "ERROR")
        for words in logic.ends(state.result[0]) if state.result else ():
            _lines(layout, words, "BONE_DATA")
        for number, candidate in enumerate(state.result):
            self._draw_candidate(layout, number, candidate)
        if state.shown is not None and hasattr(context.scene, "shigusa_sliders"):
            box = layout.box()
            for name in state.parameters:
                box.prop(context.scene.shigusa_sliders, name, slider=True)

    def _draw_candidate(self, layout: Any, number: int, candidate: Any) -> None:
        chosen = number == state.chosen
        shown = state.shown if chosen else candidate
        column = layout.box().column()
        column.operator("shigusa.apply", text=f"{number + 1}: {shown.verdict}", depress=chosen).candidate = number
        row = column.split(factor=0.45)
        if str(number) in pictures:
            row.template_icon(icon_value=pictures[str(number)].icon_id, scale=4)
        column = row.column()
        _lines(column, logic.title(shown), "NONE", 14)
        for words in logic.remarks(shown):
            _lines(column, words, "NONE", 14)


def _lines(layout: Any, text: str, icon: str, letters: int = 26) -> None:
    """A text in lines, as labels do not wrap."""
    column = layout.column(align=True)
    column.scale_y = 0.75
    lines = [""]
    for word in text.split():
        if lines[-1] and len(lines[-1]) + len(word) > letters:
            lines.append("")
        lines[-1] += (" " if lines[-1] else "") + word
    for line in lines:
        column.label(text=line, icon=icon)
        icon = "BLANK1" if icon != "NONE" else "NONE"


@bpy.app.handlers.persistent
def _forget(*_: Any) -> None:
    """Another file is loaded: what was found was of the one before."""
    if state.search is not None:
        state.search.cancel()
    state.__init__()  # type: ignore[misc]


@bpy.app.handlers.persistent
def _undone(*_: Any) -> None:
    """Shows the candidate that the armature's Action is of, after an undo or a redo."""
    armature = bpy.data.objects.get(state.armature)
    action = armature.animation_data.action if armature is not None and armature.animation_data else None
    token, _, number = str(action.get(rig.OWN, "") if action is not None else "").partition(" ")
    if token != state.token:
        state.chosen, state.shown = -1, None
        return
    if int(number) != state.chosen:
        _choose(int(number))
    _replay(bpy.context.scene.shigusa_sliders)


CLASSES = (SHIGUSA_PG_settings, SHIGUSA_OT_goal, SHIGUSA_OT_find, SHIGUSA_OT_cancel, SHIGUSA_OT_apply, SHIGUSA_PT_panel)


def register() -> None:
    global pictures
    for one in CLASSES:
        bpy.utils.register_class(one)
    bpy.types.Scene.shigusa = bpy.props.PointerProperty(type=SHIGUSA_PG_settings)
    pictures = bpy.utils.previews.new()
    bpy.app.handlers.load_post.append(_forget)
    bpy.app.handlers.undo_post.append(_undone)
    bpy.app.handlers.redo_post.append(_undone)


def unregister() -> None:
    bpy.app.handlers.load_post.remove(_forget)
    bpy.app.handlers.undo_post.remove(_undone)
    bpy.app.handlers.redo_post.remove(_undone)
    _forget()
    _drop_sliders()
    bpy.utils.previews.remove(pictures)
    del bpy.types.Scene.shigusa
    for one in reversed(CLASSES):
        bpy.utils.unregister_class(one)
