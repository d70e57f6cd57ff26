"""Fails where the error ids of the code and those of docs/errors.md are not the same.

An id is a string like "points.too-few" that the sources hand to Error, or to a function that does.
"""

import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
WORD = r"[a-z0-9]+(?:-[a-z0-9]+)*"
LITERAL = re.compile(rf'"({WORD}\.{WORD})"')
ROW = re.compile(rf"^\| `({WORD}\.{WORD})` \|", re.MULTILINE)
FILE_SUFFIXES = {"csv", "json", "npy", "svg", "dat", "txt", "png", "pgm", "hpp", "gcode", "dxf"}


def ids_of_code():
    found = {}
    for folder in ("include", "src", "faces"):
        for path in sorted((ROOT / folder).rglob("*.[hc]pp")):
            for match in LITERAL.finditer(path.read_text(encoding="utf-8")):
                if match.group(1).rsplit(".")[-1] not in FILE_SUFFIXES:
                    found.setdefault(match.group(1), path.relative_to(ROOT))
    return found


def ids_of_docs():
    return ROW.findall((ROOT / "docs/errors.md").read_text(encoding="utf-8"))


def main():
    code, docs = ids_of_code(), ids_of_docs()
    complaints = [f"{path}: {name} is not in docs/errors.md"
                  for name, path in sorted(code.items()) if name not in docs]
    complaints += [f"docs/errors.md: {name} is thrown nowhere"
                   for name in docs if name not in code]
    complaints += [f"docs/errors.md: {name} stands twice"
                   for name in sorted(set(docs)) if docs.count(name) > 1]
    if docs != sorted(docs):
        complaints.append("docs/errors.md: the ids are not in alphabetical order")
    print("\n".join(complaints + [f"{len(code)} ids thrown, {len(docs)} documented"]))
    return 1 if complaints else 0


if __name__ == "__main__":
    sys.exit(main())
