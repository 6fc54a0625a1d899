"""The motion of one body without Bullet."""

from __future__ import annotations

import dataclasses
import operator
from typing import Callable, Optional, Union

import numpy as np
import numpy.typing as npt

from . import _core
from ._core import Motion, State, Torque
from ._scheme import Scheme, handle_of

Array = npt.NDArray[np.float64]
TorqueLaw = Union[_core.TorqueLaw, Callable[[Motion], Union[npt.ArrayLike, Torque]]]


@dataclasses.dataclass(frozen=True, eq=False, repr=False)
class Trajectory:
    """A run, record by record; n is the number of records. The first one is the start."""

    scheme: str
    t_s: Array
    """(n,) time, s"""
    q_WB: Array
    """(n, 4) orientation, w, x, y, z"""
    R_WB: Array
    """(n, 3, 3) its matrix, or what a scheme that loses the rotation keeps in its place"""
    omega_W: Array
    """(n, 3) angular velocity, rad/s"""
    L_W: Array
    """(n, 3) angular momentum with that of rotors, kg m^2/s"""
    rotor_momentum_B: Array
    """(n, 3) the part of it that rotors carry, in the body's axes"""
    energy_J: Array
    """(n,) rotational kinetic energy of the body, without that of its rotors. Of a compared scenario, the
    whole energy"""
    det_R: Array
    """(n,) det R_WB: the factor by which the body has swollen; 1 for a rotation"""
    diverged_at_s: Optional[float]
    """When the scheme diverged: the last record is of the step before. None if it did not"""

    def __len__(self) -> int:
        return len(self.t_s)

    def __repr__(self) -> str:
        end = f", diverged at {self.diverged_at_s:g} s" if self.diverged_at_s is not None else ""
        return f"<{type(self).__name__} of {self.scheme}: {len(self)} records to {self.t_s[-1]:g} s{end}>"

    @property
    def omega_B(self) -> Array:
        """(n, 3) the angular velocity in the axes of the body: the curve it draws there is the polhode"""
        turned: Array = np.einsum("nji,nj->ni", self.R_WB, self.omega_W)
        return turned

    @property
    def energy_error(self) -> Array:
        """(n,) E/E0 - 1, NaN without an energy at the start"""
        return _relative_error(self.energy_J)

    @property
    def momentum_error(self) -> Array:
        """(n,) |L|/|L0| - 1, NaN without an angular momentum at the start"""
        return _relative_error(np.linalg.norm(self.L_W, axis=1))


def _relative_error(values: Array) -> Array:
    if values[0] == 0.0:
        return np.full_like(values, np.nan)
    error: Array = values / values[0] - 1.0
    return error


def free_motion(
    scheme: Union[str, Scheme] = "exact",
    *,
    inertia_B: npt.ArrayLike,
    omega_W: npt.ArrayLike,
    q_WB: npt.ArrayLike = (1.0, 0.0, 0.0, 0.0),
    dt: float,
    steps: int,
    torque_law: Optional[TorqueLaw] = None,
    order: int = 2,
    rotor_momentum_B: npt.ArrayLike = 0,
    rotor_torque_B: npt.ArrayLike = 0,
    position_W: npt.ArrayLike = 0,
    every: int = 1,
) -> Trajectory:
    """Return the motion of one body that nothing touches, stepped by a scheme.

    scheme            a name, or a Scheme
    inertia_B         (3,) principal moments, kg m^2, each above 0
    omega_W           (3,) angular velocity at the start, rad/s
    q_WB              (4,) orientation at the start, w, x, y, z; made a unit quaternion
    dt, steps         length of a step, s (negative: back in time), and how many
    torque_law        a torque that depends on the motion: one of polhode.torque_laws, or a function of a
                      Motion that returns a torque in the axes of the world, (3,) N m, or a Torque
    order             2 or 4: how fast the error of a step with a law falls with dt, where the scheme's own
                      order allows it
    rotor_momentum_B  (3,) angular momentum of rotors inside the body, kg m^2/s
    rotor_torque_B    (3,) constant torque of motors on them, N m; the body is turned the other way
    position_W        (3,) where the body is, for laws that ask, m
    every             records each step whose number is a multiple of it, and the last one

    Raises ValueError or TypeError that says what is valid, RuntimeError for a built-in law that returns no
    finite torque, and whatever a scheme or law in Python raises.
    """
    handle = handle_of(scheme)
    start = State(inertia_B, q_WB=q_WB, omega_W=omega_W, rotor_momentum_B=rotor_momentum_B)
    columns, diverged = _core.free_motion(
        handle, inertia_B, start, float(dt), operator.index(steps), torque_law, operator.index(order),
        rotor_torque_B, position_W, operator.index(every),
    )  # fmt: skip
    del columns["position_W"], columns["attitude_error_rad"]
    name = scheme if isinstance(scheme, str) else scheme.name
    return Trajectory(scheme=name, diverged_at_s=None if diverged is None else diverged * dt, **columns)
