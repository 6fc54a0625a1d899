"""Rotation schemes: the built-in ones, and those written in Python."""

from __future__ import annotations

import abc
import inspect
from typing import Any, Optional, Type, TypeVar, Union

import numpy.typing as npt

from . import _core
from ._core import State


class Scheme(abc.ABC):
    """A way to step the rotation of a body. Derive a class from it to write one of your own:

        @polhode.register_scheme
        class Euler(polhode.Scheme):
            "Turns by the velocity at the start of the step."
            name = "euler"

            def step(self, inertia_B, state, dt, delta_omega_W=0):
                omega_W = state.omega_W + delta_omega_W
                turn = polhode.rotations.exponential(omega_W * dt)
                q_WB = polhode.rotations.multiply(turn, state.q_WB)
                return polhode.State(inertia_B, q_WB=q_WB, omega_W=omega_W)

    It can then be named wherever a scheme or a contender is asked for; an object of it can be passed too,
    registered or not. Registered schemes take part in a comparison by default.
    """

    name: str = ""
    """Of the form [a-z][a-z0-9_]*."""
    summary: str = ""
    """One line; by default the first one of the class's documentation."""
    source: str = ""
    """The paper or text it is from."""
    fails_when: str = ""
    """One line."""
    order: Optional[int] = 1
    """Of convergence of the orientation in dt, in free motion; None if the only error is rounding. With a
    torque law, schemes of order 1 take the torque at the start of the step."""
    energy: str = "lost"
    """How well it keeps the rotational energy: "exact" (to rounding), "bounded" (the error does not grow) or
    "lost"."""
    angular_momentum: str = "lost"
    """The same for the vector L_W."""
    rotation: str = "exact"
    """The same for det R_WB = 1. A scheme whose R_WB becomes another matrix has to declare "lost"."""
    takes_rotors: bool = False
    """True if it steps bodies with rotors inside (State.rotor_momentum_B)."""

    def __init_subclass__(cls, **arguments: Any) -> None:
        super().__init_subclass__(**arguments)
        if "summary" not in vars(cls) and cls.__doc__:
            cls.summary = inspect.cleandoc(cls.__doc__).splitlines()[0]

    @abc.abstractmethod
    def step(
        self, inertia_B: npt.ArrayLike, state: State, dt: float, delta_omega_W: npt.ArrayLike = 0
    ) -> State:
        """Return the state one step later.

        inertia_B      (3,) principal moments, kg m^2
        state          at the start of the step, before the kick
        dt             s; may be negative
        delta_omega_W  (3,) the kick, rad/s: the change of velocity that torques and impulses make at the
                       start of the step

        A result that is not finite, or faster than 1e9 rad/s, ends a run: the scheme has diverged. An
        exception ends it too, and is raised where the run was started.
        """

    def description(self) -> dict[str, Any]:
        """Return the attributes above by name."""
        return self._handle().describe()

    def _handle(self) -> _core.SchemeHandle:
        return _core.make_scheme(self)

    def __repr__(self) -> str:
        order = "exact" if self.order is None else f"order {self.order}"
        return f"<polhode scheme {self.name}: {self.summary} ({order})>"


class _BuiltIn(Scheme):
    def __init__(self, handle: _core.SchemeHandle) -> None:
        self._built_in = handle
        for attribute, value in handle.describe().items():
            setattr(self, attribute, value)

    def step(
        self, inertia_B: npt.ArrayLike, state: State, dt: float, delta_omega_W: npt.ArrayLike = 0
    ) -> State:
        return self._built_in.step(inertia_B, state, dt, delta_omega_W)

    def _handle(self) -> _core.SchemeHandle:
        return self._built_in


def schemes() -> list[Scheme]:
    """Return all schemes: the built-in ones, then the registered ones."""
    return [_scheme_of(handle) for handle in _core.all_schemes()]


def _scheme_of(handle: _core.SchemeHandle) -> Scheme:
    in_python: Optional[Scheme] = handle.python_object()
    return _BuiltIn(handle) if in_python is None else in_python


def scheme(name: str) -> Scheme:
    """Return the scheme of that name. Raises ValueError, which lists the valid ones."""
    return _scheme_of(_core.find_scheme(name))


def handle_of(scheme_or_name: Union[str, Scheme]) -> _core.SchemeHandle:
    if isinstance(scheme_or_name, str):
        return _core.find_scheme(scheme_or_name)
    if isinstance(scheme_or_name, Scheme):
        return scheme_or_name._handle()
    raise TypeError(f"a scheme must be a name or a polhode.Scheme, is {scheme_or_name!r}")


AnyScheme = TypeVar("AnyScheme", bound=Union[Scheme, Type[Scheme]])


def register_scheme(scheme: AnyScheme) -> AnyScheme:
    """Make a scheme known by its name, in place of one that was registered under it before. Returns its
    argument, so that it can decorate a class, of which an object is made then.

    Raises ValueError for the name of a built-in scheme, and for attributes that describe no scheme; TypeError
    for anything else.
    """
    made = scheme() if isinstance(scheme, type) and issubclass(scheme, Scheme) else scheme
    if not isinstance(made, Scheme):
        raise TypeError(f"a scheme must be a polhode.Scheme or a class of it, is {scheme!r}")
    handle = made._handle()
    _core.register_scheme(handle)
    for listener in listeners:
        listener(handle)
    return scheme


# The modules with Bullet in them have registries of their own.
listeners: list[Any] = []
