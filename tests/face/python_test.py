"""What the Python module promises: the command's answers, bit for bit, and Python's own habits.

usage: python_test.py PACKAGE_PARENT COMMAND SOURCE_FOLDER
"""

import inspect
import json
import os
import pickle
import resource
import signal
import subprocess
import sys
import tempfile
import threading
import time
import unittest

import numpy

PARENT, COMMAND, SOURCE = (os.path.abspath(name) for name in sys.argv[1:4])
sys.path.insert(0, PARENT)
import batten  # noqa: E402

POINTS = os.path.join(SOURCE, "cases", "points")
CASES = sorted(os.listdir(POINTS))
ZIGZAG = numpy.array([[0.0, 0], [1, 1], [2, 0], [3, 1], [4, 0]])


def command(*arguments):
    """The files that the command wrote: its output and its report."""
    with tempfile.TemporaryDirectory() as folder:
        output, report = (os.path.join(folder, name) for name in ("out.json", "report.json"))
        done = subprocess.run([COMMAND, *arguments, "--quiet", "-o", output, "--report", report],
                              capture_output=True, text=True, timeout=60)
        assert done.returncode in (0, 3), done.stderr
        with open(output, encoding="utf-8") as one, open(report, encoding="utf-8") as other:
            return one.read(), other.read()


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


class Errors(unittest.TestCase):
    def refused(self, code, call):
        with self.assertRaises(batten.Error) as caught:
            call()
        error = caught.exception
        self.assertEqual(error.code, code)
        self.assertTrue(error.place and error.value and error.rule)
        self.assertEqual(str(error), f"{code}: {error.place}: {error.value}: {error.rule}")
        self.assertEqual(pickle.loads(pickle.dumps(error)).code, code)
        return error

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


class Work(unittest.TestCase):
    # Long enough to be stopped on its way.
    wave = numpy.stack([numpy.arange(5000.0), numpy.sin(numpy.arange(5000.0))], axis=1)

    def long_work(self, **more):
        return batten.interpolate(self.wave, exact=True, **more)

    def test_progress_is_told_and_may_stop_the_work(self):
        shares = []
        batten.interpolate(self.wave, progress=shares.append)
        self.assertEqual(sorted(shares), shares)
        self.assertEqual(shares[-1], 1)
        with self.assertRaises(batten.Cancelled):
            self.long_work(progress=lambda share: False)
        with self.assertRaises(ZeroDivisionError):
            self.long_work(progress=lambda share: 1 / 0)

    def test_an_interrupt_stops_the_work(self):
        timer = threading.Timer(0.2, lambda: os.kill(os.getpid(), signal.SIGINT))
        timer.start()
        with self.assertRaises(KeyboardInterrupt):
            while True:
                self.long_work()

    def test_other_threads_run_meanwhile(self):
        ticks = []
        stop = threading.Event()

        def tick():
            while not stop.is_set():
                ticks.append(time.perf_counter())
                time.sleep(0.001)

        thread = threading.Thread(target=tick)
        thread.start()
        before = len(ticks)
        batten.interpolate(self.wave)
        stop.set()
        thread.join()
        self.assertGreater(len(ticks) - before, 3)


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


class Description(unittest.TestCase):
    def functions(self):
        return [value for name, value in vars(batten).items()
                if inspect.isbuiltin(value) and not name.startswith("read_")]

    def test_every_function_has_a_signature_and_a_text(self):
        self.assertGreater(len(self.functions()), 8)
        for function in self.functions():
            signature = inspect.signature(function)
            self.assertIn("progress", signature.parameters)
            self.assertIn("Returns an Outcome", function.__doc__)
            for keyword in list(signature.parameters)[1:-1]:
                self.assertIn("\n" + keyword + "\n", function.__doc__)

    def test_the_stub_file_declares_what_there_is(self):
        folder = os.path.dirname(batten.__file__)
        self.assertTrue(os.path.exists(os.path.join(folder, "py.typed")))
        with open(os.path.join(folder, "__init__.pyi"), encoding="utf-8") as stream:
            stub = stream.read()
        compile(stub, "__init__.pyi", "exec")
        for function in self.functions():
            self.assertIn("\ndef " + function.__name__ + "(", stub)

    def test_the_version_is_the_one_in_the_file(self):
        with open(os.path.join(SOURCE, "VERSION"), encoding="utf-8") as stream:
            self.assertEqual(batten.__version__, stream.read().strip())


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1], verbosity=1)
