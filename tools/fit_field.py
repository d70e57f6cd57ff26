#!/usr/bin/env python3
"""Fits beside the field: mean squared errors and effective parameters of Batten, SciPy's smoothing
spline by GCV, mgcv by REML, and FITPACK given the best s there is (by the truth).

usage: fit_field.py [COMMAND] [--peers FILE] [--seeds 100] [--sizes 201,1024,2048]
                    [--functions Blocks,Bumps] [--without mgcv]

The four functions of [DonohoJohnstone1994] and a bathtub, scaled so that their standard
deviation is the signal-to-noise ratio and the noise 1. Batten and FITPACK are told the noise. Every
seed draws its own noise, so that a few seeds are the beginning of many. Prints one row a cell, means
over seeds, ready for docs/fitting.md. --peers keeps what the others found, a line of JSON for each
fit; what the file holds is not computed again. Without COMMAND only that file is filled.
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


class Cell:
    """A function at one number of samples and one ratio of signal to noise."""

    def __init__(self, label, n, ratio):
        self.label, self.n, self.ratio = label, n, ratio
        self.x = (numpy.arange(n) + .5) / n
        truth = FUNCTIONS[label](self.x)
        self.truth = truth * ratio / numpy.std(truth)

    def random(self, seed, stream=0):
        key = [list(FUNCTIONS).index(self.label), self.n, self.ratio, seed, stream]
        return numpy.random.default_rng(key)

    def sample(self, seed):
        return self.truth + self.random(seed).standard_normal(self.n)

    def error(self, fit):
        return float(numpy.mean((fit - self.truth) ** 2))


class Peers:
    """What the others found, by cell, seed and peer; appended to a file if there is one."""

    NAMES = ["SciPy GCV", "FITPACK best s", "mgcv"]
    BLOCK = 10

    def __init__(self, path, without, folder):
        self.names = [name for name in self.NAMES if name not in without.split(",")]
        self.path, self.folder, self.penalty, self.found = path, folder, Lambda(), {}
        if path and os.path.exists(path):
            with open(path, encoding="utf-8") as stream:
                for row in map(json.loads, stream):
                    key = row["function"], row["n"], row["ratio"], row["seed"], row["peer"]
                    self.found[key] = row["error"], row["parameters"]

    def _fits(self, name, cell, seeds):
        samples = [cell.sample(seed) for seed in seeds]
        if name == "mgcv":
            return mgcv(cell.x, samples, self.folder)
        if name == "SciPy GCV":
            return [smoothing(cell.x, y, self.penalty, cell.random(seed, 1))
                    for y, seed in zip(samples, seeds)]
        return [fitpack(cell.x, y, cell.truth) for y in samples]

    def fill(self, cells, seeds):
        """Blocks of seeds are the outermost loop: stopped early, every cell has as many."""
        for first in range(0, seeds, self.BLOCK):
            for cell in cells:
                for name in self.names:
                    self._fill(name, cell, range(first, min(first + self.BLOCK, seeds)))

    def _fill(self, name, cell, seeds):
        key = cell.label, cell.n, cell.ratio
        missing = [seed for seed in seeds if (*key, seed, name) not in self.found]
        if not missing:
            return
        lines = []
        for seed, (fit, count) in zip(missing, self._fits(name, cell, missing)):
            result = cell.error(fit), float(count)
            self.found[(*key, seed, name)] = result
            lines.append(json.dumps(dict(zip(
                ("function", "n", "ratio", "seed", "peer", "error", "parameters"),
                (*key, seed, name, *result)))) + "\n")
        if self.path:
            with open(self.path, "a", encoding="utf-8") as stream:
                stream.writelines(lines)

    def means(self, cell, seeds):
        key = cell.label, cell.n, cell.ratio
        return {name: numpy.mean([self.found[(*key, seed, name)] for seed in range(seeds)], axis=0)
                for name in self.names}


OURS = {"Batten": [], "Batten, pruned": ["--knots", "pruned"]}


def ours(command, cell, seeds, folder):
    """Means of error and parameters of both modes."""
    means = {}
    for name, more in OURS.items():
        fits = [batten(command, cell.x, cell.sample(seed), folder, *more) for seed in range(seeds)]
        means[name] = numpy.mean([(cell.error(fit), count) for fit, count in fits], axis=0)
    return means


def table(arguments, cells, peers, folder):
    near, slim, both = ({name: 0 for name in OURS} for _ in range(3))
    names = [*OURS, *peers.names]
    print("| | N | S/N | " + " | ".join(names) + " | |")
    print("|---" * (len(names) + 4) + "|")
    for cell in cells:
        peers.fill([cell], arguments.seeds)
        others = peers.means(cell, arguments.seeds)
        mine = ours(arguments.command, cell, arguments.seeds, folder)
        best = min(others.values(), key=lambda pair: pair[0])
        marks = []
        for name, (error, count) in mine.items():
            is_near, is_slim = error <= 1.1 * best[0], count <= .5 * best[1]
            near[name] += is_near
            slim[name] += is_slim
            both[name] += is_near and is_slim
            marks.append(("✓" if is_near else "–") + ("½" if is_slim else ""))
        print(f"| {cell.label} | {cell.n} | {cell.ratio} | " + " | ".join(
            f"{error:.4g} ({count:.0f})" for error, count in [*mine.values(), *others.values()]) +
            f" | {' '.join(marks)} |", flush=True)
    for name in OURS:
        print(f"\n{name}: best or within 10 % of the best other in {near[name]} of {len(cells)} "
              f"cells; at most half the parameters of the best other in {slim[name]}; both in "
              f"{both[name]}")


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("command", nargs="?")
    parser.add_argument("--peers")
    parser.add_argument("--seeds", type=int, default=100)
    parser.add_argument("--sizes", default="201,1024,2048")
    parser.add_argument("--functions", default=",".join(FUNCTIONS))
    parser.add_argument("--without", default="")
    arguments = parser.parse_args()
    warnings.simplefilter("ignore")
    cells = [Cell(label, int(n), ratio) for label in arguments.functions.split(",")
             for n in arguments.sizes.split(",") for ratio in (3, 7)]
    with tempfile.TemporaryDirectory() as folder:
        peers = Peers(arguments.peers, arguments.without, folder)
        if arguments.command:
            table(arguments, cells, peers, folder)
        else:
            peers.fill(cells, arguments.seeds)


main()
