#!/usr/bin/env python3
"""Surfaces against summing the array and against SciPy (FITPACK) in one run on one core.

usage: taskset -c 0 surface_speed.py PROGRAM    (PROGRAM: build/release/bench/surface_speed)

Runs alternate; the least time of each side counts. `RectBivariateSpline(s)` and ours go to the same
delta2; `bispev` is what RectBivariateSpline calls for a grid.
"""

import os
import subprocess
import sys
import tempfile
import time

import numpy
from scipy import interpolate

ROUNDS = 3


def hills(x, y):
    return (numpy.sin(6 * x)[:, None] * numpy.cos(5 * y)[None, :]
            + numpy.exp(-60 * (x[:, None] - .4) ** 2 - 40 * (y[None, :] - .6) ** 2))


def timed(work):
    start = time.perf_counter()
    result = work()
    return time.perf_counter() - start, result


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
    for name, limit in (("fit", 3), ("report", 6)):
        print(f"4096 x 4096, 200 x 200 coefficients, {name}: {least[name] * 1e3:.1f} ms, "
              f"{least[name] / m / n * 1e9:.2f} ns a node, {least[name] / least['sum']:.2f} x "
              f"the sum's {least['sum'] * 1e3:.1f} ms (goal {limit})")


def automatic(program, path, m, n, sigma, goal):
    x, y, z = data(m, n, sigma, path)
    theirs, ours = [], []
    for _ in range(ROUNDS if m < 2000 else 1):
        seconds, spline = timed(lambda: interpolate.RectBivariateSpline(x, y, z, s=m * n))
        theirs.append(seconds)
        fp = spline.get_residual()
        ours.append(batten(program, path, m, n, "auto", repr(fp)))
    mine, other = min(run[0] for run in ours), min(theirs)
    tx, ty = spline.get_knots()
    print(f"{m} x {n} automatic: {mine * 1e3:.2f} ms against {other * 1e3:.2f} ms, "
          f"{other / mine:.1f} x (goal {goal}); delta2 {ours[0][2]:.6g} against {fp:.6g}, strips "
          f"{int(ours[0][3])} x {int(ours[0][4])} against {len(tx) - 7} x {len(ty) - 7}")


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
    print(f"4096 x 4096 values of 64 x 64 coefficients: {mine / m / n * 1e9:.2f} ns a node, bispev "
          f"{other / m / n * 1e9:.2f}, {other / mine:.1f} x (goal 8); they differ by {difference:.1e}")


def main():
    program = sys.argv[1]
    os.environ["OMP_NUM_THREADS"] = "1"
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "z")
        against_sum(program, path)
        evaluation(program, path)
        automatic(program, path, 61, 51, .05, 2)
        automatic(program, path, 512, 512, .05, 30)
        automatic(program, path, 4096, 4096, .05, 30)


main()
