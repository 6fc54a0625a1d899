import numpy as np
import pytest
from schemes_of_tests import Euler

import polhode


def test_all_built_in_schemes_describe_themselves():
    names = [scheme.name for scheme in polhode.schemes()]
    assert names[:5] == ["exact", "matrix", "quaternion", "semi_implicit_gyroscopic", "implicit_gyroscopic"]
    built_in = [
        scheme for scheme in polhode.schemes() if scheme.source
    ]  # other tests register some that name none
    assert len(built_in) >= 11
    for scheme in built_in:
        described = scheme.description()
        assert set(described) == {
            "name", "summary", "source", "fails_when", "order", "energy", "angular_momentum", "rotation",
            "takes_rotors",
        }  # fmt: skip
        assert all(described[key] == getattr(scheme, key) for key in described)
        assert {described[key] for key in ("energy", "angular_momentum", "rotation")} <= {
            "exact",
            "bounded",
            "lost",
        }
        assert scheme.summary and scheme.fails_when
    assert polhode.scheme("exact").order is None and polhode.scheme("rk4").order == 4
    assert polhode.scheme("matrix").rotation == "lost"


def test_a_scheme_in_python_describes_itself():
    described = Euler().description()
    assert described["summary"] == "Turns by the velocity at the start of the step, whose momentum it keeps."
    assert (
        described["order"] == 1 and described["angular_momentum"] == "exact" and not described["takes_rotors"]
    )
    assert repr(Euler()).startswith("<polhode scheme euler_in_python: Turns")


def test_a_state_is_consistent():
    state = polhode.State((1, 2, 3), q_WB=(2, 0, 0, 2), omega_W=(0.5, 0.25, 1), rotor_momentum_B=(1, 0, 0))
    np.testing.assert_allclose(state.q_WB, np.array((1, 0, 0, 1)) / np.sqrt(2), atol=1e-16)
    np.testing.assert_allclose(state.R_WB, [[0, -1, 0], [1, 0, 0], [0, 0, 1]], atol=1e-15)
    np.testing.assert_allclose(
        state.L_W, state.R_WB @ (np.diag((1, 2, 3)) @ state.R_WB.T @ state.omega_W + (1, 0, 0)), atol=1e-15
    )
    again = polhode.State((1, 2, 3), q_WB=state.q_WB, L_W=state.L_W, rotor_momentum_B=(1, 0, 0))
    np.testing.assert_allclose(again.omega_W, state.omega_W, atol=1e-15)
    omega_B = state.R_WB.T @ state.omega_W
    assert state.energy_J == pytest.approx(0.5 * omega_B @ (np.array((1, 2, 3)) * omega_B))


def test_a_state_of_a_swollen_matrix_has_the_nearest_rotation():
    turn = polhode.State((1, 2, 3), q_WB=(0.8, 0.6, 0, 0)).R_WB
    swollen = polhode.State((1, 2, 3), R_WB=1.5 * turn, L_W=(1, 2, 3))
    np.testing.assert_allclose(swollen.q_WB, (0.8, 0.6, 0, 0), atol=1e-15)
    assert swollen.det_R == pytest.approx(1.5**3)
    inverse_inertia_W = swollen.R_WB @ np.diag((1, 1 / 2, 1 / 3)) @ swollen.R_WB.T
    np.testing.assert_allclose(swollen.omega_W, inverse_inertia_W @ (1, 2, 3), atol=1e-15)


def test_rotations_agree_with_their_definitions():
    v = np.array((0.3, -0.2, 0.9))
    q = polhode.rotations.exponential(v)
    np.testing.assert_allclose(polhode.rotations.logarithm(q), v, atol=1e-15)
    p = polhode.rotations.exponential((1, 0, 0))
    product = polhode.rotations.multiply(p, q)
    matrices = [polhode.State((1, 1, 1), q_WB=each).R_WB for each in (p, q, product)]
    np.testing.assert_allclose(matrices[0] @ matrices[1], matrices[2], atol=1e-15)
    assert float(polhode.rotations.angle_between(q, (1, 0, 0, 0))) == pytest.approx(np.linalg.norm(v))
    assert float(polhode.rotations.angle_between(q, -q)) == 0.0
    assert polhode.rotations.angle_between(np.tile(q, (5, 1)), p).shape == (5,)
    with pytest.raises(
        ValueError, match=r"q must be quaternions w, x, y, z of shape \(..., 4\), has shape \(3,\)"
    ):
        polhode.rotations.angle_between(p, v)


def test_scenarios_are_found_and_read_back():
    assert "dzhanibekov" in polhode.scenarios() and "heavy_top" in polhode.scenarios()
    for name in polhode.scenarios():
        scenario = polhode.Scenario(name)
        assert polhode.Scenario(scenario.to_dict()) == scenario and scenario.name == name
    changed = polhode.Scenario("tumble").replace(dt=0.5, angular_damping=None)
    assert changed.dt == 0.5 and changed.name == "tumble" and changed != polhode.Scenario("tumble")


def test_a_scenario_is_read_from_a_file_and_from_where_the_programs_look(tmp_path, monkeypatch):
    file = tmp_path / "own.json"
    file.write_text('{"inertia": [1, 2, 3], "dt": 0.25, "duration": 1}', encoding="utf-8")
    assert polhode.Scenario(str(file)).dt == polhode.Scenario(file).dt == 0.25
    assert polhode.Scenario(file).name == polhode.Scenario(file).replace(dt=0.5).name == "own"
    monkeypatch.setenv("POLHODE_SCENARIOS", str(tmp_path))
    assert polhode.scenarios() == ["own"] and polhode.Scenario("own").dt == 0.25


def test_a_scenario_cannot_be_changed_through_its_dict():
    scenario = polhode.Scenario("tumble")
    scenario.to_dict()["inertia"][0] = 17
    assert scenario.to_dict()["inertia"][0] != 17
