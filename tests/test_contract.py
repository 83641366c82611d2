"""What users and other programs rely on: names, options, files, exit codes (the contract)."""

import json
import subprocess
import sys
from importlib import import_module
from importlib.metadata import entry_points
from math import pi

import numpy as np
import pytest

import soccersim
from soccersim import Recording, Simulation, load_scenario
from soccersim.cli import main
from soccersim.problems import InputError, MachineError, RunError, Stopped
from soccersim.report import report

VERBS = {
    *("list", "run", "reproduce", "tune", "match", "regress", "tournament", "replay", "plot"),
    *("live", "worker", "merge", "bench", "schema", "new"),
}
RUN_OPTIONS = {
    *("--seed", "--out", "--set", "--frames", "--video", "--no-plot", "--runs", "--jobs"),
    *("--json", "--force"),
    *("--from", "--to", "--speed", "--size"),  # of --video and --frames
}


def test_the_front_door_of_the_package():
    recording = Simulation(load_scenario("defender", seed=3)).run()
    assert isinstance(recording, Recording)
    assert recording.meta["seed"] == 3
    doors = {"Recording", "Simulation", "__version__", "load_scenario", "play_match"}
    assert set(soccersim.__all__) == doors
    with pytest.raises(AttributeError, match="has no attribute 'nothing'"):
        _ = soccersim.nothing


def test_the_front_door_opens_without_loading_what_is_behind_it():
    code = (
        "import sys, soccersim; print([m for m in ('numpy', 'numba', 'yaml') if m in sys.modules])"
    )
    ended = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert ended.stdout == "[]\n"


def test_a_simulation_goes_step_by_step_with_its_state_open_to_look_at():
    simulation = Simulation(load_scenario("linear"))
    for _ in range(100):
        simulation.step()
    assert (simulation.tick, simulation.done) == (100, False)
    assert simulation.machine.truth.body[0, 0] > -1.5
    shares = []
    recording = simulation.run(shares.append)
    assert simulation.done
    assert recording.duration == 6.0
    assert shares == sorted(shares)
    assert shares[-1] == 1.0
    simulation.advance(100)  # over is over
    assert simulation.tick == 3000


def test_kinematics_by_their_contracted_names():
    from soccersim.kinematics import OmniBase

    base = OmniBase.tangential(azimuths_deg=(30, 150, 270), distance=0.19, wheel_radius=0.05)
    twist = (0.5, -0.2, 1.0)
    wheels = base.wheel_speeds(twist)
    assert base.twist(wheels) == pytest.approx(twist)
    assert base.slip_residual(wheels) == pytest.approx([0, 0, 0], abs=1e-12)
    assert base.wheel_speeds((0, 0, 1)) == pytest.approx([0.19 / 0.05] * 3)


def test_axes_are_x_forward_y_left_and_counter_clockwise_in_si():
    words = ["robots.0.open_loop=[{seconds: 1, twist: [0.3, 0, 0]}]", "robots.0.start=[0, 0, 90]"]
    body = Simulation(load_scenario("linear", settings=words)).run().body[:, 0]
    assert body[0, 2] == pytest.approx(pi / 2)
    assert np.argmax(np.abs(body[-1, :2])) == 1  # it faces along y: left of x
    assert body[-1, 1] > 0.1
    words[0] = "robots.0.open_loop=[{seconds: 1, twist: [0, 0, 1]}]"
    assert Simulation(load_scenario("linear", settings=words)).run().body[-1, 0, 2] > pi / 2 + 0.3


def test_the_program_is_installed_by_its_name():
    (script,) = entry_points(group="console_scripts", name="soccersim")
    assert script.load() is import_module("soccersim.__main__").main
    assert set(main.VERBS) <= VERBS
    assert {"list", "run", "match", "replay", "bench", "schema", "new"} <= set(main.VERBS)


def test_run_has_the_contracted_options():
    command = import_module("soccersim.cli.run").command
    assert {option for p in command.params for option in p.opts} == RUN_OPTIONS | {"scenario"}
    for verb in main.VERBS:
        command = import_module(f"soccersim.cli.{verb}").command
        # the contract gives these no --json
        silent = verb in ("schema", "replay", "plot", "live", "new")
        assert silent or "--json" in {o for p in command.params for o in p.opts}, verb


def test_every_kind_of_failure_has_its_exit_code(capsys):
    codes = {
        InputError(()): 2,
        MachineError("disk"): 3,
        MemoryError(): 3,
        OSError(28, "No space left on device", "x"): 3,
        RunError("not a number"): 4,
        ValueError("ours"): 4,
        Stopped("stopped"): 130,
        KeyboardInterrupt(): 130,
    }
    assert {error: main.tell(error) for error in codes} == codes
    assert capsys.readouterr().out == ""


def test_all_problems_of_an_input_come_whole_out_of_another_process():
    import pickle

    with pytest.raises(InputError) as caught:
        load_scenario("defender", settings=["duration=-1", "name=3"])
    again = pickle.loads(pickle.dumps(caught.value))
    assert again.problems == caught.value.problems
    assert str(again) == str(caught.value)


def test_python_without_assertions_behaves_the_same():
    words = ["-O", "-m", "soccersim", "run", "linear", "--set", "duration=0.1", "--json"]
    ended = subprocess.run([sys.executable, *words], capture_output=True, text=True, check=True)
    here = report(Simulation(load_scenario("linear", settings=["duration=0.1"])).run())
    assert json.loads(ended.stdout) == json.loads(json.dumps(here))
