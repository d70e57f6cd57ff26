#!/usr/bin/env python3
"""Fits beside the field: mean squared errors and effective parameters of Batten, SciPy's smoothing
spline by GCV, mgcv by REML, and FITPACK given the best s there is (by the truth).

usage: fit_field.py [COMMAND] [--peers FILE] [--ours FILE] [--as-kept] [--seeds 100]
                    [--sizes 201,1024,2048] [--functions Blocks,Bumps] [--without mgcv]

The four functions of [DonohoJohnstone1994] and a bathtub, scaled so that their standard
deviation is the signal-to-noise ratio and the noise 1. Batten and FITPACK are told the noise. Every
seed draws its own noise, so that a few seeds are the beginning of many. Prints one row a cell, means
over seeds, ready for docs/fitting.md. --peers keeps what the others found, --ours what COMMAND
found, a line of JSON for each fit; what a file holds is not computed again, and with --as-kept
nothing is. Without COMMAND only the peers are worked out.
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
        self.label, self.n, self.ratio = self.key = label, n, ratio
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


OURS = {"Batten": [], "Batten, pruned": ["--knots", "pruned"]}
PEERS = ["SciPy GCV", "FITPACK best s", "mgcv"]
BLOCK = 10


class Fitters:
    """All the ways to fit, by name."""

    def __init__(self, command, folder):
        self.command, self.folder, self.penalty = command, folder, Lambda()

    def fits(self, name, cell, seeds):
        samples = [cell.sample(seed) for seed in seeds]
        if name in OURS:
            return [batten(self.command, cell.x, y, self.folder, *OURS[name]) for y in samples]
        if name == "mgcv":
            return mgcv(cell.x, samples, self.folder)
        if name == "SciPy GCV":
            return [smoothing(cell.x, y, self.penalty, cell.random(seed, 1))
                    for y, seed in zip(samples, seeds)]
        return [fitpack(cell.x, y, cell.truth) for y in samples]


class Results:
    """Errors and parameters by cell, seed and name; kept in a file if there is one."""

    def __init__(self, path, names, fitters):
        self.path, self.names, self.fitters, self.found = path, names, fitters, {}
        if path and os.path.exists(path):
            with open(path, encoding="utf-8") as stream:
                for row in map(json.loads, stream):
                    key = row["function"], row["n"], row["ratio"], row["seed"], row["peer"]
                    self.found[key] = row["error"], row["parameters"]

    def fill(self, cells, seeds):
        """Blocks of seeds are the outermost loop: stopped early, every cell has as many."""
        for first in range(0, seeds, BLOCK):
            for cell in cells:
                for name in self.names:
                    self._fill(name, cell, range(first, min(first + BLOCK, seeds)))

    def _fill(self, name, cell, seeds):
        missing = [seed for seed in seeds if (*cell.key, seed, name) not in self.found]
        if not missing:
            return
        lines = []
        for seed, (fit, count) in zip(missing, self.fitters.fits(name, cell, missing)):
            result = cell.error(fit), float(count)
            self.found[(*cell.key, seed, name)] = result
            lines.append(json.dumps(dict(zip(
                ("function", "n", "ratio", "seed", "peer", "error", "parameters"),
                (*cell.key, seed, name, *result)))) + "\n")
        if self.path:
            with open(self.path, "a", encoding="utf-8") as stream:
                stream.writelines(lines)

    def seeds(self, cells, name, most):
        """How many of the first seeds every cell has."""
        count = 0
        while count < most and all((*cell.key, count, name) in self.found for cell in cells):
            count += 1
        return count

    def mean(self, cell, name, seeds):
        return numpy.mean([self.found[(*cell.key, seed, name)] for seed in range(seeds)], axis=0)


def table(cells, seeds, ours, peers):
    near, slim, both = ({name: 0 for name in ours.names} for _ in range(3))
    columns = [(results, name, results.seeds(cells, name, seeds))
               for results in (ours, peers) for name in results.names]
    print("| | N | S/N | " + " | ".join(f"{name}, {count} seeds" for _, name, count in columns) +
          " | |")
    print("|---" * (len(columns) + 4) + "|")
    for cell in cells:
        means = {name: results.mean(cell, name, count) for results, name, count in columns}
        best = min((means[name] for name in peers.names), key=lambda pair: pair[0])
        marks = []
        for name in ours.names:
            error, count = means[name]
            is_near, is_slim = error <= 1.1 * best[0], count <= .5 * best[1]
            near[name] += is_near
            slim[name] += is_slim
            both[name] += is_near and is_slim
            marks.append(("✓" if is_near else "–") + ("½" if is_slim else ""))
        print(f"| {cell.label} | {cell.n} | {cell.ratio} | " + " | ".join(
            f"{error:.4g} ({count:.1f})" for error, count in means.values()) +
            f" | {' '.join(marks)} |")
    for name in ours.names:
        print(f"\n{name}: best or within 10 % of the best other in {near[name]} of {len(cells)} "
              f"cells; at most half the parameters of the best other in {slim[name]}; both in "
              f"{both[name]}")


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("command", nargs="?")
    for option in ("--peers", "--ours"):
        parser.add_argument(option)
    parser.add_argument("--as-kept", action="store_true")
    parser.add_argument("--seeds", type=int, default=100)
    parser.add_argument("--sizes", default="201,1024,2048")
    parser.add_argument("--functions", default=",".join(FUNCTIONS))
    parser.add_argument("--without", default="")
    arguments = parser.parse_args()
    warnings.simplefilter("ignore")
    cells = [Cell(label, int(n), ratio) for label in arguments.functions.split(",")
             for n in arguments.sizes.split(",") for ratio in (3, 7)]
    with tempfile.TemporaryDirectory() as folder:
        fitters = Fitters(arguments.command, folder)
        left_out = arguments.without.split(",")
        peers = Results(arguments.peers, [n for n in PEERS if n not in left_out], fitters)
        ours = Results(arguments.ours, [n for n in OURS if n not in left_out], fitters)
        if not arguments.as_kept:
            if arguments.command:
                ours.fill(cells, arguments.seeds)
            peers.fill(cells, arguments.seeds)
        if arguments.command or arguments.as_kept:
            table(cells, arguments.seeds, ours, peers)


main()
