"""What the command promises: surfaces: fits, level lines, fair grids.

usage: command_surfaces_test.py COMMAND SOURCE_FOLDER
"""

import json
import math
import os
import shutil
import subprocess
import sys
import unittest

from command_folder import Folder, main


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

    def front(self):
        """A surface whose knot lines follow the front x = 0.4 + 0.2 y^2."""
        rows = ["," + ",".join(str(j / 20) for j in range(21))]
        for i in range(41):
            heights = [math.tanh((i / 40 - 0.4 - 0.2 * (j / 20) ** 2) / 0.1) for j in range(21)]
            rows.append(",".join(str(z) for z in [i / 40] + heights))
        lines = ["y,X1,X2,X3,X4,X5"]
        for j in range(5):
            y = j / 4
            lines.append(",".join(str(v) for v in [y] + [0.4 + 0.2 * y * y + o
                                                          for o in (-0.2, -0.1, 0, 0.1, 0.2)]))
        self.good("fit-surface", self.file("front.csv", "\n".join(rows) + "\n"), "--sigma", "0.01",
                  "--lines", self.file("lines.csv", "\n".join(lines) + "\n"), "-o",
                  self.path("front.json"), "--draw", self.path("front.svg"))
        return self.path("front.json")

    def numbers(self, name):
        with open(self.path(name), encoding="utf-8") as stream:
            lines = stream.read().split()
        return [dict(zip(lines[0].split(","), map(float, line.split(",")))) for line in lines[1:]]

    def test_every_verb_takes_a_surface_with_curved_knot_lines(self):
        front = self.front()
        self.good("evaluate", front, "--at", "0.5,0.3", "--derivatives", "2", "--curvature", "-o",
                  self.path("at.csv"))
        at = self.numbers("at.csv")[0]
        self.good("evaluate", front, "--at", "0.5,0.300001", "--derivatives", "1", "-o",
                  self.path("near.csv"))
        near = self.numbers("near.csv")[0]
        self.assertAlmostEqual((near["z"] - at["z"]) / 1e-6, at["z_y"], delta=1e-3)
        self.assertAlmostEqual((near["z_y"] - at["z_y"]) / 1e-6, at["z_yy"], delta=1e-2)
        length = math.hypot(1, at["z_x"], at["z_y"])
        self.assertAlmostEqual(at["nz"], 1 / length, places=12)

        whole = self.report("evaluate", front, "--integral", "0,1,0,1")["report"]["integral"]
        # Of tanh((x - phi) / w) over x from 0 to 1, then over y, by the rule of the middles.
        w, exact = 0.1, 0.0
        for k in range(1000):
            phi = 0.4 + 0.2 * ((k + 0.5) / 1000) ** 2
            exact += w * math.log(math.cosh((1 - phi) / w) / math.cosh(phi / w)) / 1000
        self.assertAlmostEqual(whole, exact, delta=2e-3)
        measured = self.report("measure", front)["report"]
        self.assertAlmostEqual(measured["integral"], whole, places=12)
        self.assertGreater(measured["area"], 2)

        line = self.report("contour", front, "--levels", "0", "-o", self.path("line.json"),
                           "--draw", self.path("line.svg"))["report"]["lines"]
        self.assertEqual(len(line), 1)
        # The arc length of x = 0.4 + 0.2 y^2 over y from 0 to 1.
        arc = 0.5 * math.sqrt(1.16) + math.asinh(0.4) / 0.8
        self.assertAlmostEqual(line[0]["length"], arc, delta=2e-3)

        for cut, place in (("--y", "y"), ("--x", "x")):
            self.good("section", front, cut, "0.45", "-o", self.path("cut.json"))
            self.good("evaluate", self.path("cut.json"), "--at", "0.3,0.6", "-o",
                      self.path("cut.csv"))
            for row in self.numbers("cut.csv"):
                x, y = (row["t"], 0.45) if place == "y" else (0.45, row["t"])
                self.good("evaluate", front, "--at", f"{x},{y}", "-o", self.path("one.csv"))
                self.assertAlmostEqual(row["y"], self.numbers("one.csv")[0]["z"], places=7)

        for form in ("csv", "npy", "obj", "ply", "stl", "json"):
            self.good("convert", front, "--count", "21", "-o", self.path("f." + form))
        self.refused("surface.patches", "convert", front, "--format", "patches", "-o",
                     self.path("p.json"), says=["no polynomial"])

    def test_a_grid_read_in_blocks_gives_the_same_surface(self):
        lines = ["--knots", "equal", "--intervals", "3,2", "--sigma", "0.01"]
        self.good("fit-surface", self.grid(), *lines, "-o", self.path("heights.npy"))
        for name in ("grid.csv", "heights.npy"):
            whole = self.report("fit-surface", self.path(name), *lines)["report"]
            blocks = self.report("fit-surface", self.path(name), *lines, "--stream", "--draw",
                                 self.path("s.svg"))["report"]
            self.assertEqual(blocks["knots_x"], whole["knots_x"])
            self.assertAlmostEqual(blocks["bic"], whole["bic"], places=9)
            self.assertEqual(blocks["psi"], whole["psi"])
        searched = self.report("fit-surface", self.grid(), "--stream")["report"]
        self.assertEqual(searched, self.report("fit-surface", self.grid())["report"])
        self.refused("fit-surface.streamed", "fit-surface", self.grid(), "--stream", "--scattered")

    def test_what_stands_line_by_line_is_turned_with_falling_lines(self):
        heights = [[math.sin(3 * i + 2 * j * j) for j in range(6)] for i in range(7)]
        x_sigma = [1 + i for i in range(7)]
        y_sigma = [1, 1, 1, 2, 5, 30]
        lines = ["--degree", "1", "--knots", "equal", "--intervals", "2,2"]
        seen = set()
        for x_way in (1, -1):
            for y_way in (1, -1):
                rows = ["c," + ",".join(str(j) for j in range(6)[::y_way])]
                rows += [",".join(str(v) for v in [i] + heights[i][::y_way])
                         for i in range(7)[::x_way]]
                grid = self.file("t.csv", "\n".join(rows) + "\n")
                products = ["--x-sigma", ",".join(map(str, x_sigma[::x_way])),
                            "--y-sigma", ",".join(map(str, y_sigma[::y_way]))]
                for more in ([], ["--stream"]):
                    report = self.report("fit-surface", grid, *products, *lines, *more)["report"]
                    seen.add(round(report["delta2"], 9))
                # The same heights without places, which are given.
                bare = ["0," + ",".join(str(j) for j in range(6))]
                bare += [",".join(str(v) for v in [i] + heights[i][::y_way]) for i in range(7)]
                if x_way < 0:
                    bare[1:] = [",".join(str(v) for v in [6 - i] + heights[i][::y_way])
                                for i in range(6, -1, -1)]
                places = ["--x", ",".join(str(i) for i in range(7)[::x_way]),
                          "--y", ",".join(str(j) for j in range(6)[::y_way])]
                for more in ([], ["--stream"]):
                    report = self.report("fit-surface", self.file("b.csv", "\n".join(bare) + "\n"),
                                         *places, *products, *lines, *more)["report"]
                    seen.add(round(report["delta2"], 9))
        self.assertEqual(len(seen), 1, seen)

    def test_scattered_columns_are_named_or_picked_or_refused(self):
        values = [(i, 100 + i % 7, 200 + i * i % 11, math.sin(i)) for i in range(60)]
        text = "".join(f"{i},{x},{y},{z}\n" for i, x, y, z in values)
        ids = self.file("ids.csv", "id,easting,northing,depth\n" + text)
        equal = ["--scattered", "--knots", "equal", "--intervals", "1,1", "--degree", "1"]
        self.refused("table.columns", "fit-surface", ids, *equal,
                     says=("id, easting, northing, depth", "--columns"))
        picked = self.report("fit-surface", ids, *equal, "--columns", "easting,northing,depth")
        self.assertEqual(picked["report"]["breaks_x"], [100, 106])
        named = self.file("named.csv", "id,x,y,z\n" + text)
        self.assertEqual(self.report("fit-surface", named, *equal)["report"], picked["report"])
        three = self.file("three.csv", "".join(f"{x},{y},{z}\n" for _, x, y, z in values))
        self.assertEqual(self.report("fit-surface", three, *equal)["report"], picked["report"])
        self.refused("fit.options", "fit-surface", self.grid(), "--columns", "a,b,c")

    def test_a_flat_grid_is_drawn(self):
        flat = self.file("flat.csv", ",0,1,2,3,4\n" + "".join(f"{i}" + ",2.5" * 5 + "\n"
                                                             for i in range(5)))
        self.good("fit-surface", flat, "-o", self.path("f.json"), "--draw", self.path("f.svg"))
        with open(self.path("f.svg"), encoding="utf-8") as picture:
            self.assertIn("one height: 2.5", picture.read())

    def test_lines_that_do_not_come_to_rest_are_told(self):
        grid = os.path.join(os.path.abspath(sys.argv[2]), "cases", "surfaces", "hatano-surface.csv")
        done = self.run_command("fit-surface", grid, "--sigma", "1", "--knots", "free",
                                "--intervals", "8,8", "-o", self.path("f.json"), "--quiet",
                                "--report", self.path("r.json"))
        self.assertEqual(done.returncode, 3, done.stderr)
        with open(self.path("r.json"), encoding="utf-8") as stream:
            report = json.load(stream)
        self.assertEqual(report["status"], "not_converged")
        self.assertTrue(any("come to rest" in note for note in report["report"]["notes"]))

    def test_given_lines_that_fit_badly_are_told(self):
        rows = ["," + ",".join(str(j / 20) for j in range(21))]
        for i in range(41):
            heights = [math.tanh((i / 40 - 0.5) / 0.02) for j in range(21)]
            rows.append(",".join(str(z) for z in [i / 40] + heights))
        report = self.report("fit-surface", self.file("step.csv", "\n".join(rows) + "\n"),
                             "--sigma", "0.01", "--lines",
                             self.file("far.csv", "y,X1\n0,0.8\n0.5,0.8\n1,0.8\n"))["report"]
        self.assertEqual(report["chi2_p"], 0)
        self.assertTrue(any("residuals are larger" in note for note in report["notes"]))

    def test_options_without_effect_are_refused(self):
        for given in (["--intervals", "3,3"], ["--stop", "aic"], ["--delta2", "3"],
                      ["--degree", "5"], ["--rule", "marginal"], ["--x-knots", "0.5"]):
            self.refused("fit.options", "fit-surface", self.grid(), "--knots", "curved", *given,
                         says=(given[0] + ": ",))
        rows = self.file("rows.csv", "x,y,z\n0,0,1\n1,0,2\n0,1,3\n1,1,5\n0.5,0.5,1\n")
        for given in (["--x", "0,1"], ["--lines", rows], ["--knots", "curved"]):
            self.refused("fit.options", "fit-surface", rows, "--scattered", *given,
                         says=(given[0] + ": ",))

    def test_the_report_of_given_lines_says_nothing_that_was_not_asked(self):
        lines = self.file("lines.csv", "y,X1,X2\n0,.3,.5\n.5,.4,.6\n1,.3,.5\n")
        report = self.report("fit-surface", self.grid(), "--sigma", "0.01", "--lines", lines,
                             "--intervals", "2")["report"]
        self.assertEqual(report["intervals"], [3, 2])
        self.assertEqual(report["parameters"], 6 * 5)
        self.assertEqual(len(report["lines"]), 2)
        self.assertEqual(report["breaks_y"], [0, 0.5, 1])
        self.assertEqual(report["sigma_source"], "number")
        self.assertNotIn("tensor_bic", report)
        self.assertNotIn("has_front", report)
        done = self.good("fit-surface", self.grid(), "--sigma", "0.01", "--lines", lines)
        self.assertIn("2 in the report", done.stderr)
        self.refused("fit.options", "fit-surface", self.grid(), "--lines", lines, "--stop", "aic")

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

    def test_what_is_asked_of_a_surface_is_answered_or_refused_in_its_own_words(self):
        surface = self.surface()
        for cut, header in ((("--x", "0.5"), "y,z"), (("--y", "0.5"), "x,z")):
            rows = self.good("section", surface, *cut, "--format", "csv").stdout.splitlines()
            self.assertEqual(rows[0], header)
            x, z = map(float, rows[5].split(","))
            place = f"0.5,{x}" if header == "y,z" else f"{x},0.5"
            at = self.good("evaluate", surface, "--at", place).stdout.splitlines()[1].split(",")
            self.assertAlmostEqual(float(at[2]), z, places=12)
        whole, turned, twice = (
            self.report("evaluate", surface, "--integral", part)["report"]["integral"]
            for part in ("0,1.2,0,1", "1.2,0,0,1", "1.2,0,1,0"))
        self.assertEqual([turned, twice], [-whole, whole])
        self.refused("surface.outside", "evaluate", surface, "--at", "3,0.5",
                     says=["domain [0, 1.2", "] x [0, 1]"])
        self.refused("option.range", "contour", surface, "--tolerance", "0", says=["--tolerance"])
        self.refused("option.unused", "contour", surface, "--levels", "0.1", "--count", "4",
                     says=["--count"])
        found = self.report("contour", surface, "--levels", "0.1,9999")["report"]
        self.assertEqual(found["notes"], ["no line at the level 9999"])
        for option in ("--comb", "--control-polygon", "--curvature", "--lcg", "--index"):
            self.refused("option.unused", "draw", surface, option, says=[option])
        self.refused("fit.options", "fit-surface", self.grid(), "--knots", "given",
                     says=["--knots", "--x-knots or --y-knots"])
        rows = self.file("rows.csv", "".join(f"{i % 7},{i % 5},{i}\n" for i in range(35)))
        self.refused("fit.options", "fit-surface", rows, "--scattered", "--knots", "curved",
                     says=["--knots", "grids"])
        self.refused("fit.knots", "fit-surface", self.grid(), "--x-knots", "9",
                     says=["x_knots 1"])

    def test_a_file_of_several_lines_is_read_by_every_verb(self):
        surface, lines = self.surface(), self.path("lines.json")
        self.good("contour", surface, "--levels", "0.04,0.09", "-o", lines)
        radii = [0.2, 0.3]
        reports = self.report("measure", lines)["report"]["curves"]
        for report, radius in zip(reports, radii):
            self.assertAlmostEqual(report["length"], 2 * math.pi * radius, places=5)
        rows = self.good("evaluate", lines, "--count", "3").stdout.splitlines()
        self.assertEqual(rows[0], "curve,t,x,y")
        self.assertEqual([row[0] for row in rows[1:]], list("000111"))
        self.assertEqual(len(self.good("sample", lines, "--count", "5").stdout.splitlines()), 11)
        self.assertEqual(self.report("draw", lines, "-o", self.path("d.svg"))["report"]["curves"], 2)
        self.good("measure", lines, "--draw", self.path("m.svg"))
        one, two = self.path("one.json"), self.path("two.json")
        self.good("convert", lines, "--only", "1", "-o", one)
        self.assertEqual(self.report("measure", one)["report"], reports[1])
        self.good("convert", lines, "--scale", "2", "-o", two)
        self.assertAlmostEqual(self.report("measure", two)["report"]["curves"][1]["length"],
                               2 * reports[1]["length"], places=9)
        self.good("convert", lines, "-o", self.path("two.dxf"))
        self.good("compare", lines, "--to", one)
        job = [{"operation": "contour", "input": surface, "options": {"levels": [0.04, 0.09]},
                "name": "lines"},
               {"operation": "measure", "input": "lines", "report": self.path("job.r.json")}]
        self.good("run", self.file("job.json", json.dumps(job)))
        with open(self.path("job.r.json"), encoding="utf-8") as stream:
            self.assertEqual(json.load(stream)["report"]["curves"], reports)

    def test_a_file_of_several_lines_is_refused_where_one_is_needed(self):
        surface, lines = self.surface(), self.path("lines.json")
        self.good("contour", surface, "--levels", "0.04,0.09", "-o", lines)
        self.refused("curve.several", "compare", lines, "--to", lines, says=["2 curves", "--only"])
        self.refused("option.range", "convert", lines, "--only", "2", says=["holds 2 curves"])
        self.refused("output.format", "convert", lines, "-o", self.path("x.gcode"))
        self.refused("curve.outside", "evaluate", lines, "--at", "99", says=["curve 0"])
        empty = self.file("empty.json", '{"format": "batten.contours/1", "lines": []}')
        self.refused("curve.entry", "measure", empty)
        broken = self.file("broken.json", '{"format": "batten.curves/1", "curves": [3]}')
        self.refused("curve.format", "measure", broken, says=["curves[0]"])

    def test_errors_of_nodes_come_from_files(self):
        grid = [[math.sin(0.3 * i * j) for j in range(8)] for i in range(9)]
        table = lambda rows: "\n".join(["," + ",".join(map(str, range(8)))] + [
            ",".join(map(str, [i, *row])) for i, row in enumerate(rows)])
        heights = self.file("z.csv", table(grid))
        errors = self.file("s.csv", table([[0.1 * (1 + i) * (2 + j) for j in range(8)]
                                           for i in range(9)]))
        rows = self.file("rows.txt", "\n".join(str(0.1 * (1 + i)) for i in range(9)))
        columns = ",".join(str(2 + j) for j in range(8))
        knots = ("--knots", "equal", "--intervals", "2,1")
        one = self.report("fit-surface", heights, *knots, "--sigma", errors)["report"]
        two = self.report("fit-surface", heights, *knots, "--x-sigma", rows, "--y-sigma", columns)
        three = self.report("fit-surface", heights, *knots, "--x-sigma", rows, "--y-sigma", columns,
                            "--stream")
        self.assertEqual(one["sigma_source"], "column")
        for other in (two["report"], three["report"]):
            self.assertEqual(other["sigma_source"], "column")
            self.assertAlmostEqual(other["aic"], one["aic"], delta=1e-6)
        self.refused("fit-surface.streamed", "fit-surface", heights, *knots, "--sigma", errors,
                     "--stream")
        self.refused("file.missing", "fit-surface", heights, "--sigma", "nowhere.csv",
                     says=["nowhere.csv"])
        self.refused("fit.options", "fit-surface", heights, "--sigma", "1", "--x-sigma", rows)

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
    main()
