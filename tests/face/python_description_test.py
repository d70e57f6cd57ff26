"""What the Python module promises: signatures, texts and the stub file.

usage: python_description_test.py PACKAGE_PARENT COMMAND SOURCE_FOLDER
"""

import inspect
import os
import unittest

from python_module import SOURCE, batten, main


class Description(unittest.TestCase):
    def functions(self):
        return [value for name, value in vars(batten).items()
                if inspect.isbuiltin(value) and not name.startswith("read_")]

    def test_every_function_has_a_signature_and_a_text(self):
        self.assertGreater(len(self.functions()), 8)
        for function in self.functions():
            signature = inspect.signature(function)
            self.assertIn("progress", signature.parameters)
            self.assertIn("Returns an Outcome", function.__doc__)
            for keyword in list(signature.parameters)[1:-1]:
                self.assertIn("\n" + keyword + "\n", function.__doc__)

    def test_the_stub_file_declares_what_there_is(self):
        folder = os.path.dirname(batten.__file__)
        self.assertTrue(os.path.exists(os.path.join(folder, "py.typed")))
        with open(os.path.join(folder, "__init__.pyi"), encoding="utf-8") as stream:
            stub = stream.read()
        compile(stub, "__init__.pyi", "exec")
        for function in self.functions():
            self.assertIn("\ndef " + function.__name__ + "(", stub)

    def test_the_version_is_the_one_in_the_file(self):
        with open(os.path.join(SOURCE, "VERSION"), encoding="utf-8") as stream:
            self.assertEqual(batten.__version__, stream.read().strip())


if __name__ == "__main__":
    main()
