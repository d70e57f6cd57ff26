"""Reads DXF files back with ezdxf and compares them with what was meant.

    read_dxf.py CASES.json

CASES.json: [{"file": PATH, "version": "AC1015", "entities": [...]}], each entity with its "type",
"layer" and, as far as it has them, "points" [[x, y, z, bulge]], "closed", "arc" [cx, cy, radius,
start, end] in degrees, "degree", "weights" and "samples" [[t, x, y, z]] of a spline.
Exit status 0: all agree; 1: they do not; 77: ezdxf is not installed.
"""
import json
import sys

try:
    import ezdxf
except ImportError:
    sys.exit(77)

faults = []


def expect(truth, *words):
    if not truth:
        faults.append(" ".join(str(word) for word in words))


def near(a, b, tolerance=1e-12):
    scale = max([1.0] + [abs(x) for x in b])
    return len(a) == len(b) and all(abs(x - y) <= tolerance * scale for x, y in zip(a, b))


def vertices(entity):
    if entity.dxftype() == "LWPOLYLINE":
        return [[x, y, 0.0, bulge] for x, y, bulge in entity.get_points("xyb")]
    return [list(v.dxf.location.xyz) + [v.dxf.get("bulge", 0.0)] for v in entity.vertices]


def compare(entity, meant):
    name = entity.dxftype()
    expect(name == meant["type"], name, "is not", meant["type"])
    expect(entity.dxf.layer == meant["layer"], "layer", entity.dxf.layer)
    if name in ("LWPOLYLINE", "POLYLINE"):
        closed = entity.closed if name == "LWPOLYLINE" else entity.is_closed
        expect(bool(closed) == meant["closed"], name, "closed", closed)
        found = vertices(entity)
        expect(found == meant["points"], name, found, "is not", meant["points"])
    if name == "LINE":
        found = [list(entity.dxf.start.xyz), list(entity.dxf.end.xyz)]
        expect(found == [p[:3] for p in meant["points"]], "LINE", found)
    if name == "ARC":
        dxf = entity.dxf
        found = [dxf.center.x, dxf.center.y, dxf.radius, dxf.start_angle, dxf.end_angle]
        expect(near(found, meant["arc"]), "ARC", found, "is not", meant["arc"])
    if name == "SPLINE":
        curve = entity.construction_tool()
        expect(entity.dxf.degree == meant["degree"], "degree", entity.dxf.degree)
        expect(bool(entity.closed) == meant["closed"], "closed", entity.closed)
        expect(list(entity.weights) == meant["weights"], "weights", list(entity.weights))
        for t, *point in meant["samples"]:
            found = list(curve.point(t).xyz)
            expect(near(found, point, 1e-11), "at", t, found, "is not", point)


def main():
    with open(sys.argv[1], encoding="utf-8") as file:
        cases = json.load(file)
    count = 0
    for case in cases:
        document = ezdxf.readfile(case["file"])
        auditor = document.audit()
        for problem in list(auditor.errors) + list(auditor.fixes):
            faults.append(f"{case['file']}: {problem.message}")
        expect(document.dxfversion == case["version"], "version", document.dxfversion)
        entities = list(document.modelspace())
        expect(len(entities) == len(case["entities"]), case["file"], len(entities), "entities")
        for entity, meant in zip(entities, case["entities"]):
            compare(entity, meant)
            count += 1
    for fault in faults:
        print(fault)
    print(f"{count} entities in {len(cases)} files, {len(faults)} faults")
    sys.exit(1 if faults else 0)


if __name__ == "__main__":
    main()
