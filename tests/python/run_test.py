"""What follows from a fit: draws, predictions, choices."""
import io
import json
import re
import shutil
import warnings

import numpy as np
import pandas as pd
import pytest

import fourpost as fp
from conftest import SOURCE, STARTER, program

SETTINGS = """knobs:
  spring: {sets: k, range: {from: 12 kN/m, to: 28 kN/m, step: 4 kN/m}}
roads:
  - {class: B, speed: 80 km/h}
draws: 20
duration: 10 s
"""


def test_a_run_of_another_version_is_said(run, tmp_path):
    folder = shutil.copytree(run.folder, tmp_path / "run")
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        fp.read_run(folder)
    text = (folder / "result.json").read_text()
    for version in ("7.1.0", "0.1.9"):
        (folder / "result.json").write_text(text.replace(f'"fourpost": "{fp.__version__}"', f'"fourpost": "{version}"'))
        with pytest.warns(fp.InputWarning, match=f"of fourpost {version}, and this is ") as caught:
            fp.read_run(folder)
        assert caught[0].filename == __file__ and caught[0].message.finding.id == "result-not-understood"


def test_the_notebook_of_how_to_runs(tmp_path, monkeypatch):
    text = (SOURCE / "docs/how_to.md").read_text()
    notebook = re.search(r"^```python\n(.*?)^```", text, re.S | re.M)[1]
    plan = next(block for block in re.findall(r"^```yaml\n(.*?)^```", text, re.S | re.M) if "\nfits:" in block)
    monkeypatch.chdir(tmp_path)
    (tmp_path / "plan.yaml").write_text(plan)
    program("init", "car")
    program("batch", "plan.yaml", "-o", "batch", "--unpack")
    names = {}
    exec(notebook, names)
    assert set(names["table"]["unit"]) == {"study/seed1", "study/seed2", "study/seed3", "stiff"}


def test_draws_are_those_of_the_program(run):
    text = program("draws", run.folder, "--seed", "3")
    by_program = pd.read_csv(io.StringIO(text), skiprows=[1], float_precision="round_trip")
    draws = run.draws(seed=3)
    assert draws.attrs["units"]["k"] == "N/m"
    pd.testing.assert_frame_equal(draws, by_program, check_exact=True)


def test_draws_are_cars(run):
    draws = run.draws(10)
    batch = run.vehicle.responses(draws, frequency=[1, 2])
    assert len(batch) == 10 and not batch.failures
    # Their gains surround that of the fit.
    gains = abs(batch["a_body"])
    fitted = abs(run.vehicle.response(frequency=[1, 2], engine="reduced")["a_body"])
    assert np.all(gains.min(axis=0) < fitted) and np.all(fitted < gains.max(axis=0))


def test_a_prediction_is_that_of_the_program(run):
    recording = STARTER / "stepped_sine.csv"
    outcome = json.loads(program("predict", run.folder, "--recording", recording, "--json"))
    prediction = run.predict(recording)
    assert prediction.result == outcome
    assert "a_body" in set(prediction.channels["name"])
    with pytest.raises(fp.InputError):
        run.predict(STARTER / "vehicle.urdf")


def test_a_frame_is_predicted_as_its_file(car, tmp_path):
    t = np.arange(800) / 200
    posts = pd.DataFrame({car.posts[0]: 0.01 * (1 - np.cos(2 * t)) * np.sin(2 * np.pi * (1 + t) * t)}, index=t)
    history = car.simulate(posts, k=26e3).frame
    test = fp.TimeHistory(posts, history[["a_body", "F_tyre"]])
    run = fp.fit(fp.Study(car, [test], free=["k"], evaluations=20, starts=1))
    slower = 0.5 * posts
    post = f"post_{car.posts[0]}"
    frame = car.simulate(slower, k=26e3).frame[["a_body", "F_tyre"]].assign(**{post: slower[car.posts[0]]})
    prediction = run.predict(frame, units={"a_body": "m/s^2", "F_tyre": "N", post: "m"})
    # Integrated to 1e-3, whose square is the mean square error.
    assert prediction.channels.query("name == 'a_body'")["nmse_percent"].item() < 0.01
    # Posts by their own names, in m.
    own = frame.rename(columns={post: car.posts[0]})
    assert run.predict(own, units={"a_body": "m/s^2", "F_tyre": "N"}).result["channels"] == prediction.result["channels"]
    with pytest.raises(fp.InputError) as refused:
        run.predict(frame.rename(columns={post: "stroke"}), units={"a_body": "m/s^2", "F_tyre": "N"})
    text = str(refused.value)
    assert "recording.csv" not in text
    assert "the frame has the columns a_body [m/s^2], F_tyre [N], stroke [no unit]" in text
    assert "post_NAME of each post" in text


def test_a_choice_is_that_of_the_program(run, tmp_path):
    settings = tmp_path / "settings.yaml"
    settings.write_text(SETTINGS)
    outcome = json.loads(program("choose", run.folder, "--settings", settings, "--json"))
    choice = fp.choose(run, settings, tmp_path / "choice")
    assert choice.result == outcome
    assert choice.best == outcome["best"]["setting"]
    assert json.loads((tmp_path / "choice/result.json").read_text()) == outcome
    assert "Best setting" in choice._repr_html_()


def test_a_folder_without_a_run_is_refused(tmp_path):
    with pytest.raises(fp.InputError):
        fp.read_run(tmp_path)
    with pytest.raises(fp.InputError):
        fp.read_run(tmp_path / "none")


def test_tables_draws_and_folders_that_are_not_there_are_named(run, tmp_path):
    for call, id in ((lambda: run.table("nope"), "name-unknown"), (lambda: run.draws(1), "value-out-of-range"),
                     (lambda: fp.read_run(tmp_path), "result-missing")):
        with pytest.raises(fp.InputError) as raised:
            call()
        assert raised.value.ids == [id]
