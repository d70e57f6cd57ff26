#!/usr/bin/env python3
"""Parametric curves by every way to place knots: the table of docs/fitting.md.

usage: curve_knots.py COMMAND FOLDER    (FOLDER: with rae2822.dat and clarky.dat)

Rounded rectangle and square get noise of the sigma they are fitted with, of seed 1.
"""

import json
import os
import subprocess
import sys
import tempfile
import time

import numpy


def rounded_rectangle(count):
    """20 x 10, corners of radius 2, at equal steps."""
    quarter = numpy.pi
    lengths = [8, quarter, 6, quarter, 16, quarter, 6, quarter, 8]
    centers = [(8, -3), (8, 3), (-8, 3), (-8, -3)]
    starts = [(0, -5), (10, -3), (8, 5), (-10, 3), (-8, -5)]
    ways = [(1, 0), (0, 1), (-1, 0), (0, -1), (1, 0)]
    points = []
    for s in sum(lengths) * numpy.arange(count) / count:
        part = 0
        while part < 8 and s > lengths[part]:
            s -= lengths[part]
            part += 1
        if part % 2 == 0:
            points.append(numpy.add(starts[part // 2], numpy.multiply(s, ways[part // 2])))
        else:
            angle = .5 * numpy.pi * (part // 2 - 1) + s / 2
            points.append(numpy.add(centers[part // 2],
                                    (2 * numpy.cos(angle), 2 * numpy.sin(angle))))
    return numpy.array(points)


def square(count):
    s = 4 * numpy.arange(count) / count
    side, along = numpy.divmod(s, 1)
    corners = numpy.array([(0, 0), (1, 0), (1, 1), (0, 1), (0, 0)])
    at = side.astype(int)
    return corners[at] + along[:, None] * (corners[at + 1] - corners[at])


def fitted(command, path, sigma, knots, closed, folder):
    report = os.path.join(folder, "report.json")
    start = time.perf_counter()
    subprocess.run([command, "fit", path, "--parametric", "--sigma", repr(sigma), "--knots", knots,
                    "--report", report, *(["--closed"] if closed else [])],
                   check=True, capture_output=True)
    elapsed = time.perf_counter() - start
    with open(report) as stream:
        return json.load(stream)["report"], elapsed


def main():
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    command, data = sys.argv[1:]
    random = numpy.random.default_rng(1)
    with tempfile.TemporaryDirectory() as folder:
        cases = [("aerofoil RAE 2822", os.path.join(data, "rae2822.dat"), 1e-4, False),
                 ("aerofoil Clark Y", os.path.join(data, "clarky.dat"), 1e-4, False)]
        for name, points, sigma in (("rounded rectangle", rounded_rectangle(200), .005),
                                    ("square", square(120), .002)):
            path = os.path.join(folder, name + ".csv")
            noisy = points + sigma * random.standard_normal(points.shape)
            numpy.savetxt(path, noisy, delimiter=",", header="x,y", comments="")
            cases.append((name, path, sigma, True))
        for name, path, sigma, closed in cases:
            cells = []
            for knots in ("auto", "pruned", "free"):
                report, seconds = fitted(command, path, sigma, knots, closed, folder)
                rms = sigma * (report["delta2"] / report["samples"]) ** .5
                cells.append(f"{len(report['coefficients'])}; {rms:.2g}; {report['bic']:.0f}; "
                             f"{seconds:.3f} s")
            print("|", name, "|", " | ".join(cells), "|", flush=True)


main()
