"""What the command promises: results, files, pipes, messages and exit statuses.

usage: cli_test.py COMMAND SOURCE_FOLDER
"""

import json
import math
import os
import re
import shutil
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
                       "hermite-arc", "spline", "lagrange-2", "lagrange-3", "arc-chain",
                       "log-aesthetic"):
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

    def samples(self, *arguments, input=None):
        """The header and the rows of numbers that `sample` writes."""
        lines = self.good("sample", *arguments, "--quiet", input=input).stdout.splitlines()
        return lines[0], [[float(cell) for cell in line.split(",")] for line in lines[1:]]

    def test_sample_reads_what_interpolate_writes_and_keeps_count_and_columns(self):
        curve = self.good("interpolate", points("violin.csv"), "--closed").stdout
        header, rows = self.samples("-", "--count", "100", input=curve)
        self.assertEqual(header, "i,time,s,t,x,y,tx,ty,kappa,speed")
        self.assertEqual(len(rows), 100)
        self.assertEqual([row[0] for row in rows], list(range(100)))
        steps = [b[2] - a[2] for a, b in zip(rows, rows[1:])]
        self.assertLess(max(steps) - min(steps), 1e-11 * rows[-1][2])
        header, rows = self.samples("-", "--law", "s-curve", "--duration", "2", "--fps", "10",
                                    input=curve)
        self.assertEqual(len(rows), 21)
        self.assertEqual(rows[-1][1], 2)
        self.assertEqual((rows[0][-1], rows[-1][-1]), (0, 0))

    def assert_places(self, rows, places):
        self.assertEqual(len(rows), len(places))
        for row, x in zip(rows, places):
            self.assertAlmostEqual(row[4], x, delta=1e-14 * 10)

    def test_sample_takes_its_laws_from_files(self):
        line = self.good("interpolate", self.file("l.csv", "0,0\n10,0\n")).stdout
        places = self.file("p.txt", "# arc lengths, the last two as shares\n0\n2.5\n0.5r\n1r\n")
        rows = self.samples("-", "--law", "positions", "--positions", places, input=line)[1]
        self.assert_places(rows, [0, 2.5, 5, 10])
        rows = self.samples("-", "--law", "positions", "--positions", "0,0.25r,10", input=line)[1]
        self.assert_places(rows, [0, 2.5, 10])
        steps = self.file("w.csv", "1\n3\n4\n2\n")
        rows = self.samples("-", "--law", "relative", "--weights", steps, input=line)[1]
        self.assert_places(rows, [0, 1, 4, 8, 10])
        keys = self.file("k.csv", "time,s\n0,0\n1,6\n3,6\n4,10\n")
        rows = self.samples("-", "--law", "keyframes", "--keys", keys, "--fps", "1",
                            input=line)[1]
        self.assert_places(rows, [0, 6, 6, 6, 10])
        weights = self.file("d.csv", "s,w\n0,1\n10,3\n")
        rows = self.samples("-", "--law", "weight", "--weights", weights, "--count", "3",
                            input=line)[1]
        self.assertAlmostEqual(rows[1][4], 5 * (5 ** 0.5 - 1), delta=1e-12)  # x + x^2 / 10 = 10

    def test_sample_draws_and_reports_and_the_paper_method_takes_points(self):
        report = self.report("sample", points("violin.csv"), "--method", "harada-nakamae",
                             "--count", "200", "-o", self.path("s.csv"),
                             "--draw", self.path("s.svg"))
        self.assertGreater(report["report"]["max_position_error"], 0)
        for key in ("length", "max_spacing_error", "duration", "overrun", "correction"):
            self.assertIn(key, report["report"])
        self.assertGreater(os.path.getsize(self.path("s.svg")), 1000)

    def test_draw_marks_equal_distances(self):
        self.good("interpolate", points("violin.csv"), "--closed", "-o", self.path("c.json"))
        self.good("draw", self.path("c.json"), "--samples", "50", "-o", self.path("c.svg"))
        self.good("draw", self.path("c.json"), "-o", self.path("d.svg"))
        self.assertGreater(os.path.getsize(self.path("c.svg")), os.path.getsize(self.path("d.svg")))

    def test_options_may_stand_before_the_input(self):
        self.good("interpolate", "--method", "natural-chord", points("violin.csv"))
        self.good("fit", "--degree", "2", fits("titanium.csv"))

    def test_help_of_every_verb_lists_its_options(self):
        top = self.good("--help").stdout
        verbs = top.split("Verbs:\n")[1].split("\n\n")[0].splitlines()
        names = [line.split()[0] for line in verbs if not line.startswith("   ")]
        self.assertGreaterEqual(len(names), 15)
        for verb in names:
            text = self.good(verb, "--help").stdout
            self.assertIn("--quiet", text)
            self.assertLessEqual(max(len(line) for line in text.splitlines()), 100, verb)
            self.assertNotIn("\n\n\n", text)
            self.assertIn("Usage: batten " + verb + " ", text)
        self.assertIn("batten interpolate POINTS ", self.good("interpolate", "--help").stdout)
        self.assertNotIn("--draw ", self.good("draw", "--help").stdout)
        self.assertIn("--weight-exponent", self.good("interpolate", "--help").stdout)

    def test_progress_is_told_on_standard_error_only_when_it_is_wanted(self):
        file = self.file("wave.csv", "".join(f"{i},{i % 3}\n" for i in range(60)))
        done = self.good("interpolate", file, "--quiet", "--progress", "always")
        lines = done.stderr.splitlines()
        self.assertTrue(all(line.startswith("batten interpolate: ") for line in lines), lines)
        self.assertEqual(lines[-1], "batten interpolate: 100 %")
        self.assertEqual(self.good("interpolate", file, "--quiet").stderr, "")

    def test_the_version_is_the_one_in_the_file(self):
        with open(os.path.join(POINTS, "..", "..", "VERSION"), encoding="utf-8") as stream:
            self.assertEqual(self.good("--version").stdout.strip(), stream.read().strip())


HALF_ELLIPSE = "east,north\n" + "".join(
    f"{2 * math.cos(math.pi * k / 6)!r},{math.sin(math.pi * k / 6)!r}\n" for k in range(7))


class MorePointsAndArcs(Folder):
    def test_densify_keeps_the_points_and_the_names_of_their_columns(self):
        made = self.good("densify", "-", "--degree", "3", "--end-degree", "2", "--between", "1",
                         input=HALF_ELLIPSE).stdout.splitlines()
        self.assertEqual(made[0], "east,north")
        numbers = [[float(x) for x in row.split(",")] for row in made[1:]]
        self.assertEqual(numbers[::2], [[float(x) for x in row.split(",")]
                                        for row in HALF_ELLIPSE.splitlines()[1:]])
        self.assertEqual(len(numbers), 13)

    def test_densify_within_a_tolerance_says_how_far_the_curve_is_from_its_chords(self):
        report = self.report("densify", "-", "--tolerance", "1e-3", "-o", self.path("d.csv"),
                             "--draw", self.path("d.svg"), input=HALF_ELLIPSE)["report"]
        self.assertEqual(report["points_in"], 7)
        self.assertGreater(report["points_out"], 20)
        self.assertLessEqual(report["max_chord_error"], 1e-3)
        self.assertAlmostEqual(math.degrees(report["max_tangent_jump"]), 0.81, delta=0.01)

    def test_thin_gives_back_few_points_from_which_densify_makes_the_curve(self):
        many = self.good("densify", "-", "--between", "40", input=HALF_ELLIPSE).stdout
        report = self.report("thin", "-", "--tolerance", "1e-2", "-o", self.path("t.csv"),
                             "--draw", self.path("t.svg"), input=many)["report"]
        self.assertEqual(report["points_in"], 247)
        self.assertLess(report["points_out"], 20)
        self.assertLessEqual(report["max_error"], 1e-2)

    def test_thin_keeps_the_other_columns_of_its_rows(self):
        rows = ["time,x,y,label,z2"] + [f"{i},{i * 0.1},0,p{i},{i * i}" for i in range(11)]
        done = self.good("thin", "-", "--tolerance", "1e-3", input="\n".join(rows))
        self.assertEqual(done.stdout.splitlines()[0], "time,x,y,z2")
        self.assertEqual(done.stdout.splitlines()[-1], "10,1,0,100")

    def test_the_summary_of_arcs_is_short(self):
        summary = self.good("arcs", "-", input=HALF_ELLIPSE).stderr
        self.assertLess(max(len(line) for line in summary.splitlines()), 80)

    def test_arcs_slow_down_by_a_law_of_motion(self):
        self.good("arcs", "-", "--feed", "300", "--feed-law", "smoothstep", "-o",
                  self.path("a.gcode"), input=HALF_ELLIPSE)
        with open(self.path("a.gcode"), encoding="utf-8") as stream:
            # the two arcs in the middle take the same time
            feeds = [float(line.split("F")[1]) for line in stream if "F" in line]
        self.assertEqual((max(feeds), len(feeds)), (300, 5))
        self.refused("option.missing", "arcs", "-", "--feed-law", "time-optimal", "-o",
                     self.path("b.gcode"), input=HALF_ELLIPSE)

    def test_the_papers_chain_of_arcs_has_the_papers_radii(self):
        for start in (("--start-angle", "90"), ("--start-normal", "0"), ("--start-normal", "180")):
            report = self.report("arcs", "-", *start, "-o", self.path("a.json"),
                                 input=HALF_ELLIPSE)["report"]
            self.assertEqual((report["arcs"], report["lines"]), (6, 0))
            radii = [arc["radius"] for arc in report["arc"]]
            for radius, known in zip(radii, (0.600480947, 3.328889618, 2.451942577, 8.534838771,
                                             1.526927905, 0.841312613)):
                self.assertAlmostEqual(radius, known, delta=1e-9)
        self.assertEqual(set(report["arc"][0]),
                         {"start", "end", "center", "radius", "sweep", "error"})

    def test_arcs_along_a_curve_keep_within_the_tolerance(self):
        curve = self.good("interpolate", points("violin.csv"), "--closed", "--corner",
                          "6,12,24,30").stdout
        report = self.report("arcs", "-", "--tolerance", "0.1", "-o", self.path("a.json"),
                             "--draw", self.path("a.svg"), input=curve)["report"]
        self.assertLessEqual(report["max_error"], 0.1)
        measured = self.report("measure", self.path("a.json"))["report"]
        self.assertEqual(len(measured["joints"]), report["arcs"] + report["lines"])

    def test_arcs_are_written_for_machines_and_programs_by_suffix(self):
        for name in ("a.gcode", "a.dxf", "a.svg", "a.json", "a.csv"):
            self.good("arcs", "-", "--start-angle", "90", "--feed", "300", "--units", "inch",
                      "--decimals", "4", "--z", "-0.5", "--header", "(half an ellipse)",
                      "--footer", "M30", "-o", self.path(name), input=HALF_ELLIPSE)
        text = {}
        for name in ("a.gcode", "a.dxf", "a.svg"):
            with open(self.path(name), encoding="utf-8") as stream:
                text[name] = stream.read()
        lines = text["a.gcode"].splitlines()
        self.assertEqual(lines[:6], ["(half an ellipse)", "G20", "G90", "G17",
                                     "G0 X2 Y0", "G1 Z-0.5 F300"])
        self.assertTrue(lines[6].startswith("G3 X1.7321 Y0.5 I-0.6"), lines[6])
        self.assertEqual((len(lines), lines[-1]), (13, "M30"))
        self.assertIn("LWPOLYLINE", text["a.dxf"])
        self.assertEqual(text["a.svg"].count(" A "), 6)
        again = json.loads(self.good("measure", self.path("a.svg")).stdout)["report"]
        exact = json.loads(self.good("measure", self.path("a.json")).stdout)["report"]
        self.assertAlmostEqual(again["length"], exact["length"], delta=1e-9)

    def test_a_curve_is_converted_to_arcs_cubics_lines_and_drawings(self):
        self.good("interpolate", points("rae2822.dat"), "-o", self.path("c.json"))
        report = self.report("convert", self.path("c.json"), "--as", "arcs", "--tolerance", "1e-4",
                             "-o", self.path("c.gcode"))["report"]
        self.assertLessEqual(report["max_error"], 1e-4)
        with open(self.path("c.gcode"), encoding="utf-8") as stream:
            self.assertEqual(len([x for x in stream if x.startswith(("G1 ", "G2 ", "G3 "))]),
                             report["pieces"])
        self.good("convert", self.path("c.json"), "--as", "polyline", "--tolerance", "1e-3",
                  "-o", self.path("p.gcode"))
        self.good("convert", self.path("c.json"), "-o", self.path("spline.dxf"))
        with open(self.path("spline.dxf"), encoding="utf-8") as stream:
            self.assertIn("SPLINE", stream.read().split("ENTITIES")[1])

    def test_a_ring_that_no_chain_closes_is_said_to_be_missed(self):
        ring = self.file("r.csv", "0,0\n3,0\n3,1\n1,1.5\n")
        done = self.run_command("arcs", ring, "--closed", "--method", "chain",
                                "--report", self.path("r.json"), "-o", self.path("a.json"))
        self.assertEqual(done.returncode, 3, done.stderr)
        with open(self.path("r.json"), encoding="utf-8") as stream:
            self.assertIn("biarcs instead", json.load(stream)["report"]["notes"][0])

    def test_what_makes_no_sense_is_refused(self):
        p = self.file("p.csv", HALF_ELLIPSE)
        self.refused("option.range", "arcs", p, "--tolerance", "0", says=["--tolerance"])
        self.refused("option.range", "arcs", p, "--tolerance", "nan", says=["--tolerance"])
        self.refused("arcs.start-twice", "arcs", p, "--start-angle", "1", "--start-normal", "2")
        self.refused("option.range", "arcs", p, "--decimals", "12", "-o", "a.gcode")
        self.refused("output.format", "arcs", p, "-o", "a.step", says=["gcode", "dxf"])
        self.refused("dxf.layer", "arcs", p, "--layer", "a b", "-o", "a.dxf")
        self.refused("points.too-few", "densify", self.file("q.csv", "0,0\n1,1\n"),
                     says=["q.csv"])
        self.refused("densify.two-counts", "densify", p, "--between", "3", "--tolerance", "1e-3")
        self.refused("lagrange.parameters-not-increasing", "densify",
                     self.file("u.csv", "u,x,y\n0,0,0\n1,1,1\n1,2,0\n3,3,1\n"),
                     "--columns", "x,y", "--parameter", "u")
        self.refused("option.range", "thin", p, "--tolerance", "0")
        self.refused("input.kind", "densify", self.file("c.svg", "M0 0L1 1"))
        self.good("interpolate", p, "-o", self.path("c.json"))
        self.refused("curve.not-exact", "convert", "c.json", "-o", "c.gcode")
        self.refused("dxf.needs-r2000", "convert", "c.json", "-o", "c.dxf", "--dxf-version", "r12")
        self.refused("arcs.start-not-taken", "arcs", "c.json", "--start-angle", "0")
def fits(name):
    return os.path.join(POINTS, "..", "fits", name)


class Fits(Folder):
    """batten fit"""

    def test_the_titanium_data_stop_at_8_intervals_by_the_paper_rule(self):
        report = self.report("fit", fits("titanium.csv"), "--stop", "distribution",
                             "--distribution", "0.68,0.95,0.99", "-o", self.path("t.json"))
        self.assertEqual(report["status"], "met")
        self.assertEqual(report["report"]["intervals"], 8)
        self.assertAlmostEqual(report["report"]["delta2"], 27.883080, delta=1e-6)
        self.assertEqual(report["report"]["sigma_source"], "column")
        self.assertEqual(report["report"]["breaks"],
                         [595, 835, 865, 880, 895, 910, 925, 955, 1075])
        self.assertEqual(len(report["report"]["path"]), 8)
        self.assertEqual(len(report["report"]["covariance_band"]["x"]), 201)
        top = min(report["report"]["extrema"], key=lambda e: abs(e["value"] - 900))
        self.assertLess(abs(top["value"] - 899), 3)
        self.assertLess(top["deviation"], 2)
        self.assertGreater(report["report"]["integral"]["deviation"], 0)

    def test_a_fit_is_a_curve_that_other_verbs_read(self):
        curve = self.good("fit", fits("titanium.csv"), "--quiet").stdout
        rows = self.good("evaluate", "-", "--at", "595,900", input=curve).stdout.splitlines()
        self.assertEqual(len(rows), 3)
        self.assertAlmostEqual(float(rows[2].split(",")[2]), 2.17, delta=0.05)
        measured = json.loads(self.good("measure", "-", input=curve).stdout)
        self.assertGreater(measured["report"]["length"], 480)

    def test_a_table_of_residuals_is_written_by_suffix(self):
        self.good("fit", fits("titanium.csv"), "-o", self.path("t.csv"))
        with open(self.path("t.csv"), encoding="utf-8") as stream:
            lines = stream.read().splitlines()
        self.assertEqual(lines[0], "x,y,sigma,fit,residual")
        self.assertEqual(len(lines), 50)
        for line in lines[1:]:
            x, y, sigma, fit, residual = map(float, line.split(","))
            self.assertAlmostEqual(residual, y - fit, delta=1e-15)
            self.assertEqual(sigma, 0.02)

    def test_knots_come_as_a_list_or_in_a_file_with_or_without_the_ends(self):
        knots = self.file("knots.csv", "595\n800\n900\n1075\n")
        seen = [self.report("fit", fits("titanium.csv"), "--knots", how, "-o", self.path("t.csv"))
                for how in ("800,900", "595,800,900,1075", knots)]
        for report in seen:
            self.assertEqual(report["report"]["breaks"], [595, 800, 900, 1075])
            self.assertEqual(report["report"]["coefficients"], seen[0]["report"]["coefficients"])

    def test_robust_alone_means_reject_wherever_it_stands(self):
        rows = ["x,y"] + [f"{i},{(i % 7) * 0.01 + (2 if i == 30 else 0)}" for i in range(100)]
        table = self.file("d.csv", "\n".join(rows))
        for words in (("--robust", table, "--sigma", "0.05"), (table, "--sigma", "0.05", "--robust"),
                      (table, "--robust", "reject", "--sigma", "0.05")):
            report = self.report("fit", *words, "-o", self.path("o.csv"))
            self.assertEqual(report["options"]["robust"], "reject")
            self.assertEqual(report["report"]["rejected"], [30])

    def test_columns_are_picked_by_name_or_place_and_sigma_may_be_a_number(self):
        table = self.file("d.csv", "\n".join(
            ["label,time,value"] + [f"p{i},{i},{i * i}" for i in range(20)]))
        report = self.report("fit", table, "--x", "time", "--y", "#3", "--sigma", "2", "-o",
                             self.path("o.json"))
        self.assertEqual(report["report"]["sigma"], 2)
        self.assertEqual(report["report"]["sigma_source"], "number")
        self.assertLess(report["report"]["delta2"], 1e-20)

    def test_parametric_fits_go_near_the_points(self):
        report = self.report("fit", points("violin.csv"), "--parametric", "--closed", "--sigma",
                             "2", "-o", self.path("v.json"))
        self.assertEqual(report["report"]["samples"], 72)
        with open(self.path("v.json"), encoding="utf-8") as stream:
            self.assertTrue(json.load(stream)["closed"])
        self.good("fit", points("violin.csv"), "--parametric", "--sigma", "2", "-o",
                  self.path("v.csv"), "--draw", self.path("v.svg"))

    def test_pictures_are_drawn_for_every_kind_of_knots(self):
        for knots in ("auto", "equal", "free", "pruned"):
            self.good("fit", fits("titanium.csv"), "--knots", knots, "-o", self.path("t.csv"),
                      "--draw", self.path("t.svg"))
            self.assertGreater(os.path.getsize(self.path("t.svg")), 5000)

    def test_a_target_that_is_not_reached_exits_3(self):
        table = self.file("d.csv", "x,y\n" + "\n".join(f"{i // 2},{i % 2}" for i in range(20)))
        done = self.run_command("fit", table, "--sigma", "0.1", "--tolerance", "0.1", "-o",
                                self.path("o.csv"))
        self.assertEqual(done.returncode, 3, done.stderr)

    def test_bad_input_is_refused_with_its_id_and_line(self):
        good = [f"{i},{i % 3},1" for i in range(12)]

        def refused(error_id, content, *more, says=()):
            self.refused(error_id, "fit", self.file("d.csv", content), "-o", "out.json", *more,
                         says=says)

        def table(rows):
            return "x,y,sigma\n" + "\n".join(rows) + "\n"

        refused("fit.too-few", table(good[:3]))
        refused("fit.too-few", table(good), "--knots", "1,2,3,4,5,6,7,8,9,10")
        refused("fit.x-equal", table([f"5,{i},1" for i in range(12)]))
        refused("fit.sigma", table(good[:4] + ["4,1,0"] + good[5:]),
                says=("d.csv row 6", "column sigma"))
        refused("fit.sigma", table(good), "--sigma", "-1")
        refused("fit.sigma", table(good), "--sigma", "nan")
        refused("points.not-finite", table(good[:4] + ["4,1,nan"] + good[5:]), says=("row 6",))
        refused("fit.distribution", table(good), "--stop", "distribution", "--distribution",
                "0.9,0.5")
        refused("option.range", table(good), "--stop", "distribution", "--distribution", "0.9,1.5")
        refused("fit.knots", table(good), "--knots", "4,40")
        refused("fit.knots", table(good), "--knots", "6,4")
        refused("option.range", table(good), "--intervals", "0", says=("--intervals",))
        refused("points.not-finite", table(good[:5] + ["nan,1,1"] + good[6:]),
                says=("d.csv row 7", "column x"))
        refused("table.unknown-column", table(good), "--y", "height")
        refused("table.unknown-column", table(good), "--sigma", "error")


class Jobs(Folder):
    def job(self, steps):
        return self.file("job.json", json.dumps(steps))

    def test_a_step_of_a_job_does_what_the_verb_does(self):
        self.good("interpolate", points("violin.csv"), "--closed", "--corner", "6,12",
                  "--method", "hermite-arc", "-o", self.path("verb.json"),
                  "--report", self.path("verb.report"))
        job = self.job({"operation": "interpolate", "input": points("violin.csv"),
                        "options": {"closed": True, "corner": [6, 12], "method": "hermite-arc"},
                        "output": self.path("job.out.json"), "report": self.path("job.report")})
        self.assertEqual(self.good("run", job, "--quiet").stdout, "")
        for verb, step in (("verb.json", "job.out.json"), ("verb.report", "job.report")):
            with open(self.path(verb), "rb") as one, open(self.path(step), "rb") as other:
                self.assertEqual(one.read(), other.read())

    def test_steps_take_what_steps_before_them_made(self):
        job = self.job({"steps": [
            {"name": "more", "operation": "densify", "input": [[0, 0], [1, 1], [2, 0], [3, 1]],
             "options": {"between": 2}},
            {"name": "fair", "operation": "interpolate", "input": "more", "draw": "fair.svg"},
            {"name": "plain", "operation": "interpolate", "input": "more",
             "options": {"method": "natural-chord"}},
            {"operation": "draw", "inputs": ["plain", "fair", "more"], "output": "all.svg"},
            {"operation": "compare", "input": "fair", "options": {"to": "plain"}}]})
        report = json.loads(self.good("run", job).stdout)
        self.assertEqual(report["operation"], "compare")
        self.assertNotEqual(report["report"]["max"], 0)
        self.assertEqual(sorted(os.listdir(self.folder.name)), ["all.svg", "fair.svg", "job.json"])

    def test_a_parameter_column_of_an_earlier_step_is_found_by_its_name(self):
        job = self.job([
            {"name": "curve", "operation": "interpolate", "input": [[0, 0], [1, 1], [3, 0]]},
            {"name": "rows", "operation": "evaluate", "input": "curve", "options": {"count": 5}},
            {"operation": "interpolate", "input": "rows", "columns": "x,y",
             "options": {"method": "spline", "parameter": "t"}}])
        curve = json.loads(self.good("run", job).stdout)
        self.assertEqual(curve["breaks"], [0, 0.5, 1, 1.5, 2])

    def test_the_worst_step_decides_the_exit_status(self):
        job = self.job([
            {"name": "a", "operation": "interpolate", "input": [[0, 0], [1, 1], [2, 0]]},
            {"operation": "compare", "input": "a", "options": {"to": [[5, 5], [6, 6]],
                                                              "tolerance": 1}, "report": "r.json"},
            {"operation": "measure", "input": "a"}])
        self.assertEqual(self.run_command("run", job).returncode, 3)

    def test_nothing_is_written_when_a_later_step_is_bad(self):
        first = {"name": "a", "operation": "interpolate", "input": points("violin.csv"),
                 "output": "a.json", "draw": "a.svg"}
        def refused(error_id, second, says):
            self.refused(error_id, "run", self.job([first, second]),
                         says=["job.json step 2", *says])
        refused("option.range", {"operation": "interpolate", "input": points("violin.csv"),
                                 "options": {"weight_exponent": 99}}, ["weight_exponent"])
        refused("file.missing", {"operation": "measure", "input": "nowhere.json"},
                ["nowhere.json"])
        refused("input.kind", {"operation": "measure", "input": points("violin.csv")}, [])
        refused("file.missing", {"operation": "compare", "input": "a",
                                 "options": {"to": "nowhere.csv"}}, ["nowhere.csv"])
        refused("option.range", {"operation": "evaluate", "input": "a",
                                 "options": {"derivatives": 99}}, ["derivatives"])
        refused("points.repeated", {"operation": "interpolate", "input": [[0, 0], [0, 0], [1, 1]]},
                ["input"])
        refused("output.format", {"operation": "measure", "input": "a", "output": "m.xyz"}, [])
        refused("curve.outside", {"operation": "evaluate", "input": "a",
                                  "options": {"at": [1e9]}}, ["at"])
        self.refused("job.operation", "run", self.job({"operation": "magic"}))
        self.refused("json.syntax", "run", self.file("job.json", "[{"), says=["line 1"])
        self.refused("json.too-deep", "run", self.file("job.json", "[" * 100000))
        self.refused("file.missing", "run", "nowhere.json")


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
        self.interpolating("option.unknown", "0,0\n1,1\n", "--no-such-flag",
                           says=["--no-such-flag"])
        self.interpolating("option.unknown", "0,0\n1,1\n", "--metod", "natural",
                           says=["did you mean --method?"])
        self.interpolating("option.value", "0,0\n1,1\n", "--method", says=["--method"])
        self.interpolating("option.choice", "0,0\n1,1\n", "--progress", "loud",
                           says=["--progress", "loud"])
        self.interpolating("input.count", "0,0\n1,1\n", "second.csv", says=["second.csv"])
        self.refused("input.missing", "fit")
        self.refused("command.missing")
        self.refused("command.unknown", "fot", says=["did you mean fit?"])
        self.refused("input.kind", "measure", self.file("q.csv", "0,0\n1,1\n"),
                     says=["batten interpolate"])

    def test_nothing_is_lost_by_what_is_written(self):
        self.file("p.csv", "0,0\n1,1\n2,0\n")
        os.mkdir(self.path("d"))

        def refused(error_id, *more, says=()):
            self.refused(error_id, "interpolate", self.path("p.csv"), *more, says=says)

        refused("output.is-input", "-o", self.path("p.csv"), says=["p.csv"])
        refused("output.is-input", "-o", self.path("d/../p.csv"))
        refused("output.is-input", "-o", self.path("c.json"), "--report", self.path("p.csv"))
        refused("output.twice", "-o", self.path("c.json"), "--report", self.path("c.json"),
                says=["-o and --report"])
        refused("file.unwritable", "-o", self.path("c.json"), "--draw", self.path("no/c.svg"))
        refused("file.unwritable", "-o", self.path("c.json"), "--report", self.path("d"))
        self.good("interpolate", self.path("p.csv"), "-o", os.devnull, "--format", "json",
                  "--report", os.devnull)

    def test_a_full_device_is_told(self):
        if not os.path.exists("/dev/full"):
            self.skipTest("this system has no /dev/full")
        rows = self.file("p.csv", "0,0\n1,1\n2,0\n")
        with open("/dev/full", "w", encoding="utf-8") as full:
            done = subprocess.run([COMMAND, "interpolate", rows], stdout=full,
                                  stderr=subprocess.PIPE, text=True)
        self.assertEqual(done.returncode, 2)
        self.assertIn("file.unwritable: standard output", done.stderr)

    def test_samples_that_cannot_be_taken(self):
        self.good("interpolate", self.file("l.csv", "0,0\n10,0\n"), "-o", self.path("l.json"))
        line = self.path("l.json")

        def refused(error_id, *more, says=()):
            self.refused(error_id, "sample", line, *more, "-o", "out.csv", says=says)

        refused("option.missing", says=["--count"])
        refused("option.range", "--count", "1", says=["--count"])
        refused("option.choice", "--count", "5", "--law", "warp", says=["--law", "time-optimal"])
        refused("sample.options", "--count", "5", "--spacing", "1")
        refused("motion.positions", "--law", "positions", "--positions", "0,11", says=["row 2"])
        refused("motion.weights", "--law", "relative", "--weights", self.file("w.csv", "1\n-1\n"))
        refused("motion.keys", "--law", "keyframes", "--count", "5",
                "--keys", self.file("k.csv", "0,0\n0,5\n"))
        refused("option.missing", "--law", "time-optimal", "--count", "5", says=["--max-speed"])
        refused("option.range", "--law", "time-optimal", "--count", "5", "--max-speed", "0")
        refused("curve.dimension", "--count", "5", "--frames")
        self.refused("input.kind", "sample", self.file("p.csv", "0,0\n1,1\n"), "--count", "5")
        self.refused("input.kind", "sample", line, "--count", "5", "--method", "harada-nakamae")

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


class Surfaces(Folder):
    def grid(self):
        rows = ["," + ",".join(str(0.1 * j) for j in range(11))]
        for i in range(13):
            cells = [str((0.1 * i - 0.6) ** 2 + (0.1 * j - 0.5) ** 2) for j in range(11)]
            rows.append(",".join([str(0.1 * i)] + cells))
        return self.file("grid.csv", "\n".join(rows) + "\n")

    def test_a_grid_becomes_a_surface_and_its_level_line_a_curve(self):
        report = self.report("fit-surface", self.grid(), "--sigma", "0.01", "-o",
                             self.path("s.json"), "--draw", self.path("s.svg"))
        self.assertEqual(report["report"]["intervals"], [1, 1])
        self.assertEqual(report["report"]["samples"], 143)
        self.good("contour", self.path("s.json"), "--levels", "0.09", "-o", self.path("c.json"))
        circle = self.report("measure", self.path("c.json"))["report"]
        self.assertAlmostEqual(circle["length"], 0.6 * math.pi, places=5)
        for form in ("csv", "npy", "obj", "ply", "stl"):
            self.good("fit-surface", self.grid(), "-o", self.path("s." + form))
        for form in ("csv", "svg", "dxf"):
            self.good("contour", self.path("s.json"), "-o", self.path("c." + form))

    def test_pictures_of_surfaces_have_their_panels(self):
        self.good("fit-surface", self.grid(), "--sigma", "0.01", "-o", self.path("s.json"),
                  "--draw", self.path("s.svg"))
        self.good("contour", self.path("s.json"), "--levels", "0.1,0.2", "-o",
                  self.path("c.csv"), "--draw", self.path("c.svg"))
        for name, captions in (("s.svg", ("data and knot lines", "lines of equal height",
                                          "residuals", "the surface", "residual / σ")),
                               ("c.svg", ("lines of equal height", "the surface", ">0.1<"))):
            with open(self.path(name), encoding="utf-8") as stream:
                text = stream.read()
            for caption in captions:
                self.assertIn(caption, text)

    @unittest.skipUnless(shutil.which("gnuplot"), "needs gnuplot")
    def test_pictures_of_surfaces_are_png_by_gnuplot(self):
        self.good("fit-surface", self.grid(), "--sigma", "0.01", "--draw", self.path("s.png"))
        with open(self.path("s.png"), "rb") as stream:
            self.assertEqual(stream.read(4), b"\x89PNG")

    def test_noisy_heights_give_the_curvature_of_a_level_circle_to_a_hundredth(self):
        program = os.path.join(os.path.abspath(sys.argv[2]), "tools", "make_dome.py")
        dome = self.file("dome.csv", subprocess.run([sys.executable, program], check=True,
                                                    capture_output=True, text=True).stdout)
        self.good("fit-surface", dome, "--sigma", "0.002", "--degree", "5", "-o",
                  self.path("s.json"))
        self.good("contour", self.path("s.json"), "--levels", "0.835270211", "-o",
                  self.path("c.json"))
        self.good("evaluate", self.path("c.json"), "--count", "721", "--derivatives", "2", "-o",
                  self.path("d.csv"))
        with open(self.path("d.csv"), encoding="utf-8") as stream:
            rows = [[float(cell) for cell in line.split(",")] for line in list(stream)[1:]]
        for _, _, _, dx, dy, ddx, ddy in rows:
            bend = (dx * ddy - dy * ddx) / math.hypot(dx, dy) ** 3
            self.assertAlmostEqual(0.3 * bend, 1, delta=0.01)

    def surface(self):
        self.good("fit-surface", self.grid(), "--sigma", "0.01", "-o", self.path("s.json"))
        return self.path("s.json")

    def test_a_surface_is_evaluated_measured_cut_converted_and_drawn(self):
        surface = self.surface()
        rows = self.good("evaluate", surface, "--at", "0.7,0.4", "--derivatives", "2",
                         "--curvature").stdout.splitlines()
        self.assertEqual(rows[0], "x,y,z,z_x,z_y,z_xx,z_xy,z_yy,nx,ny,nz,gaussian,mean")
        for found, known in zip(rows[1].split(","), (0.7, 0.4, 0.02, 0.2, -0.2, 2, 0, 2)):
            self.assertAlmostEqual(float(found), known, places=9)
        places = self.file("places.csv", "x,y\n0.7,0.4\n0.6,0.5\n")
        self.assertEqual(self.good("evaluate", surface, "--at", places).stdout.count("\n"), 3)
        self.assertEqual(self.good("evaluate", surface, "--count", "5").stdout.count("\n"), 26)
        whole = self.report("evaluate", surface, "--integral", "0,1.2,0,1")["report"]
        self.assertAlmostEqual(whole["integral"], 0.244, places=9)
        measures = self.report("measure", surface)["report"]
        self.assertAlmostEqual(measures["integral"], 0.244, places=9)
        self.assertAlmostEqual(measures["gaussian_curvature"]["largest"]["value"], 4, places=6)
        cut = self.path("cut.json")
        self.good("section", surface, "--y", "0.5", "-o", cut)
        self.assertAlmostEqual(
            self.report("evaluate", cut, "--integral", "0,1.2")["report"]["integral"], 0.144,
            places=9)
        for form in ("json", "csv", "npy", "obj", "ply", "stl"):
            self.good("convert", surface, "--count", "9", "-o", self.path("c." + form))
        again = self.path("again.json")
        self.good("fit-surface", self.path("c.csv"), "--sigma", "0.01", "-o", again)
        patches = json.loads(self.good("convert", surface, "--format", "patches").stdout)
        self.assertEqual(len(patches["patches"]), 1)
        self.good("draw", surface, "--surface", "--contours", "5", "-o", self.path("picture.svg"))
        with open(self.path("picture.svg"), encoding="utf-8") as stream:
            self.assertIn("the surface", stream.read())

    def test_a_surface_refuses_what_is_asked_of_curves(self):
        surface = self.surface()
        self.refused("surface.option", "evaluate", surface, "--roots")
        self.refused("surface.option", "convert", surface, "--reverse")
        self.refused("surface.outside", "evaluate", surface, "--at", "0.7,4")
        self.refused("option.value", "evaluate", surface, "--at", "0.7")
        self.refused("surface.section", "section", surface)
        self.refused("surface.outside", "section", surface, "--x", "9")
        self.refused("input.kind", "compare", surface, "--to", surface)
        self.refused("input.kind", "fit", surface)

    def test_a_job_passes_surfaces_on(self):
        rows = [[(0.1 * i - 0.6) ** 2 + (0.1 * j - 0.5) ** 2 for j in range(11)] for i in range(13)]
        job = [{"operation": "fit-surface", "input": rows, "name": "bowl",
                "options": {"sigma": 0.01, "x": [0.1 * i for i in range(13)],
                            "y": [0.1 * j for j in range(11)]}},
               {"operation": "contour", "input": "bowl", "options": {"levels": [0.09]},
                "output": self.path("c.json")}]
        self.good("run", self.file("job.json", json.dumps(job)))
        circle = self.report("measure", self.path("c.json"))["report"]
        self.assertAlmostEqual(circle["length"], 0.6 * math.pi, places=5)
        job[1]["operation"] = "measure"
        job[1].pop("options")
        job[0]["input"][2].pop()
        self.refused("grid.ragged", "run", self.file("job.json", json.dumps(job)))

    def nodes(self):
        rows = ["v,u,z,x,y"]
        for i in range(9):
            for j in range(8):
                u, v = 0.1 * i, 0.1 * j
                bump = 0.001 * ((7 * i + 5 * j) % 3 - 1) if 0 < i < 8 and 0 < j < 7 else 0
                rows.append(f"{j},{i},{math.sin(v) + bump},{math.cos(v) * math.cos(u)},"
                            f"{math.cos(v) * math.sin(u)}")
        return self.file("nodes.csv", "\n".join(rows) + "\n")

    def test_a_grid_of_points_is_made_fair(self):
        report = self.report("fair-surface", self.nodes(), "-o", self.path("fair.csv"),
                             "--draw", self.path("fair.svg"))
        self.assertAlmostEqual(report["report"]["gaussian_curvature"]["rms"], 1, delta=0.1)
        with open(self.path("fair.csv"), encoding="utf-8") as stream:
            lines = stream.read().splitlines()
        self.assertEqual(lines[0], "u,v,x,y,z,gaussian,mean")
        self.assertEqual(len(lines), 73)
        self.good("fair-surface", self.path("fair.csv"), "-o", self.path("again.csv"))
        for form in ("obj", "ply", "stl"):
            self.good("fair-surface", self.nodes(), "-o", self.path("fair." + form))
        heights = self.report("fair-surface", self.grid(), "--border", "g1", "-o",
                              self.path("heights.csv"))
        self.assertLess(heights["report"]["max_displacement"], 1e-3)

    def test_the_papers_step_is_told_unstable(self):
        done = self.run_command("fair-surface", self.nodes(), "--engine", "filter", "-o",
                               self.path("fair.csv"))
        self.assertEqual(done.returncode, 3)

    def test_holes_of_a_grid_of_points_are_refused(self):
        with open(self.nodes(), encoding="utf-8") as stream:
            lines = stream.read().splitlines()
        self.refused("grid.holes", "fair-surface",
                     self.file("holed.csv", "\n".join(lines[:20] + lines[21:]) + "\n"))
        self.refused("grid.not-a-grid", "fair-surface",
                     self.file("twice.csv", "\n".join(lines + lines[-1:]) + "\n"))

    def test_what_is_no_grid_is_refused(self):
        bad = self.file("bad.csv", "x,y,f\n0,0,1\n0,1,1\n1,0,1\n")
        self.refused("grid.not-a-grid", "fit-surface", bad)
        self.refused("picture.format", "fit-surface", self.file("a.png", "text"))
        self.refused("surface.format", "contour", self.grid())


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1], verbosity=1)
