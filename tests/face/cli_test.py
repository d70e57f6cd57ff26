"""What the command promises: results, files, pipes, messages and exit statuses.

usage: cli_test.py COMMAND SOURCE_FOLDER
"""

import json
import math
import os
import subprocess
import sys
import tempfile
import unittest

COMMAND = os.path.abspath(sys.argv[1])
POINTS = os.path.join(os.path.abspath(sys.argv[2]), "cases", "points")


def points(name):
    return os.path.join(POINTS, name)


class Folder(unittest.TestCase):
    """Each test runs in an empty folder of its own."""

    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)

    def path(self, name):
        return os.path.join(self.folder.name, name)

    def file(self, name, content):
        with open(self.path(name), "wb") as stream:
            stream.write(content.encode() if isinstance(content, str) else content)
        return self.path(name)

    def run_command(self, *arguments, input=None):
        return subprocess.run([COMMAND, *arguments], input=input, capture_output=True, text=True,
                              cwd=self.folder.name, timeout=60)

    def good(self, *arguments, input=None):
        done = self.run_command(*arguments, input=input)
        self.assertEqual(done.returncode, 0, done.stderr)
        return done

    def report(self, *arguments, input=None):
        self.good(*arguments, "--quiet", "--report", self.path("r.json"), input=input)
        with open(self.path("r.json"), encoding="utf-8") as stream:
            return json.load(stream)

    def refused(self, error_id, *arguments, says=(), input=None):
        """Bad input: exit status 2, one line with the id, and no file that was not there."""
        before = sorted(os.listdir(self.folder.name))
        done = self.run_command(*arguments, input=input)
        last = done.stderr.strip().splitlines()[-1]
        self.assertEqual(done.returncode, 2, done.stderr)
        self.assertTrue(last.startswith("batten: error: " + error_id + ": "), last)
        for words in says:
            self.assertIn(words, last)
        self.assertEqual(done.stdout, "")
        self.assertEqual(sorted(os.listdir(self.folder.name)), before)


class Results(Folder):
    def test_a_circle_of_eight_points_has_the_length_and_area_of_the_paper_method(self):
        rows = "\n".join(f"{math.cos(k * math.pi / 4)!r},{math.sin(k * math.pi / 4)!r}"
                         for k in range(8))
        report = self.report("interpolate", self.file("circle.csv", rows), "--closed",
                             "-o", self.path("c.json"))
        self.assertEqual(report["operation"], "interpolate")
        self.assertEqual(report["status"], "met")
        self.assertAlmostEqual(report["report"]["length"], 6.28149539109290, delta=1e-11)
        self.assertAlmostEqual(report["report"]["area"], 3.13989653532265, delta=1e-11)
        self.assertEqual(len(report["report"]["tangent_angles"]), 8)

    def test_the_curve_file_says_its_format_and_reads_back_to_the_same_numbers(self):
        self.good("interpolate", points("violin.csv"), "--closed", "-o", self.path("a.json"))
        with open(self.path("a.json"), encoding="utf-8") as stream:
            self.assertEqual(json.load(stream)["format"], "batten.curve/1")
        self.good("convert", self.path("a.json"), "-o", self.path("b.json"))
        with open(self.path("a.json"), "rb") as a, open(self.path("b.json"), "rb") as b:
            self.assertEqual(a.read(), b.read())

    def test_verbs_read_what_other_verbs_write(self):
        curve = self.good("interpolate", points("violin.csv"), "--closed").stdout
        measured = json.loads(self.good("measure", "-", input=curve).stdout)
        self.assertEqual(measured["operation"], "measure")
        self.assertGreater(measured["report"]["length"], 1000)
        rows = self.good("evaluate", "-", "--count", "5", "--derivatives", "1", input=curve).stdout
        lines = rows.strip().splitlines()
        self.assertEqual(len(lines), 6)
        again = self.good("interpolate", "-", "--method", "natural-chord", "--columns", "x,y",
                          input=rows)
        self.assertIn("batten.curve/1", again.stdout)

    def test_every_method_goes_through_the_points(self):
        for method in ("pseudo-spline", "natural-uniform", "natural-chord", "hermite-chord",
                       "hermite-arc", "spline", "log-aesthetic"):
            curve = self.good("interpolate", points("violin.csv"), "--method", method).stdout
            compared = self.report("compare", "-", "--to", points("violin.csv"), input=curve)
            self.assertLess(compared["report"]["max"], 1e-12 * 400)

    def test_a_log_aesthetic_segment_is_a_curve_that_other_verbs_read(self):
        segment = self.good("log-aesthetic", "--points", "0,0,1,0,1,1", "--alpha", "0.5").stdout
        measured = self.report("measure", "-", input=segment)
        self.assertAlmostEqual(measured["report"]["length"], math.pi / 2, delta=1e-13)
        report = self.report("log-aesthetic", "--points", "0,0,1,0,1.3,0.9", "--alpha", "2",
                             "-o", self.path("c.json"), "--draw", self.path("c.svg"))
        self.assertTrue(report["report"]["drawable"])
        self.assertEqual(len(report["report"]["curvatures"]), 2)
        self.good("draw", self.path("c.json"), "--lcg", "-o", self.path("lcg.svg"))

    def test_an_undrawable_segment_exits_3_and_writes_no_curve(self):
        done = self.run_command("log-aesthetic", "--points", "0,0,1,0,1,20", "--alpha=-1",
                                "-o", "c.json", "--draw", "c.svg", "--report", "r.json")
        self.assertEqual(done.returncode, 3, done.stderr)
        self.assertIn("no arc of alpha -1", done.stderr)
        self.assertEqual(sorted(os.listdir(self.folder.name)), ["r.json"])
        with open(self.path("r.json"), encoding="utf-8") as stream:
            self.assertEqual(json.load(stream)["status"], "not_met")

    def test_noisy_points_come_out_fair_in_the_columns_they_were_given(self):
        rows = "\n".join(f"{t},{t * 0.1!r},{math.sin(t * 0.1) + 0.001 * (t * 7 % 5 - 2)!r}"
                         for t in range(60))
        table = self.file("p.csv", "n,east,north\n" + rows + "\n")
        report = self.report("fair", table, "--columns", "east,north", "--tolerance", "0.01",
                             "-o", self.path("f.csv"), "--draw", self.path("f.svg"))["report"]
        self.assertLessEqual(report["max_displacement"], 0.01)
        for key in ("alpha", "sweeps", "rms_displacement", "linearity_residual", "segments"):
            self.assertIn(key, report)
        with open(self.path("f.csv"), encoding="utf-8") as stream:
            lines = stream.read().splitlines()
        self.assertEqual((lines[0], len(lines)), ("east,north", 61))
        arcs = self.good("fair", table, "--columns", "east,north", "--as", "arcs").stdout
        self.assertEqual(json.loads(arcs)["kind"], "log-aesthetic")
        self.good("fair", table, "--columns", "east,north", "--engine", "filter", "--alpha=-1",
                  "--spacing", "kept", "--split", "--tolerance", "0.01", "--sweeps", "1000")

    def test_compare_exits_3_where_a_point_is_out_of_tolerance(self):
        self.good("interpolate", points("violin.csv"), "-o", self.path("c.json"))
        moved = self.file("moved.csv", "x,y\n0,0\n500,0\n")
        done = self.run_command("compare", self.path("c.json"), "--to", moved, "--tolerance", "1")
        self.assertEqual(done.returncode, 3, done.stderr)

    def test_a_picture_a_path_and_samples_are_written_by_suffix(self):
        for name in ("c.svg", "c.csv", "c.json"):
            self.good("interpolate", points("rae2822.dat"), "-o", self.path(name),
                      "--draw", self.path("picture.svg"))
            self.assertGreater(os.path.getsize(self.path(name)), 1000)
        with open(self.path("picture.svg"), encoding="utf-8") as stream:
            self.assertTrue(stream.read().startswith("<"))

    def test_a_parameter_column_of_the_table_is_found_by_its_name(self):
        table = self.file("p.csv", "u,x,y\n0,0,0\n1,1,1\n3,2,0\n4,3,1\n")
        self.good("interpolate", table, "--method", "spline", "--parameter", "u",
                  "--columns", "x,y", "-o", self.path("c.json"))
        with open(self.path("c.json"), encoding="utf-8") as stream:
            self.assertEqual(json.load(stream)["breaks"], [0, 1, 3, 4])

    def test_a_closed_curve_with_its_first_point_repeated_is_accepted_with_a_note(self):
        square = self.file("s.csv", "0,0\n1,0\n1,1\n0,1\n0,0\n")
        report = self.report("interpolate", square, "--closed", "-o", self.path("c.json"))
        self.assertTrue(any("repeat" in note for note in report["report"]["notes"]))

    def test_an_exact_fold_back_gives_a_finite_curve(self):
        fold = self.file("f.csv", "0,0\n2,0\n1,0\n3,0\n")
        report = self.report("interpolate", fold, "-o", self.path("c.json"))
        self.assertTrue(math.isfinite(report["report"]["length"]))

    def test_help_of_every_verb_lists_its_options(self):
        top = self.good("--help").stdout
        for verb in ("interpolate", "measure", "evaluate", "compare", "convert", "fair",
                     "log-aesthetic", "draw"):
            self.assertIn(verb, top)
            self.assertIn("--report", self.good(verb, "--help").stdout)
        self.assertIn("--weight-exponent", self.good("interpolate", "--help").stdout)

    def test_the_version_is_the_one_in_the_file(self):
        with open(os.path.join(POINTS, "..", "..", "VERSION"), encoding="utf-8") as stream:
            self.assertEqual(self.good("--version").stdout.strip(), stream.read().strip())


class BadInput(Folder):
    def interpolating(self, error_id, content, *more, says=(), name="p.csv"):
        self.refused(error_id, "interpolate", self.file(name, content), "-o", "out.json", *more,
                     says=says)

    def test_files_that_hold_no_points(self):
        self.interpolating("file.empty", "", says=["p.csv"])
        self.interpolating("points.too-few", "1,2\n", says=["p.csv", ": 1: "])
        self.interpolating("table.ragged", "0,0\n1,1,1\n", says=["row 2"])
        self.interpolating("table.not-a-number", "x,y\n0,0\n1,one\n2,2\n",
                           says=["row 3", "column y", "one"])
        self.interpolating("points.not-finite", "x,y\n0,0\n1,nan\n", says=["row 3", "column y"])
        self.interpolating("points.not-finite", "x,y\n0,0\n1,inf\n", says=["row 3", "column y"])
        self.interpolating("number.overflow", "x,y\n0,0\n1,1e999\n", says=["row 3", "column y"])

    def test_points_that_make_no_curve(self):
        self.interpolating("points.repeated", "# a\nx,y\n0,0\n1,1\n1,1\n2,0\n",
                           says=["rows 4 and 5"])
        self.interpolating("points.all-equal", "1,1\n1,1\n1,1\n", says=["p.csv"])
        self.interpolating("number.overflow", "0,0\n1e308,1e308\n-1e308,1e308\n")

    def test_points_that_cannot_be_made_fair(self):
        few = self.file("few.csv", "0,0\n1,0\n2,1\n3,1\n")
        self.refused("points.too-few", "fair", few, says=["few.csv"])
        arc = self.file("arc.csv", "\n".join(f"{math.cos(k / 9)!r},{math.sin(k / 9)!r}"
                                             for k in range(9)))
        self.refused("fair.tolerance-below-sigma", "fair", arc, "--sigma", "0.1",
                     "--tolerance", "0.01")
        self.refused("fair.closed-has-no-ends", "fair", arc, "--closed", "--fix-ends", "position")
        self.refused("option.value", "fair", arc, "--alpha", "much", says=["--alpha"])
        self.refused("option.range", "fair", arc, "--alpha", "nan", says=["--alpha"])
        self.refused("log-aesthetic.points", "log-aesthetic", "--points", "0,0,1,0")

    def test_files_that_cannot_be_read_or_written(self):
        self.refused("file.missing", "interpolate", "nowhere.csv", says=["nowhere.csv"])
        self.refused("file.directory", "interpolate", self.folder.name)
        good = self.file("p.csv", "0,0\n1,1\n")
        self.refused("file.unwritable", "interpolate", good, "-o", "no/such/folder/c.json",
                     says=["no/such/folder"])
        self.refused("output.format", "interpolate", good, "-o", "c.xyz", says=["xyz", "json"])

    def test_a_declared_array_without_its_body(self):
        header = "{'descr': '<f8', 'fortran_order': False, 'shape': (100000000, 2), }"
        header += " " * (118 - len(header) - 1) + "\n"
        content = b"\x93NUMPY\x01\x00" + bytes([118, 0]) + header.encode() + b"\0" * 64
        self.interpolating("npy.truncated", content, name="big.npy")

    def test_hostile_json(self):
        self.interpolating("json.too-deep", "[" * 100000, name="p.json")
        self.interpolating("json.syntax", "[[0, 0], [1, ", name="p.json", says=["line 1"])
        self.refused("json.too-deep", "measure", self.file("c.json", '{"a":' * 100000))

    def test_columns_and_options_that_do_not_exist(self):
        self.interpolating("table.unknown-column", "x,y\n0,0\n1,1\n", "--columns", "x,z",
                           says=["z"])
        self.interpolating("option.choice", "0,0\n1,1\n", "--method", "magic",
                           says=["--method", "pseudo-spline"])
        self.interpolating("option.value", "0,0\n1,1\n", "--weight-exponent", "much",
                           says=["--weight-exponent"])
        self.interpolating("option.range", "0,0\n1,1\n", "--weight-exponent", "1e9",
                           says=["--weight-exponent"])
        self.interpolating("usage", "0,0\n1,1\n", "--no-such-flag", says=["--no-such-flag"])
        self.refused("usage")
        self.refused("input.kind", "measure", self.file("q.csv", "0,0\n1,1\n"),
                     says=["batten interpolate"])

    def test_nothing_written_is_ever_nan(self):
        for rows in ("0,0\n1e-300,0\n0,1e-300\n", "0,0\n1e150,0\n0,1e150\n", "0,0\n1,0\n2,0\n"):
            done = self.run_command("interpolate", self.file("p.csv", rows), "--report", "r.json",
                                    "-o", "c.json", "--draw", "d.svg")
            for name in ("r.json", "c.json", "d.svg"):
                if os.path.exists(self.path(name)):
                    with open(self.path(name), encoding="utf-8") as stream:
                        text = stream.read().lower()
                    self.assertNotIn("nan", text)
                    self.assertNotIn("inf", text.replace("inflection", ""))
            self.assertIn(done.returncode, (0, 2), done.stderr)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1], verbosity=1)
