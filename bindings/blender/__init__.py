# SPDX-License-Identifier: GPL-3.0-or-later
"""Natural whole-body motions to empties: the add-on shigusa for Blender."""

bl_info = {
    "name": "shigusa",
    "description": "Natural whole-body motions that bring hands and feet to empties",
    "author": "The authors of shigusa",
    "version": (0, 0, 0),
    "blender": (3, 4, 0),
    "location": "3D View > Sidebar > Shigusa",
    "category": "Animation",
}

if "bpy" in locals():  # the add-on is enabled again
    import importlib

    for module in (logic, rig, panel):  # noqa: F821
        importlib.reload(module)
else:
    import bpy  # noqa: F401

    from . import logic, panel, rig


def register() -> None:
    panel.register()


def unregister() -> None:
    panel.unregister()
