"""What the Python module promises: the command's answers, bit for bit.

usage: python_agreement_test.py PACKAGE_PARENT COMMAND SOURCE_FOLDER
"""

import json
import os
import tempfile
import unittest

import numpy

from python_module import POINTS, SOURCE, batten, command, main

CASES = sorted(os.listdir(POINTS))


class BitForBit(unittest.TestCase):
    """The same text means the same bits: numbers are written in their shortest exact form."""

    def test_every_case_file_gives_the_same_curve_and_report(self):
        self.assertTrue(CASES)
        for case in CASES:
            path = os.path.join(POINTS, case)
            points = batten.read_points(path)
            for method in ("pseudo-spline", "natural-chord", "hermite-arc", "lagrange-3"):
                curve, report = command("interpolate", path, "--method", method)
                made = batten.interpolate(points, method=method)
                self.assertEqual(made.curve.to_json(), curve, (case, method))
                report, ours = json.loads(report), json.loads(made.to_json())
                # Notes tell what a file's reader did, which had nothing to do here.
                report["report"].pop("notes", None), ours["report"].pop("notes", None)
                self.assertEqual(ours, report, (case, method))

    def test_every_case_file_gives_the_same_measures_rows_and_arcs(self):
        for case in CASES:
            path = os.path.join(POINTS, case)
            curve = batten.interpolate(batten.read_points(path)).curve
            with tempfile.NamedTemporaryFile("w", suffix=".json") as file:
                file.write(curve.to_json())
                file.flush()
                _, report = command("measure", file.name)
                self.assertEqual(batten.measure(curve).to_json(), report, case)
                rows, report = command("evaluate", file.name, "--count", "50", "--derivatives", "2")
                made = batten.evaluate(curve, count=50, derivatives=2)
                self.assertEqual(made.points.tolist(), json.loads(rows), case)
                self.assertEqual(made.to_json(), report, case)
                arcs, report = command("convert", file.name, "--as", "arcs", "--tolerance", "1e-3r")
                made = batten.convert(curve, as_="arcs", tolerance="1e-3r")
                self.assertEqual(made.curve.to_json(), arcs, case)
                self.assertEqual(made.to_json(), report, case)

    def test_every_fit_file_gives_the_same_spline_and_report(self):
        folder = os.path.join(SOURCE, "cases", "fits")
        for case in sorted(os.listdir(folder)):
            path = os.path.join(folder, case)
            curve, report = command("fit", path)
            table = numpy.genfromtxt(path, delimiter=",", names=True)
            made = batten.fit({name: table[name] for name in table.dtype.names})
            self.assertEqual(made.curve.to_json(), curve, case)
            self.assertEqual(made.to_json(), report, case)
            self.assertEqual(list(made.rows()), ["x", "y", "sigma", "fit", "residual"])

    def test_pictures_are_the_same(self):
        with tempfile.TemporaryDirectory() as folder:
            picture = os.path.join(folder, "p.svg")
            path = os.path.join(POINTS, "violin.csv")
            command("interpolate", path, "--closed", "--draw", picture)
            with open(picture, encoding="utf-8") as stream:
                self.assertEqual(batten.interpolate(batten.read_points(path), closed=True).draw(),
                                 stream.read())


if __name__ == "__main__":
    main()
