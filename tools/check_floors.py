"""Fails where an #include points up, or out of what is allowed.

The floors of docs/architecture.md, from the ground: a file includes its own floor and lower ones.
Public headers include the standard library and batten only, so that whoever uses them needs
nothing else. Files stay under 500 lines, but those that a program has made.
"""

import pathlib
import re
import sys

FLOORS = ["base", "num", "shape", "measure", "make", "io", "api", "faces"]
MOST_LINES = 500
GENERATED = "// Made by "
ROOT = pathlib.Path(__file__).resolve().parent.parent
INCLUDE = re.compile(r'^\s*#\s*include\s*([<"])([^>"]+)[>"]', re.MULTILINE)
SOURCES = (".hpp", ".cpp")


def files(folder):
    return sorted(p for p in (ROOT / folder).rglob("*") if p.suffix in SOURCES)


def floor_of(path):
    """The floor that a path below include/batten, src or faces belongs to, or None."""
    parts = path.relative_to(ROOT).parts
    if parts[0] == "faces":
        return "faces"
    below = parts[2:] if parts[0] == "include" else parts[1:]
    return below[0] if below[0] in FLOORS else None


def target_of(name):
    """The file of this project that an include names, or None."""
    for folder in ("include", "src", "faces"):
        if (ROOT / folder / name).is_file():
            return ROOT / folder / name
    return None


def include_breach(path, mark, name):
    public = path.is_relative_to(ROOT / "include")
    target = target_of(name)
    if target is None and (path.parent / name).is_file():
        target = path.parent / name
    if target is None:
        outside = "." in name or "/" in name
        if mark == '"':
            return f'"{name}" is no file of this project'
        return f"<{name}> in a public header" if public and outside else None
    if public and not target.is_relative_to(ROOT / "include"):
        return f'private "{name}" in a public header'
    here, there = floor_of(path), floor_of(target)
    if here is None:  # the umbrella header is the table of contents of all floors
        return None
    if there is None:
        return f'"{name}" stands above all floors'
    if FLOORS.index(there) > FLOORS.index(here):
        return f'"{name}" is on floor {there}, above {here}'
    return None


def breaches_of(path):
    text = path.read_text(encoding="utf-8")
    for match in INCLUDE.finditer(text):
        breach = include_breach(path, *match.groups())
        if breach:
            yield text.count("\n", 0, match.start()) + 1, breach


def long_files():
    for path in [p for folder in ("include", "src", "faces", "tests") for p in files(folder)]:
        text = path.read_text(encoding="utf-8")
        lines = text.count("\n")
        if lines > MOST_LINES and not text.startswith(GENERATED):
            yield path, lines, f"longer than {MOST_LINES} lines"


def main():
    found = list(long_files())
    checked = [p for folder in ("include", "src", "faces") for p in files(folder)]
    for path in checked:
        found += [(path, line, breach) for line, breach in breaches_of(path)]
    for path, line, breach in found:
        print(f"{path.relative_to(ROOT)}:{line}: {breach}")
    print(f"{len(checked)} files, {len(found)} breaches")
    return 1 if found or not checked else 0


if __name__ == "__main__":
    sys.exit(main())
