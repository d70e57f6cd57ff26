"""Writes cases/spline_reference.json: interpolating curves as SciPy makes them.

Run it with SciPy 1.10 or later and compare: /usr/bin/python3 tools/make_spline_reference.py
The file is read by tests/versus/interpolate_scipy_test.cpp. Floats are written with the 17 digits
that give the same double back.
"""

import json
import pathlib

import numpy as np
import scipy
from scipy.interpolate import CubicSpline, PchipInterpolator

OUTPUT = pathlib.Path(__file__).resolve().parent.parent / "cases/spline_reference.json"
SEED = 20240607
PLACE = 0.375  # of a span


def parameters(points, rule):
    """One parameter a point. Batten's centripetal steps are in units of the longest chord."""
    chords = np.sqrt(np.sum(np.diff(points, axis=0) ** 2, axis=1))
    if rule == "uniform":
        steps = np.ones_like(chords)
    elif rule == "chord":
        steps = chords
    else:
        steps = chords.max() * np.sqrt(chords / chords.max())
    return np.concatenate([[0.0], np.cumsum(steps)])


def case(name, points, options, spline, breaks):
    """Value and derivative at one place inside each span."""
    at = breaks[:-1] + PLACE * np.diff(breaks)
    value, slope = (np.asarray(spline(at, order)).reshape(len(at), -1) for order in (0, 1))
    return {"name": name, "points": points.tolist(), "options": options,
            "value": value.tolist(), "derivative": slope.tolist()}


def splines(random):
    for dim in (1, 2, 3):
        for count in (3, 4, 11):
            points = random.uniform(-1, 1, (count, dim))
            if dim == 1:
                points = np.cumsum(np.abs(points) + 0.1, axis=0) * np.sign(points)
            for rule in ("uniform", "chord", "centripetal"):
                breaks = parameters(points, rule)
                for ends in ("natural", "not-a-knot", "clamped"):
                    conditions = ends
                    if ends == "clamped":
                        slopes = np.diff(points, axis=0) / np.diff(breaks)[:, None]
                        conditions = ((1, slopes[0]), (1, slopes[-1]))
                    yield case(f"{ends} {rule} {count} points in {dim}-D", points,
                               {"method": "spline", "ends": ends, "parameter": rule},
                               CubicSpline(breaks, points, bc_type=conditions), breaks)
                looped = np.concatenate([points, points[:1]])
                breaks = parameters(looped, rule)
                yield case(f"periodic {rule} {count} points in {dim}-D", points,
                           {"method": "spline", "parameter": rule, "closed": True},
                           CubicSpline(breaks, looped, bc_type="periodic"), breaks)


def given_parameters(random):
    breaks = np.cumsum(random.uniform(0.01, 3, 15)) - 7
    points = random.uniform(-5, 5, (15, 2))
    for ends in ("natural", "not-a-knot"):
        yield case(f"{ends} at given parameters", points,
                   {"method": "spline", "ends": ends, "parameter_values": breaks.tolist()},
                   CubicSpline(breaks, points, bc_type=ends), breaks)


def functions(random):
    """y(x) by pchip."""
    for count in (2, 3, 4, 12, 40):
        x = np.cumsum(random.uniform(0.1, 2, count))
        y = np.round(random.uniform(-2, 2, count), 1)
        spline = PchipInterpolator(x, y)
        yield case(f"pchip {count} points", np.column_stack([x, y]), {"method": "pchip"},
                   lambda at, order, f=spline: f(at, nu=order), x)


def main():
    random = np.random.default_rng(SEED)
    cases = [*splines(random), *given_parameters(random), *functions(random)]
    text = json.dumps({"made_with": f"SciPy {scipy.__version__}", "seed": SEED, "place": PLACE,
                       "cases": cases})
    OUTPUT.write_text(text.replace('{"name"', '\n{"name"') + "\n", encoding="utf-8")
    print(f"{OUTPUT}: {len(cases)} cases, {len(text)} bytes")


if __name__ == "__main__":
    main()
