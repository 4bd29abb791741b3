"""Modes, state spaces and paths of poles: those of the program, and of the response."""
import csv
import io
import json

import numpy as np
import pytest

import fourpost as fp
from conftest import SOURCE, STARTER, program

LAND_ROVER = SOURCE / "urdf/landrover110_model3.urdf"


@pytest.mark.parametrize("file", [STARTER / "vehicle.urdf", LAND_ROVER])
def test_modes_are_those_of_the_program_to_the_last_bit(file):
    by_program = json.loads(program("modes", file, "--json"))
    modes = fp.load(file).modes()
    assert list(modes.table.index) == [one["name"] for one in by_program["modes"]] and len(modes) > 1
    for i, one in enumerate(by_program["modes"]):
        row = modes.table.iloc[i]
        for key in ("kind", "frequency_Hz", "damped_frequency_Hz", "damping_ratio", "rise_time_s", "settling_time_s"):
            assert row[key] == one[key], key
        assert [[pole.real, pole.imag] for pole in modes.poles[i]] == one["poles_per_s"]
        assert row["pole"] == modes.poles[i][0]
        assert {name: share for name, share in modes.energy.iloc[i].items() if share} == one["kinetic_energy"]
        for b, body in enumerate(one["shape"]):
            assert modes.bodies[b] == body["body"]
            components = body["translation_m"] + body["rotation_rad"]
            assert [[x.real, x.imag] for x in modes.shapes[i, b]] == components
    space = by_program["state_space"]
    for name, key in (("a", "A"), ("b", "B"), ("c", "C"), ("d", "D"), ("d_rate", "D_rate"),
                      ("d_acceleration", "D_acceleration")):
        assert np.array_equal(getattr(modes.state_space, name), space[key]), name


def test_a_state_space_answers_as_the_car_does(car):
    """For motions so small that the laws are linear."""
    frequency = np.array([0.8, 1.3, 4.0, 11.0])
    response = car.response(frequency=frequency, amplitude=1e-5)
    space = car.modes().state_space
    for sensor in ("s_strut", "F_tyre"):
        row = space.sensors.index(sensor)
        for at, hertz in enumerate(frequency):
            s = 2j * np.pi * hertz
            states = np.linalg.solve(s * np.eye(len(space.a)) - space.a, space.b)
            answer = space.c @ states + space.d + s * space.d_rate + s ** 2 * space.d_acceleration
            # The balance is solved to 2e-4.
            assert abs(answer[row, 0] - response[sensor][at]) < 1e-3 * abs(answer[row, 0]), (sensor, hertz)


def test_modes_at_other_values(car):
    stiff = car.modes(k="80 kN/m").table
    assert stiff.loc["heave", "frequency_Hz"] > 1.2 * car.modes().table.loc["heave", "frequency_Hz"]
    shape = car.modes().shape("wheel hop")
    # The wheel leads its own mode.
    assert abs(shape.loc["wheel", "z"]) > abs(shape.loc["body", "z"])
    assert "wheel hop" in car.modes()._repr_html_()


def test_an_unstable_car_is_warned_of(tmp_path):
    """Whose tyre stands 15 m below its axle."""
    text = (SOURCE / "urdf/landrover110_linkage.urdf").read_text()
    tyre = '<fp:tyre name="front_tyre" link="front_axle" xyz="0.870 0 '
    assert f'{tyre}-0.075"' in text
    text = text.replace(f'{tyre}-0.075"', f'{tyre}-15"').replace("../meshes", str(SOURCE / "meshes"))
    (tmp_path / "car.urdf").write_text(text)
    with pytest.warns(fp.InputWarning, match="unstable-in-design-pose") as caught:
        modes = fp.load(tmp_path / "car.urdf").modes()
    assert caught[-1].filename == __file__
    assert [finding.id for finding in modes.warnings] == ["unstable-in-design-pose"]
    assert "diverging" in set(modes.table["kind"]) and "unstable-in-design-pose" in modes._repr_html_()


def test_poles_are_those_of_the_program(car, tmp_path):
    program("modes", STARTER / "vehicle.urdf", "--vary", "k=12kN/m:40kN/m:8", "-o", tmp_path / "out")
    rows = list(csv.DictReader(io.StringIO((tmp_path / "out/poles.csv").read_text())))
    values = sorted({float(row["value"]) for row in rows})
    poles = car.poles("k", values)
    assert list(poles.index) == values and poles.index.name == "k"
    seen = [(row["mode"], float(row["value"]), complex(float(row["real_per_s"]), float(row["imag_per_s"]))) for row in rows]
    own = [(mode, value, pole) for mode, column in poles.items() for value, pole in column.items() if not np.isnan(pole)]
    assert own == seen


@pytest.mark.parametrize("call, id", [
    (lambda car: car.modes(kk=1.0), "name-unknown"), (lambda car: car.modes(k="2 kg"), "setting-unit"),
    (lambda car: car.poles("kk", [1.0]), "name-unknown"), (lambda car: car.poles("k", [np.nan]), "number-not-finite"),
    (lambda car: car.poles("k", [-1.0]), "setting-sign"), (lambda car: car.poles("k", []), "argument-refused"),
    (lambda car: car.poles("k", [[1.0]]), "table-shape"), (lambda car: car.modes().shape("hop"), "name-unknown")])
def test_wrong_calls_are_refused_by_id(car, call, id):
    with pytest.raises(fp.InputError) as raised:
        call(car)
    assert raised.value.ids == [id]
