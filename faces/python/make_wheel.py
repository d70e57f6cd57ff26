"""Packs the built package as a wheel, a zip of a known form (PEP 427); no network, no build tool.

usage: make_wheel.py PACKAGE_FOLDER VERSION LICENCE OUTPUT_FOLDER
"""

import base64
import hashlib
import pathlib
import sys
import sysconfig
import zipfile

METADATA = """Metadata-Version: 2.1
Name: batten
Version: {version}
Summary: Fair curves and surfaces from points, and how good they are
License: MIT
Requires-Python: >=3.9
Requires-Dist: numpy
"""
WHEEL = "Wheel-Version: 1.0\nGenerator: batten\nRoot-Is-Purelib: false\nTag: {tag}\n"


def tag():
    python = f"cp{sys.version_info.major}{sys.version_info.minor}"
    return f"{python}-{python}-{sysconfig.get_platform().replace('-', '_').replace('.', '_')}"


def members(package, version, licence):
    """Names in the archive and their bytes."""
    for path in sorted(package.iterdir()):
        if path.is_file():
            yield f"batten/{path.name}", path.read_bytes()
    info = f"batten-{version}.dist-info"
    yield f"{info}/METADATA", METADATA.format(version=version).encode()
    yield f"{info}/WHEEL", WHEEL.format(tag=tag()).encode()
    yield f"{info}/LICENSE", licence.read_bytes()


def record_line(name, content):
    digest = base64.urlsafe_b64encode(hashlib.sha256(content).digest()).rstrip(b"=").decode()
    return f"{name},sha256={digest},{len(content)}\n"


def main():
    package, version, licence, folder = sys.argv[1:]
    wheel = pathlib.Path(folder) / f"batten-{version}-{tag()}.whl"
    wheel.parent.mkdir(parents=True, exist_ok=True)
    record, name = "", f"batten-{version}.dist-info/RECORD"
    with zipfile.ZipFile(wheel, "w", zipfile.ZIP_DEFLATED) as archive:
        for member, content in members(pathlib.Path(package), version, pathlib.Path(licence)):
            # The same bytes give the same wheel: no clock in it.
            archive.writestr(zipfile.ZipInfo(member), content, zipfile.ZIP_DEFLATED)
            record += record_line(member, content)
        archive.writestr(zipfile.ZipInfo(name), record + f"{name},,\n", zipfile.ZIP_DEFLATED)
    print(wheel)


main()
