"""The Python module and the command side by side: what the module's tests share.

Each of them is called with PACKAGE_PARENT COMMAND SOURCE_FOLDER.
"""

import os
import pickle
import subprocess
import sys
import tempfile
import unittest

import numpy

PARENT, COMMAND, SOURCE = (os.path.abspath(name) for name in sys.argv[1:4])
sys.path.insert(0, PARENT)
import batten  # noqa: E402

POINTS = os.path.join(SOURCE, "cases", "points")
ZIGZAG = numpy.array([[0.0, 0], [1, 1], [2, 0], [3, 1], [4, 0]])


def command(*arguments):
    """The files that the command wrote: its output and its report."""
    with tempfile.TemporaryDirectory() as folder:
        output, report = (os.path.join(folder, name) for name in ("out.json", "report.json"))
        done = subprocess.run([COMMAND, *arguments, "--quiet", "-o", output, "--report", report],
                              capture_output=True, text=True, timeout=60)
        assert done.returncode in (0, 3), done.stderr
        with open(output, encoding="utf-8") as one, open(report, encoding="utf-8") as other:
            return one.read(), other.read()


class Refusing(unittest.TestCase):
    """Bad input: an error with its parts."""

    def refused(self, code, call):
        with self.assertRaises(batten.Error) as caught:
            call()
        error = caught.exception
        self.assertEqual(error.code, code)
        self.assertTrue(error.place and error.value and error.rule)
        self.assertEqual(str(error), f"{code}: {error.place}: {error.value}: {error.rule}")
        self.assertEqual(pickle.loads(pickle.dumps(error)).code, code)
        return error


def main():
    unittest.main(argv=sys.argv[:1], verbosity=1)
