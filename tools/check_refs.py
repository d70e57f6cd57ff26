"""Fails where a comment cites what docs/references.bib does not hold, or the other way round.

A citation reads [Key] or [Key, where]: [InoueShibata, eq. 11], [DLMF, 3.5(v)].
"""

import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
COMMENT = re.compile(r"(?://|#|^\s*\*)(.*)$", re.MULTILINE)
KEY = r"[A-Z][A-Za-z]{3,}(?:[12][0-9]{3})?"
CITATION = re.compile(rf"\[({KEY})(?:, [^\]]*)?\](?!\()")
ENTRY = re.compile(r"^@\w+\{([^,\s]+),", re.MULTILINE)


def cited():
    found = {}
    sources = [p for folder in ("include", "src", "faces", "tests", "tools", "papers")
               for p in sorted((ROOT / folder).rglob("*")) if p.suffix in (".hpp", ".cpp", ".py")]
    for path in sources:
        if path == pathlib.Path(__file__).resolve():
            continue
        # A citation may be broken over two comment lines.
        comments = " ".join(COMMENT.findall(path.read_text(encoding="utf-8")))
        for key in CITATION.findall(re.sub(r"\s*/?\s{2,}|\s+/\s+", " ", comments)):
            found.setdefault(key, path.relative_to(ROOT))
    for path in sorted((ROOT / "docs").rglob("*.md")):
        for key in CITATION.findall(path.read_text(encoding="utf-8")):
            found.setdefault(key, path.relative_to(ROOT))
    return found


def main():
    found = cited()
    known = ENTRY.findall((ROOT / "docs/references.bib").read_text(encoding="utf-8"))
    complaints = [f"{path}: [{key}] is not in docs/references.bib"
                  for key, path in sorted(found.items()) if key not in known]
    complaints += [f"docs/references.bib: {key} stands twice"
                   for key in sorted(set(known)) if known.count(key) > 1]
    print("\n".join(complaints + [f"{len(found)} works cited, {len(known)} known"]))
    return 1 if complaints else 0


if __name__ == "__main__":
    sys.exit(main())
