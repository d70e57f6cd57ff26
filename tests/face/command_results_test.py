"""What the command promises: curves made, measured, drawn and compared.

usage: command_results_test.py COMMAND SOURCE_FOLDER
"""

import json
import math
import os

from command_folder import POINTS, Folder, fits, main, points


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


if __name__ == "__main__":
    main()
