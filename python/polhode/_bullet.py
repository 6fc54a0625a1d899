"""The modules that run Bullet, in one of its precisions."""

from __future__ import annotations

import importlib
from typing import Any, Optional, Sequence, Union

from . import _core, _scheme
from ._scheme import Scheme

_MODULES = {"double": "_float64", "single": "_float32"}
_loaded: dict[str, Any] = {}

Contenders = Optional[Sequence[Union[str, Scheme]]]


def module(precision: str) -> Any:
    """Load the module of that precision.

    One process can have one of them alone: Bullet's libraries share symbols across their precisions
    (btTransform::getIdentity() is a GNU unique symbol), and the second one would read the first one's
    numbers.
    """
    if precision not in _MODULES:
        raise ValueError(f"precision must be {' or '.join(map(repr, _MODULES))}, is {precision!r}")
    for other in _loaded:
        if other != precision:
            raise RuntimeError(
                f"this process runs {other}-precision Bullet already, and Bullet's libraries share symbols "
                f"across their precisions; valid is {other!r}, or {precision!r} in a process of its own"
            )
    if precision not in _loaded:
        loaded = importlib.import_module(f"polhode.{_MODULES[precision]}")
        for handle in _core.registered_schemes():
            loaded.register_scheme(handle)
        _scheme.listeners.append(loaded.register_scheme)
        _loaded[precision] = loaded
    return _loaded[precision]


def contender_list(contenders: Contenders) -> Any:
    if contenders is None:
        return None
    if isinstance(contenders, (str, Scheme)):
        contenders = [contenders]
    return [each if isinstance(each, str) else _scheme.handle_of(each) for each in contenders]


def run(function: Any, *arguments: Any) -> Any:
    """Call a function of such a module that runs schemes. What a scheme in Python raised is raised here."""
    try:
        return function(*arguments, _core.raise_kept_exception)
    finally:
        _core.raise_kept_exception()
