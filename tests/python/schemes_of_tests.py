"""Schemes in Python that several tests use."""

import numpy as np

import polhode


class Euler(polhode.Scheme):
    """Turns by the velocity at the start of the step, whose momentum it keeps."""

    name = "euler_in_python"
    angular_momentum = "exact"

    def step(self, inertia_B, state, dt, delta_omega_W=0):
        start = polhode.State(inertia_B, q_WB=state.q_WB, omega_W=state.omega_W + delta_omega_W)
        turn = polhode.rotations.exponential(start.omega_W * dt)
        q_WB = polhode.rotations.multiply(turn, start.q_WB)
        return polhode.State(inertia_B, q_WB=q_WB, L_W=start.L_W)


class ExactInDisguise(polhode.Scheme):
    """Hands the step to a built-in scheme."""

    name = "exact_in_disguise"
    order = None
    takes_rotors = True

    def step(self, inertia_B, state, dt, delta_omega_W=0):
        return polhode.scheme("exact").step(inertia_B, state, dt, delta_omega_W)


class Failing(polhode.Scheme):
    """Raises in its third step."""

    name = "failing"

    def __init__(self):
        self.steps = 0

    def step(self, inertia_B, state, dt, delta_omega_W=0):
        self.steps += 1
        if self.steps == 3:
            raise ZeroDivisionError("in step 3")
        return state


BODY = {"inertia_B": (1.0, 2.0, 3.0), "omega_W": (3.0, 2.0, 4.0)}
TUMBLE = polhode.Scenario(
    {"name": "tumble", "inertia": [1, 2, 3], "angular_velocity": [3, 2, 4], "dt": 1 / 60, "duration": 2}
)


def same_bits(a, b):
    return np.array_equal(a, b, equal_nan=True)
