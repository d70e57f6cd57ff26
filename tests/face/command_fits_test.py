"""What the command promises: fits of data with known errors.

usage: command_fits_test.py COMMAND SOURCE_FOLDER
"""

import json
import math
import os

from command_folder import Folder, fits, main, points


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
        top = min(report["report"]["extrema"], key=lambda e: abs(e["t"] - 900))
        self.assertLess(abs(top["t"] - 899), 3)
        self.assertEqual(top["kind"], "maximum")
        told = self.report("evaluate", self.path("t.json"), "--extrema")["report"]["extrema"]
        for one, other in zip(report["report"]["extrema"], told, strict=True):
            self.assertEqual(one["kind"], other["kind"])
            for key in ("t", "deviation", "value", "value_deviation"):
                self.assertAlmostEqual(one[key], other[key], delta=1e-9 * abs(one[key]))
        at = self.good("evaluate", self.path("t.json"), "--at", str(top["t"]), "--band",
                       "68.26894921370859").stdout.splitlines()[1].split(",")
        self.assertAlmostEqual(float(at[2]), top["value"], delta=1e-12)
        self.assertAlmostEqual(float(at[3]), top["value_deviation"], delta=1e-9)
        self.assertLess(top["deviation"], 2)
        self.assertGreater(report["report"]["integral"]["deviation"], 0)

    def test_a_fit_is_a_curve_that_other_verbs_read(self):
        curve = self.good("fit", fits("titanium.csv"), "--quiet").stdout
        rows = self.good("evaluate", "-", "--at", "595,900", input=curve).stdout.splitlines()
        self.assertEqual(len(rows), 3)
        self.assertAlmostEqual(float(rows[2].split(",")[2]), 2.17, delta=0.05)
        measured = json.loads(self.good("measure", "-", input=curve).stdout)
        self.assertGreater(measured["report"]["length"], 480)

    def test_parameters_in_a_file_stand_in_one_column(self):
        self.good("fit", fits("titanium.csv"), "-o", self.path("t.json"))
        one = self.good("evaluate", self.path("t.json"), "--at",
                        self.file("one.csv", "t\n595\n900\n")).stdout
        self.assertEqual(one, self.good("evaluate", self.path("t.json"), "--at", "595,900").stdout)
        self.refused("option.value", "evaluate", self.path("t.json"), "--at",
                     self.file("two.csv", "x,y\n600,610\n700,710\n"), says=("2 columns",))

    def test_knots_that_fit_badly_are_told(self):
        report = self.report("fit", fits("titanium.csv"), "--intervals", "1")["report"]
        self.assertEqual(report["chi2_p"], 0)
        self.assertTrue(any("residuals are larger" in note for note in report["notes"]))

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

    def test_the_third_of_three_columns_without_names_holds_the_errors(self):
        rows = "".join(f"{i},{i * i % 7},{1 + i % 3}\n" for i in range(12))
        named, plain = self.file("n.csv", "x,y,sigma\n" + rows), self.file("p.csv", rows)
        reports = [self.report("fit", table)["report"] for table in (named, plain)]
        self.assertEqual(reports[1]["sigma_source"], "column")
        self.assertEqual(reports[0]["coefficients"], reports[1]["coefficients"])
        asked = self.report("fit", plain, "--sigma", "2")["report"]
        self.assertEqual(asked["sigma_source"], "number")

    def test_the_ordinates_are_the_first_other_column(self):
        rows = "".join(f"{7 - i},{i},{i * i},1\n" for i in range(9))
        table = self.file("n.csv", "n,time,v,sigma\n" + rows)
        one = self.report("fit", table, "--x", "time")["report"]
        other = self.report("fit", table, "--x", "time", "--y", "n")["report"]
        self.assertEqual(one["coefficients"], other["coefficients"])
        last = self.report("fit", table, "--y", "n")["report"]
        self.assertEqual(last["breaks"], [0, 8])

    def test_a_third_column_that_is_not_used_is_told(self):
        table = self.file("c.csv", "conc,volt,err\n" + "".join(
            f"{i},{i * i % 7},{0.1 + i}\n" for i in range(12)))
        notes = self.report("fit", table)["report"]["notes"]
        self.assertIn("column err is not used; if it holds the errors, --sigma err takes it", notes)
        notes = self.report("fit", table, "--sigma", "err")["report"]["notes"]
        self.assertFalse([note for note in notes if "not used" in note])

    def test_a_fit_is_compared_with_the_table_it_was_made_of(self):
        rows = [(i, 0.25 * i * i, 0.1) for i in range(12)]
        table = self.file("c.csv", "conc,volt,err\n" + "".join(
            f"{x},{y},{s}\n" for x, y, s in rows))
        self.good("fit", table, "--sigma", "err", "-o", self.path("c.json"))
        found = self.report("compare", self.path("c.json"), "--to", table)["report"]
        self.assertLess(abs(found["max"]), 1e-9)
        self.good("draw", self.path("c.json"), table, "-o", self.path("c.svg"))
        job = [{"operation": "fit", "input": table, "options": {"sigma": "err"}, "name": "f"},
               {"operation": "compare", "input": "f", "options": {"to": table},
                "report": self.path("j.json")}]
        self.good("run", self.file("job.json", json.dumps(job)))
        known = self.file("k.csv", "x,y,sigma\n0,0,1\n1,1,1\n2,0,1\n")
        space = self.file("s.csv", "x,y,z\n0,0,0\n1,1,1\n2,0,1\n")
        self.good("interpolate", self.file("p.csv", "0,0\n1,1\n2,0\n"), "-o",
                  self.path("p.json"))
        self.good("compare", self.path("p.json"), "--to", known)
        self.refused("points.dimension", "compare", self.path("p.json"), "--to", space,
                     says=["s.csv", "3 coordinates"])

    def test_a_table_read_in_blocks_has_a_picture_with_its_band(self):
        table = self.file("s.csv", "x,y,sigma\n" + "".join(
            f"{100 * i},{math.sin(0.3 * i)},0.01\n" for i in range(40)))
        self.good("fit", table, "--stream", "--knots", "equal", "--intervals", "6", "-o",
                  self.path("s.json"), "--draw", self.path("s.svg"))
        with open(self.path("s.svg"), encoding="utf-8") as stream:
            picture = stream.read()
        for words in ("95 % band", "dy/dx", "knots"):
            self.assertIn(f">{words}<", picture)

    def test_errors_may_stand_in_a_file_of_their_own(self):
        table = self.file("d.csv", "x,y\n" + "".join(f"{i},{i * i % 7}\n" for i in range(12)))
        errors = self.file("s.txt", "".join(f"{1 + i % 3}\n" for i in range(12)))
        whole = self.file("w.csv", "x,y,sigma\n" + "".join(
            f"{i},{i * i % 7},{1 + i % 3}\n" for i in range(12)))
        self.assertEqual(self.report("fit", table, "--sigma", errors)["report"],
                         self.report("fit", whole)["report"])
        job = {"operation": "fit", "input": table, "options": {"sigma": [1 + i % 3
                                                                          for i in range(12)]},
               "report": self.path("j.json")}
        self.good("run", self.file("job.json", json.dumps(job)))
        with open(self.path("j.json"), encoding="utf-8") as stream:
            self.assertEqual(json.load(stream)["report"], self.report("fit", whole)["report"])
        self.refused("fit.lengths", "fit", fits("titanium.csv"), "--sigma", errors)

    def test_knots_and_degree_of_the_file_of_a_fit_change(self):
        fit, more = self.path("t.json"), self.path("more.json")
        self.good("fit", fits("titanium.csv"), "--knots", "equal", "--intervals", "6", "-o", fit)
        done = self.report("convert", fit, "--insert-knots", "700,700,900", "--elevate", "1", "-o",
                           more)["report"]
        self.assertEqual(done["pieces"], 8)
        self.assertLess(done["max_error"], 1e-11)
        done = self.report("convert", more, "--remove-knots", "-o", self.path("fewer.json"))
        self.assertEqual(done["status"], "met")
        self.assertEqual(done["report"]["pieces"], 6)
        self.assertGreaterEqual(done["report"]["removed"], 3)
        self.assertLess(self.report("compare", self.path("fewer.json"), "--to", fit)["report"]["max"],
                        1e-2)
        rows = self.good("convert", fit, "--as", "power").stdout.splitlines()
        self.assertEqual(rows[0], "from,to,x0,x1,x2,x3,y0,y1,y2,y3")
        self.assertEqual(len(rows), 7)

    def test_parametric_fits_go_near_the_points(self):
        report = self.report("fit", points("violin.csv"), "--parametric", "--closed", "--sigma",
                             "2", "-o", self.path("v.json"))
        self.assertEqual(report["report"]["samples"], 36)
        with open(self.path("v.json"), encoding="utf-8") as stream:
            self.assertTrue(json.load(stream)["closed"])
        self.good("fit", points("violin.csv"), "--parametric", "--sigma", "2", "-o",
                  self.path("v.csv"), "--draw", self.path("v.svg"))

    def test_the_file_of_a_fit_knows_its_bands(self):
        made = self.report("fit", fits("titanium.csv"), "--knots", "835,865,880,895,910,955", "-o",
                           self.path("t.json"))["report"]
        band = made["covariance_band"]
        at = [band["x"][i] for i in (0, 50, 137, 200)]
        where = ",".join(repr(x) for x in at)
        rows = self.good("evaluate", self.path("t.json"), "--at", where, "--derivatives", "1",
                         "--band").stdout.splitlines()
        self.assertEqual(rows[0], "t,x,y,d1x,d1y,y_band,d1y_band")
        for row, i in zip(rows[1:], (0, 50, 137, 200)):
            cells = [float(cell) for cell in row.split(",")]
            self.assertAlmostEqual(cells[2] + cells[5], band["upper"][i], 12)
            self.assertGreater(cells[6], 0)
        asked = ("evaluate", self.path("t.json"), "--integral", "595,1075", "--roots", "--extrema",
                 "-o", self.path("e.csv"), "--band")
        answers = self.report(*asked, "68.26894921370859")["report"]
        self.assertAlmostEqual(answers["integral_band"], made["integral"]["deviation"], 9)
        self.assertEqual(answers["roots_band"], [])
        for half, extremum in zip(answers["extrema_band"], made["extrema"]):
            self.assertAlmostEqual(half, extremum["deviation"], 9)
        wide = self.report(*asked, "99")["report"]
        self.assertGreater(wide["integral_band"], 2.5 * answers["integral_band"])

    def test_a_band_is_refused_of_curves_that_have_none(self):
        self.good("fit", fits("titanium.csv"), "-o", self.path("t.json"))
        self.good("convert", self.path("t.json"), "--trim", "600,700", "-o", self.path("part.json"))
        self.refused("curve.no-band", "evaluate", self.path("part.json"), "--band")
        self.refused("option.range", "evaluate", self.path("t.json"), "--band", "100")

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

    def test_options_without_effect_are_refused(self):
        for given in (["--columns", "f,x"], ["--corrections", "3"], ["--delta2", "3", "--knots", "700"],
                      ["--sigma-model", "0,1", "--sigma", "1"]):
            self.refused("fit.options", "fit", fits("titanium.csv"), *given,
                         says=(given[0] + ": ",))

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

    def test_a_spline_with_jumps_is_read_again(self):
        rows = ["x,y,sigma"]
        for k in range(200):
            x = k / 199
            noise = 0.05 * math.sin(37.0 * k * k)
            rows.append(f"{x},{(2 if x > 0.4 else -1) + noise},0.05")
        data = self.file("step.csv", "\n".join(rows) + "\n")
        self.good("fit", data, "--knots", "pruned", "-o", self.path("step.json"))
        with open(self.path("step.json"), encoding="utf-8") as stream:
            self.assertEqual(json.load(stream)["kind"], "b-spline-graph")
        self.good("evaluate", self.path("step.json"), "--at", "0.2,0.8", "--derivatives", "1",
                  "--band", "-o", self.path("at.csv"))
        with open(self.path("at.csv"), encoding="utf-8") as stream:
            low, high = [[float(c) for c in line.split(",")] for line in stream.read().split()[1:]]
        self.assertAlmostEqual(low[2], -1, delta=0.1)
        self.assertAlmostEqual(high[2], 2, delta=0.1)
        answers = self.report("evaluate", self.path("step.json"), "--integral", "0,1", "--roots",
                              "--extrema", "--band", "--draw", self.path("step.svg"))["report"]
        self.assertAlmostEqual(answers["integral"], 0.6 * 2 - 0.4, delta=0.03)
        self.assertEqual(len(answers["roots"]), 1)
        self.assertAlmostEqual(answers["roots"][0], 0.4, delta=0.01)
        self.assertEqual(answers["roots_band"], [None])
        self.good("draw", self.path("step.json"), "-o", self.path("drawn.svg"))
        self.refused("curve.jumps", "measure", self.path("step.json"), says=["evaluate and draw"])
        self.refused("curve.jumps", "fit", data, "--knots", "pruned", "-o", self.path("step.svg2"),
                     "--format", "svg")
        self.good("fit", data, "--degree", "0", "--knots", "equal", "--intervals", "5", "-o",
                  self.path("steps.json"))
        self.good("evaluate", self.path("steps.json"), "--count", "7", "-o", self.path("steps.csv"))

    def test_a_corner_is_known_as_its_knot_is(self):
        rows = ["x,y,sigma"]
        for k in range(300):
            x = k / 299
            rows.append(f"{x},{2 - 5 * abs(x - 0.4) + 0.05 * math.sin(91.0 * k * k)},0.05")
        data = self.file("corner.csv", "\n".join(rows) + "\n")
        report = self.report("fit", data, "--knots", "pruned", "-o",
                             self.path("corner.json"))["report"]
        top = min(report["extrema"], key=lambda e: abs(e["t"] - 0.4))
        self.assertAlmostEqual(top["t"], 0.4, delta=0.01)
        self.assertAlmostEqual(top["value"], 2, delta=0.1)
        self.assertIsNone(top["deviation"])
        answers = self.report("evaluate", self.path("corner.json"), "--extrema",
                              "--band")["report"]
        at = min(range(len(answers["extrema"])),
                 key=lambda k: abs(answers["extrema"][k]["t"] - 0.4))
        self.assertIsNone(answers["extrema_band"][at])


if __name__ == "__main__":
    main()
