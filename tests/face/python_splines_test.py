"""What the Python module promises: splines y(x) with knots, coefficients and degree.

usage: python_splines_test.py PACKAGE_PARENT COMMAND SOURCE_FOLDER
"""

import pickle

import numpy

from python_module import ZIGZAG, Refusing, batten, main


class Splines(Refusing):
    def setUp(self):
        self.x = numpy.linspace(0, 6, 61)
        made = batten.fit({"x": self.x, "y": numpy.sin(self.x)}, sigma="0.01", knots="equal",
                          intervals=8)
        self.made, self.curve, self.spline = made, made.curve, made.spline

    def test_a_fit_is_a_spline_with_knots_coefficients_and_degree(self):
        s = self.spline
        self.assertEqual((len(s.t), len(s.c), s.k), (15, 11, 3))
        self.assertTrue(s.t.flags.writeable)  # SciPy takes no other
        self.assertTrue(numpy.abs(s(self.x) - numpy.sin(self.x)).max() < 1e-3)
        self.assertTrue(numpy.abs(s(self.x, 1) - numpy.cos(self.x)).max() < 1e-2)
        self.assertTrue(numpy.allclose(s(self.x), self.curve(self.x)[:, 1], rtol=0, atol=1e-14))

    def test_samples_that_lie_unevenly_are_fitted_by_least_squares(self):
        random = numpy.random.RandomState(3)
        for dense, sparse in ((1000, 60), (60, 1000)):
            x = numpy.sort(numpy.concatenate([[0, 10], random.uniform(0, 1, dense),
                                              random.uniform(1, 10, sparse)]))
            y = numpy.sin(x) + 0.01 * random.normal(size=len(x))
            for knots in ([4, 7], [0.5, 4, 7], [2, 4, 6, 8]):
                spline = batten.fit({"x": x, "y": y}, sigma=0.01, knots=knots).spline
                columns = [batten.Spline(spline.t, unit)(x) for unit in numpy.eye(len(spline.c))]
                best = numpy.linalg.lstsq(numpy.transpose(columns), y, rcond=None)[0]
                numpy.testing.assert_allclose(spline.c, best, rtol=0, atol=1e-10)

    def test_the_spline_of_a_fit_is_that_of_its_report_and_of_its_file(self):
        report, x = self.made.report, self.x
        for spline in (self.spline, self.curve.spline,
                       batten.Curve.from_json(self.curve.to_json()).spline):
            self.assertEqual(spline.t.tolist(), report["knots"])
            self.assertEqual(spline.c.tolist(), report["coefficients"])
            self.assertEqual(spline.k, self.made.options["degree"])
            for nu in (0, 2):
                for ours, theirs in zip(spline.band(x, nu, 90), self.curve.band(x, nu, 90)):
                    numpy.testing.assert_allclose(ours, theirs, rtol=0, atol=1e-9)
        self.assertEqual(self.spline.band(numpy.ones((2, 3)))[0].shape, (2, 3))

    def test_a_spline_with_jumps_and_a_closed_one_are_there_too(self):
        y = numpy.where(self.x < 3, 0.0, 1.0)
        steps = batten.fit({"x": self.x, "y": y}, degree=0, sigma=0.1, knots=[2.95])
        numpy.testing.assert_allclose(steps.curve([1, 5]), [[1, 0], [5, 1]], rtol=0, atol=1e-14)
        self.assertEqual(len(steps.curves), 1)
        self.assertEqual(steps.curve._repr_svg_().count("M"), 2)
        numpy.testing.assert_allclose(steps.spline([1, 5]), [0, 1], rtol=0, atol=1e-14)
        closed = batten.fit({"x": self.x, "y": numpy.cos(self.x * numpy.pi / 3)}, closed=True,
                            sigma=0.01, knots="equal", intervals=6)
        self.assertEqual(closed.spline.t.tolist(), closed.report["knots"])
        numpy.testing.assert_allclose(closed.spline(self.x), closed.curve(self.x)[:, 1], atol=1e-13)

    def test_what_is_no_fit_has_no_band_and_what_is_no_graph_no_spline(self):
        for spline in (self.spline.insert_knots([0.1]), self.spline.derivative(),
                       batten.Spline(self.spline.t, self.spline.c)):
            self.refused("curve.no-band", lambda: spline.band(1))
        self.refused("option.range", lambda: self.spline.band(1, percent=0))
        self.refused("curve.parameter", lambda: self.spline.band(numpy.nan))
        outline = batten.fit(numpy.stack([numpy.cos(self.x), numpy.sin(self.x)], axis=1),
                             parametric=True, sigma=0.1)
        self.assertIsNone(outline.spline)
        self.assertIsNone(outline.curve.spline)
        self.assertIsNone(batten.measure(self.curve).spline)

    def test_knots_degree_and_power_form_of_any_curve(self):
        curve = batten.interpolate(ZIGZAG, method="spline").curve
        t = numpy.linspace(*curve.domain, 200)
        more = batten.convert(curve, insert_knots=[0.5, 0.5, 1.25], elevate=1)
        self.assertEqual((more.curve.degree, more.curve.pieces), (4, 6))
        self.assertLess(more.report["max_error"], 1e-14)
        numpy.testing.assert_allclose(more.curve(t, 2), curve(t, 2), atol=1e-11)
        fewer = batten.convert(batten.convert(curve, insert_knots=[0.5, 1.25]), remove_knots=True)
        self.assertEqual((fewer.report["removed"], fewer.curve.pieces), (2, 4))
        numpy.testing.assert_allclose(fewer.curve(t), curve(t), atol=1e-13)
        self.assertEqual(batten.convert(curve, elevate=2, remove_knots=True).curve.pieces, 4)
        rows = batten.convert(curve, as_="power").rows()
        self.assertEqual(list(rows), ["from", "to"] + [a + str(j) for a in "xy" for j in range(4)])
        for i in range(4):
            u = t[(t >= rows["from"][i]) & (t <= rows["to"][i])]
            for axis, column in (("x", 0), ("y", 1)):
                value = sum(rows[axis + str(j)][i] * (u - rows["from"][i]) ** j for j in range(4))
                numpy.testing.assert_allclose(value, curve(u)[:, column], atol=1e-14)

    def test_knots_that_a_curve_cannot_have_are_refused(self):
        arcs = batten.arcs(ZIGZAG)
        closed = batten.interpolate(ZIGZAG, method="spline", closed=True)
        self.refused("curve.not-exact", lambda: batten.convert(arcs, elevate=1))
        self.refused("curve.not-exact", lambda: batten.convert(arcs, as_="power"))
        self.refused("curve.outside", lambda: batten.convert(self.curve, insert_knots=[99]))
        self.refused("bspline.removal", lambda: batten.convert(closed, remove_knots=True))
        self.assertEqual(batten.convert(closed, insert_knots=[0.5]).curve.pieces, 6)

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
