"""What the command promises: job files.

usage: command_jobs_test.py COMMAND SOURCE_FOLDER
"""

import json
import os

from command_folder import Folder, main, points


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


if __name__ == "__main__":
    main()
