# SPDX-License-Identifier: GPL-3.0-or-later
"""Run by Blender: installs the zip after -- as the preferences' Install button does, and keeps it enabled."""
import sys

import bpy

bpy.ops.preferences.addon_install(filepath=sys.argv[sys.argv.index("--") + 1])
for module in ("rigify", "shigusa_blender"):
    bpy.ops.preferences.addon_enable(module=module)
bpy.context.preferences.view.show_splash = False
bpy.ops.wm.save_userpref()
