# SPDX-License-Identifier: GPL-3.0-or-later
"""make_addon.py LIBRARY FOLDER: packs the add-on, the Python package and the C library into a zip in FOLDER, and prints
its path. The same files give the same bytes."""
import ctypes
import pathlib
import sys
import zipfile

HERE = pathlib.Path(__file__).parent
library, folder = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2])
loaded = ctypes.CDLL(str(library))
loaded.shigusa_version.restype = ctypes.c_char_p
version = loaded.shigusa_version().decode()

files = {name: (HERE / name).read_bytes() for name in ("logic.py", "rig.py", "panel.py", "README.md")}
for name, unset, told in (
    ("__init__.py", "(0, 0, 0)", str(tuple(int(part) for part in version.split(".")))),
    ("blender_manifest.toml", '"0.0.0"', f'"{version}"'),
):
    text = (HERE / name).read_text()
    if text.count(unset) != 1:
        sys.exit(f"{name} does not have {unset} once")
    files[name] = text.replace(unset, told).encode()
package = HERE / "../python/shigusa"
files |= {f"shigusa/{path.name}": path.read_bytes() for path in sorted(package.glob("*.py"))}
files["shigusa/LICENSE"] = (HERE / "../../LICENSE").read_bytes()
files["shigusa/libshigusa_c.so"] = library.read_bytes()

folder.mkdir(parents=True, exist_ok=True)
target = folder / f"shigusa_blender-{version}.zip"
with zipfile.ZipFile(target, "w", zipfile.ZIP_DEFLATED) as made:
    for name, data in files.items():
        entry = zipfile.ZipInfo(f"shigusa_blender/{name}", (1980, 1, 1, 0, 0, 0))
        entry.external_attr = 0o644 << 16
        made.writestr(entry, data, zipfile.ZIP_DEFLATED)
print(target)
