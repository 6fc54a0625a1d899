"""What a scheme of one's own needs of quaternions (w, x, y, z)."""

from __future__ import annotations

import numpy as np
import numpy.typing as npt

from . import _core

Array = npt.NDArray[np.float64]

__all__ = ["angle_between", "exponential", "logarithm", "multiply"]


def exponential(v: npt.ArrayLike) -> Array:
    """Return the rotation by |v| radians about v, (3,), as a unit quaternion (4,)."""
    return _core.exponential(v)


def logarithm(q: npt.ArrayLike) -> Array:
    """Return the shortest rotation vector (3,) of a quaternion (4,), at most pi long, rad."""
    return _core.logarithm(q)


def multiply(p: npt.ArrayLike, q: npt.ArrayLike) -> Array:
    """Return the product p q of two unit quaternions (4,): the rotation q, then p."""
    return _core.multiply(p, q)


def angle_between(p: npt.ArrayLike, q: npt.ArrayLike) -> Array:
    """Return the angle between orientations, from 0 to pi rad, of unit quaternions (..., 4), which are
    broadcast. (...)"""
    a, b = _quaternions(p, "p"), _quaternions(q, "q")
    apart, other_sign = np.linalg.norm(a - b, axis=-1), np.linalg.norm(a + b, axis=-1)
    angle: Array = 4.0 * np.arctan2(np.minimum(apart, other_sign), np.maximum(apart, other_sign))
    return angle


def _quaternions(values: npt.ArrayLike, name: str) -> Array:
    array = np.asarray(values, dtype=np.float64)
    if array.ndim == 0 or array.shape[-1] != 4:
        raise ValueError(f"{name} must be quaternions w, x, y, z of shape (..., 4), has shape {array.shape}")
    return array
