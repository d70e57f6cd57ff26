"""What the Python module promises: surfaces to call, and grids.

usage: python_surfaces_test.py PACKAGE_PARENT COMMAND SOURCE_FOLDER
"""

import json
import os
import pickle
import tempfile
import unittest

import numpy

from python_module import batten, command, main


class Surfaces(unittest.TestCase):
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

    def test_missing_nodes_are_nan_masked_or_not_there(self):
        holed = self.heights.copy()
        holed[3, 4] = numpy.nan
        one = batten.fit_surface(holed, sigma=1e-4)
        two = batten.fit_surface(numpy.ma.masked_invalid(holed), sigma=1e-4)
        self.assertEqual(one.report["missing"], 1)
        self.assertEqual(one.to_json(), two.to_json())

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
