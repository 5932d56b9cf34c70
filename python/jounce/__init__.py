# SPDX-License-Identifier: Apache-2.0
"""Motion tables and electronic cams, with exact limit checks.

    import jounce

    axis = jounce.Bounds(velocity=2, acceleration=10, jerk=100)   # u/s, u/s^2, u/s^3
    move = jounce.move_to(0, 1, axis)                             # time-optimal
    print(move.duration, move.check(axis.limits))
    t, motion = move.sample(0.001)                                # NumPy arrays

u is the unit of the axis, m that of its master. Arrays are broadcast by the rules of NumPy. Errors in the input raise
InputError; broken limits are findings in a Report.
"""
from . import _jounce
from ._errors import AxisError, AxisTimeout, InputError, MoveError
from ._jounce import *  # noqa: F403
from ._jounce import __version__
from ._values import Motion, State, Transfer

for _class in (AxisError, AxisTimeout, InputError, MoveError, Motion, State, Transfer):
    _class.__module__ = "jounce"

__all__ = ["__version__", "AxisError", "AxisTimeout", "InputError", "MoveError", "Motion", "State", "Transfer"]
__all__ += [name for name in vars(_jounce) if not name.startswith("_")]
