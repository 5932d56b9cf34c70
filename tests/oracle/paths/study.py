# SPDX-License-Identifier: Apache-2.0
"""The digits of the study that the path module was planned with, each beside the number computed here."""
from exact import digits_agree
from mpmath import mpf

V, A, J = mpf(100), mpf(1000), mpf(10000)  # mm/s, mm/s², mm/s³
X, Y = [mpf(1), mpf(0)], [mpf(0), mpf(1)]
STUDY = {}  # name -> printed digits and whether they are the computed ones


def study(name, printed, value):
    """Notes how the study's digits relate to the computed value. A difference is recorded, not an error."""
    STUDY[name] = {"printed": printed, "computed": value, "agrees": digits_agree(printed, value) == "rounded"
                   or digits_agree(printed, value) == "both"}
    return value


def floats(values):
    return [float(v) for v in values]


def given(values):
    return [mpf(v) for v in values]
