"""Scenarios: a body, what acts on it, and how it is stepped."""

from __future__ import annotations

import json
import os
import pathlib
from typing import Any, Mapping, Union

from . import _core

ScenarioSource = Union[str, "os.PathLike[str]", Mapping[str, Any]]


def _directory() -> pathlib.Path:
    chosen = os.environ.get("POLHODE_SCENARIOS")
    return pathlib.Path(chosen) if chosen else pathlib.Path(__file__).parent / "scenarios"


def scenarios() -> list[str]:
    """Return the names of the scenarios that came with the package, or in $POLHODE_SCENARIOS if that is
    set."""
    return sorted(file.stem for file in _directory().glob("*.json"))


def _file_of(source: Union[str, "os.PathLike[str]"]) -> pathlib.Path:
    text = os.fspath(source)
    if not isinstance(source, str) or "/" in text or text.endswith(".json"):
        return pathlib.Path(text)
    if text in scenarios():
        return _directory() / f"{text}.json"
    raise ValueError(
        f"unknown scenario {text!r}; valid are {', '.join(scenarios())} or a path to a .json file"
    )


def _plain(value: Any) -> Any:
    if hasattr(value, "tolist"):
        return value.tolist()  # of numpy's arrays and numbers
    raise TypeError(f"a scenario is made of numbers, texts, lists and dicts, not of {value!r}")


class Scenario:
    """A body (or several), what acts on it, and how it is stepped. It cannot be changed; `replace` makes
    another one.

        polhode.Scenario("dzhanibekov")                 # one of polhode.scenarios()
        polhode.Scenario("my/own.json")                 # a file
        polhode.Scenario({"inertia": [1, 2, 3], "angular_velocity": [3, 2, 4], "dt": 0.01, "duration": 20})

    The keys are those of the scenario files, in SI units, which docs/scenario_files.md documents. Raises ValueError
    that names the key and says what is valid, OSError for a file that cannot be read.
    """

    def __init__(self, source: ScenarioSource) -> None:
        if isinstance(source, Mapping):
            self._where = "scenario"
            self._text = json.dumps(dict(source), default=_plain)
        else:
            file = _file_of(source)
            self._where = str(file)
            self._text = file.read_text(encoding="utf-8")
        self._complete: dict[str, Any] = json.loads(_core.complete_scenario(self._text, self._where))

    @property
    def name(self) -> str:
        """The name of it, or of its file."""
        return str(self._complete["name"])

    @property
    def description(self) -> str:
        """One line."""
        return str(self._complete["description"])

    @property
    def dt(self) -> float:
        """Length of a step, s."""
        return float(self._complete["dt"])

    @property
    def duration(self) -> float:
        """Length of the run, s."""
        return float(self._complete["duration"])

    def to_dict(self) -> dict[str, Any]:
        """Return all of it by key, with every default spelled out."""
        copy: dict[str, Any] = json.loads(json.dumps(self._complete))
        return copy

    def to_json(self) -> str:
        """Return the same as the text of a scenario file."""
        return json.dumps(self._complete, indent=2) + "\n"

    def replace(self, **changes: Any) -> Scenario:
        """Return another scenario, with other values for these keys; None leaves a key out. replace(dt=0.01,
        duration=5)"""
        given = {"name": self.name, **json.loads(self._text), **changes}
        return Scenario({key: value for key, value in given.items() if value is not None})

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Scenario) and self._complete == other._complete

    def __hash__(self) -> int:
        return hash(self.to_json())

    def __repr__(self) -> str:
        return f"<polhode scenario {self.name}: {self.description or 'no description'}>"

    def _for(self, module: Any) -> Any:
        return module.ScenarioText(self._text, self._where)
