"""What recordings hold, and frequency responses of time histories: those of the program, of files and of frames."""
import json

import numpy as np
import pandas as pd
import pytest

import fourpost as fp
from conftest import SOURCE, STARTER, program

SWEEP = SOURCE / "studies/landrover110/bounce_sweep.csv"
POSTS = {post: f"z_post_{post}" for post in ("FL", "FR", "RL", "RR")}


def recorded(file):
    """Its columns by name, over time, and their units."""
    table = pd.read_csv(file, header=[0, 1])
    units = {name: unit for name, unit in table.columns}
    frame = table.droplevel(1, axis=1)
    return frame.set_index(frame.columns[0]).rename_axis("time"), units


@pytest.mark.parametrize("file", [STARTER / "stepped_sine.csv", STARTER / "study.yaml", SWEEP])
def test_what_a_file_holds_is_what_the_program_says(file):
    info = fp.info(file)
    assert info.result == json.loads(program("info", file, "--json"))["files"][0]
    assert f"{file}: {info}" == program("info", file)
    assert info.kind in ("stepped_sine", "study", "time_history")
    assert "<table" in info._repr_html_()


def test_channels_of_a_recording_are_a_frame():
    channels = fp.info(SWEEP).channels.set_index("name")
    frame, _ = recorded(SWEEP)
    assert channels.loc["z_post_FL", "unit"] == "m"
    assert channels.loc["z_post_FL", "maximum"] == frame["z_post_FL"].max()


def test_a_frame_is_described_as_its_file():
    frame, units = recorded(SWEEP)
    # Texts of numbers read back to the same doubles.
    by_frame, by_file = fp.info(frame, units=units), fp.info(SWEEP)
    assert by_frame.result["file"] == "the frame" and "recording.csv" not in str(by_frame)
    pd.testing.assert_frame_equal(by_frame.channels, by_file.channels)


def test_a_rig_that_contradicts_itself_is_warned_of(tmp_path):
    """A sign of a channel turned: the audit names it."""
    for name in ("bounce_frf.csv", "pitch_frf.csv", "bounce_sweep.csv", "static.csv"):
        (tmp_path / name).symlink_to(SOURCE / "studies/landrover110" / name)
    text = (SOURCE / "studies/landrover110/model2.yaml").read_text()
    text = text.replace("../../urdf", str(SOURCE / "urdf"))
    study = tmp_path / "study.yaml"
    study.write_text(text.replace("  a_tow_point: a_tow_point", "  a_tow_point: {channel: a_tow_point, sign: -1}", 1))
    assert study.read_text() != text
    with pytest.warns(fp.InputWarning) as caught:
        info = fp.info(study)
    assert any("a_tow_point" in str(one.message) for one in caught) and info.warnings
    assert {"name", "left_over", "expected"} <= set(info.channels.columns)


def test_responses_of_a_recording_are_those_of_the_program(tmp_path):
    options = [word for post, channel in POSTS.items() for word in ("--post", f"{channel}={post}")]
    text = program("frf", SWEEP, *options, "--frequencies", "1Hz:20Hz:12", "-o", tmp_path / "by_program", "--json")
    frequency = json.loads(text)["responses"][0]["frequency_Hz"]
    found = fp.frf(SWEEP, posts=POSTS, frequency=frequency, output=tmp_path / "by_module")
    assert found.result == json.loads(text) and found.kind == "sweep"
    for file in (tmp_path / "by_program").iterdir():
        assert (tmp_path / "by_module" / file.name).read_bytes() == file.read_bytes(), file.name
    heave = found["heave"]
    assert heave.posts == "heave" and heave.frf.shape == heave.gain_sd.shape == (len(heave.channels), 12)
    for one in found.result["responses"][0]["channels"]:
        assert [abs(complex(value)) for value in heave[one["name"]]] == one["gain"]
        assert np.array_equal(heave.gain_sd[heave.channels.index(one["name"])], one["gain_sd"])
    assert str(found) in program("frf", SWEEP, *options, "--frequencies", "1Hz:20Hz:12")
    assert "heave" in found._repr_html_()
    assert len(heave.to_frame()) == heave.frf.size
    assert np.isnan(heave.mean).all() and np.isfinite(heave.coherence).all()


def dwells(car, frequencies, rate=400.0):
    """The readings of a car over a stepped sine, after two seconds of rest."""
    pieces = [np.zeros(int(2 * rate))]
    for hertz in frequencies:
        t = np.arange(int(10 * rate / hertz + 4 * rate)) / rate
        pieces.append(0.008 * np.sin(2 * np.pi * hertz * t))
    height = np.concatenate(pieces)
    time = pd.Index(np.arange(len(height)) / rate, name="time")
    posts = pd.DataFrame({car.posts[0]: height}, index=time)
    return posts, car.simulate(posts, engine="reduced").frame


def test_recordings_become_experiments_of_a_study(car):
    """Time histories of a car, as a rig records them, give back the car: by responses that were made of them."""
    truth = {"k": 26e3, "c_bump": 1800.0}
    frequencies = [1.0, 1.5, 2.5, 4.0, 8.0, 12.0]
    posts, readings = dwells(car.at(truth), frequencies)
    frame = readings[["a_body", "s_strut", "F_tyre"]].rename(columns={"s_strut": "pot 1"})
    frame[f"post_{car.posts[0]}"] = posts
    units = {"a_body": "m/s^2", "pot 1": "m", "F_tyre": "N", f"post_{car.posts[0]}": "m"}
    found = fp.frf(frame, units=units)
    assert found.kind == "stepped"
    one = next(iter(found.patterns.values()))
    # Dwells are found to a thousandth of their frequency.
    assert np.allclose(one.frequency, frequencies, rtol=1e-3)
    sine = one.sine({"a_body": "a_body", "s_strut": "pot 1", "F_tyre": "F_tyre"})
    run = fp.fit(fp.Study(car, [sine], free=list(truth), evaluations=40, starts=1), accept_implausible=True)
    # The bench's 0.01 of a response: what dwells that ran in leave.
    for name, value in truth.items():
        assert run.parameters.loc[name, "value"] == pytest.approx(value, rel=0.02), name
    # Such a run predicts time histories, too, whose posts go by their names.
    again = readings[["a_body", "s_strut", "F_tyre"]].assign(**{car.posts[0]: posts.iloc[:, 0]})
    channels = run.predict(again, units=car.sensors).channels
    # The same share, 0.02, of a parameter; its square.
    assert (channels["nmse_percent"] < 100 * 0.02 ** 2).all()
    with pytest.raises(fp.InputError) as raised:
        one.sine(["pot 7"])
    assert raised.value.ids == ["name-unknown"]


@pytest.mark.parametrize("call, id", [
    (lambda: fp.info(STARTER / "vehicle.urdf"), "vehicle-for-recording"),
    (lambda: fp.info(STARTER / "none.csv"), "file-not-there"),
    (lambda: fp.frf([]), "argument-refused"),
    (lambda: fp.frf(SWEEP, posts=POSTS, kind="steped"), "name-unknown"),
    (lambda: fp.frf(SWEEP, posts=POSTS, frequency=[3, 2]), "argument-refused"),
    (lambda: fp.frf(SWEEP, posts=POSTS, frequency=[1, np.nan]), "number-not-finite"),
    (lambda: fp.frf(SWEEP, posts=POSTS, low_pass=(0, 100.0)), "argument-refused"),
    (lambda: fp.frf(SWEEP, posts={**POSTS, "RR": "z_post_rr"}), "response-post-missing"),
    (lambda: fp.frf(SWEEP, posts=POSTS, beside={"other.csv": "3 mm"}), "quantity-unreadable")])
def test_wrong_recordings_are_refused_by_id(call, id):
    with pytest.raises(fp.InputError) as raised:
        call()
    assert id in raised.value.ids


def test_faults_of_a_frame_are_of_the_frame():
    frame, units = recorded(SWEEP)
    with pytest.raises(fp.InputError) as raised:
        fp.frf(frame.iloc[:400].drop(columns=list(POSTS.values())), units=units)
    assert "recording.csv" not in str(raised.value) and "the frame has the columns" in str(raised.value)
    assert {finding.file for finding in raised.value.findings} == {"the frame"}


def test_a_standard_deviation_may_be_one_per_frequency(car):
    frequency = [1, 2, 4]
    response = car.response(frequency=frequency, amplitude=0.01)
    shifted = 1.02 * response["a_body"]

    def cost(sd):
        sine = fp.SteppedSine(frequency, 0.01, {"a_body": fp.Measured(shifted, sd)})
        return fp.Study(car, [sine], free=["k"], model_error=fp.ModelError(1e-9, 1e-9, 1e-9)).objective().cost([car["k"]])
    assert cost([0.02] * 3) == cost(0.02)
    # Residuals are 1 at each frequency, then 2 at one; the loss of large ones is not theirs.
    assert cost([0.02, 0.02, 0.04]) < cost(0.02)
    with pytest.raises(fp.InputError) as raised:
        cost([0.01, 0.01])
    assert raised.value.ids == ["arrays-unequal"]
