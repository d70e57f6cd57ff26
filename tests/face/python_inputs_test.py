"""What the Python module promises: what can be given, and what is refused.

usage: python_inputs_test.py PACKAGE_PARENT COMMAND SOURCE_FOLDER
"""

import unittest

import numpy

from python_module import ZIGZAG, Refusing, batten, main


class Inputs(unittest.TestCase):
    def answers(self, points, **options):
        return batten.interpolate(points, **options).to_json()

    def test_lists_arrays_of_any_layout_and_columns_give_the_same(self):
        expected = self.answers(ZIGZAG)
        for same in (ZIGZAG.tolist(), ZIGZAG.astype("f4"), ZIGZAG.astype(int),
                     numpy.asfortranarray(ZIGZAG), numpy.repeat(ZIGZAG, 2, axis=0)[::2],
                     {"x": ZIGZAG[:, 0], "y": ZIGZAG[:, 1]}):
            self.assertEqual(self.answers(same), expected)

    def test_options_are_pythons_own_kinds(self):
        expected = self.answers(ZIGZAG, corner=[1, 3], tangent=["0:90"], weight_exponent=2)
        self.assertEqual(expected, self.answers(ZIGZAG, corner=numpy.array([1, 3]),
                                                tangent={0: 90}, weight_exponent=numpy.float64(2)))
        self.assertEqual(expected, self.answers(ZIGZAG, corner=(1, 3), tangent="0:90",
                                                weight_exponent="2", method=None))

    def test_parameters_may_be_an_array(self):
        curve = batten.interpolate(ZIGZAG, method="spline",
                                   parameter=numpy.array([0, 1, 3, 4, 9.0])).curve
        self.assertEqual(curve.breaks.tolist(), [0, 1, 3, 4, 9])

    def test_an_outcome_is_an_input(self):
        made = batten.densify(ZIGZAG, between=3)
        self.assertEqual(self.answers(made), self.answers(made.points))
        fair = batten.interpolate(made)
        self.assertEqual(batten.measure(fair).to_json(), batten.measure(fair.curve).to_json())
        self.assertEqual(batten.compare(fair, to=fair).report["max"], 0)
        self.assertLess(batten.compare(fair, to=ZIGZAG).report["max"], 1e-12)
        self.assertIn("<svg", batten.draw(fair, ZIGZAG).draw())

    def test_the_callers_points_stay_as_they_are(self):
        points = ZIGZAG.copy()
        points.setflags(write=False)
        batten.interpolate(points)
        self.assertTrue((points == ZIGZAG).all())


class ErrorsOfData(Refusing):
    """sigma: one of all, a column's name, or an array."""

    x = numpy.linspace(0, 6, 61)
    y = numpy.sin(x)
    sigma = numpy.where(x < 3, 0.01, 0.04)

    def fit(self, **options):
        return batten.fit({"x": self.x, "y": self.y}, knots="equal", intervals=8, **options)

    def test_an_array_is_the_column_bit_for_bit(self):
        column = batten.fit({"x": self.x, "y": self.y, "sigma": self.sigma}, knots="equal",
                            intervals=8)
        for same in (self.sigma, list(self.sigma), self.sigma[::-1][::-1]):
            self.assertEqual(self.fit(sigma=same).report, column.report)
        self.assertEqual(self.fit(sigma=self.sigma).options["sigma"], "61 numbers")
        self.assertEqual(self.fit(sigma=0.01).report, self.fit(sigma=numpy.array(0.01)).report)
        ratio = (self.fit(sigma=0.01).report["delta2"] /
                 self.fit(sigma=numpy.full(61, 0.01)).report["delta2"])
        self.assertAlmostEqual(ratio, 1, delta=1e-9)

    def test_an_infinite_error_takes_the_weight(self):
        sigma = self.sigma.copy()
        sigma[5] = numpy.inf
        self.assertEqual(self.fit(sigma=sigma).report["samples"], 60)

    def test_a_curve_of_points_takes_them_too(self):
        points = numpy.stack([numpy.cos(self.x), self.y], axis=1)
        table = {"x": points[:, 0], "y": points[:, 1], "sigma": self.sigma}
        self.assertEqual(batten.fit(points, parametric=True, sigma=self.sigma).report,
                         batten.fit(table, parametric=True).report)

    def test_wrong_ones_are_refused(self):
        self.refused("fit.lengths", lambda: self.fit(sigma=self.sigma[:-1]))
        self.refused("option.value", lambda: self.fit(sigma=numpy.ones((61, 2))))
        self.refused("option.value", lambda: self.fit(sigma=[]))
        self.refused("fit.sigma", lambda: self.fit(sigma=-self.sigma))
        self.refused("table.unknown-column", lambda: self.fit(sigma="error"))


class Errors(Refusing):
    def test_errors_are_value_errors_with_their_parts(self):
        self.assertTrue(issubclass(batten.Error, ValueError))
        error = self.refused("points.repeated", lambda: batten.interpolate([[0, 0], [1, 1], [1, 1]]))
        self.assertIn("points", error.place)
        nan = numpy.array([[0, 0], [1, numpy.nan], [2, 0]])
        self.refused("points.not-finite", lambda: batten.interpolate(nan))
        self.refused("points.not-finite", lambda: batten.fit(nan))
        line = batten.interpolate([[0, 0], [1, 1], [2, 0]]).curve
        self.refused("curve.no-band", lambda: line.band(0.5))
        self.refused("option.range", lambda: line.band(0.5, percent=100))
        self.refused("points.not-finite", lambda: batten.fair({"x": nan[:, 0], "y": nan[:, 1]}))
        self.refused("points.not-finite", lambda: batten.compare(batten.interpolate(ZIGZAG), to=nan))

    def test_options_and_inputs_that_make_no_sense(self):
        curve = batten.interpolate(ZIGZAG).curve
        self.refused("option.unknown", lambda: batten.interpolate(ZIGZAG, speed=1))
        self.refused("option.choice", lambda: batten.interpolate(ZIGZAG, method="magic"))
        self.refused("option.range", lambda: batten.interpolate(ZIGZAG, weight_exponent=99))
        self.refused("option.range", lambda: batten.interpolate(ZIGZAG, weight_exponent=numpy.nan))
        self.refused("option.value", lambda: batten.interpolate(ZIGZAG, closed=object()))
        self.refused("option.value", lambda: batten.interpolate(ZIGZAG, corner=[[1], [2]]))
        self.refused("input.kind", lambda: batten.interpolate(curve))
        self.refused("input.kind", lambda: batten.measure(ZIGZAG))
        self.refused("input.kind", lambda: batten.interpolate("points.csv"))
        self.refused("input.count", lambda: batten.interpolate())
        self.refused("input.count", lambda: batten.interpolate(ZIGZAG, ZIGZAG))
        self.refused("points.dimension", lambda: batten.interpolate([1, 2, 3]))
        self.refused("points.too-few", lambda: batten.interpolate(numpy.empty((0, 2))))
        self.refused("job.input", lambda: batten.interpolate(batten.measure(curve)))
        self.refused("file.missing", lambda: batten.read_points("nowhere.csv"))
        self.refused("json.syntax", lambda: batten.Curve.from_json("["))


if __name__ == "__main__":
    main()
