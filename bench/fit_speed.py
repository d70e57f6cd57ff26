#!/usr/bin/env python3
"""Fits against SciPy (FITPACK) in one run on one core: seconds and their ratios.

usage: taskset -c 0 fit_speed.py PROGRAM    (PROGRAM: build/release/bench/fit_speed)

Runs alternate; the least time of each side counts. Fixed knots: 1,000 equal intervals, N = 10^6.
Automatic knots: to delta2 = N sigma^2, which is what splrep's s stands for.
"""

import os
import subprocess
import sys
import tempfile
import time

import numpy
from scipy import interpolate

ROUNDS = 3


def bump(x):
    return numpy.exp(-50 * (x - .4) ** 2) + .5 * numpy.sin(6 * x)


def chirp(x):
    return numpy.sin(2 * numpy.pi * (1 + 12 * x) * x)


def timed(work):
    start = time.perf_counter()
    result = work()
    return time.perf_counter() - start, result


def batten(program, path, *arguments):
    done = subprocess.run([program, path, *arguments], check=True, capture_output=True, text=True)
    least, _, delta2, intervals, copy = done.stdout.split()
    return float(least), float(delta2), int(intervals), float(copy)


def data(function, n, sigma, path, shuffled=False):
    random = numpy.random.default_rng(n)
    x = numpy.sort(random.random(n))
    y = function(x) / sigma + random.standard_normal(n)
    order = random.permutation(n) if shuffled else slice(None)
    numpy.concatenate([x[order], y[order]]).tofile(path)
    return x, y


def fixed(program, path):
    n, intervals = 10 ** 6, 1000
    x, y = data(chirp, n, .1, path)
    knots = numpy.concatenate([[x[0]] * 4, numpy.linspace(x[0], x[-1], intervals + 1)[1:-1],
                               [x[-1]] * 4])
    ours, theirs = [], []
    for _ in range(ROUNDS):
        ours.append(batten(program, path, "fixed", str(intervals)))
        theirs.append(timed(lambda: interpolate.make_lsq_spline(x, y, knots, 3))[0])
    mine, other = min(t[0] for t in ours), min(theirs)
    print(f"copying a double: {min(t[3] for t in ours) * 1e9:.2f} ns")
    print(f"fixed knots, N = {n}, {intervals} intervals: {mine * 1e9 / n:.2f} ns/point, "
          f"make_lsq_spline {other * 1e9 / n:.1f}: {other / mine:.1f} x")
    weighted = min(batten(program, path, "weighted", str(intervals))[0] for _ in range(ROUNDS))
    print(f"  the same, an error for every sample: {weighted * 1e9 / n:.2f} ns/point")
    data(chirp, n, .1, path, shuffled=True)
    print(f"  the same, not sorted: {batten(program, path, 'fixed', str(intervals))[0] * 1e9 / n:.1f}"
          f" ns/point; numpy.argsort of as many: "
          f"{timed(lambda: numpy.argsort(numpy.random.random(n)))[0] * 1e9 / n:.1f}")


def automatic(program, path):
    for name, function in (("bump", bump), ("chirp", chirp)):
        for n in (201, 10 ** 4, 10 ** 6):
            x, y = data(function, n, .1, path)
            ours, theirs, knots = [], [], 0
            for _ in range(ROUNDS if n < 10 ** 6 else 1):
                elapsed, (result, fp, *_) = timed(lambda: interpolate.splrep(
                    x, y, w=numpy.ones_like(x), s=n, full_output=1))
                theirs.append(elapsed)
                knots = len(result[0]) - 8
                # To the residual that the other reached: at N = 10^6 it may be a little above s.
                ours.append(batten(program, path, "auto", repr(max(n, fp))))
            mine, other = min(t[0] for t in ours), min(theirs)
            print(f"automatic knots, {name}, N = {n}: {mine * 1e3:.3f} ms, splrep "
                  f"{other * 1e3:.2f} ms: {other / mine:.1f} x; knots {ours[0][2] - 1} to {knots}: "
                  f"{(ours[0][2] - 1) / max(knots, 1):.2f}; delta2/N {ours[0][1] / n:.4f} to "
                  f"{fp / n:.4f}")
            sys.stdout.flush()


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "data.bin")
        fixed(sys.argv[1], path)
        automatic(sys.argv[1], path)


main()
