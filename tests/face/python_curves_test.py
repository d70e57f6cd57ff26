"""What the Python module promises: curves to call.

usage: python_curves_test.py PACKAGE_PARENT COMMAND SOURCE_FOLDER
"""

import pickle
import unittest

import numpy

from python_module import ZIGZAG, batten, main


class Curves(unittest.TestCase):
    def setUp(self):
        self.curve = batten.interpolate(ZIGZAG, method="natural-chord").curve

    def test_a_curve_is_called_with_any_shape_of_parameters(self):
        lo, hi = self.curve.domain
        for shape in ((), (3,), (2, 3), (0,)):
            t = numpy.full(shape, 0.5 * (lo + hi))
            self.assertEqual(self.curve(t).shape, shape + (2,))
            self.assertEqual(self.curve.jets(t, 2).shape, shape + (3, 2))
        self.assertEqual(self.curve(1).shape, (2,))

    def test_derivatives_are_those_of_the_jets(self):
        t = numpy.linspace(*self.curve.domain, 2000)
        jets = self.curve.jets(t, 3)
        for nu in range(4):
            self.assertTrue((self.curve(t, nu) == jets[:, nu]).all())
        self.assertTrue((self.curve(t, nu=9) == 0).all())

    def test_the_points_are_on_the_curve(self):
        numpy.testing.assert_allclose(self.curve(self.curve.breaks), ZIGZAG, atol=1e-15)
        self.assertEqual((self.curve.dim, self.curve.degree, self.curve.is_closed), (2, 3, False))

    def test_results_are_written_into_the_array_that_is_given(self):
        t = numpy.linspace(*self.curve.domain, 10)
        out = numpy.empty((10, 2))
        self.assertIs(self.curve(t, out=out), out)
        self.assertTrue((out == self.curve(t)).all())
        for wrong in (numpy.empty((10, 3)), numpy.empty((10, 2), "f4"),
                      numpy.empty((2, 10)).T, [0.0]):
            with self.assertRaises(batten.Error) as caught:
                self.curve(t, out=wrong)
            self.assertEqual(caught.exception.code, "option.value")

    def test_arrays_of_the_module_are_views_that_keep_their_owner(self):
        breaks = self.curve.breaks
        self.assertIs(breaks.base, self.curve)
        self.assertFalse(breaks.flags.writeable)
        rows = batten.evaluate(self.curve, count=5).points
        self.assertIsInstance(rows.base, batten.Outcome)
        self.assertEqual(rows.shape, (5, 3))

    def test_a_curve_survives_pickle_and_json(self):
        t = numpy.linspace(*self.curve.domain, 99)
        for copy in (pickle.loads(pickle.dumps(self.curve)),
                     batten.Curve.from_json(self.curve.to_json())):
            self.assertTrue((copy(t, 1) == self.curve(t, 1)).all())

    def test_parameters_that_are_no_numbers_are_refused(self):
        for t in (numpy.nan, numpy.inf, [0.1, numpy.nan]):
            with self.assertRaises(batten.Error) as caught:
                self.curve(t)
            self.assertEqual(caught.exception.code, "curve.parameter")
        with self.assertRaises(batten.Error):
            self.curve(0.5, -1)
        with self.assertRaises(TypeError):
            self.curve("half")


if __name__ == "__main__":
    main()
