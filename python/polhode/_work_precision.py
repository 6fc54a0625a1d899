"""Error and cost against the time step."""

from __future__ import annotations

import dataclasses
import json
import operator
from typing import Any, Union

import numpy as np
import numpy.typing as npt

from . import _bullet
from ._bullet import Contenders
from ._motion import Array
from ._scenario import Scenario, ScenarioSource

TUMBLING = Scenario(
    {"name": "tumbling", "inertia": [1, 2, 3], "angular_velocity": [3, 2, 4], "dt": 0.01, "duration": 10}
)


@dataclasses.dataclass(frozen=True, eq=False, repr=False)
class Curve:
    """One contender over the ladder of time steps, from the largest one to the smallest. All (levels,); NaN
    is not applicable."""

    contender: str
    declared_order: str
    """as "2", or "exact"; "-" for Bullet without a gyroscopic term"""
    dt_s: Array
    steps: Array
    attitude_error_rad: Array
    """the angle from the exact motion at the end; NaN if it diverged"""
    observed_order: Array
    """log2 of the error at twice the dt over that at this one; NaN where rounding rules"""
    worst_energy_error: Array
    """the largest |E/E0 - 1|"""
    diverged_at_s: Array
    """NaN if it did not"""
    ns_per_step: Array
    ns_per_simulated_second: Array
    ratio_to_implicit_body: Array
    """of the cost of a step to that of Bullet's default"""


class WorkPrecision:
    """Contenders' errors and costs: print it for the table, index it by a contender's name for its Curve."""

    def __init__(self, table: str, text: str) -> None:
        self._table = table
        self._text = text
        self.curves = {
            name: _curve(name, self.points)
            for name in dict.fromkeys(each["contender"] for each in self.points)
        }
        """By the contenders' names, in the order of the table."""

    @property
    def points(self) -> list[dict[str, Any]]:
        """The rows of the table, unrounded, as for pandas.DataFrame(work_precision.points). None is not
        applicable."""
        points: list[dict[str, Any]] = json.loads(self._text)["points"]
        return points

    def __getitem__(self, contender: str) -> Curve:
        return self.curves[contender]

    def __str__(self) -> str:
        return self._table

    def __repr__(self) -> str:
        return f"<WorkPrecision of {', '.join(self.curves)}>"

    def to_json(self) -> str:
        """Return what polhode_workprecision curve --json writes."""
        return self._text


def _curve(name: str, points: list[dict[str, Any]]) -> Curve:
    rows = [point for point in points if point["contender"] == name]
    columns = {key: np.array([row[key] for row in rows], dtype=np.float64) for key in rows[0] if key not in
               ("contender", "declared_order")}  # fmt: skip
    return Curve(contender=name, declared_order=rows[0]["declared_order"], **columns)


def _checked(name: str, value: Union[int, float], lowest: float, highest: float) -> Any:
    if not lowest <= value <= highest:
        raise ValueError(f"{name} must be from {lowest:g} to {highest:g}, is {value!r}")
    return value


def work_precision(
    contenders: Contenders = None,
    scenario: Union[Scenario, ScenarioSource] = TUMBLING,
    *,
    time_s: float = 10.0,
    dt_from: float = 1.0 / 15.0,
    levels: int = 8,
    rounds: int = 21,
    precision: str = "double",
) -> WorkPrecision:
    """Measure the error of a free body's orientation, and the cost of a step, over a ladder of time steps.

    contenders  names of polhode.contenders() or Schemes; by default all of them
    scenario    the body at its start, free and spinning; by default moments 1, 2, 3 kg m^2 at 3, 2, 4 rad/s.
                Its dt is not used
    time_s      when the error is measured, s
    dt_from     the largest time step, s; each of the `levels` ones is half the one before
    rounds      of the measurement of cost, of 1,000 steps each; the figure is the median
    precision   of Bullet, which its own contenders run in

    Raises as compare does.
    """
    module = _bullet.module(precision)
    time_s = _checked("time_s", float(time_s), 1e-6, 1e11)
    dt_from = _checked("dt_from", float(dt_from), 1e-6, min(1e3, time_s))
    levels = _checked("levels", operator.index(levels), 1, 30)
    rounds = _checked("rounds", operator.index(rounds), 1, 1_000_000)
    _checked(
        "the number of smallest steps, time_s / dt_from times 2^(levels - 1),",
        time_s / dt_from * 2.0 ** (levels - 1),
        1,
        1e8,
    )
    chosen = scenario if isinstance(scenario, Scenario) else Scenario(scenario)
    table, text = _bullet.run(
        module.work_precision, chosen._for(module), _bullet.contender_list(contenders), time_s, dt_from,
        levels, rounds
    )  # fmt: skip
    return WorkPrecision(table, text)
