"""What concerns a whole process: precisions, Ctrl-C, the end."""

import os
import signal
import subprocess
import sys
import time

import pytest


def run_python(code, **more):
    return subprocess.run(
        [sys.executable, "-c", code],
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
        check=False,
        timeout=50,
        **more,
    )


@pytest.mark.skipif("POLHODE_COMPARE" not in os.environ, reason="no single-precision Bullet")
def test_single_precision_is_that_of_the_program(tmp_path):
    file = tmp_path / "figures.json"
    subprocess.run(
        [os.environ["POLHODE_COMPARE"], "--json", str(file)], check=True, stdout=subprocess.DEVNULL
    )
    code = f"""
import json, polhode
def figures(rows):
    return [{{k: v for k, v in row.items() if k != "ns_per_step"}} for row in rows]
comparison = polhode.compare("dzhanibekov", precision="single")
assert comparison.precision == "single"
assert figures(comparison.figures) == figures(json.load(open({str(file)!r}))["contenders"])
try:
    polhode.compare("dzhanibekov")
except RuntimeError as error:
    print(error)
"""
    ran = run_python(code)
    assert ran.returncode == 0, ran.stderr
    assert (
        ran.stdout.startswith("this process runs single-precision Bullet already")
        and "'double' in a process of its own" in ran.stdout
    )


@pytest.mark.parametrize(
    "work",
    [
        "polhode.compare(polhode.Scenario('dzhanibekov').replace(duration=300000))",
        "polhode.work_precision(['exact'], rounds=1000000)",
        "polhode.work_precision(['exact'], time_s=1000000, rounds=1, levels=1)",
        "run(polhode.scheme('exact'))",
        "run(Slow())",
    ],
)
def test_ctrl_c_ends_a_run(work):
    code = f"""
import polhode, time
class Slow(polhode.Scheme):
    name = "slow"
    def step(self, inertia_B, state, dt, delta_omega_W=0):
        return state
def run(scheme):
    polhode.free_motion(scheme, inertia_B=(1, 2, 3), omega_W=(3, 2, 4), dt=0.01, steps=10**8, every=10**8)
try:
    print("started", flush=True)
    {work}
except KeyboardInterrupt:
    polhode.free_motion(inertia_B=(1, 2, 3), omega_W=(3, 2, 4), dt=0.01, steps=1)
    print("interrupted", flush=True)
"""
    process = subprocess.Popen([sys.executable, "-c", code], stdout=subprocess.PIPE, text=True)
    assert process.stdout.readline() == "started\n"
    time.sleep(0.5)
    process.send_signal(signal.SIGINT)
    before = time.monotonic()
    assert process.communicate(timeout=30)[0] == "interrupted\n"
    assert time.monotonic() - before < 5  # measured 0.1 to 0.4


def test_the_end_of_a_process_with_a_registered_scheme_is_quiet():
    ran = run_python(
        """
import polhode
@polhode.register_scheme
class Mine(polhode.Scheme):
    name = "mine"
    def step(self, inertia_B, state, dt, delta_omega_W=0):
        return state
    def __del__(self):
        print("deleted")
polhode.compare("tumble", ["mine"])
law = polhode.torque_laws.rate_damping(0.1) + (lambda motion: (0, 0, 0))
"""
    )
    assert ran.returncode == 0 and ran.stderr == ""


def test_matplotlib_is_not_needed():
    ran = run_python(
        "import sys, polhode; polhode.compare('tumble', ['exact']); print('matplotlib' in sys.modules)"
    )
    assert ran.stdout == "False\n", ran.stderr
