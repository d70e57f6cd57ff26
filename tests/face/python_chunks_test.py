"""What the Python module and the command promise: fits of data that come in blocks.

usage: python_chunks_test.py PACKAGE_PARENT COMMAND SOURCE_FOLDER
"""

import json
import os
import subprocess
import tempfile

import numpy

from python_module import COMMAND, Refusing, batten, command, main

KNOTS = numpy.linspace(0, 6, 13)


def data(count, seed=1):
    random = numpy.random.RandomState(seed)
    x = numpy.sort(random.uniform(0, 6, count))
    x[0], x[-1] = 0, 6
    sigma = 0.01 * (1 + x)
    return x, numpy.sin(x) + sigma * random.normal(size=count), sigma


class FitsAlike(Refusing):
    def assert_is_the_fit(self, report, expected):
        numpy.testing.assert_allclose(report["coefficients"], expected["coefficients"],
                                      rtol=0, atol=1e-11)
        numpy.testing.assert_allclose(report["covariance_band"]["upper"],
                                      expected["covariance_band"]["upper"], rtol=0, atol=1e-11)
        self.assertEqual(report["knots"], expected["knots"])
        self.assertEqual(report["samples"], expected["samples"])
        for key in ("delta2", "aic", "bic"):
            self.assertAlmostEqual(report[key] / expected[key], 1, delta=1e-10)


class Chunks(FitsAlike):
    x, y, sigma = data(1001)

    def test_blocks_of_any_size_merged_in_any_order_give_the_fit(self):
        expected = batten.fit({"x": self.x, "y": self.y, "sigma": self.sigma}, knots=KNOTS)
        for size in (1, 7, 400, 1001):
            chunks = []
            for start in range(0, 1001, size):
                part = slice(start, start + size)
                chunks.append(batten.FitChunk(KNOTS))
                chunks[-1].add(self.x[part], self.y[part], self.sigma[part])
            whole = batten.FitChunk(KNOTS)
            for chunk in reversed(chunks):
                whole.merge(chunk)
            made = whole.solve()
            self.assertEqual(whole.samples, 1001)
            self.assertEqual(whole.knots.tolist(), made.spline.t.tolist())
            self.assert_is_the_fit(made.report, expected.report)
            at = numpy.linspace(0, 6, 50)
            for ours, theirs in zip(made.spline.band(at, 1), expected.spline.band(at, 1)):
                numpy.testing.assert_allclose(ours, theirs, rtol=0, atol=1e-9)
            numpy.testing.assert_allclose(made.curve(at), expected.curve(at), rtol=0, atol=1e-11)

    def test_one_error_of_all_and_rows_without_weight(self):
        chunk = batten.FitChunk(KNOTS, degree=2)
        y, sigma = self.y.copy(), numpy.full(1001, 0.02)
        y[500], sigma[500] = 99, numpy.inf
        chunk.add(self.x, y, sigma)
        other = batten.FitChunk(KNOTS, degree=2)
        kept = numpy.arange(1001) != 500
        other.add(self.x[kept], self.y[kept], 0.02)
        other.add([], [])
        self.assertEqual((chunk.samples, chunk.degree), (1000, 2))
        self.assert_is_the_fit(chunk.solve().report, other.solve().report)

    def test_what_makes_no_sense_is_refused(self):
        chunk = batten.FitChunk(KNOTS)
        self.refused("fit.outside", lambda: chunk.add([7.0], [1.0]))
        self.refused("fit.lengths", lambda: chunk.add([1.0, 2.0], [1.0]))
        self.refused("fit.sigma", lambda: chunk.add([1.0], [1.0], 0))
        self.refused("fit.sigma", lambda: chunk.add([1.0], [1.0], [-1.0]))
        self.refused("points.not-finite", lambda: chunk.add([1.0], [numpy.nan]))
        self.refused("option.value", lambda: chunk.add([[1.0]], [[1.0]]))
        self.refused("fit.chunks-differ", lambda: chunk.merge(batten.FitChunk(KNOTS, 2)))
        self.refused("fit.too-few", chunk.solve)
        self.refused("fit.knots", lambda: batten.FitChunk([1.0]))
        self.refused("fit.knots", lambda: batten.FitChunk([0.0, 2, 1, 3]))
        self.refused("option.range", lambda: batten.FitChunk(KNOTS, 10))


class Streams(FitsAlike):
    """batten fit --stream"""

    many = data(400_000)
    knots = ("--knots", "equal", "--intervals", "12")

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name

    def path(self, name):
        return os.path.join(self.folder, name)

    def reports(self, path, *options):
        return [json.loads(command("fit", path, *options, *more)[1])["report"]
                for more in ((), ("--stream",))]

    def assert_streams_alike(self, path, *options):
        expected, report = self.reports(path, *options)
        self.assert_is_the_fit(report, expected)
        self.assertEqual(report["psi"], expected["psi"])
        self.assertAlmostEqual(report["max_residual"], expected["max_residual"], delta=1e-11)
        self.assertEqual(report["sigma_source"], expected["sigma_source"])
        return report

    def test_an_array_in_blocks_gives_the_fit(self):
        numpy.save(self.path("a.npy"), numpy.stack(self.many, axis=1))
        report = self.assert_streams_alike(self.path("a.npy"), *self.knots, "--sigma", "#3")
        self.assertEqual(report["samples"], 400_000)
        self.assert_streams_alike(self.path("a.npy"), "--knots", "0,1,2,2,4", "--sigma", "0.1")

    def test_a_text_in_blocks_gives_the_fit_and_tells_the_right_lines(self):
        rows = [f"{s!r};{x!r};{y!r}" for x, y, s in zip(*map(numpy.ndarray.tolist, self.many))]
        head = ["# measured at night", "sigma;x;y"]
        rows[300_000:300_000] = ["# a break", ""]
        path = self.path("a.csv")
        self.write(path, head + rows)
        self.assertGreater(os.path.getsize(path), 2 << 23)
        self.assert_streams_alike(path, *self.knots)
        for bad, error_id in (("1;2;nan", "points.not-finite"), ("-1;2;3", "fit.sigma"),
                              ("1;2", "table.ragged")):
            rows[350_000] = bad
            self.write(path, head + rows)
            self.assert_refused(error_id, path, *self.knots, says="row 350003")

    def write(self, path, lines):
        with open(path, "w", encoding="utf-8") as stream:
            stream.write("\n".join(lines))

    def assert_refused(self, error_id, *arguments, says=""):
        done = subprocess.run([COMMAND, "fit", *arguments, "--stream"], capture_output=True,
                              text=True, timeout=60)
        self.assertEqual(done.returncode, 2, done.stderr)
        self.assertTrue(done.stderr.startswith("batten: error: " + error_id + ": "), done.stderr)
        self.assertIn(says, done.stderr)

    def test_what_needs_all_samples_at_once_is_refused(self):
        path = self.path("a.npy")
        numpy.save(path, numpy.stack(self.many[:2], axis=1)[:50])
        self.assert_refused("fit.streamed", path, "--sigma", "1", says="knots")
        self.assert_refused("fit.streamed", path, *self.knots, says="sigma")
        self.assert_refused("fit.streamed", path, *self.knots, "--robust", says="robust")
        self.assert_refused("fit.streamed", path, *self.knots, "--parametric", says="parametric")
        numpy.save(path, numpy.asfortranarray(numpy.stack(self.many, axis=1)[:50]))
        self.assert_refused("table.streamed", path, *self.knots, "--sigma", "1")
        self.refused("table.streamed", lambda: batten.fit([[0, 0], [1, 1]], stream=True))


if __name__ == "__main__":
    main()
