# SPDX-License-Identifier: Apache-2.0
"""Types of arguments and results, for type checkers. `import jounce` does not load this module."""
import os
from collections.abc import Callable, Sequence
from typing import Any, Literal

import numpy as np
from numpy.typing import NDArray

from ._values import State

Array = NDArray[np.float64]
Values = Sequence[Any] | NDArray[Any]
NumberLike = float | Values
StateLike = float | Values | State[Any]
StrPath = str | os.PathLike[str]
Side = Literal["right", "left"]
Outside = Literal["refuse", "hold", "wrap", "advance"]
Rule = Literal["linear", "cubic_hermite", "quintic_hermite"]
Domain = Literal["time", "master"]
Sync = Literal["none", "time", "phase", "time_if_moving", "phase_or_time"]
Mode = Literal["aborting", "buffered", "blending_low", "blending_previous", "blending_next", "blending_high"]
Progress = Callable[[float, str], bool | None]
