"""Runs the command in an empty folder: what the tests of the command share.

Each of them is called with COMMAND SOURCE_FOLDER.
"""

import json
import os
import subprocess
import sys
import tempfile
import unittest

COMMAND = os.path.abspath(sys.argv[1])
POINTS = os.path.join(os.path.abspath(sys.argv[2]), "cases", "points")


def points(name):
    return os.path.join(POINTS, name)


def fits(name):
    return os.path.join(os.path.abspath(sys.argv[2]), "cases", "fits", name)


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


def main():
    unittest.main(argv=sys.argv[:1], verbosity=1)
