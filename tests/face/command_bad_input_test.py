"""What the command promises: messages and exit statuses where input is bad.

usage: command_bad_input_test.py COMMAND SOURCE_FOLDER
"""

import json
import math
import os
import re
import subprocess

from command_folder import COMMAND, Folder, main


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

    def test_words_in_the_wrong_place_are_named(self):
        table = self.file("t.csv", "a,b,err\n" + "".join(f"{i},{i * i},0.1\n" for i in range(9)))
        self.refused("option.value", "fit", table, "--sigma", "--quiet",
                     says=["--sigma", "a value must follow", "--quiet"])
        self.refused("option.value", "fit", table, "-o", "--quiet", says=["-o"])
        self.refused("input.count", "fit", table, "second.csv", "-o", "x.json", "--quiet",
                     says=[": second.csv: "])
        self.good("fit", table, "--sigma", "err", "-o", self.path("t.json"))
        self.refused("input.count", "evaluate", self.path("t.json"), "--band", "abc", "--at", "5",
                     says=[": abc: "])
        self.refused("table.unknown-column", "fit", table, "--knots", "fre",
                     says=["did you mean free?"])
        self.refused("table.unknown-column", "fit", table, "--sigma", "nosuch.txt",
                     says=["there is no such file"])
        # A number below zero is a value.
        self.good("fit", table, "--sigma", "err", "--start-value", "-1")

    def test_options_that_would_do_nothing_are_refused(self):
        table = self.file("t.csv", "".join(f"{i},{i * i % 7},0.1\n" for i in range(40)))
        self.refused("fit.options", "fit", table, "--knots", "given", says=["--knots"])
        self.refused("fit.options", "fit", table, "--intervals", "4", "--stop", "gcv",
                     says=["--stop"])
        self.good("fit", table, "--intervals", "4", "--stop", "none", "-o", self.path("t.json"))
        curve = self.path("t.json")
        self.refused("option.unused", "convert", curve, "--count", "7", says=["--count"])
        self.refused("option.unused", "draw", curve, "--index", says=["--index"])
        self.refused("option.unused", "draw", curve, "--contours", "5", says=["--contours"])
        self.refused("option.unused", "draw", table, "--columns", "#1,#2", "--comb",
                     says=["--comb"])

    def test_messages_say_flags(self):
        points = self.file("p.csv", "".join(f"{i},{i % 3}\n" for i in range(12)))
        self.refused("fit.options", "fit", points, "--fix-ends",
                     says=["--fix-ends, --start-tangent, --end-tangent", "take --start-value"])
        self.refused("fair.closed-has-no-ends", "fair", points, "--closed", "--fix-ends",
                     "position", says=["--fix-ends"])

    def test_help_names_the_forms_that_are_written(self):
        verbs = self.run_command("--help").stdout.split("Verbs:\n")[1].split("\n\n")[0]
        for verb in re.findall(r"^  ([a-z-]+)", verbs, re.MULTILINE):
            if verb == "run":
                continue
            text = " ".join(self.run_command(verb, "--help").stdout.split())
            listed = re.search(r"where no suffix says it: (.*?) --report", text).group(1)
            forms = listed.replace(" or ", ", ").split(", ")
            given = [] if verb == "log-aesthetic" else ["nowhere"]
            done = self.run_command(verb, *given, "-o", "x.nonsense")
            self.assertIn("output.format", done.stderr)
            self.assertEqual(done.stderr.strip().split(" ", 2)[2].split("one of ")[-1]
                             .split("must be ")[-1].split(", "), forms, verb)

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


if __name__ == "__main__":
    main()
