"""Contenders side by side in one scenario."""

from __future__ import annotations

import dataclasses
import json
import operator
import os
import pathlib
from typing import Any, Mapping, Optional, Union

from . import _bullet
from ._bullet import Contenders
from ._motion import Array, Trajectory
from ._scenario import Scenario, ScenarioSource


@dataclasses.dataclass(frozen=True, eq=False, repr=False)
class Series(Trajectory):
    """A contender's run in a scenario."""

    position_W: Array
    """(n, 3) of the centre of mass, m"""
    attitude_error_rad: Array
    """(n,) the angle from the exact motion, which is computed in 50 digits; NaN where that is not known"""


class Comparison:
    """Contenders side by side: print it for the table, index it by a contender's name for its Series."""

    def __init__(self, scenario: Scenario, result: Any) -> None:
        self.scenario = scenario
        self._result = result
        self._json: dict[str, Any] = json.loads(result.json())
        self.series = {
            row["name"]: Series(
                scheme=row["name"], diverged_at_s=row["diverged_at_s"], **result.series[row["name"]]
            )
            for row in self.figures
        }
        """The runs by the contenders' names, in the order of the table."""

    @property
    def precision(self) -> str:
        """Bullet's: "double" or "single"."""
        return str(self._json["precision"])

    @property
    def figures(self) -> list[dict[str, Any]]:
        """The rows of the table, unrounded, a dict each, as for pandas.DataFrame(comparison.figures). None is
        not applicable.

        name, steps, final_energy_error (E/E0 - 1), worst_energy_error, worst_momentum_error (|L|/|L0| - 1),
        worst_momentum_angle_rad, final_attitude_error_rad, worst_attitude_error_rad, final_det_R,
        steps_past_cut (with more than pi/4 rad, where Bullet's own turn is cut), diverged_at_s, ns_per_step.
        """
        rows: list[dict[str, Any]] = self._json["contenders"]
        return [dict(row) for row in rows]

    def __getitem__(self, contender: str) -> Series:
        return self.series[contender]

    def __str__(self) -> str:
        return str(self._result.table())

    def __repr__(self) -> str:
        return f"<Comparison of {', '.join(self.series)} in {self.scenario.name}>"

    def to_json(self) -> str:
        """Return what polhode_compare --json writes."""
        return str(self._result.json())

    def report(self, path: Union[str, "os.PathLike[str]"]) -> pathlib.Path:
        """Write a page with the table, plots and a 3D playback, which needs nothing but a browser. Returns
        its path."""
        page = pathlib.Path(path)
        page.write_text(self._result.html(), encoding="utf-8")
        return page


def contenders(precision: str = "double") -> Mapping[str, str]:
    """Return all that can be compared, each name with its summary: the schemes, and Bullet's own ways to
    rotate a body."""
    names: dict[str, str] = _bullet.module(precision).contenders()
    return names


def compare(
    scenario: Union[Scenario, ScenarioSource] = "dzhanibekov",
    contenders: Contenders = None,
    *,
    precision: str = "double",
    every: Optional[int] = None,
) -> Comparison:
    """Run a scenario in Bullet once for each contender.

    scenario    a Scenario, or what makes one: a name, a file, a dict
    contenders  names of polhode.contenders() or Schemes; by default those that can run it of `exact`, the
                exercise's four, registered ones and Bullet's own
    precision   of Bullet, "double" or "single". A process can use one of them alone
    every       records each step whose number is a multiple of it, and the last one; by default at most
                10,000 records

    Raises ValueError or TypeError that says what is valid, RuntimeError for a second precision in one
    process, and whatever a scheme in Python raises.
    """
    module = _bullet.module(precision)
    chosen = scenario if isinstance(scenario, Scenario) else Scenario(scenario)
    stride = 0 if every is None else operator.index(every)
    if every is not None and stride < 1:
        raise ValueError(f"every must be a whole number of at least 1, is {every}")
    result = _bullet.run(module.compare, chosen._for(module), _bullet.contender_list(contenders), stride)
    return Comparison(chosen, result)
