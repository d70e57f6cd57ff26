"""What the Python module promises: splines y(x) with knots, coefficients and degree.

usage: python_splines_test.py PACKAGE_PARENT COMMAND SOURCE_FOLDER
"""

import pickle
import unittest

import numpy

from python_module import batten, main


class Splines(unittest.TestCase):
    def setUp(self):
        self.x = numpy.linspace(0, 6, 61)
        made = batten.fit({"x": self.x, "y": numpy.sin(self.x)}, sigma="0.01", knots="equal",
                          intervals=8)
        report = made.report
        self.curve = made.curve
        self.spline = batten.Spline(report["knots"], report["coefficients"],
                                    made.options["degree"])

    def test_a_fit_is_a_spline_with_knots_coefficients_and_degree(self):
        s = self.spline
        self.assertEqual((len(s.t), len(s.c), s.k), (15, 11, 3))
        self.assertTrue(numpy.abs(s(self.x) - numpy.sin(self.x)).max() < 1e-3)
        self.assertTrue(numpy.abs(s(self.x, 1) - numpy.cos(self.x)).max() < 1e-2)
        self.assertTrue(numpy.allclose(s(self.x), self.curve(self.x)[:, 1], rtol=0, atol=1e-14))

    def test_the_curve_of_a_fit_knows_its_bands(self):
        made = batten.fit({"x": self.x, "y": numpy.sin(self.x)}, sigma="0.01", knots="equal",
                          intervals=8)
        band = made.report["covariance_band"]
        x = numpy.array(band["x"])
        for curve in (made.curve, batten.Curve.from_json(made.curve.to_json()),
                      pickle.loads(pickle.dumps(made.curve))):
            lower, upper = curve.band(x)
            self.assertTrue(numpy.allclose(lower, band["lower"], rtol=0, atol=1e-12))
            self.assertTrue(numpy.allclose(upper, band["upper"], rtol=0, atol=1e-12))
        lower, upper = made.curve.band(x, nu=1, percent=99)
        self.assertTrue(numpy.all((lower < numpy.cos(x)) & (numpy.cos(x) < upper)))
        rows = batten.evaluate(made.curve, at=[1, 2], band=95).rows()
        lower, upper = made.curve.band([1, 2])
        self.assertTrue(numpy.allclose(2 * rows["y_band"], upper - lower))

    def test_integrals_roots_and_extrema_are_those_of_the_sine(self):
        s = self.spline
        self.assertAlmostEqual(s.integrate(0, numpy.pi), 2, places=3)
        self.assertAlmostEqual(s.roots()[-1], numpy.pi, places=3)
        self.assertTrue(numpy.allclose(s.extrema(), [numpy.pi / 2, 1.5 * numpy.pi], atol=1e-2))

    def test_knots_come_and_go_and_degrees_rise_without_a_change(self):
        s, x = self.spline, self.x
        more = s.insert_knots([0.1, 2.5])
        fewer, error = more.remove_knot(int(numpy.searchsorted(more.t, 0.1)))
        higher = s.elevate_degree(2)
        self.assertEqual((len(more.t), len(fewer.t), higher.k), (17, 16, 5))
        self.assertLess(error, 1e-14)
        for other in (more, fewer, higher, pickle.loads(pickle.dumps(s)),
                      s.antiderivative().derivative()):
            self.assertTrue(numpy.allclose(other(x), s(x), rtol=0, atol=1e-13))
        u = x[5] - s.breaks[0]
        self.assertAlmostEqual(numpy.polyval(s.power[:, 0], u), s(x[5]), places=14)

    def test_a_row_whose_error_is_infinite_has_no_weight(self):
        y, sigma = numpy.sin(self.x), numpy.full(61, 0.01)
        y[30], sigma[30] = 50, numpy.inf
        report = batten.fit({"x": self.x, "y": y, "sigma": sigma}, knots="equal",
                            intervals=8).report
        self.assertEqual(report["samples"], 60)
        self.assertLess(report["delta2"], 1)


if __name__ == "__main__":
    main()
