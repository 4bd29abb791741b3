"""Every long call lets other threads of Python run, and ends by Ctrl-C. Each would go on for many minutes."""
import os
import signal
import threading
import time

import numpy as np
import pandas as pd
import pytest

import fourpost as fp
from conftest import SOURCE, STARTER

LAND_ROVER = SOURCE / "urdf/landrover110_model3.urdf"
SETTINGS = """knobs:
  spring: {sets: k, range: {from: 12 kN/m, to: 40 kN/m, step: 0.1 kN/m}}
  tyre: {sets: kt, range: {from: 120 kN/m, to: 380 kN/m, step: 1 kN/m}}
roads: [{class: B, speed: 80 km/h}]
draws: 1000
"""


def post_heights(car, seconds, rate=500):
    t = np.arange(int(seconds * rate)) / rate
    return pd.DataFrame({car.posts[0]: 0.01 * np.sin(2 * np.pi * 2 * t)}, index=pd.Index(t, name="time"))


def of_history(car, seconds):
    """The Jacobian by differences takes many such recordings."""
    posts = post_heights(car, seconds)
    noise = pd.DataFrame({"a_body": np.random.default_rng(1).standard_normal(len(posts))}, index=posts.index)
    return fp.Study(car, [fp.TimeHistory(posts, noise)], evaluations=10 ** 8)


def many_rows(car, count):
    row = car.parameters.query("upper > lower")
    return pd.DataFrame(np.tile(row["value"].to_numpy(), (count, 1)), columns=row.index)


def long_recording(folder):
    """Of a stepped sine at many frequencies."""
    table = pd.read_csv(STARTER / "stepped_sine.csv")
    first = table[table["frequency_Hz"] == table["frequency_Hz"].iloc[0]]
    rows = [first.assign(frequency_Hz=hertz) for hertz in np.linspace(0.5, 20, 2000)]
    pd.concat(rows).to_csv(folder / "long.csv", index=False)
    return folder / "long.csv"


def call_response(car, run, folder):
    return lambda: car.response(frequency=np.linspace(0.5, 1, 10 ** 5), engine="time_integration")


def call_responses(car, run, folder):
    rover = fp.load(LAND_ROVER)
    rows = many_rows(rover, 10 ** 5)
    return lambda: rover.responses(rows, frequency=[1.0], engine="full", threads=1)


def call_simulate(car, run, folder):
    posts = post_heights(car, 3600)
    return lambda: car.simulate(posts, engine="full")


def call_draws(car, run, folder):
    return lambda: run.draws(10 ** 6, noise_of=STARTER / "study.yaml", threads=1)


def call_predict(car, run, folder):
    recording = long_recording(folder)
    return lambda: run.predict(recording, engine="time_integration", posts="heave")


def call_choose(car, run, folder):
    (folder / "settings.yaml").write_text(SETTINGS)
    return lambda: fp.choose(run, folder / "settings.yaml", threads=1)


def call_objective(car, run, folder):
    objective = fp.Study(STARTER / "study.yaml").objective()
    points = np.tile(objective.parameters["value"].to_numpy(), (10 ** 6, 1))
    points[:, 0] += np.arange(10 ** 6)
    return lambda: objective.cost(points, threads=1)


def call_jacobian(car, run, folder):
    objective = of_history(car, seconds=900).objective()
    return lambda: [objective.jacobian(objective.parameters["value"]) for _ in range(1000)]


def call_minimise(car, run, folder):
    return lambda: fp.minimise({"x": fp.Axis(0, 1e9, 1)}, lambda x: (time.sleep(1e-3), x)[1], evaluations=10 ** 8)


def call_fit(car, run, folder):
    study = of_history(car, seconds=90)
    return lambda: fp.fit(study, folder / "run", threads=1)


@pytest.mark.parametrize("prepare", [call_response, call_responses, call_simulate, call_draws, call_predict, call_choose,
                                     call_objective, call_jacobian, call_minimise, call_fit],
                         ids=lambda prepare: prepare.__name__.removeprefix("call_"))
def test_it_ends_by_ctrl_c(prepare, car, run, tmp_path):
    call = prepare(car, run, tmp_path)
    is_calling = threading.Event()

    def interrupt():
        # Only a thread that has the interpreter's lock gets here, some moments into the call.
        is_calling.wait()
        time.sleep(0.5)
        os.kill(os.getpid(), signal.SIGINT)
    other = threading.Thread(target=interrupt)
    other.start()
    was_over_before = False
    with pytest.raises(KeyboardInterrupt):
        is_calling.set()
        call()
        was_over_before = True
        time.sleep(60)
    other.join()
    assert not was_over_before
