#!/usr/bin/env python3
"""Surfaces against summing the array and against SciPy (FITPACK) in one run on one core.

usage: taskset -c 0 surface_speed.py build/release/bench/surface_speed [--table]

Runs alternate; the least CPU time of each side counts. `RectBivariateSpline(s)` and ours go to the
same delta2; `bispev` is what RectBivariateSpline calls for a grid. `make bench` puts the table into
docs/benchmarks.md.
"""

import collections
import os
import subprocess
import sys
import tempfile
import time

import numpy
from scipy import interpolate

ROUNDS = 3
# ours, theirs in seconds; goal: that often faster, or below 0 that many times theirs at most.
Case = collections.namedtuple("Case", "title ours peer theirs goal remark")


def hills(x, y):
    return (numpy.sin(6 * x)[:, None] * numpy.cos(5 * y)[None, :]
            + numpy.exp(-60 * (x[:, None] - .4) ** 2 - 40 * (y[None, :] - .6) ** 2))


def timed(work):
    start = time.process_time()
    result = work()
    return time.process_time() - start, result


def batten(program, path, m, n, *arguments):
    done = subprocess.run([program, path, str(m), str(n), *arguments], check=True,
                          capture_output=True, text=True)
    return [float(word) for word in done.stdout.split()]


def data(m, n, sigma, path):
    x, y = numpy.linspace(0, 1, m), numpy.linspace(0, 1, n)
    z = hills(x, y) / sigma + numpy.random.default_rng(m).standard_normal((m, n))
    z.tofile(path)
    return x, y, z


def against_sum(program, path):
    m = n = 4096
    data(m, n, .05, path)
    times = {"sum": [], "fit": [], "report": []}
    for _ in range(ROUNDS):
        for name in times:
            strips = () if name == "sum" else ("197", "197")
            times[name].append(batten(program, path, m, n, name, *strips)[0])
    least = {name: min(values) for name, values in times.items()}
    for name, title, goal in (("fit", "the fit", -3), ("report", "with delta2 and psi", -6)):
        yield Case(f"4096 x 4096 nodes, 200 x 200 coefficients: {title}", least[name],
                   "summing the array", least["sum"], goal,
                   f"{least[name] / m / n * 1e9:.2f} ns a node")


def automatic(program, path, m, n, goal):
    x, y, z = data(m, n, .05, path)
    theirs, ours = [], []
    for _ in range(ROUNDS if m < 2000 else 1):
        seconds, spline = timed(lambda: interpolate.RectBivariateSpline(x, y, z, s=m * n))
        theirs.append(seconds)
        fp = spline.get_residual()
        ours.append(batten(program, path, m, n, "auto", repr(fp)))
    if m >= 2000:
        ours += [batten(program, path, m, n, "auto", repr(fp)) for _ in range(ROUNDS - 1)]
    tx, ty = spline.get_knots()
    yield Case(f"{m} x {n} nodes, automatic knot lines", min(run[0] for run in ours),
               "RectBivariateSpline(s)", min(theirs), goal,
               f"delta2 {ours[0][2]:.7g} against {fp:.7g}, strips {int(ours[0][3])} x "
               f"{int(ours[0][4])} against {len(tx) - 7} x {len(ty) - 7}")


def evaluation(program, path):
    m = n = 4096
    k = 64
    knots = numpy.concatenate([[0.0] * 3, numpy.linspace(0, 1, k - 2), [1.0] * 3])
    x = numpy.linspace(0, 1, m)
    c = numpy.sin(numpy.arange(k * k, dtype=float))
    ours, theirs = [], []
    for _ in range(ROUNDS):
        ours.append(batten(program, path, m, n, "evaluate", str(k)))
        theirs.append(timed(lambda: interpolate.bisplev(x, x, (knots, knots, c, 3, 3))))
    mine, (other, z) = min(run[0] for run in ours), min(theirs, key=lambda run: run[0])
    difference = abs(z.ravel()[m * n // 2] - ours[0][2])
    yield Case("4096 x 4096 values of 64 x 64 coefficients", mine, "bispev", other, 8,
               f"{mine / m / n * 1e9:.2f} ns a value; they differ by {difference:.1e}")


def cases(program):
    os.environ["OMP_NUM_THREADS"] = "1"
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "z")
        yield from against_sum(program, path)
        yield from evaluation(program, path)
        for m, n, goal in ((61, 51, 2), (512, 512, 30), (4096, 4096, 30)):
            yield from automatic(program, path, m, n, goal)


def ratio(case):
    if case.goal < 0:
        return f"takes {case.ours / case.theirs:.2f} × (goal: at most {-case.goal})"
    return f"{case.theirs / case.ours:.1f} × (goal: {case.goal})"


def table(program):
    """For docs/benchmarks.md."""
    lines = ["| | Batten | peer | peer's | ratio | |", "|---|---:|---|---:|---:|---|"]
    for case in cases(program):
        lines.append(f"| {case.title} | {case.ours * 1e3:.3g} | {case.peer} | "
                     f"{case.theirs * 1e3:.3g} | {ratio(case)} | {case.remark} |")
    return "\n".join(lines) + "\n"


def main():
    if "--table" in sys.argv:
        print(table(sys.argv[1]), end="")
        return
    for case in cases(sys.argv[1]):
        print(f"{case.title}: {case.ours * 1e3:.3g} ms, {case.peer} {case.theirs * 1e3:.3g} ms, "
              f"{ratio(case)}; {case.remark}", flush=True)


if __name__ == "__main__":
    main()
