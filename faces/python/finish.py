"""Puts the package's Python files beside the compiled module, and writes its stub file.

usage: finish.py SOURCE_FOLDER PACKAGE_FOLDER
"""

import pathlib
import shutil
import sys

source, package = (pathlib.Path(name) for name in sys.argv[1:])
for name in ("__init__.py", "_error.py", "py.typed"):
    shutil.copy(source / name, package / name)
sys.path.insert(0, str(package.parent))
from batten import _core  # noqa: E402

head = (source / "head.pyi").read_text(encoding="utf-8")
(package / "__init__.pyi").write_text(head + _core._stubs(), encoding="utf-8")
