"""Fair curves through points, and how good they are.

Every operation of the command line is a function here, with the same words:

    made = batten.interpolate(points, closed=True, corner=[6, 12])
    made.curve(t)            # points of the curve; made.curve(t, 1) derivatives
    made.report["length"]
"""

from ._core import *
from ._core import __version__
from ._error import Cancelled, Error
