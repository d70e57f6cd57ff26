"""What the command promises: more points, fewer points, arcs and programs for machines.

usage: command_arcs_test.py COMMAND SOURCE_FOLDER
"""

import json
import math

from command_folder import Folder, main, points


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


if __name__ == "__main__":
    main()
