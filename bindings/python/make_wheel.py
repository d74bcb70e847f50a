# SPDX-License-Identifier: MIT
"""make_wheel.py LIBRARY FOLDER: packs the package and the C library into a wheel in FOLDER, and prints its path. The same
files give the same bytes."""
import base64
import ctypes
import hashlib
import pathlib
import sys
import sysconfig
import zipfile

HERE = pathlib.Path(__file__).parent
# licences of what is compiled into the library, as Debian's packages have them
LICENSES = [f"/usr/share/doc/{package}/copyright" for package in
            ("libdraco-dev", "libexpected-dev", "libfmt-dev", "libmd-dev", "nlohmann-json3-dev", "zlib1g-dev")] + ["/usr/share/common-licenses/Apache-2.0"]
METADATA = """\
Metadata-Version: 2.1
Name: shigusa
Version: {version}
Summary: Natural whole-body motions to final places of hands and feet
License: MIT
Requires-Python: >=3.9
Requires-Dist: numpy
Provides-Extra: frames
Requires-Dist: pandas; extra == "frames"
Provides-Extra: dataset
Requires-Dist: h5py; extra == "dataset"
Requires-Dist: pandas; extra == "dataset"
Requires-Dist: matplotlib; extra == "dataset"
Description-Content-Type: text/markdown

{readme}"""
WHEEL = """\
Wheel-Version: 1.0
Generator: shigusa
Root-Is-Purelib: false
Tag: {tag}
"""


def version_of(library: pathlib.Path) -> str:
    loaded = ctypes.CDLL(str(library.resolve()))
    loaded.shigusa_version.restype = ctypes.c_char_p
    return loaded.shigusa_version().decode()


def main() -> None:
    library, folder = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])
    version = version_of(library)
    tag = "py3-none-" + sysconfig.get_platform().replace("-", "_").replace(".", "_")
    about = f"shigusa-{version}.dist-info"
    files = {f"shigusa/{path.name}": path.read_bytes() for path in sorted((HERE / "shigusa").glob("*.py"))}
    files["shigusa/py.typed"] = b""
    files["shigusa/libshigusa_c.so"] = library.read_bytes()
    readme = (HERE / "README.md").read_text()
    files[f"{about}/METADATA"] = METADATA.format(version=version, readme=readme).encode()
    files[f"{about}/WHEEL"] = WHEEL.format(tag=tag).encode()
    files[f"{about}/LICENSE"] = (HERE / "../../LICENSE").read_bytes()
    for license in map(pathlib.Path, LICENSES):
        files[f"{about}/licenses/{license.parent.name}/{license.name}"] = license.read_bytes()
    record = ""
    for name, data in files.items():
        digest = base64.urlsafe_b64encode(hashlib.sha256(data).digest()).rstrip(b"=").decode()
        record += f"{name},sha256={digest},{len(data)}\n"
    files[f"{about}/RECORD"] = f"{record}{about}/RECORD,,\n".encode()
    folder.mkdir(parents=True, exist_ok=True)
    path = folder / f"shigusa-{version}-{tag}.whl"
    with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED) as wheel:
        for name, data in files.items():
            entry = zipfile.ZipInfo(name, (1980, 1, 1, 0, 0, 0))
            entry.external_attr = 0o644 << 16
            wheel.writestr(entry, data, zipfile.ZIP_DEFLATED)
    print(path)


main()
