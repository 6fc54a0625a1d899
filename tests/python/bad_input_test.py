import math

import numpy as np
import pytest
from schemes_of_tests import BODY, Euler

import polhode


@pytest.mark.parametrize(
    ("change", "error", "message"),
    [
        ({"inertia_B": (1, 2)}, ValueError, r"inertia_B must be three principal moments .* has shape \(2,\)"),
        ({"inertia_B": (1, 2, 0)}, ValueError, "each finite and above 0, is"),
        ({"inertia_B": (1, 2, math.nan)}, ValueError, "inertia_B must be three principal moments"),
        ({"inertia_B": np.eye(3)}, ValueError, r"has shape \(3, 3\)"),
        ({"inertia_B": "cube"}, TypeError, "inertia_B must be three principal moments .* is 'cube'"),
        ({"omega_W": (1, 2, math.inf)}, ValueError, "omega_W must be three finite numbers, is"),
        ({"omega_W": 5}, ValueError, r"omega_W must be three finite numbers, has shape \(\)"),
        ({"omega_W": (1e10, 0, 0)}, ValueError, "omega_W must be a start of at most 1000000000"),
        (
            {"q_WB": (0, 0, 0, 0)},
            ValueError,
            "q_WB must be four finite numbers w, x, y, z that are not all 0",
        ),
        ({"q_WB": (1, 0, 0)}, ValueError, r"q_WB must be four finite numbers .* has shape \(3,\)"),
        ({"dt": 0}, ValueError, "dt must be a finite number of seconds other than 0"),
        ({"dt": math.nan}, ValueError, "dt must be a finite number of seconds other than 0"),
        ({"dt": "long"}, ValueError, "could not convert"),
        ({"steps": 0}, ValueError, "steps must be a whole number from 1 to 100000000, is 0"),
        ({"steps": 1.5}, TypeError, "integer"),
        ({"every": 0}, ValueError, "every must be a whole number from 1"),
        ({"order": 3}, ValueError, "order must be 2 or 4, is 3"),
        (
            {"torque_law": 5},
            TypeError,
            "torque_law must be a law of polhode.torque_laws, a callable of a motion, or None, is 5",
        ),
        ({"rotor_momentum_B": (1, 2)}, ValueError, "rotor_momentum_B must be three finite numbers"),
        ({"position_W": (1, 2)}, ValueError, "position_W must be three finite numbers"),
        ({"scheme": "euler"}, ValueError, 'unknown rotation scheme "euler": valid are exact, matrix'),
        ({"scheme": 7}, TypeError, "a scheme must be a name or a polhode.Scheme, is 7"),
        ({"scheme": "matrix", "rotor_momentum_B": (0, 0, 1)}, ValueError, "scheme matrix takes no rotors"),
        ({"scheme": "matrix", "rotor_torque_B": (0, 0, 1)}, ValueError, "scheme matrix takes no rotors"),
    ],
)
def test_free_motion_says_what_is_valid(change, error, message):
    with pytest.raises(error, match=message):
        polhode.free_motion(**{"scheme": "exact", **BODY, "dt": 0.01, "steps": 10, **change})


@pytest.mark.parametrize(
    ("arguments", "error", "message"),
    [
        ({"q_WB": (1, 0, 0, 0), "R_WB": np.eye(3)}, TypeError, "give one of q_WB and R_WB, not both"),
        ({"omega_W": (1, 0, 0), "L_W": (1, 0, 0)}, TypeError, "give one of omega_W and L_W, not both"),
        ({"R_WB": np.eye(4)}, ValueError, r"R_WB must be 3 by 3 finite numbers, has shape \(4, 4\)"),
        ({"R_WB": -np.eye(3)}, ValueError, "R_WB must have a determinant above 0"),
    ],
)
def test_a_state_says_what_is_valid(arguments, error, message):
    with pytest.raises(error, match=message):
        polhode.State((1, 2, 3), **arguments)


def test_a_state_cannot_be_changed():
    state = polhode.State((1, 2, 3), omega_W=(1, 1, 1))
    with pytest.raises(ValueError, match="read-only"):
        state.omega_W[0] = 5
    with pytest.raises(AttributeError):
        state.omega_W = (1, 2, 3)


@pytest.mark.parametrize(
    ("attribute", "value", "error", "message"),
    [
        ("name", "", ValueError, r"must be of the form \[a-z\]\[a-z0-9_\]\*, is \"\""),
        ("name", "My scheme", ValueError, r"must be of the form"),
        ("name", 5, TypeError, "name of a scheme must be a str, is 5"),
        (
            "order",
            0,
            ValueError,
            "order of a scheme must be a whole number from 1 to 100, or None for exact, is 0",
        ),
        ("order", "two", ValueError, "order of a scheme must be"),
        ("energy", "kept", ValueError, 'energy of a scheme must be "exact", "bounded" or "lost", is "kept"'),
        ("name", "exact", ValueError, '"exact" is built in'),
    ],
)
def test_a_scheme_says_what_is_valid(attribute, value, error, message):
    scheme = Euler()
    setattr(scheme, attribute, value)
    with pytest.raises(error, match=message):
        polhode.register_scheme(scheme)


def test_only_schemes_are_registered():
    with pytest.raises(TypeError, match="a scheme must be a polhode.Scheme or a class of it, is <function"):
        polhode.register_scheme(lambda: None)


@pytest.mark.parametrize(
    ("arguments", "error", "message"),
    [
        ({"scenario": "tumbling"}, ValueError, "unknown scenario 'tumbling'; valid are bicycle_wheel, "),
        ({"scenario": "no/such.json"}, FileNotFoundError, "no/such.json"),
        (
            {"contenders": ["exact", "bullet:magic"]},
            ValueError,
            'unknown contender "bullet:magic"; valid are exact, matrix',
        ),
        (
            {"contenders": ["exact", "exact"]},
            ValueError,
            'contender "exact" is given twice; valid is each once',
        ),
        ({"contenders": []}, ValueError, "contenders is empty; valid is at least one"),
        ({"contenders": [5]}, TypeError, "a scheme must be a name or a polhode.Scheme, is 5"),
        (
            {"scenario": "reaction_wheels", "contenders": ["matrix"]},
            ValueError,
            'contender "matrix" takes no rotors',
        ),
        ({"precision": "half"}, ValueError, "precision must be 'double' or 'single', is 'half'"),
        ({"every": 0}, ValueError, "every must be a whole number of at least 1, is 0"),
    ],
)
def test_compare_says_what_is_valid(arguments, error, message):
    with pytest.raises(error, match=message):
        polhode.compare(**arguments)


@pytest.mark.parametrize(
    ("arguments", "error", "message"),
    [
        ({"scenario": "heavy_top"}, ValueError, "not a free body; valid is one without torque"),
        (
            {"scenario": {"inertia": [1, 2, 3], "dt": 1, "duration": 1}},
            ValueError,
            "does not spin; valid is a body that spins",
        ),
        ({"levels": 0}, ValueError, "levels must be from 1 to 30, is 0"),
        ({"rounds": 0}, ValueError, "rounds must be from 1 to 1e.06, is 0"),
        ({"dt_from": 50}, ValueError, "dt_from must be from 1e-06 to 10, is 50"),
        ({"levels": 30}, ValueError, "the number of smallest steps, .* must be from 1 to 1e.08, is 805306"),
        ({"time_s": math.nan}, ValueError, "time_s must be from 1e-06"),
        ({"contenders": ["magic"]}, ValueError, 'unknown contender "magic"'),
    ],
)
def test_work_precision_says_what_is_valid(arguments, error, message):
    with pytest.raises(error, match=message):
        polhode.work_precision(**arguments)


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"dt": 0}, 'scenario: "dt": must be a finite number between 1e-06 and 1000, is 0'),
        ({"inertia": [1, 2]}, 'scenario: "inertia": must be a list of 3 numbers'),
        ({"spin": 3}, 'scenario: "spin": unknown key; valid are'),
        ({"duration": 1e-5}, "duration / dt must be between 1 and"),
        ({"inertia": [1, 2, math.nan]}, "valid is a JSON object"),
    ],
)
def test_a_scenario_says_what_is_valid(change, message):
    with pytest.raises(ValueError, match=message):
        polhode.Scenario({"inertia": [1, 2, 3], "dt": 0.01, "duration": 1, **change})


def test_a_scenario_is_made_of_plain_values():
    with pytest.raises(TypeError, match="a scenario is made of numbers, texts, lists and dicts, not of"):
        polhode.Scenario({"inertia": object(), "dt": 0.01, "duration": 1})
    assert (
        polhode.Scenario({"inertia": np.array((1, 2, 3)), "dt": np.float64(0.01), "duration": 1}).dt == 0.01
    )
