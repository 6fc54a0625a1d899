"""Torques as functions of the motion. A law is called with a polhode.Motion; laws are added with +.

A law of your own is any function of a Motion (time_s, q_WB, R_WB, omega_W, omega_B, position_W, velocity_W,
inertia_B, rotor_momentum_B) that returns three numbers, a torque in the axes of the world in N m, or a
polhode.Torque. A step may ask it more than once, for moments within the step, so it must depend on its
argument alone.
"""

from __future__ import annotations

from typing import Callable, Union

import numpy.typing as npt

from . import _core
from ._core import Motion, TorqueLaw

__all__ = [
    "TorqueLaw",
    "gravity_gradient",
    "internal_damping",
    "magnetic_dipole",
    "orientation_spring",
    "rate_damping",
]


def gravity_gradient(mu: float, centre_W: npt.ArrayLike = 0) -> TorqueLaw:
    """The torque of a planet's gravity on a body, 3 mu / r^5 r x I r, r from the planet's centre to the body.

    mu: gravitational parameter, m^3/s^2, above 0; 3.986e14 for the Earth. centre_W: (3,) m. The body must be
    elsewhere.
    """
    return _core.gravity_gradient(mu, centre_W)


def magnetic_dipole(
    dipole_B: npt.ArrayLike, field_W: Union[npt.ArrayLike, Callable[[Motion], npt.ArrayLike]]
) -> TorqueLaw:
    """The torque m x b of a magnetic field on a dipole that is fixed in the body.

    dipole_B: (3,) A m^2. field_W: (3,) T, or a function of a Motion that returns it.
    """
    return _core.magnetic_dipole(dipole_B, field_W)


def orientation_spring(target_WB: npt.ArrayLike, stiffness: float) -> TorqueLaw:
    """A spring towards an orientation by the shortest way, with the energy (1/2) stiffness angle^2.

    target_WB: (4,) w, x, y, z. stiffness: N m/rad, at least 0.
    """
    return _core.orientation_spring(target_WB, stiffness)


def rate_damping(coefficients_B: Union[float, npt.ArrayLike]) -> TorqueLaw:
    """Damps the angular velocity about each axis of the body, -coefficient omega.

    coefficients_B: (3,) or one for all axes, N m s, at least 0. With order 2, dt must be shorter than moment
    / coefficient.
    """
    return _core.rate_damping(coefficients_B)


def internal_damping(moment: float, coefficient: float) -> TorqueLaw:
    """Loses energy inside the body, whose angular momentum stays: about each axis a rotor of this moment that
    the body drags along. In the end both turn as one, about the axis of largest moment. The scheme must take
    rotors.

    moment: kg m^2, above 0, which inertia_B leaves out. coefficient: N m s, at least 0.
    """
    return _core.internal_damping(moment, coefficient)
