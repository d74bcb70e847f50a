# SPDX-License-Identifier: GPL-3.0-or-later
"""Run by Blender with a window (scripts/test_addon, in Xvfb): search in a thread, cancel, undo, the panel's picture.
PICTURE after --: where it goes."""
import os
import sys
import time
import traceback

import bpy

TAB = 165  # from the sidebar's top to the middle of the add-on's tab
PICTURE = sys.argv[sys.argv.index("--") + 1]
bpy.context.preferences.view.show_splash = False
panel = sys.modules["shigusa_blender.panel"]


# small pictures
bpy.context.preferences.themes[0].view_3d.space.gradients.background_type = "SINGLE_COLOR"
bpy.context.preferences.themes[0].view_3d.space.gradients.high_gradient = (0.2, 0.2, 0.2)


def override():
    window = bpy.context.window_manager.windows[0]
    area = next(one for one in window.screen.areas if one.type == "VIEW_3D")
    region = next(one for one in area.regions if one.type == "WINDOW")
    return bpy.context.temp_override(window=window, area=area, region=region)


def click(x, y):
    """A click of the mouse at a place of the window."""
    window = bpy.context.window_manager.windows[0]
    for kind, value in (("MOUSEMOVE", "NOTHING"), ("LEFTMOUSE", "PRESS"), ("LEFTMOUSE", "RELEASE")):
        window.event_simulate(type=kind, value=value, x=x, y=y)
        yield 0.3


def steps():
    """The test; each yield lets Blender run for so many seconds."""
    yield 1
    for one in list(bpy.data.objects):
        bpy.data.objects.remove(one)
    with override():
        bpy.ops.object.armature_human_metarig_add()
        armature = bpy.context.object
        bpy.ops.shigusa.goal(effector="right_hand")
        bpy.context.scene.shigusa.right_hand.location = (-0.3, -0.45, 0.75)
        for bone in ("upper_arm.L", "upper_arm.R"):
            armature.pose.bones[bone].rotation_mode = "XYZ"
            armature.pose.bones[bone].rotation_euler = (0.2, 0.0, -0.6 if bone.endswith("L") else 0.6)
        bpy.context.view_layer.update()
        bpy.context.view_layer.objects.active = armature
        bpy.context.space_data.show_region_ui = True
        bpy.ops.view3d.view_axis(type="FRONT")
        bpy.ops.view3d.view_orbit(angle=0.7, type="ORBITLEFT")
        bpy.ops.view3d.view_orbit(angle=0.2, type="ORBITUP")
        bpy.ops.view3d.view_all()
    bpy.ops.ed.undo_push(message="Ready")
    yield 0.5

    # a search that takes long is cancelled and leaves nothing
    reach = panel.engine.reach
    panel.engine.reach = lambda who, goals, **task: reach(who, goals, **{**task, "evaluations": 10_000_000, "candidates": 1})
    with override():
        assert bpy.ops.shigusa.find("INVOKE_DEFAULT") == {"RUNNING_MODAL"}
    yield 1
    assert panel.state.search is not None and panel.state.search.is_alive(), "the search is over too early"
    bpy.ops.shigusa.cancel()
    begun = time.monotonic()
    while panel.state.search is not None:
        assert time.monotonic() < begun + 10, "the search goes on"
        yield 0.1
    assert len(panel.state.result) == 0 and not bpy.data.actions
    panel.engine.reach = reach
    print("  cancelled")

    with override():
        assert bpy.ops.shigusa.find("INVOKE_DEFAULT") == {"RUNNING_MODAL"}
        assert not bpy.ops.shigusa.find.poll(), "two searches at once"
    while panel.state.search is not None:
        yield 0.1
    assert len(panel.state.result) > 0, panel.state.message
    print("  found", len(panel.state.result))

    # applying is one step of undo
    pose = [bone.matrix.copy() for bone in armature.pose.bones]
    with override():
        assert bpy.ops.shigusa.apply("EXEC_DEFAULT", True, candidate=0) == {"FINISHED"}
        assert len(bpy.data.actions) == 1
        assert bpy.ops.ed.undo() == {"FINISHED"}
        armature = bpy.data.objects["metarig"]
        assert panel.state.chosen == -1 and not bpy.data.actions and (armature.animation_data is None or armature.animation_data.action is None)
        assert max(abs(x) for a, b in zip(pose, armature.pose.bones) for row in a - b.matrix for x in row) < 1e-6
        assert bpy.ops.ed.redo() == {"FINISHED"}
        assert len(bpy.data.actions) == 1 and bpy.data.objects["metarig"].animation_data.action
        print("  undone and done again")

        # and so is a slider, of which a user's drag is one step, and another candidate
        def curves():
            return [point.co[1] for curve in bpy.data.actions[0].fcurves for point in curve.keyframe_points]

        before, sliders = curves(), bpy.context.scene.shigusa_sliders
        value = sliders.squat_deg
        sliders.squat_deg = 70
        bpy.ops.ed.undo_push(message="Squat")
        assert curves() != before and panel.state.shown.parameters()["squat_deg"]["value"] == 70
        assert bpy.ops.ed.undo() == {"FINISHED"}
        assert curves() == before and abs(bpy.context.scene.shigusa_sliders.squat_deg - value) < 1e-4
        assert abs(panel.state.shown.parameters()["squat_deg"]["value"] - value) < 1e-4
        assert bpy.ops.shigusa.apply("EXEC_DEFAULT", True, candidate=1) == {"FINISHED"} and panel.state.chosen == 1
        assert bpy.ops.ed.undo() == {"FINISHED"} and panel.state.chosen == 0 and curves() == before
        print("  a slider and a second candidate undone")
        bpy.context.scene.frame_set(int(bpy.data.actions[0].frame_range[1]))
        bpy.ops.view3d.view_all()
    # the add-on's tab is the last of the sidebar
    area = next(one for one in bpy.context.window_manager.windows[0].screen.areas if one.type == "VIEW_3D")
    sidebar = next(one for one in area.regions if one.type == "UI")
    yield from click(sidebar.x + sidebar.width - 12, sidebar.y + sidebar.height - TAB)
    yield 2
    with override():
        bpy.ops.screen.screenshot_area(filepath=PICTURE)
    assert os.path.getsize(PICTURE) > 10_000

    # removed, nothing of it is left
    path = os.path.dirname(sys.modules["shigusa_blender"].__file__)
    with override():
        bpy.ops.preferences.addon_remove("EXEC_DEFAULT", module="shigusa_blender")
    assert not os.path.exists(path) and not hasattr(bpy.types.Scene, "shigusa"), path
    assert "shigusa_blender" not in bpy.context.preferences.addons


running = steps()


def go_on():
    try:
        return next(running)
    except StopIteration:
        print("  the window's tests passed", flush=True)
        os._exit(0)
    except BaseException:  # Blender would go on
        traceback.print_exc()
        sys.stderr.flush()
        os._exit(1)


bpy.app.timers.register(go_on, first_interval=1)
