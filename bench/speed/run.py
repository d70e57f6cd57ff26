"""Runs the benchmarks, peers between them, and writes the tables of docs/benchmarks.md.

usage: run.py PROGRAM SOURCE_FOLDER [OPERATION...]

Each operation is run ROUNDS times, C++ and SciPy in turn, everything on one core; medians count.
The figures of a run stand in its own JSON file beside the program.
"""

import collections
import json
import os
import pathlib
import platform
import statistics
import subprocess
import sys

ROUNDS = 3
COPY_OF_THE_GOALS = 1.25  # ns a double, on the machine that the goals were set on
OPERATIONS = {
    "natural-spline": "Natural cubic spline by chord length, ns a point",
    "evaluate-sorted": "A million values of a cubic spline, parameters sorted, ns a value; by knots",
    "evaluate-random": "The same, parameters in no order",
    "evaluate-derivatives": "The same, sorted, with two derivatives",
    "pseudo-spline": "Pseudo-spline with length and area, ns a point",
    "pseudo-spline-sharp": "The same, turns of up to 100 degrees",
    "length": "Length of cubic pieces to 1e-12, ns a piece",
    "area": "Area of cubic pieces, ns a piece",
    "filter": "The paper's fairing filter, window 5, no sample clamped, ns a point and sweep",
    "filter-clamped": "The same with noise of 5 % of the spacing",
    "fair-step": "Fairing, ns a point and Gauss-Newton step",
    "fair-lambda-given": "Fairing at a given lambda, ns in all",
    "fair-lambda-found": "Fairing with lambda found, ns in all",
    "alpha": "Alpha of points by maximum likelihood, ns in all",
    "log-aesthetic-segment": "A log-aesthetic segment by its triangle, ns",
    "fair-surface": "Fairing a grid of points, ns in all; by nodes",
}
SURFACES = "fit-surface"  # bench/surface_speed.py
PLACE = pathlib.Path(__file__).resolve().parent


def pinned(*command):
    done = subprocess.run(["taskset", "-c", "0", *command], check=True, capture_output=True,
                          text=True, env=dict(os.environ, OMP_NUM_THREADS="1",
                                              OPENBLAS_NUM_THREADS="1"))
    return done.stdout


def of_program(program, operation):
    text = pinned(program, f"--benchmark_filter=^{operation}/", "--benchmark_format=json",
                  "--benchmark_min_time=0.1", "--benchmark_min_warmup_time=0.05")
    for each in json.loads(text)["benchmarks"]:
        if not each.get("error_occurred"):
            yield each["name"], 1e9 / each["items_per_second"]


def of_scipy(operation):
    for line in pinned("/usr/bin/python3", str(PLACE / "scipy_peers.py"), operation).splitlines():
        each = json.loads(line)
        yield each["name"], each["ns"]


def measured(program, operations):
    """Per name the figures of all rounds."""
    figures = collections.defaultdict(list)
    for _ in range(ROUNDS):
        for operation in ["copy", *operations]:
            for name, ns in [*of_program(program, operation), *of_scipy(operation)]:
                figures[name].append(ns)
    return figures


def number(x):
    return f"{x:.2f}" if x < 10 else f"{x:.1f}" if x < 100 else f"{x:,.0f}"


def table(operation, medians):
    """Rows by size: Batten's figure, its growth, the peers' figures and how many times slower."""
    found = {tuple(name.split("/")[1:]): ns for name, ns in medians.items()
             if name.split("/")[0] == operation}
    sizes = sorted({int(size) for _, size in found})
    peers = [peer for peer in dict.fromkeys(peer for peer, _ in found) if peer != "batten"]
    lines = ["| n | Batten |" + "".join(f" {peer} | ratio |" for peer in peers),
             "|" + "---:|" * (2 + 2 * len(peers))]
    for size in sizes:
        ours = found.get(("batten", str(size)))
        cells = [f"{size:,}", number(ours) if ours else "–"]
        for peer in peers:
            theirs = found.get((peer, str(size)))
            cells += [number(theirs) if theirs else "–",
                      f"{theirs / ours:.1f} ×" if ours and theirs else "–"]
        lines.append("| " + " | ".join(cells) + " |")
    return "\n".join(lines) + "\n\n" + growth(found, sizes)


def growth(found, sizes):
    ours = [(size, found[("batten", str(size))]) for size in sizes if ("batten", str(size)) in found]
    if len(ours) < 2:
        return ""
    (small, one), (large, other) = ours[0], ours[-1]
    return (f"From n = {small:,} to {large:,} the time of one grows by {other / one:.2f} "
            f"(linear work: 1).\n")


def beside_copy(operation, medians):
    """The floor: input and output of a million values copied, both in cache."""
    floor = medians["copy/machine/1000000"]
    ours = [(name.split("/")[2], ns / floor) for name, ns in medians.items()
            if name.startswith(operation + "/batten/")]
    if not ours:
        return ""
    return ("\nBeside a copy of the parameters to the values (10⁶ doubles, in cache): "
            + ", ".join(f"{ratio:.1f} × at {int(size):,} knots" for size, ratio in ours) + ".\n")


def version(package):
    done = subprocess.run(["dpkg-query", "-W", "-f=${Version}", package], capture_output=True,
                          text=True)
    return done.stdout or "unknown"


def processor():
    for line in pathlib.Path("/proc/cpuinfo").read_text().splitlines():
        if line.startswith("model name"):
            return line.split(":", 1)[1].strip()
    return platform.machine()


def surfaces(program):
    text = pinned("/usr/bin/python3", str(PLACE.parent / "surface_speed.py"), program, "--table")
    return ("\n## Surfaces on grids, ms\n\nThe least of some runs each. Automatic knot lines go to the "
            "residual that RectBivariateSpline(s = number of nodes) reaches.\n\n" + text)


def page(medians, loads):
    copy = medians["copy/machine/10000000"]
    compiler = subprocess.run(["c++", "-dumpfullversion"], capture_output=True, text=True).stdout
    packages = ("libgsl-dev", "libspiro-dev", "libboost-dev", "python3-scipy")
    text = ("# Benchmarks\n\nWritten by `make bench`; do not edit. Batten and its peers in one run, "
            "one core, the release build, CPU time, medians of "
            f"{ROUNDS} rounds. A ratio above 1 means that Batten is faster.\n\n"
            f"Machine: {processor()}; {platform.system()} {platform.release()}; "
            f"g++ {compiler.strip()}. Peers: "
            + ", ".join(f"{each} {version(each)}" for each in packages)
            + f". Load of the machine when the run began and ended: {loads[0]:.1f}, {loads[1]:.1f}"
            + (" (others were at work: absolute figures are too high).\n\n" if max(loads) > 1.5
               else ".\n\n")
            + f"A copy of doubles costs {copy:.2f} ns each in this run (10⁷ of them); absolute goals "
            f"are scaled by {copy / COPY_OF_THE_GOALS:.2f}. A copy of 10⁶: "
            f"{medians['copy/machine/1000000']:.2f} ns.\n")
    for operation, title in OPERATIONS.items():
        if any(name.startswith(operation + "/") for name in medians):
            text += f"\n## {title}\n\n{table(operation, medians)}"
        if operation == "evaluate-sorted":
            text += beside_copy(operation, medians)
    return text


def main():
    program, source, *operations = sys.argv[1:]
    before = os.getloadavg()[0]
    figures = measured(program, [each for each in operations or OPERATIONS if each != SURFACES])
    medians = {name: statistics.median(values) for name, values in figures.items()}
    pathlib.Path(program + ".json").write_text(json.dumps(figures, indent=1) + "\n")
    text = page(medians, (before, os.getloadavg()[0]))
    if not operations or SURFACES in operations:
        text += surfaces(str(pathlib.Path(program).with_name("surface_speed")))
    pathlib.Path(source, "docs", "benchmarks.md").write_text(text, encoding="utf-8")
    print(text)


main()
