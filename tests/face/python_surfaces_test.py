"""What the Python module promises: surfaces to call, and grids.

usage: python_surfaces_test.py PACKAGE_PARENT COMMAND SOURCE_FOLDER
"""

import json
import os
import pickle
import tempfile

import numpy

from python_module import Refusing, batten, command, main


class Surfaces(Refusing):
    x, y = numpy.linspace(0, 1, 31), numpy.linspace(-1, 1, 25)
    heights = numpy.sin(3 * x)[:, None] * numpy.cos(y)[None, :]

    def test_an_array_of_heights_becomes_a_surface_to_call(self):
        made = batten.fit_surface(self.heights, x=self.x, y=self.y, sigma=1e-4)
        surface = made.surface
        self.assertEqual(surface.domain, ((0, 1), (-1, 1)))
        z = surface(self.x[:, None], self.y[None, :])
        self.assertEqual(z.shape, (31, 25))
        self.assertLess(abs(z - self.heights).max(), 4e-4)
        numpy.testing.assert_allclose(surface.grid(self.x, self.y), z, atol=1e-14)
        slope = surface(0.5, 0.25, 1, 1)
        self.assertAlmostEqual(float(slope), -3 * numpy.cos(1.5) * numpy.sin(0.25), delta=0.05)
        again = batten.Surface.from_json(surface.json)
        self.assertEqual(float(again(0.3, 0.1)), float(surface(0.3, 0.1)))
        self.assertEqual(float(pickle.loads(pickle.dumps(surface))(0.3, 0.1)),
                         float(surface(0.3, 0.1)))
        lines = batten.contour(made, levels=[0.5])
        self.assertLess(abs(surface(lines.points[:, 2], lines.points[:, 3]) - 0.5).max(), 1e-9)

    def test_level_lines_are_curves_and_inputs(self):
        u = numpy.linspace(-1, 1, 21)
        surface = batten.fit_surface(u[:, None] ** 2 + u ** 2, x=u, y=u, sigma=1e-4).surface
        made = batten.contour(surface, levels=[0.25, 0.49])
        self.assertIsNone(made.curve)
        self.assertEqual(len(made.curves), 2)
        for curve, radius in zip(made.curves, (0.5, 0.7)):
            numpy.testing.assert_allclose(numpy.hypot(*curve(curve.breaks).T), radius, atol=1e-5)
        for lines in (made, made.curves):
            reports = batten.measure(lines).report["curves"]
            numpy.testing.assert_allclose([r["length"] for r in reports],
                                          2 * numpy.pi * numpy.array([0.5, 0.7]), rtol=1e-4)
        self.assertEqual(reports[1], batten.measure(made.curves[1]).report)
        rows = batten.sample(made, count=9).rows()
        self.assertEqual(rows["curve"].tolist(), [0.0] * 9 + [1.0] * 9)
        self.assertEqual(len(batten.convert(made, as_="polyline", tolerance=0.01).curves), 2)
        self.assertIn("<svg", batten.draw(made).draw())
        self.assertEqual(batten.draw(made, surface).report["curves"], 2)
        one = batten.contour(surface, levels=[0.25])
        self.assertEqual(one.curve.to_json(), made.curves[0].to_json())
        self.assertEqual(batten.measure(one).report, reports[0])
        self.refused("curve.several", lambda: batten.compare(one, to=made))
        self.refused("option.range", lambda: batten.convert(made, only=2))

    def test_missing_nodes_are_nan_masked_or_not_there(self):
        holed = self.heights.copy()
        holed[3, 4] = numpy.nan
        one = batten.fit_surface(holed, sigma=1e-4)
        two = batten.fit_surface(numpy.ma.masked_invalid(holed), sigma=1e-4)
        self.assertEqual(one.report["missing"], 1)
        self.assertEqual(one.to_json(), two.to_json())

    def test_errors_are_an_array_or_products(self):
        rows, columns = 1e-4 * (1 + self.x), 1 + self.y ** 2
        each = rows[:, None] * columns
        long_form = {"x": numpy.repeat(self.x, 25), "y": numpy.tile(self.y, 31),
                     "f": self.heights.ravel(), "sigma": each.ravel()}
        lines = {"x": self.x, "y": self.y, "knots": "equal", "intervals": [3, 2]}
        expected = batten.fit_surface(long_form, knots="equal", intervals=[3, 2]).report
        given = batten.fit_surface(self.heights, sigma=each, **lines).report
        products = batten.fit_surface(self.heights, x_sigma=rows, y_sigma=columns, **lines).report
        self.assertEqual(given, expected)
        self.assertAlmostEqual(products["delta2"] / expected["delta2"], 1, delta=1e-6)
        self.assertEqual(products["sigma_source"], "column")
        drawn = batten.fit_surface(self.heights, x_sigma=rows, y_sigma=columns, **lines).draw()
        self.assertIn("residuals", drawn)

    def test_errors_of_missing_nodes_may_be_missing(self):
        holed, each = self.heights.copy(), numpy.full((31, 25), 1e-4)
        holed[3, 4] = each[3, 4] = numpy.nan
        one = batten.fit_surface(holed, sigma=each).report
        two = batten.fit_surface(holed, sigma=numpy.ma.masked_invalid(each)).report
        self.assertEqual(one["missing"], 1)
        self.assertEqual(one, two)
        self.assertAlmostEqual(one["delta2"] / batten.fit_surface(holed, sigma=1e-4).report["delta2"],
                               1, delta=1e-9)

    def test_errors_that_do_not_fit_the_grid_are_refused(self):
        ones = numpy.ones((31, 25))
        self.refused("fit-surface.sizes", lambda: batten.fit_surface(self.heights, sigma=ones.T))
        self.refused("fit-surface.sizes",
                     lambda: batten.fit_surface(self.heights, x_sigma=numpy.ones(25)))
        self.refused("fit.sigma", lambda: batten.fit_surface(self.heights, sigma=0 * ones))
        self.refused("fit.options",
                     lambda: batten.fit_surface(self.heights, sigma=1, y_sigma=numpy.ones(25)))
        self.refused("option.value", lambda: batten.fit_surface(self.heights, sigma="error"))
        rows = numpy.stack([ones.ravel()] * 3, axis=1)
        self.refused("fit.options", lambda: batten.fit_surface(rows, scattered=True, x_sigma=[1]))

    def test_places_are_rows_of_lists_or_arrays(self):
        surface = batten.fit_surface(self.heights, x=self.x, y=self.y, sigma=1e-4).surface
        places = [[0.3, 0.4], [0.5, -0.5]]
        for at in (places, numpy.array(places), [0.3, 0.4, 0.5, -0.5]):
            z = batten.evaluate(surface, at=at).points[:, 2]
            numpy.testing.assert_allclose(z, surface(*numpy.transpose(places)), atol=1e-15)
        self.refused("option.value", lambda: batten.evaluate(surface, at=[[0.3, 0.4], [0.5]]))

    def test_columns_by_name_are_a_grid_in_any_order(self):
        x, y = (each.ravel() for each in numpy.meshgrid(self.x, self.y))
        made = batten.fit_surface({"y": y, "x": x, "f": self.heights.T.ravel()}, sigma=1e-4)
        same = batten.fit_surface(self.heights, x=self.x, y=self.y, sigma=1e-4)
        self.assertEqual(made.surface.json, same.surface.json)

    def test_the_command_and_the_function_make_the_same_file(self):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "grid.npy")
            numpy.save(path, self.heights)
            surface, report = command("fit-surface", path, "--sigma", "1e-4")
        made = batten.fit_surface(self.heights, sigma=1e-4)
        self.assertEqual(made.surface.json, surface)
        self.assertEqual(json.loads(made.to_json()), json.loads(report))

    def test_an_array_of_nodes_is_made_fair(self):
        u, v = numpy.meshgrid(numpy.linspace(0, 1, 12), numpy.linspace(0, 1, 10), indexing="ij")
        nodes = numpy.stack([numpy.cos(v) * numpy.cos(u), numpy.cos(v) * numpy.sin(u),
                             numpy.sin(v)], axis=-1)
        noise = 1e-3 * numpy.random.RandomState(1).normal(size=(10, 8, 3))
        noisy = nodes.copy()
        noisy[1:-1, 1:-1] += noise
        made = batten.fair_surface(noisy, sigma=1e-3)
        fair = made.points[:, 2:5].reshape(nodes.shape)
        self.assertLess(numpy.linalg.norm(fair - nodes), 0.6 * numpy.linalg.norm(noise))
        numpy.testing.assert_array_equal(fair[0], nodes[0])

    def test_what_is_no_grid_is_refused(self):
        for bad, code in ((numpy.zeros(5), "input.kind"), (numpy.zeros((1, 5)), "grid.too-small"),
                          (numpy.full((5, 5), numpy.inf), "grid.cell")):
            with self.assertRaises(batten.Error) as caught:
                batten.fit_surface(bad)
            self.assertEqual(caught.exception.code, code)


if __name__ == "__main__":
    main()
