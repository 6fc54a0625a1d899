import gc
import math
import threading
import weakref

import numpy as np
import pytest
from schemes_of_tests import BODY, Euler, ExactInDisguise, Failing, same_bits

import polhode


def test_has_the_shapes_that_it_documents():
    run = polhode.free_motion("exact", **BODY, dt=0.01, steps=10)
    shapes = {
        name: getattr(run, name).shape
        for name in ("t_s", "q_WB", "R_WB", "omega_W", "L_W", "energy_J", "det_R")
    }
    assert shapes == {
        "t_s": (11,),
        "q_WB": (11, 4),
        "R_WB": (11, 3, 3),
        "omega_W": (11, 3),
        "L_W": (11, 3),
        "energy_J": (11,),
        "det_R": (11,),
    }
    assert run.rotor_momentum_B.shape == (11, 3) and run.omega_B.shape == (11, 3)
    assert len(run) == 11 and run.diverged_at_s is None and run.scheme == "exact"


def test_exact_keeps_energy_and_momentum():
    run = polhode.free_motion("exact", **BODY, dt=0.1, steps=1000)
    assert np.abs(run.energy_error).max() < 5e-15  # measured 2.4e-15
    assert np.abs(run.L_W - run.L_W[0]).max() == 0.0
    assert np.abs(run.det_R - 1.0).max() < 3e-15  # measured 1.3e-15


def test_euler_of_a_symmetric_body_turns_about_its_axis():
    run = polhode.free_motion("quaternion", inertia_B=(1, 1, 1), omega_W=(0, 0, 2), dt=1e-3, steps=1000)
    angle = 2 * math.atan2(run.q_WB[-1, 3], run.q_WB[-1, 0])
    assert angle == pytest.approx(2.0, abs=1e-6)  # measured -6.7e-7: its turn is 2 atan(omega dt/2)


def test_order_of_a_scheme_shows_by_halving_the_step():
    exact = polhode.free_motion("exact", **BODY, dt=1.0, steps=1).q_WB[-1]
    errors = [
        float(
            polhode.rotations.angle_between(
                polhode.free_motion("implicit_midpoint", **BODY, dt=1 / n, steps=n).q_WB[-1], exact
            )
        )
        for n in (200, 400)
    ]
    assert math.log2(errors[0] / errors[1]) == pytest.approx(2.0, abs=0.01)  # measured 1.9998


def test_every_thins_and_keeps_the_last_record():
    whole = polhode.free_motion("exact", **BODY, dt=0.01, steps=10)
    thinned = polhode.free_motion("exact", **BODY, dt=0.01, steps=10, every=4)
    assert same_bits(thinned.t_s, whole.t_s[[0, 4, 8, 10]])
    assert same_bits(thinned.q_WB, whole.q_WB[[0, 4, 8, 10]])


def test_ends_where_a_scheme_diverges():
    run = polhode.free_motion("matrix", **BODY, dt=0.1, steps=10000)
    assert run.diverged_at_s == pytest.approx(run.t_s[-1] + 0.1)
    assert np.isfinite(run.energy_J).all() and run.det_R[-1] > 1e3


def test_runs_back_in_time():
    there = polhode.free_motion("exact", **BODY, dt=0.1, steps=50)
    back = polhode.free_motion(
        "exact",
        inertia_B=BODY["inertia_B"],
        omega_W=there.omega_W[-1],
        q_WB=there.q_WB[-1],
        dt=-0.1,
        steps=50,
    )
    assert float(polhode.rotations.angle_between(back.q_WB[-1], [1, 0, 0, 0])) < 1e-13  # measured 1.8e-14


def test_a_step_is_a_step_of_free_motion():
    state = polhode.State(BODY["inertia_B"], omega_W=BODY["omega_W"])
    for scheme in polhode.schemes():
        end = scheme.step(BODY["inertia_B"], state, 0.01)
        run = polhode.free_motion(scheme, **BODY, dt=0.01, steps=1)
        assert same_bits(end.q_WB, run.q_WB[-1]) and same_bits(end.R_WB, run.R_WB[-1]), scheme
        assert same_bits(end.omega_W, run.omega_W[-1]) and same_bits(end.L_W, run.L_W[-1]), scheme


def test_a_scheme_in_python_that_calls_exact_has_its_bits():
    exact = polhode.free_motion("exact", **BODY, dt=0.05, steps=100)
    disguised = polhode.free_motion(ExactInDisguise(), **BODY, dt=0.05, steps=100)
    assert same_bits(exact.q_WB, disguised.q_WB) and same_bits(exact.omega_W, disguised.omega_W)


def test_a_scheme_in_python_is_driven_by_a_law_as_a_built_in_one():
    law = polhode.torque_laws.orientation_spring((1, 0, 0, 0), 2.0)
    runs = [
        polhode.free_motion(scheme, **BODY, dt=0.01, steps=50, torque_law=law, order=4)
        for scheme in ("exact", ExactInDisguise())
    ]
    assert same_bits(runs[0].q_WB, runs[1].q_WB)


def test_what_a_scheme_raises_arrives():
    with pytest.raises(ZeroDivisionError, match="in step 3"):
        polhode.free_motion(Failing(), **BODY, dt=0.01, steps=1000)
    polhode.free_motion("exact", **BODY, dt=0.01, steps=1)  # nothing is left of it


def test_a_scheme_must_return_a_state():
    class Forgetful(polhode.Scheme):
        name = "forgetful"

        def step(self, inertia_B, state, dt, delta_omega_W=0):
            pass

    with pytest.raises(
        TypeError, match="step of scheme forgetful must return a polhode.State, returned None"
    ):
        polhode.free_motion(Forgetful(), **BODY, dt=0.01, steps=1)


def test_a_scheme_that_swells_has_to_say_so():
    class Swelling(polhode.Scheme):
        name = "swelling"

        def step(self, inertia_B, state, dt, delta_omega_W=0):
            return polhode.State(inertia_B, R_WB=1.01 * state.R_WB, L_W=state.L_W)

    with pytest.raises(
        ValueError, match="swelling returned an R_WB of determinant 1.030301; valid is a rotation"
    ):
        polhode.free_motion(Swelling(), **BODY, dt=0.01, steps=10)
    Swelling.rotation = "lost"
    assert polhode.free_motion(Swelling(), **BODY, dt=0.01, steps=10).det_R[-1] == pytest.approx(1.01**30)


def test_a_scheme_may_itself_run_schemes():
    class Nested(polhode.Scheme):
        name = "nested"

        def step(self, inertia_B, state, dt, delta_omega_W=0):
            with pytest.raises(ZeroDivisionError):
                polhode.free_motion(Failing(), **BODY, dt=0.01, steps=10)
            return polhode.scheme("exact").step(inertia_B, state, dt, delta_omega_W)

    nested = polhode.free_motion(Nested(), **BODY, dt=0.01, steps=5)
    assert same_bits(nested.q_WB, polhode.free_motion("exact", **BODY, dt=0.01, steps=5).q_WB)


def test_threads_run_at_the_same_time_with_the_same_result():
    expected = polhode.free_motion(Euler(), **BODY, dt=0.01, steps=500)
    results = {}

    def run(i):
        scheme = Euler() if i % 2 == 0 else "rk4"
        results[i] = polhode.free_motion(scheme, **BODY, dt=0.01, steps=500)

    threads = [threading.Thread(target=run, args=(i,)) for i in range(8)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    rk4 = polhode.free_motion("rk4", **BODY, dt=0.01, steps=500)
    assert all(same_bits(results[i].q_WB, (expected if i % 2 == 0 else rk4).q_WB) for i in range(8))


def test_an_exception_in_one_thread_stays_there():
    caught = []

    def fail():
        try:
            polhode.free_motion(Failing(), **BODY, dt=0.01, steps=10)
        except ZeroDivisionError as error:
            caught.append(error)

    threads = [threading.Thread(target=fail) for _ in range(4)]
    for thread in threads:
        thread.start()
    polhode.free_motion(Euler(), **BODY, dt=0.01, steps=500)
    for thread in threads:
        thread.join()
    assert len(caught) == 4


def test_the_gil_is_released():
    ticks = []
    stop = threading.Event()

    def count():
        while not stop.is_set():
            ticks.append(1)
            stop.wait(1e-3)

    thread = threading.Thread(target=count)
    thread.start()
    polhode.free_motion("exact", **BODY, dt=0.01, steps=300_000, every=300_000)
    during = len(ticks)
    stop.set()
    thread.join()
    assert during > 5  # measured 194; 2 if the GIL is held


def test_schemes_and_laws_are_let_go():
    scheme, law = Euler(), lambda motion: (0, 0, 0)
    polhode.free_motion(
        scheme, **BODY, dt=0.01, steps=3, torque_law=polhode.torque_laws.rate_damping(0.1) + law
    )
    with_name_of_another = Euler()
    polhode.register_scheme(with_name_of_another)
    polhode.register_scheme(Euler())
    left = [weakref.ref(each) for each in (scheme, law, with_name_of_another)]
    del scheme, law, with_name_of_another
    gc.collect()
    assert [each() for each in left] == [None, None, None]


def _resident_kib():
    with open("/proc/self/statm", encoding="ascii") as file:
        return int(file.read().split()[1]) * 4


def test_a_thousand_of_everything_leave_no_memory_behind():
    def all_once():
        scheme = Euler()
        polhode.register_scheme(scheme)
        law = polhode.torque_laws.rate_damping(0.1) + (lambda motion: motion.omega_W * 0.0)
        polhode.free_motion(scheme, **BODY, dt=0.01, steps=3, torque_law=law)
        polhode.schemes()
        with pytest.raises(ZeroDivisionError):
            polhode.free_motion(Failing(), **BODY, dt=0.01, steps=4)

    for _ in range(200):
        all_once()
    gc.collect()
    before = _resident_kib()
    for _ in range(1000):
        all_once()
    gc.collect()
    assert _resident_kib() - before < 256  # measured 0 KiB; 1,000 leaked Trajectories would be 1.5 MiB
