"""Fails where the shared library shows a name that its public headers do not.

Usage: check_exports.py NM LIBRARY

Allowed are the types and functions that stand directly in namespace batten and in a public header,
and the tables that the compiler makes for these types.
"""

import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
NAME = re.compile(
    r"(?:vtable for |typeinfo for |typeinfo name for )?"
    r"batten::(?:([A-Z]\w*)(?:::|$)|([a-z_]\w*)(?:\[abi:cxx11\])?(?:\(|$)|(operator))"
)
NEEDED = ("batten::Curve::", "typeinfo for batten::Error")


def exported(nm, library):
    answer = subprocess.run(
        [nm, "-DC", "--defined-only", library], check=True, capture_output=True, text=True
    )
    return sorted({line.split(maxsplit=2)[2] for line in answer.stdout.splitlines()})


def words_of_headers():
    texts = (path.read_text(encoding="utf-8") for path in (ROOT / "include").rglob("*.hpp"))
    return {word for text in texts for word in re.findall(r"\w+", text)}


def is_public(name, words):
    match = NAME.match(name)
    return bool(match) and next(filter(None, match.groups())) in words


def main():
    names, words = exported(*sys.argv[1:3]), words_of_headers()
    leaks = [name for name in names if not is_public(name, words)]
    missing = [part for part in NEEDED if not any(name.startswith(part) for name in names)]
    for name in leaks:
        print(f"in no public header, yet exported: {name}")
    for part in missing:
        print(f"in a public header, yet not exported: {part}")
    print(f"{len(names)} names exported")
    return 1 if leaks or missing else 0


if __name__ == "__main__":
    sys.exit(main())
