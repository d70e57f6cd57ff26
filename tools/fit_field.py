#!/usr/bin/env python3
"""Fits beside the field: mean squared errors and effective parameters of Batten, SciPy's smoothing
spline by GCV, mgcv by REML, and FITPACK given the best s there is (by the truth).

usage: fit_field.py COMMAND [--seeds 100] [--sizes 201,1024,2048] [--functions Blocks,Bumps]
                    [--without mgcv]

The four functions of [DonohoJohnstone1994] and a bathtub, scaled so that their standard
deviation is the signal-to-noise ratio and the noise 1. Batten and FITPACK are told the noise. Prints
one row a cell, medians and means over seeds, ready for docs/fitting.md.
"""

import argparse
import json
import os
import subprocess
import sys
import tempfile
import warnings

import numpy
from scipy import interpolate
from scipy.interpolate import _bsplines

R_PROGRAM = """
suppressMessages(library(mgcv))
files <- commandArgs(trailingOnly = TRUE)
d <- as.matrix(read.csv(files[1], header = FALSE))
x <- d[, 1]; n <- length(x)
out <- matrix(0, n + 1, ncol(d) - 1)
for (j in 2:ncol(d)) {
  y <- d[, j]
  g <- gam(y ~ s(x, bs = "cr", k = min(round(n / 4), 200)), method = "REML")
  out[, j - 1] <- c(fitted(g), sum(g$edf))
}
write.table(out, files[2], sep = ",", row.names = FALSE, col.names = FALSE)
"""


def blocks(x):
    at = [.1, .13, .15, .23, .25, .40, .44, .65, .76, .78, .81]
    height = [4, -5, 3, -4, 5, -4.2, 2.1, 4.3, -3.1, 2.1, -4.2]
    return sum(h * (1 + numpy.sign(x - t)) / 2 for t, h in zip(at, height))


def bumps(x):
    at = [.1, .13, .15, .23, .25, .40, .44, .65, .76, .78, .81]
    height = [4, 5, 3, 4, 5, 4.2, 2.1, 4.3, 3.1, 5.1, 4.2]
    width = [.005, .005, .006, .01, .01, .03, .01, .01, .005, .008, .005]
    return sum(h * (1 + numpy.abs((x - t) / w)) ** -4 for t, h, w in zip(at, height, width))


def heavisine(x):
    return 4 * numpy.sin(4 * numpy.pi * x) - numpy.sign(x - .3) - numpy.sign(.72 - x)


def doppler(x):
    return numpy.sqrt(x * (1 - x)) * numpy.sin(2.1 * numpy.pi / (x + .05))


def bathtub(x):
    return numpy.exp(-40 * x) + numpy.exp(60 * (x - 1))


FUNCTIONS = {"Blocks": blocks, "Bumps": bumps, "HeaviSine": heavisine, "Doppler": doppler,
             "bathtub": bathtub}


def batten(command, x, y, folder, *more):
    table, rows, report = (os.path.join(folder, name) for name in ("d.csv", "o.csv", "r.json"))
    numpy.savetxt(table, numpy.column_stack([x, y]), delimiter=",", header="x,y", comments="")
    subprocess.run([command, "fit", table, "--sigma", "1", "-o", rows, "--report", report,
                    "--quiet", *more], check=True)
    with open(report, encoding="utf-8") as stream:
        parameters = json.load(stream)["report"]["parameters"]
    return numpy.loadtxt(rows, delimiter=",", skiprows=1)[:, 3], parameters


class Lambda:
    """Keeps the penalty that SciPy's GCV finds."""

    def __init__(self):
        self.find = _bsplines._compute_optimal_gcv_parameter
        _bsplines._compute_optimal_gcv_parameter = self
        self.value = None

    def __call__(self, *arguments):
        self.value = self.find(*arguments)
        return self.value


def smoothing(x, y, penalty, random):
    fit = interpolate.make_smoothing_spline(x, y)(x)
    # The trace of the smoother by random signs (Hutchinson).
    traces = []
    for _ in range(4):
        z = random.choice([-1., 1.], len(x))
        traces.append(z @ interpolate.make_smoothing_spline(x, z, lam=penalty.value)(x))
    return fit, numpy.mean(traces)


def fitpack(x, y, truth):
    best = None
    for share in numpy.concatenate([numpy.linspace(.5, 1.3, 33), [1.5, 2, 3]]):
        knots, c, degree = interpolate.splrep(x, y, w=numpy.ones_like(x), s=share * len(x))
        fit = interpolate.splev(x, (knots, c, degree))
        error = numpy.mean((fit - truth) ** 2)
        if best is None or error < best[0]:
            best = error, fit, len(knots) - degree - 1
    return best[1], best[2]


def mgcv(x, columns, folder):
    data, out = os.path.join(folder, "m.csv"), os.path.join(folder, "mo.csv")
    program = os.path.join(folder, "m.R")
    numpy.savetxt(data, numpy.column_stack([x, *columns]), delimiter=",")
    with open(program, "w", encoding="utf-8") as stream:
        stream.write(R_PROGRAM)
    subprocess.run(["Rscript", program, data, out], check=True)
    table = numpy.loadtxt(out, delimiter=",", ndmin=2)
    return [(table[:-1, j], table[-1, j]) for j in range(len(columns))]


def cell(arguments, function, n, ratio, folder, penalty):
    x = (numpy.arange(n) + .5) / n
    truth = function(x)
    truth = truth * ratio / numpy.std(truth)
    random = numpy.random.default_rng([n, ratio])
    samples = [truth + random.standard_normal(n) for _ in range(arguments.seeds)]
    fits = {"Batten": [batten(arguments.command, x, y, folder) for y in samples],
            "Batten, pruned": [batten(arguments.command, x, y, folder, "--knots", "pruned")
                               for y in samples],
            "SciPy GCV": [smoothing(x, y, penalty, random) for y in samples],
            "FITPACK best s": [fitpack(x, y, truth) for y in samples]}
    if arguments.without != "mgcv":
        fits["mgcv"] = mgcv(x, samples, folder)
    return {name: (numpy.mean([numpy.mean((f - truth) ** 2) for f, _ in list_]),
                   numpy.mean([p for _, p in list_])) for name, list_ in fits.items()}


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("command")
    parser.add_argument("--seeds", type=int, default=100)
    parser.add_argument("--sizes", default="201,1024,2048")
    parser.add_argument("--functions", default=",".join(FUNCTIONS))
    parser.add_argument("--without", default="")
    arguments = parser.parse_args()
    warnings.simplefilter("ignore")
    penalty = Lambda()
    wins, cells = {"Batten": 0, "Batten, pruned": 0}, 0
    slim, both = dict(wins), dict(wins)
    names = None
    with tempfile.TemporaryDirectory() as folder:
        for label in arguments.functions.split(","):
            function = FUNCTIONS[label]
            for n in (int(text) for text in arguments.sizes.split(",")):
                for ratio in (3, 7):
                    result = cell(arguments, function, n, ratio, folder, penalty)
                    if names is None:
                        names = list(result)
                        print("| | N | S/N | " + " | ".join(names) + " | |")
                        print("|---" * (len(names) + 4) + "|")
                    best = min(r for name, r in result.items() if name not in wins)
                    marks = []
                    for name in wins:
                        near = result[name][0] <= 1.1 * best[0]
                        half = result[name][1] <= .5 * best[1]
                        wins[name] += near
                        slim[name] += half
                        both[name] += near and half
                        marks.append(("✓" if near else "–") + ("½" if half else ""))
                    cells += 1
                    print(f"| {label} | {n} | {ratio} | " + " | ".join(
                        f"{error:.4g} ({count:.0f})" for error, count in result.values()) +
                        f" | {' '.join(marks)} |")
                    sys.stdout.flush()
    for name in wins:
        print(f"\n{name}: best or within 10 % of the best other in {wins[name]} of {cells} cells; at "
              f"most half the parameters of the best other in {slim[name]}; both in {both[name]}")


main()
