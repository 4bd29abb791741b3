"""Responses and histories: those of the program, one by one and in batches."""
import csv
import io
import math
import threading
import time

import numpy as np
import pandas as pd
import pytest
import xarray

import fourpost as fp
from fourpost._arrays import report_unanswered
from conftest import SOURCE, STARTER, program

LAND_ROVER = SOURCE / "urdf/landrover110_model3.urdf"


@pytest.mark.parametrize("file, mode, engine", [
    (STARTER / "vehicle.urdf", "heave", "auto"), (LAND_ROVER, "roll", "reduced"), (LAND_ROVER, "FL=1,RR=-0.5", "auto")])
def test_a_response_is_that_of_the_program_to_the_last_bit(file, mode, engine, tmp_path):
    program("response", file, "--mode", mode, "--engine", engine, "-o", tmp_path / "out")
    rows = list(csv.DictReader(io.StringIO((tmp_path / "out/response.csv").read_text())))
    response = fp.load(file).response(mode, engine=engine)
    assert rows and len(rows) == response.frf.size
    for row, value, mean, second in zip(rows, response.frf.flat, response.mean.flat, response.second_harmonic.flat):
        value = complex(value)
        # As analysis/signals/decibel.h has degrees.
        degrees = math.atan2(value.imag, value.real) * (180 / math.pi)
        assert (float(row["gain"]), float(row["phase_deg"])) == (abs(value), degrees)
        assert (float(row["mean"]), float(row["second_harmonic"])) == (mean, second)
    assert [float(row["frequency_Hz"]) for row in rows[:40]] == list(response.frequency)
    assert [float(row["post_amplitude_m"]) for row in rows[:40]] == list(response.amplitude)


def test_parameters_go_by_name(car):
    by_name = car.response(frequency=[1, 5], amplitude=0.01, k=30e3)
    assert np.array_equal(by_name.frf, car.at(k=30e3).response(frequency=[1, 5], amplitude=[0.01, 0.01]).frf)
    assert not np.array_equal(by_name.frf, car.response(frequency=[1, 5], amplitude=0.01).frf)
    assert by_name["s_strut"].shape == (2,)


def test_frequencies_without_a_motion_are_named():
    frf = np.array([[1, np.nan, 1], [1, 1, 1]])
    with pytest.warns(fp.InputWarning, match="at 2 Hz: .* \\[response-unanswered\\]"):
        report_unanswered(np.array([1.0, 2.0, 3.0]), frf)
    with pytest.raises(fp.SimulationError, match="at 1, 2, 3 Hz") as raised:
        report_unanswered(np.array([1.0, 2.0, 3.0]), np.full((2, 3), np.nan))
    assert raised.value.ids == ["response-unanswered"]


@pytest.mark.parametrize("call, id", [
    (lambda car: car.response(frequency=[]), "value-out-of-range"),
    (lambda car: car.response(frequency=[0, 1]), "value-out-of-range"),
    (lambda car: car.response(amplitude=-0.005), "value-out-of-range"),
    (lambda car: car.response(freq=[1, 2]), "value-unknown"),
    (lambda car: car.responses([[1, 2]], ["k", "k"]), "table-shape")])
def test_faulty_arguments_are_named(car, call, id):
    with pytest.raises(fp.InputError) as raised:
        call(car)
    assert raised.value.ids == [id]


@pytest.mark.parametrize("engine", ["reduced", "auto"])
def test_a_batch_is_its_single_responses_to_the_last_bit(engine):
    car = fp.load(LAND_ROVER)
    bounded = car.parameters.query("upper > lower").head(3)
    draw = np.random.default_rng(1).uniform(size=(4, 3))
    values = bounded["lower"].to_numpy() + draw * (bounded["upper"] - bounded["lower"]).to_numpy()
    frame = pd.DataFrame(values, columns=bounded.index)
    batch = car.responses(frame, mode="pitch", engine=engine, threads=2)
    assert batch.frf.shape == (4, len(car.sensors), 40) and not batch.failures
    for i, row in frame.iterrows():
        one = car.response("pitch", engine=engine, **row)
        assert np.array_equal(batch.frf[i], one.frf)
        assert np.array_equal(batch.mean[i], one.mean)
        assert np.array_equal(batch.second_harmonic[i], one.second_harmonic)
        assert batch.engines[i] == one.engine
    assert np.array_equal(car.responses(values, list(bounded.index), "pitch", engine=engine, threads=1).frf, batch.frf)


def test_a_car_without_a_response_leaves_the_others_theirs(car):
    batch = car.responses([[20e3], [-1.0], [30e3]], ["k"], frequency=[1, 2])
    assert list(batch.failures) == [1] and "above zero" in batch.failures[1]
    assert np.isnan(batch.frf[1]).all() and batch.engines[1] is None
    assert np.isfinite(batch.frf[[0, 2]]).all()


def test_tables_and_datasets_hold_the_same_numbers(car):
    response = car.response(frequency=[1, 2, 3])
    frame = response.to_frame()
    assert len(frame) == response.frf.size
    assert np.array_equal(frame.query("channel == 's_strut'")["gain"], abs(response["s_strut"]))
    dataset = response.to_xarray()
    assert isinstance(dataset, xarray.Dataset)
    assert np.array_equal(dataset.frf.sel(sensor="s_strut"), response["s_strut"])
    batch = car.responses([[20e3], [30e3]], ["k"], frequency=[1, 2, 3])
    assert list(batch.to_xarray().frf.sel(sensor="s_strut").k) == [20e3, 30e3]


@pytest.mark.parametrize("wrong, id", [
    (dict(frequency=[[1, 2]]), "table-shape"), (dict(frequency=[1, math.nan]), "number-not-finite"),
    (dict(frequency=[1, 2], amplitude=[1e-3, 1e-3, 1e-3]), "amplitude-count"),
    (dict(frequency=[-1.0]), "value-out-of-range"), (dict(frequency=[1.0], amplitude=12), "usual-stroke-exceeded"),
    (dict(mode="hop"), "mode-unknown"), (dict(engine="fast"), "name-unknown"), (dict(q=1.0), "name-unknown")])
def test_wrong_excitations_are_refused_by_id(car, wrong, id):
    with pytest.raises(fp.InputError) as raised:
        car.response(**wrong)
    assert id in raised.value.ids


@pytest.mark.parametrize("values, names, id", [
    ([[1.0, 2.0]], ["k"], "table-shape"), ([20e3], ["k"], "table-shape"), ([[20e3]], None, "table-shape"),
    ([[20e3]], ["q"], "name-unknown"), ([[math.nan]], ["k"], "number-not-finite")])
def test_wrong_tables_are_refused_by_id(car, values, names, id):
    with pytest.raises(fp.InputError) as raised:
        car.responses(values, names)
    assert raised.value.ids == [id]


def test_unknown_sensors_are_named(car):
    with pytest.raises(fp.InputError, match="a_body") as raised:
        car.response(frequency=[1])["a_bodi"]
    assert raised.value.ids == ["name-unknown"]


def posts(rate, seconds=4):
    t = np.arange(int(rate * seconds)) / rate
    return pd.DataFrame({"post": 0.01 * np.sin(2 * np.pi * 2 * t) * t / seconds}, index=pd.Index(t, name="time"))


def test_a_history_is_that_of_the_program(car, tmp_path):
    # At times that are doubles as printed.
    frame = posts(256).rename(columns={"post": car.posts[0]})
    table = frame.reset_index()
    table.columns = pd.MultiIndex.from_tuples([("time", "s"), (car.posts[0], "m")])
    table.to_csv(tmp_path / "posts.csv", index=False)
    text = program("simulate", STARTER / "vehicle.urdf", "--recording", tmp_path / "posts.csv", "--rate", "256Hz")
    by_program = pd.read_csv(io.StringIO(text), skiprows=[1], float_precision="round_trip")
    history = car.simulate(frame)
    assert history.rate == 256 and list(history.frame.columns) == list(car.sensors)
    for sensor in car.sensors:
        # Printed with eight digits.
        assert np.array_equal([float(f"{value:.7e}") for value in history[sensor]], by_program[sensor]), sensor


def test_notebooks_see_what_answered(car):
    assert "engine reduced" in car.response(frequency=[1, 2], engine="reduced")._repr_html_()
    history = car.simulate(posts(200).rename(columns={"post": car.posts[0]}), engine="reduced")
    assert "800 samples at 200 Hz" in history._repr_html_() and "a_body" in history._repr_html_()


def test_arrays_need_a_rate(car):
    frame = posts(200).rename(columns={"post": car.posts[0]})
    history = car.simulate({car.posts[0]: frame[car.posts[0]].to_numpy()}, 200)
    assert np.array_equal(history.frame, car.simulate(frame).frame)
    with pytest.raises(fp.InputError) as raised:
        car.simulate({car.posts[0]: [0.0] * 10})
    assert raised.value.ids == ["rate-not-positive"]


@pytest.mark.parametrize("change, id", [
    (lambda frame: frame.drop(index=frame.index[50]), "time-drifts"),
    (lambda frame: 1000 * frame, "usual-stroke-exceeded"),
    (lambda frame: frame.replace(frame.iloc[9, 0], math.nan), "number-not-finite"),
    (lambda frame: frame.rename(columns=lambda name: "FX"), "name-unknown")])
def test_wrong_posts_are_refused_by_id(car, change, id):
    with pytest.raises(fp.InputError) as raised:
        car.simulate(change(posts(200).rename(columns={"post": car.posts[0]})))
    assert raised.value.ids == [id]


def test_the_interpreter_goes_on_while_the_library_computes():
    """Another thread looks at the clock while a history in full geometry is computed."""
    car = fp.load(SOURCE / "urdf/landrover110.urdf")
    frame = posts(500, 8).rename(columns={"post": car.posts[0]})
    looks, is_done = [], threading.Event()

    def look():
        while not is_done.wait(1e-3):
            looks.append(time.monotonic())

    other = threading.Thread(target=look)
    other.start()
    began = time.monotonic()
    car.simulate(frame, engine="full")
    ended = time.monotonic()
    is_done.set()
    other.join()
    seen = [began, *(look for look in looks if began < look < ended), ended]
    # With the lock held all through the call there is one gap, the whole of it.
    assert max(np.diff(seen)) < 0.5 * (ended - began)
