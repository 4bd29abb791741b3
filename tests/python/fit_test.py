"""Fits: those of the program, in files and in memory; progress, Ctrl-C."""
import json
import os
import signal
import subprocess
import sys
import textwrap
import threading

import numpy as np
import pandas as pd
import pytest
import xarray

import fourpost as fp
from conftest import SOURCE, STARTER, program

FREQUENCY = [0.6, 1, 1.5, 2, 3, 5, 8, 12]


def measured(car, **values):
    response = car.response(frequency=FREQUENCY, amplitude=0.01, **values)
    channels = {name: fp.Measured(response[name], mean=response.mean[response.sensors.index(name)])
                for name in ("a_body", "a_wheel", "s_strut", "F_tyre")}
    return fp.SteppedSine(FREQUENCY, 0.01, channels, name="bench")


def test_a_fit_is_that_of_the_program_to_the_last_byte(run, tmp_path):
    program("fit", STARTER / "study.yaml", "-o", tmp_path / "run", "--no-suggest", "--threads", "2")
    for name in ("result.json", "response.csv", "vehicle.urdf", "parameters.csv"):
        assert (run.folder / name).read_bytes() == (tmp_path / "run" / name).read_bytes(), name
    by_program = {one["name"]: one for one in json.loads((tmp_path / "run/result.json").read_text())["parameters"]}
    frame = run.parameters
    assert list(frame.index) == list(by_program)
    for name, row in frame.iterrows():
        one = by_program[name]
        assert all(row[key] == one[key] for key in ("value", "sd", "unit", "state"))
        assert [row["lower_95"], row["upper_95"]] == one["interval_95"]


def test_a_run_is_opened_again(run):
    again = fp.read_run(run.folder)
    pd.testing.assert_frame_equal(again.parameters, run.parameters)
    assert again.converged and again.explains_data and again.cost == run.cost == run.result["cost"]
    assert again.vehicle["k"] == run.parameters.loc["k", "value"]
    page = run._repr_html_()
    assert "converged" in page and "c_rebound" in page


def test_the_response_of_a_run_is_a_dataset(run):
    dataset = run.response
    assert isinstance(dataset, xarray.Dataset)
    table = run.table("response")
    one = dataset.sel(recording="stepped_sine", channel="s_strut")
    assert np.array_equal(one.gain_modelled, table.query("channel == 's_strut'")["gain_modelled"])


def test_the_response_of_a_run_is_a_frame_without_xarray(run, monkeypatch):
    monkeypatch.setitem(sys.modules, "xarray", None)
    frame = run.response
    assert isinstance(frame, pd.DataFrame) and list(frame.index.names) == ["recording", "channel", "frequency_Hz"]


def test_arrays_in_memory_give_back_the_car_that_made_them(car, tmp_path):
    truth = dict(k=26e3, c_bump=1.2e3)
    study = fp.Study(car, [measured(car, **truth)], free=list(truth))
    run = fp.fit(study, tmp_path / "run")
    for name, value in truth.items():
        # Far below what refinements call the same, a third of a standard deviation.
        fitted = run.parameters.loc[name]
        assert abs(fitted["value"] - value) < 0.01 * fitted["sd"]
    assert (tmp_path / "run/inputs/arrays.yaml").exists()


def test_histories_in_memory_are_fitted(car):
    rate = 200
    t = np.arange(800) / rate
    posts = pd.DataFrame({car.posts[0]: 0.01 * (1 - np.cos(2 * t)) * np.sin(2 * np.pi * (1 + 2 * t) * t)}, index=t)
    history = car.simulate(posts, k=26e3)
    test = fp.TimeHistory(posts, history.frame[["a_body", "a_wheel", "F_tyre"]], name="chirp")
    run = fp.fit(fp.Study(car, [test], free=["k"], evaluations=20, starts=1))
    # Integrated to 1e-3 of a channel, as the fit is.
    assert run.parameters.loc["k", "value"] == pytest.approx(26e3, rel=2e-3)


def test_results_without_a_folder_go_with_the_run(car):
    run = fp.fit(fp.Study(car, [measured(car)], free=["k"], evaluations=20, starts=1))
    folder = run.folder
    assert (folder / "report.html").exists()
    del run
    assert not folder.exists()


def test_progress_comes_to_this_thread_and_ends_with_the_report(car):
    seen = []
    fp.fit(STARTER / "study.yaml", threads=2, progress=lambda state: seen.append((state, threading.get_ident())))
    assert {thread for _, thread in seen} == {threading.get_ident()}
    assert seen[-1][0].evaluations > 0 and np.isfinite(seen[-1][0].best_cost)
    assert str(seen[-1][0]).startswith(seen[-1][0].stage)


def test_what_progress_raises_ends_the_fit_with_what_it_has(tmp_path):
    def fail(state):
        raise ZeroDivisionError

    with pytest.raises(ZeroDivisionError):
        fp.fit(SOURCE / "studies/landrover110/model2.yaml", tmp_path / "run", progress=fail)
    assert (tmp_path / "run/archive.sqlite").exists()


def test_ctrl_c_ends_a_fit_whose_results_are_kept(tmp_path):
    """As the program: what there is is written, and the same call goes on from the archive."""
    script = tmp_path / "script.py"
    script.write_text(textwrap.dedent("""
        import sys, fourpost as fp
        car = fp.load(sys.argv[1])
        response = car.response(frequency=[1, 2, 4, 8], amplitude=0.01, k=26e3)
        sine = fp.SteppedSine([1, 2, 4, 8], 0.01, {name: response[name] for name in ("a_body", "s_strut", "F_tyre")})
        study = fp.Study(car, [sine], evaluations=10**8)
        try:
            fp.fit(study, sys.argv[2], threads=1, progress=lambda state: print(state, flush=True))
        except KeyboardInterrupt as interrupt:
            print("raised", interrupt.__notes__[0], flush=True)
    """))
    fit = subprocess.Popen([sys.executable, script, STARTER / "vehicle.urdf", tmp_path / "run"],
                           stdout=subprocess.PIPE, text=True, env={**os.environ, "PYTHONUNBUFFERED": "1"})
    for line in fit.stdout:
        if line.startswith("search") and "inf" not in line:
            break
    fit.send_signal(signal.SIGINT)
    rest = fit.stdout.read()
    assert fit.wait() == 0
    assert rest.splitlines()[-1].startswith("raised fourpost: results so far are in")
    run = fp.read_run(tmp_path / "run")
    assert run.termination == "interrupted" and len(run.parameters) > 0


@pytest.mark.parametrize("test, id", [
    (fp.SteppedSine([1, 2], 0.01, {"a_body": [1, 2, 3]}), "arrays-unequal"),
    (fp.SteppedSine([1, 2], [0.01] * 3, {"a_body": [1, 2]}), "arrays-unequal"),
    (fp.SteppedSine([1, 2], 0.01, {"a_bodi": [1, 2]}), "name-unknown"),
    (fp.SteppedSine([1, 2], 0.01, {"a_body": fp.Measured([1, 2], [0.01] * 3)}), "arrays-unequal"),
    (fp.SteppedSine([1, 2], 0.01, {"a_body": ["one", "two"]}), "table-shape"),
    (fp.SteppedSine([1, 2], 0.01, {"s_strut": fp.Measured([1, 2], mean_sd=1e-3)}), "mean-sd-without-mean"),
    (fp.SteppedSine([1, 2], 0.01, {"s_strut": fp.Measured([1, 2], mean=[0, 0], mean_sd=[1e-3, -1e-3])}), "array-negative"),
    (fp.SteppedSine([1, 2], 0.01, {"a_body": [[1, 2], [1]]}), "table-shape"),
    (fp.TimeHistory({"post": ["high"] * 9}, {"a_body": [0.0] * 9}, rate=100), "table-shape"),
    (fp.SteppedSine([1, 2], 0.01, {"a_body": [1, np.nan]}), "number-not-finite"),
    (fp.TimeHistory({"post": [0.0] * 9}, {"a_body": [0.0] * 8}, rate=100), "arrays-unequal"),
    (fp.TimeHistory({"post": [0.0] * 8}, {"a_body": [0.0] * 7 + [np.inf]}, rate=100), "number-not-finite")])
def test_wrong_arrays_are_refused_by_id(car, tmp_path, test, id):
    with pytest.raises(fp.InputError) as raised:
        fp.fit(fp.Study(car, [test]), tmp_path / "run")
    assert raised.value.ids == [id] and "''" not in str(raised.value)


def test_names_of_recordings_come_before_their_use():
    sine = fp.SteppedSine([1, 2], 0.01, {"a_body": [1, 2]}, "heave", "mine", validation=True)
    assert (sine.name, sine.validation) == ("mine", True)
    with pytest.raises(TypeError):
        fp.SteppedSine([1, 2], 0.01, {"a_body": [1, 2]}, "heave", "mine", True)


def test_deviations_of_means_are_weighed_beside_the_model_error(car, tmp_path):
    """Of means alone: chi square of the residuals goes with 1 / (mean_sd^2 + model_error.mean^2)."""
    def square(mean_sd, error):
        measured = fp.Measured([1, 1], 1e6, [0.1, 0.1], mean_sd)
        study = fp.Study(car, [fp.SteppedSine([1, 2], 0.01, {"s_strut": measured})], free=["k"],
                         model_error=fp.ModelError(mean=error))
        return study.objective().cost([car["k"]])

    assert square(3e-3, 4e-3) == pytest.approx(square([3e-3, 3e-3], 4e-3))
    assert square((), 1e-3) / square(3e-3, 4e-3) == pytest.approx(25, rel=1e-3)


def test_faults_of_a_study_have_their_lines(tmp_path):
    (tmp_path / "study.yaml").write_text((STARTER / "study.yaml").read_text().replace("starts: 4", "strats: 4"))
    with pytest.raises(fp.InputError) as raised:
        fp.fit(tmp_path / "study.yaml", tmp_path / "run")
    assert any(finding.line > 0 and finding.file.endswith("study.yaml") for finding in raised.value.findings)


def test_a_study_of_a_file_takes_nothing_else(tmp_path):
    with pytest.raises(fp.InputError) as raised:
        fp.fit(fp.Study(STARTER / "study.yaml", evaluations=7), tmp_path / "run")
    assert raised.value.ids == ["study-of-file"]


def test_a_folder_of_something_else_is_an_output_error(tmp_path):
    (tmp_path / "diary.txt").write_text("dear")
    with pytest.raises(fp.OutputError):
        fp.fit(STARTER / "study.yaml", tmp_path)
    assert (tmp_path / "diary.txt").exists()
