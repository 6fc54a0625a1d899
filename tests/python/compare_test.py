import json
import os
import subprocess

import numpy as np
import pytest
from schemes_of_tests import TUMBLE, Euler, ExactInDisguise, Failing, same_bits

import polhode

COMPARE = os.environ["POLHODE_COMPARE_FLOAT64"]
WORK_PRECISION = os.environ["POLHODE_WORKPRECISION_FLOAT64"]


def of_program(program, *arguments, file):
    subprocess.run([program, *arguments, "--json", str(file)], check=True, stdout=subprocess.DEVNULL)
    return json.loads(file.read_text(encoding="utf-8"))


def without_times(rows):
    return [
        {key: value for key, value in row.items() if not key.startswith(("ns_per", "ratio"))} for row in rows
    ]


@pytest.mark.parametrize(
    "scenario", ["dzhanibekov", "cube_expansion", "heavy_top", "reaction_wheels", "gravity_gradient", "floor"]
)
def test_figures_are_those_of_the_program_to_the_bit(scenario, tmp_path):
    program = of_program(COMPARE, "--scenario", scenario, file=tmp_path / "figures.json")
    comparison = polhode.compare(scenario, [row["name"] for row in program["contenders"]])
    assert without_times(comparison.figures) == without_times(program["contenders"])
    assert json.loads(comparison.to_json())["scenario"] == program["scenario"]
    assert comparison.precision == program["precision"] == "double"


def test_changed_times_are_those_of_the_options(tmp_path):
    program = of_program(
        COMPARE, "--dt", "0.007", "--duration", "3", "--contender", "rk4", file=tmp_path / "figures.json"
    )
    comparison = polhode.compare(polhode.Scenario("dzhanibekov").replace(dt=0.007, duration=3), ["rk4"])
    assert without_times(comparison.figures) == without_times(program["contenders"])


def test_work_precision_is_that_of_the_program_to_the_bit(tmp_path):
    program = of_program(
        WORK_PRECISION, "curve", "--contender", "quaternion", "--contender", "bullet:implicit_body",
        "--levels", "3", "--rounds", "1", file=tmp_path / "curve.json",
    )  # fmt: skip
    curves = polhode.work_precision(["quaternion", "bullet:implicit_body"], levels=3, rounds=1)
    assert without_times(curves.points) == without_times(program["points"])


def test_series_agree_with_the_figures():
    comparison = polhode.compare(TUMBLE, ["rk4", "bullet:implicit_body", "semi_implicit_gyroscopic"])
    assert list(comparison.series) == [row["name"] for row in comparison.figures]
    for row in comparison.figures:
        series = comparison[row["name"]]
        assert len(series) == row["steps"] + 1 == 121
        assert series.energy_error[-1] == row["final_energy_error"]
        assert np.abs(series.energy_error).max() == row["worst_energy_error"]
        assert series.attitude_error_rad.max() == row["worst_attitude_error_rad"]
        assert series.det_R[-1] == row["final_det_R"]
        assert series.position_W.shape == (121, 3) and series.R_WB.shape == (121, 3, 3)


def test_series_of_exact_are_its_free_motion():
    in_bullet = polhode.compare(TUMBLE, ["exact"])["exact"]
    without = polhode.free_motion("exact", inertia_B=(1, 2, 3), omega_W=(3, 2, 4), dt=TUMBLE.dt, steps=120)
    assert (
        polhode.rotations.angle_between(in_bullet.q_WB, without.q_WB).max() < 1e-14
    )  # measured 1.6e-15: Bullet keeps 1/I


def test_long_series_are_thinned_by_default_and_every_chooses():
    long = TUMBLE.replace(dt=1e-4)
    assert len(polhode.compare(long, ["quaternion"])["quaternion"]) == 10_001
    assert len(polhode.compare(long, ["quaternion"], every=5000)["quaternion"]) == 5


def test_what_is_not_known_is_absent():
    series = polhode.compare("heavy_top", ["exact"])["exact"]
    assert np.isnan(series.attitude_error_rad).all()


def test_prints_the_table_of_the_program():
    text = str(polhode.compare(TUMBLE, ["exact", "matrix"]))
    assert (
        text.splitlines()[0] == "tumble" and "double-precision Bullet, polhode " + polhode.__version__ in text
    )
    assert [line.split()[0] for line in text.splitlines()[-2:]] == ["exact", "matrix"]


def test_writes_the_report(tmp_path):
    page = polhode.compare(TUMBLE, ["exact"]).report(tmp_path / "report.html").read_text(encoding="utf-8")
    assert page.startswith("<!DOCTYPE html>") and '"name":"tumble"' in page and "@REPORT_DATA@" not in page


def test_a_scheme_in_python_is_a_contender_like_the_others():
    comparison = polhode.compare(TUMBLE, ["exact", ExactInDisguise(), "bullet:none"])
    assert list(comparison.series) == ["exact", "exact_in_disguise", "bullet:none"]
    # Bullet's bodies are stepped by another way of exact, which remembers what it computed of L.
    apart = polhode.rotations.angle_between(comparison["exact"].q_WB, comparison["exact_in_disguise"].q_WB)
    assert apart.max() < 1e-14  # measured 1.6e-15


def test_a_registered_scheme_is_known_by_its_name():
    @polhode.register_scheme
    class Mine(Euler):
        """Mine alone."""

        name = "mine"

    assert polhode.contenders()["mine"] == "Mine alone."
    assert polhode.scheme("mine").summary == "Mine alone." and isinstance(polhode.scheme("mine"), Mine)
    assert [scheme.name for scheme in polhode.schemes()].count("mine") == 1
    row = polhode.compare(TUMBLE, ["mine"]).figures[0]
    assert row["name"] == "mine" and 0.1 < row["worst_attitude_error_rad"] < 3.2
    curve = polhode.work_precision(["mine"], time_s=1, dt_from=1e-2, levels=3, rounds=1)["mine"]
    assert (
        curve.observed_order[-1] == pytest.approx(1.0, abs=0.05) and curve.ns_per_step.min() > 0
    )  # measured 1.02
    with pytest.raises(ValueError, match="mine"):
        polhode.compare(TUMBLE, ["mein"])


def test_registered_schemes_are_compared_by_default():
    polhode.register_scheme(ExactInDisguise)
    names = list(polhode.compare(TUMBLE.replace(duration=0.1)).series)
    assert names[0] == "exact" and "exact_in_disguise" in names and names[-1] == "bullet:implicit_body"


def test_registering_again_replaces():
    for speed in (1.0, 2.0):

        class Again(polhode.Scheme):
            name = "again"
            turns_by = speed

            def step(self, inertia_B, state, dt, delta_omega_W=0):
                turn = polhode.rotations.exponential((0, 0, self.turns_by * dt))
                return polhode.State(
                    inertia_B, q_WB=polhode.rotations.multiply(turn, state.q_WB), omega_W=state.omega_W
                )

        assert polhode.register_scheme(Again) is Again
        angle = polhode.rotations.angle_between(
            polhode.compare(TUMBLE, ["again"])["again"].q_WB[60], (1, 0, 0, 0)
        )
        assert float(angle) == pytest.approx(speed, abs=1e-12)
    assert [scheme.name for scheme in polhode.schemes()].count("again") == 1


def test_what_a_scheme_raises_arrives_and_ends_the_run():
    failing, after = Failing(), Failing()
    after.name, after.steps = "after", 10
    with pytest.raises(ZeroDivisionError, match="in step 3"):
        polhode.compare(TUMBLE.replace(duration=100), [failing, after])
    assert failing.steps == 3 and after.steps == 10
    with pytest.raises(ZeroDivisionError, match="in step 3"):
        polhode.work_precision([Failing()], levels=1)
    polhode.compare(TUMBLE, ["exact"])


def test_a_scheme_without_rotors_is_refused_where_there_are_some():
    with pytest.raises(ValueError, match='contender "euler_in_python" takes no rotors'):
        polhode.compare("reaction_wheels", [Euler()])
    note = str(polhode.compare(polhode.Scenario("reaction_wheels").replace(duration=0.1)))
    assert "left out, since they take no rotors: matrix" in note


def test_curves_have_their_arrays():
    curves = polhode.work_precision(["rk4", "bullet:none"], levels=7, rounds=3)
    assert list(curves.curves) == ["rk4", "bullet:none"]
    rk4 = curves["rk4"]
    assert rk4.declared_order == "4" and rk4.observed_order[-1] == pytest.approx(
        4.0, abs=0.1
    )  # measured 4.04
    np.testing.assert_allclose(rk4.dt_s, 1 / 15 / 2.0 ** np.arange(7))
    np.testing.assert_array_equal(rk4.steps, [150, 300, 600, 1200, 2400, 4800, 9600])
    assert rk4.ns_per_step.shape == rk4.ratio_to_implicit_body.shape == (7,)
    assert str(curves).startswith("a free body after 10 s, double-precision Bullet")


def test_contenders_are_those_of_the_program():
    listed = subprocess.run([COMPARE, "--list"], check=True, stdout=subprocess.PIPE, text=True).stdout
    registered = {scheme.name for scheme in polhode.schemes() if not scheme.source}  # by other tests
    for name, summary in polhode.contenders().items():
        if name not in registered:
            assert any(line.split(maxsplit=1) == [name, summary] for line in listed.splitlines()), name
