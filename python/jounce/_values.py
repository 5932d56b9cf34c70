# SPDX-License-Identifier: Apache-2.0
"""Values of a motion at one place or at many. u is the unit of the axis, m that of its master."""
from typing import Generic, NamedTuple, TypeVar

T = TypeVar("T")


class Motion(NamedTuple, Generic[T]):
    """Position and its derivatives with respect to time: numbers, or arrays of one shape."""

    position: T
    """u"""
    velocity: T
    """u/s"""
    acceleration: T
    """u/s^2"""
    jerk: T
    """u/s^3"""


class Transfer(NamedTuple, Generic[T]):
    """Slave position and its derivatives with respect to the master's position: numbers, or arrays of one shape.

    At constant master speed w (m/s), the velocity of the slave is geo_velocity * w.
    """

    position: T
    """u"""
    geo_velocity: T
    """u/m"""
    geo_acceleration: T
    """u/m^2"""
    geo_jerk: T
    """u/m^3"""


class State(NamedTuple, Generic[T]):
    """State of an axis: numbers, or arrays for many axes or moves."""

    position: T
    """u"""
    velocity: T = 0.0  # type: ignore[assignment]
    """u/s"""
    acceleration: T = 0.0  # type: ignore[assignment]
    """u/s^2"""
