"""SciPy at the work of the C++ benchmarks, on the same numbers: JSON lines of name and ns per item.

usage: scipy_peers.py OPERATION
"""

import json
import sys
import time

import numpy
from scipy import interpolate

COUNT = 10 ** 6
SHORTEST = 0.1  # seconds that each is measured for


def ns(work, items):
    runs, start = 0, time.process_time()
    while runs == 0 or time.process_time() - start < SHORTEST:
        work()
        runs += 1
    return (time.process_time() - start) / runs / items * 1e9


def told(operation, peer, size, work, items):
    work()
    print(json.dumps({"name": f"{operation}/{peer}/{size}", "ns": ns(work, items)}), flush=True)


def wave(n):
    i = numpy.arange(float(n))
    return numpy.stack([i + .3 * numpy.sin(i), numpy.sin(.7 * i) + .2 * numpy.cos(1.9 * i)], axis=1)


def natural_spline():
    for n in (10, 1000, 10 ** 4, 10 ** 5, 10 ** 6):
        points = wave(n)

        def work():
            chords = numpy.sqrt((numpy.diff(points, axis=0) ** 2).sum(axis=1))
            interpolate.CubicSpline(numpy.concatenate([[0], numpy.cumsum(chords)]), points,
                                    bc_type="natural")

        told("natural-spline", "SciPy", n, work, n)


def evaluate(operation, order):
    for knots in (100, 10 ** 4):
        x = numpy.arange(float(knots))
        y = numpy.sin(.7 * x)
        t = numpy.random.default_rng(1).uniform(0, knots - 1, COUNT)
        if operation != "evaluate-random":
            t.sort()
        spline = interpolate.make_interp_spline(x, y, 3)
        pieces = interpolate.CubicSpline(x, y, bc_type="natural")
        for peer, curve in (("SciPy BSpline", spline), ("SciPy PPoly", pieces)):
            told(operation, peer, knots,
                 lambda c=curve: [c(t, nu) for nu in range(order + 1)], COUNT)


WORKS = {"natural-spline": natural_spline,
         "evaluate-sorted": lambda: evaluate("evaluate-sorted", 0),
         "evaluate-random": lambda: evaluate("evaluate-random", 0),
         "evaluate-derivatives": lambda: evaluate("evaluate-derivatives", 2)}

if sys.argv[1] in WORKS:
    WORKS[sys.argv[1]]()
