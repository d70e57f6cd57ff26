"""The manual page and the completions know every verb, flag and word of the command.

usage: pages_test.py COMMAND FOLDER
"""

import os
import re
import shutil
import subprocess
import sys
import unittest

COMMAND, FOLDER = (os.path.abspath(name) for name in sys.argv[1:3])


def run(*arguments, **more):
    return subprocess.run(arguments, capture_output=True, text=True, timeout=60, **more)


def page(name):
    with open(os.path.join(FOLDER, name), encoding="utf-8") as stream:
        return stream.read()


def verbs():
    block = run(COMMAND, "--help").stdout.split("Verbs:\n")[1].split("\n\n")[0]
    return re.findall(r"^  ([a-z-]+)", block, re.MULTILINE)


def flags(verb):
    text = run(COMMAND, verb, "--help").stdout
    return re.findall(r"^ {2}(?:-\w, | {4})--([a-z0-9-]+)", text, re.MULTILINE)


def completed(*words):
    """What bash offers after these words, the last of them half typed."""
    script = (f'source "{FOLDER}/batten.bash"; COMP_WORDS=({" ".join(words)}); '
              f'[ -n "{words[-1]}" ] || COMP_WORDS+=(""); '
              'COMP_CWORD=$((${#COMP_WORDS[@]} - 1)); _batten; printf "%s\\n" "${COMPREPLY[@]}"')
    done = run("bash", "--norc", "-c", script, cwd=FOLDER)
    assert done.returncode == 0 and not done.stderr, done.stderr
    return done.stdout.split()


class Pages(unittest.TestCase):
    def test_the_manual_page_has_every_verb_and_flag(self):
        text = page("batten.1").replace("\\-", "-")
        for verb in verbs():
            self.assertIn(f'.SS "batten {verb} ', text)
            for flag in set(flags(verb)) - {"help"}:
                self.assertIn(f"\\fB--{flag}\\fR", text)

    @unittest.skipUnless(shutil.which("man") and shutil.which("groff"), "man or groff is missing")
    def test_the_manual_page_is_formatted_without_a_warning(self):
        done = run("man", "--warnings", "-l", os.path.join(FOLDER, "batten.1"),
                   env=dict(os.environ, LC_ALL="C.UTF-8", MANWIDTH="100", MANPAGER="cat"))
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertIn("--weight-exponent NUMBER", done.stdout)

    def test_bash_completes_verbs_flags_and_words(self):
        self.assertEqual(completed("batten", "''"), verbs() + ["--help", "--version"])
        self.assertEqual(completed("batten", "interp"), ["interpolate"])
        for verb in verbs():
            self.assertEqual([word[2:] for word in completed("batten", verb, "--")], flags(verb))
        self.assertEqual(completed("batten", "interpolate", "--method", "pseudo"),
                         ["pseudo-spline", "pseudo-spline-global"])
        self.assertIn("batten.1", completed("batten", "measure", "batten.1"))

    def test_the_other_shells_know_every_flag(self):
        zsh, fish = page("_batten"), page("batten.fish")
        for verb in verbs():
            self.assertIn(f"\n        {verb})\n", zsh)
            for flag in flags(verb):
                self.assertIn(f"'--{flag}[", zsh)
                self.assertIn(f"'__fish_seen_subcommand_from {verb}' -l {flag} ", fish)
        for shell, name in (("zsh", "_batten"), ("fish", "batten.fish")):
            if shutil.which(shell):
                self.assertEqual(run(shell, "-n", os.path.join(FOLDER, name)).returncode, 0)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1], verbosity=1)
