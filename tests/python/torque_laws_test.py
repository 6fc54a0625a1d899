import math

import numpy as np
import pytest
from schemes_of_tests import BODY, same_bits

import polhode
from polhode import torque_laws

STATE = polhode.State((1, 2, 3), q_WB=(0.8, 0.6, 0, 0), omega_W=(3, 2, 4), rotor_momentum_B=(0, 0, 0.5))
MOTION = polhode.Motion(inertia_B=(1, 2, 3), time_s=1.5, state=STATE, position_W=(7e6, 1e6, 0))


def run(law, **more):
    return polhode.free_motion("exact", **BODY, dt=0.01, steps=100, torque_law=law, **more)


def test_a_motion_has_what_it_was_made_of():
    assert MOTION.time_s == 1.5
    np.testing.assert_array_equal(MOTION.position_W, (7e6, 1e6, 0))
    np.testing.assert_allclose(MOTION.omega_B, MOTION.R_WB.T @ MOTION.omega_W, atol=1e-15)
    np.testing.assert_array_equal(MOTION.rotor_momentum_B, (0, 0, 0.5))


@pytest.mark.parametrize(
    ("law", "in_python"),
    [
        (
            torque_laws.gravity_gradient(3.986e14),
            lambda m: polhode.Torque(
                body_B=3
                * 3.986e14
                / np.linalg.norm(m.position_W) ** 5
                * np.cross(m.R_WB.T @ m.position_W, m.inertia_B * (m.R_WB.T @ m.position_W))
            ),
        ),
        (
            torque_laws.magnetic_dipole((1, 0, 2), (0, 3, 0)),
            lambda m: np.cross(m.R_WB @ (1, 0, 2), (0, 3, 0)),
        ),
        (
            torque_laws.magnetic_dipole((1, 0, 2), lambda m: (0, m.time_s, 0)),
            lambda m: np.cross(m.R_WB @ (1, 0, 2), (0, m.time_s, 0)),
        ),
        (torque_laws.orientation_spring((1, 0, 0, 0), 2), lambda m: -2 * polhode.rotations.logarithm(m.q_WB)),
        (torque_laws.rate_damping(0.3), lambda m: polhode.Torque(body_B=-0.3 * m.omega_B)),
        (
            torque_laws.rate_damping((0.1, 0.2, 0.3)),
            lambda m: polhode.Torque(body_B=-np.array((0.1, 0.2, 0.3)) * m.omega_B),
        ),
        (
            torque_laws.internal_damping(0.5, 0.1),
            lambda m: polhode.Torque(rotor_B=0.1 * (m.omega_B - m.rotor_momentum_B / 0.5)),
        ),
    ],
)
def test_laws_are_what_their_formulas_say(law, in_python):
    of_python = in_python(MOTION)
    of_python = of_python if isinstance(of_python, polhode.Torque) else polhode.Torque(world_W=of_python)
    shipped = law(MOTION)
    in_world = shipped.world_W + MOTION.R_WB @ shipped.body_B
    np.testing.assert_allclose(
        in_world, of_python.world_W + MOTION.R_WB @ of_python.body_B, rtol=1e-12, atol=1e-14
    )
    np.testing.assert_allclose(shipped.rotor_B, of_python.rotor_B, rtol=1e-12, atol=1e-14)
    a, b = (
        polhode.free_motion("exact", **BODY, dt=0.01, steps=100, torque_law=each, position_W=(7e6, 1e6, 0))
        for each in (law, in_python)
    )
    assert polhode.rotations.angle_between(a.q_WB, b.q_WB).max() < 1e-14  # measured 0


def test_a_constant_torque_adds_its_impulse():
    end = run(lambda motion: (0.1, 0.2, -0.3)).L_W[-1]
    np.testing.assert_allclose(end - (3, 4, 12), (0.1, 0.2, -0.3), atol=1e-13)  # measured 2.2e-14


def test_a_law_of_time_is_asked_in_the_middle_of_the_step():
    times = []
    run(lambda motion: times.append(motion.time_s) or (0, 0, 0))
    assert times[1:3] == pytest.approx([0.005, 0.015])
    assert len(times) == 101  # once a step, and once more for the start


def test_order_four_is_of_order_four():
    law = torque_laws.orientation_spring((1, 0, 0, 0), 20.0)

    def end(n, order):
        return polhode.free_motion("exact", **BODY, dt=1 / n, steps=n, torque_law=law, order=order).q_WB[-1]

    reference = end(2000, 4)
    for order, tolerance in ((2, 0.01), (4, 0.05)):  # measured 2.0004, 3.998
        errors = [float(polhode.rotations.angle_between(end(n, order), reference)) for n in (50, 100)]
        assert math.log2(errors[0] / errors[1]) == pytest.approx(order, abs=tolerance)


def test_laws_are_added():
    a, b = torque_laws.rate_damping(0.1), torque_laws.magnetic_dipole((1, 0, 0), (0, 1, 0))
    total = run(a + b)
    assert same_bits(total.q_WB, run(a + (lambda motion: b(motion))).q_WB)
    assert same_bits(total.q_WB, run((lambda motion: a(motion)) + b).q_WB)
    assert not same_bits(total.q_WB, run(a).q_WB)


def test_internal_damping_flattens_the_spin_and_keeps_the_momentum():
    run_with = polhode.free_motion(
        "exact", inertia_B=(1, 2, 3), omega_W=(5, 0.1, 0), dt=0.02, steps=10000, every=100,
        torque_law=torque_laws.internal_damping(0.5, 0.2),
    )  # fmt: skip
    assert np.abs(run_with.L_W - run_with.L_W[0]).max() == 0.0
    assert abs(run_with.omega_B[-1, 2]) / np.linalg.norm(run_with.omega_B[-1]) > 0.999


def test_a_motor_turns_the_body_the_other_way():
    with_motor = polhode.free_motion(
        "exact", inertia_B=(1, 2, 3), omega_W=(0, 0, 0), dt=0.01, steps=100, rotor_torque_B=(0, 0, 0.3)
    )
    np.testing.assert_allclose(with_motor.rotor_momentum_B[-1], (0, 0, 0.3), atol=1e-15)
    np.testing.assert_allclose(with_motor.omega_W[-1], (0, 0, -0.1), atol=1e-15)
    assert np.abs(with_motor.L_W).max() < 1e-15


def test_what_a_law_raises_arrives():
    def law(motion):
        if motion.time_s > 0.5:
            raise KeyError("at half a second")
        return 0, 0, 0

    with pytest.raises(KeyError, match="at half a second"):
        run(law)
    with pytest.raises(KeyError, match="at half a second"):
        run(torque_laws.rate_damping(0.1) + law)
    run(None)


@pytest.mark.parametrize("result", [None, "torque", (1, 2), np.zeros((3, 1)), (1, 2, math.nan)])
def test_a_law_must_return_three_finite_numbers(result):
    with pytest.raises(
        (TypeError, ValueError), match="the torque that a law returns must be three finite numbers"
    ):
        run(lambda motion: result)


def test_a_law_that_is_called_raises_too():
    with pytest.raises(ZeroDivisionError):
        (torque_laws.rate_damping(0.1) + (lambda motion: 1 / 0))(MOTION)


def test_a_built_in_law_without_a_finite_torque_is_an_error():
    with pytest.raises(RuntimeError, match="the torque law failed in the step from t = 0"):
        run(torque_laws.gravity_gradient(1.0))  # the body is in the planet's centre


def test_rotor_torques_are_refused_where_a_scheme_takes_none():
    with pytest.raises(RuntimeError, match="none on rotors for a scheme that takes none"):
        polhode.free_motion(
            "matrix", **BODY, dt=0.01, steps=1, torque_law=torque_laws.internal_damping(0.5, 0.1)
        )


@pytest.mark.parametrize(
    ("make", "message"),
    [
        (
            lambda: torque_laws.gravity_gradient(-1),
            "gravitational parameter is -1.000000: valid is a finite number above 0",
        ),
        (
            lambda: torque_laws.rate_damping(-1),
            "the damping coefficients .* valid is three finite numbers of at least 0",
        ),
        (
            lambda: torque_laws.magnetic_dipole((1, 2), (0, 0, 0)),
            r"dipole_B must be three finite numbers, has shape \(2,\)",
        ),
        (
            lambda: torque_laws.magnetic_dipole((1, 2, 3), (0, 0, math.inf)),
            "field_W must be three finite numbers",
        ),
        (
            lambda: torque_laws.orientation_spring((0, 0, 0, 0), 1),
            "target_WB must be four finite numbers w, x, y, z that are not all 0",
        ),
        (
            lambda: torque_laws.internal_damping(0, 1),
            "the damper's moment is 0.000000: valid is a finite number above 0",
        ),
    ],
)
def test_bad_parameters_are_refused(make, message):
    with pytest.raises(ValueError, match=message):
        make()
