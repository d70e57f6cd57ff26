"""What the Python module promises: arrays are read and looked at where they are.

usage: python_memory_test.py PACKAGE_PARENT COMMAND SOURCE_FOLDER
"""

import resource
import sys
import unittest

import numpy

from python_module import ZIGZAG, batten, main


def address(array):
    return array.__array_interface__["data"][0]


def peak_kilobytes():
    return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss


class Memory(unittest.TestCase):
    """Arrays of float64 in C order are read where they are; results are looked at where they are."""

    def test_points_given_are_kept_and_not_copied(self):
        for work in (batten.interpolate, batten.densify, batten.thin, batten.arcs, batten.fit):
            given = numpy.stack([numpy.arange(6.0), numpy.sin(numpy.arange(6.0))], axis=1)
            before = sys.getrefcount(given)
            made = work(given, degree=1) if work is batten.fit else work(given)
            # A fit wants its columns each in one piece.
            kept = 0 if work is batten.fit else 1
            self.assertEqual(sys.getrefcount(given), before + kept, work)
            del made
            self.assertEqual(sys.getrefcount(given), before, work)

    def test_a_picture_drawn_later_shows_the_very_memory_given(self):
        given = ZIGZAG.copy()
        made = batten.interpolate(given)
        self.assertEqual(sys.getrefcount(given), 3)
        first = made.draw()
        given[2] = [2.0, -0.5]
        self.assertNotEqual(made.draw(), first)
        given[2] = ZIGZAG[2]
        self.assertEqual(made.draw(), first)
        del given
        self.assertEqual(made.draw(), first)

    def test_columns_given_to_a_fit_are_kept_and_not_copied(self):
        x = numpy.linspace(0.0, 1.0, 50)
        y = numpy.sin(3 * x)
        made = batten.fit({"x": x, "y": y}, sigma="0.01")
        self.assertEqual((sys.getrefcount(x), sys.getrefcount(y)), (3, 3))
        held = made.rows()["y"]
        y[7] = 5.0
        self.assertEqual(made.rows()["y"][7], 5.0)
        self.assertNotEqual(held[7], 5.0)
        del made
        self.assertEqual((sys.getrefcount(x), sys.getrefcount(y)), (2, 2))

    def test_many_points_given_cost_no_memory_of_their_own(self):
        # 64 MB of points, filled bit by bit: a copy would show in the peak; the chords have 32 MB.
        given = numpy.zeros((4_000_000, 2))
        for start in range(0, len(given), 1000):
            given[start:start + 1000, 0] = numpy.arange(start, start + 1000)
        before = peak_kilobytes()
        with self.assertRaises(batten.Error) as caught:
            batten.interpolate(given, method="natural-chord", corner=[4_000_000])
        self.assertEqual(caught.exception.code, "interpolate.corner-not-taken")
        self.assertLess(peak_kilobytes() - before, 40_000)

    def test_rows_and_points_of_a_result_are_views_of_one_memory(self):
        made = batten.densify(ZIGZAG, between=3)
        self.assertEqual(address(made.points), address(made.points))
        rows = made.rows()
        self.assertEqual(address(rows["x"]), address(made.points))
        self.assertEqual(address(rows["y"]), address(made.points) + 8)
        self.assertTrue(numpy.shares_memory(rows["y"], made.points))
        self.assertIs(rows["y"].base, made)
        points = made.points
        last = points[-1].copy()
        del made, rows
        self.assertTrue((points[-1] == last).all())

    def test_rows_that_go_with_a_fit_are_views_that_keep_their_owner(self):
        rows = batten.fit({"x": [0.0, 1, 2, 3, 4, 5], "y": [0.0, 1, 4, 9, 16, 25]}, degree=2).rows()
        self.assertEqual(address(rows["y"]), address(rows["x"]) + 8)
        self.assertEqual(list(rows["y"]), [0, 1, 4, 9, 16, 25])

    def test_curves_write_into_the_memory_given(self):
        curve = batten.interpolate(ZIGZAG).curve
        out = numpy.empty((7, 2))
        self.assertIs(curve(numpy.linspace(0.0, 4.0, 7), out=out), out)


if __name__ == "__main__":
    main()
