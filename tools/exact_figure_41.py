"""Hatano's Figure 4.1 in rational numbers, against the values of a reference file.

The doubles in the file are taken as they stand; lines nearer than 1e-12 run together. No operation
rounds, so what is printed is the truth about those doubles.

usage: exact_figure_41.py fig41_reference.json
"""

import json
import sys
from fractions import Fraction

DEGREE = 3
TOGETHER = Fraction(1, 10**12)


def splines(knots, x):
    """All B-splines at x, by the recurrence with 0/0 = 0; right-continuous."""
    values = [Fraction(int(a <= x < b)) for a, b in zip(knots, knots[1:])]
    for degree in range(1, DEGREE + 1):
        values = [
            sum(share * value for share, value in (
                ((x - knots[i]) / max(knots[i + degree] - knots[i], TOGETHER), values[i]),
                ((knots[i + degree + 1] - x) / max(knots[i + degree + 1] - knots[i + 1], TOGETHER),
                 values[i + 1])) if value)
            for i in range(len(values) - 1)]
    return values


def lines_at(rows, intervals, along):
    knots = [Fraction(0)] * DEGREE + [Fraction(i, intervals) for i in range(intervals + 1)]
    weights = splines(knots + [Fraction(1)] * DEGREE, along)
    lines = sorted(sum(w * Fraction(c) for w, c in zip(weights, row)) for row in rows)
    for i in range(1, len(lines)):
        if lines[i] - lines[i - 1] <= TOGETHER:
            lines[i] = lines[i - 1]
    ends = DEGREE + 1
    return [Fraction(0)] * ends + lines + [Fraction(1)] * ends


def coefficient(i, j):
    a, b = i - DEGREE, j - DEGREE
    return not (a == -3 or b == 12 or (a >= 1 and b <= 0) or (a >= 5 and 1 <= b <= 4))


def height(figure, x, y):
    along_x = splines(lines_at(figure["d"], figure["q"], y), x)
    along_y = splines(lines_at(figure["e"], figure["p"], x), y)
    return sum(a * b for i, a in enumerate(along_x) for j, b in enumerate(along_y)
               if coefficient(i, j))


with open(sys.argv[1], encoding="utf-8") as stream:
    reference = json.load(stream)
print("x y exact listed difference")
for i, x in enumerate(reference["sample_x"]):
    for j, y in enumerate(reference["sample_y"]):
        exact, listed = height(reference, Fraction(x), Fraction(y)), reference["S"][i][j]
        print(x, y, repr(float(exact)), repr(listed), f"{float(Fraction(listed) - exact):.3g}")
