class Error(ValueError):
    """The input breaks a rule; no result exists.

    `code` is permanent (docs/errors.md lists all of them), `place` tells where, `value` what stood
    there, `rule` what must hold.
    """

    def __init__(self, code, place, value, rule):
        super().__init__(code, place, value, rule)
        self.code, self.place, self.value, self.rule = code, place, value, rule

    def __str__(self):
        return f"{self.code}: {self.place}: {self.value}: {self.rule}"


class Cancelled(Exception):
    """A `progress` function said False, and the work stopped without a result."""


for _each in (Error, Cancelled):
    _each.__module__ = "batten"
