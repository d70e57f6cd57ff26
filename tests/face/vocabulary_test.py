"""The faces use the same words: flags of the command, keys of jobs, keywords of Python.

usage: vocabulary_test.py PACKAGE_PARENT COMMAND
"""

import functools
import inspect
import json
import keyword
import os
import re
import subprocess
import sys
import unittest

PARENT, COMMAND = (os.path.abspath(name) for name in sys.argv[1:3])
sys.path.insert(0, PARENT)
import batten  # noqa: E402

FLAG = re.compile(r"^ {2}(?:-\w, | {4})--([a-z0-9-]+)", re.MULTILINE)


def run(*arguments, input=None):
    return subprocess.run([COMMAND, *arguments], input=input, capture_output=True, text=True,
                          timeout=60)


@functools.lru_cache(None)
def help_of(*verb):
    return run(*verb, "--help").stdout


def verbs():
    block = help_of().split("Verbs:\n")[1].split("\n\n")[0]
    names = re.findall(r"^  ([a-z-]+)", block, re.MULTILINE)
    return [name for name in names if name != "run"]


def flags(verb):
    """Options of a verb and the flags all verbs share, as its help lists them."""
    text = help_of(verb)
    own, _, shared = text.partition("\nFiles and messages:\n")
    return FLAG.findall(own), FLAG.findall(shared)


def step_of(verb):
    """A step of a job with an input, if the verb takes one."""
    step = {"operation": verb}
    if "\nInput:\n" in help_of(verb):
        step["input"] = "nowhere"
    return step


def keywords(verb):
    signature = inspect.signature(getattr(batten, verb.replace("-", "_")))
    names = [name for name, parameter in signature.parameters.items()
             if parameter.kind is parameter.KEYWORD_ONLY]
    return [name[:-1] if keyword.iskeyword(name[:-1]) else name for name in names]


class OneVocabulary(unittest.TestCase):
    def test_every_verb_is_a_function_and_every_flag_a_keyword(self):
        self.assertGreater(len(verbs()), 8)
        for verb in verbs():
            words = [flag.replace("-", "_") for flag in flags(verb)[0]]
            self.assertEqual(words + ["progress"], keywords(verb), verb)

    def test_every_flag_is_a_key_of_a_jobs_options(self):
        for verb in verbs():
            words = [flag.replace("-", "_") for flag in flags(verb)[0]]
            for more, known in (([], True), (["no_such_word"], False)):
                step = {**step_of(verb), "options": dict.fromkeys(words + more)}
                message = run("run", "-", input=json.dumps(step)).stderr
                self.assertEqual("option.unknown" not in message, known, (verb, message))

    def test_shared_flags_are_keys_of_a_step(self):
        for verb in verbs():
            shared = set(flags(verb)[1]) - {"help", "quiet", "progress"}
            step = {**step_of(verb), **{flag: flag + ".svg" for flag in shared}}
            message = run("run", "-", input=json.dumps(step)).stderr
            self.assertNotIn("job.", message.replace("job.json", ""), (verb, message))

    def test_the_words_of_choices_are_the_same(self):
        for verb in verbs():
            text = " ".join(help_of(verb).split())
            doc = getattr(batten, verb.replace("-", "_")).__doc__
            for block in re.findall(r"^    .*: ('.*')$", doc, re.MULTILINE):
                self.assertIn(block.replace("'", ""), text, verb)

    def test_reports_show_options_by_the_same_words(self):
        made = batten.interpolate([[0, 0], [1, 1], [2, 0], [3, 1]])
        self.assertEqual(list(made.options), keywords("interpolate")[:-1])


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1], verbosity=1)
