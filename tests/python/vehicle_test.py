"""Vehicles: names, values, faults, what a notebook shows."""
import re

import pytest

import fourpost as fp
from conftest import SOURCE, STARTER


def test_parameters_are_a_frame_with_units(car):
    assert list(car.parameters.columns) == ["value", "lower", "upper", "unit"]
    row = car.parameters.loc["k"]
    assert (row["value"], row["lower"], row["upper"], row["unit"]) == (20e3, 10e3, 50e3, "N/m")
    assert car["k"] == 20e3
    assert car.sensors["s_strut"] == "m"


def test_values_are_numbers_in_si_or_texts_with_units(car):
    assert car.at(k=25e3)["k"] == 25e3
    assert car.at({"k": "25 kN/m"}, kt="210 kN/m")["kt"] == 210e3
    assert car["k"] == 20e3, "at() gives another vehicle"
    # A number of which no short text in kN/m is the double.
    assert car.at(k=25e3 / 3)["k"] == 25e3 / 3
    assert "25 kN/m" in car.at(k=25e3).text()


@pytest.mark.parametrize("values, id", [({"kk": 1.0}, "name-unknown"), ({"k": "25 kg"}, "setting-unit"),
                                        ({"k": "25"}, "setting-unit"), ({"k": -1.0}, "setting-sign"),
                                        ({"k": float("nan")}, "number-not-finite")])
def test_wrong_values_are_refused_by_id(car, values, id):
    with pytest.raises(fp.InputError) as raised:
        car.at(values)
    assert raised.value.ids == [id]


def test_faults_of_a_file_are_all_there_with_their_lines(tmp_path):
    file = tmp_path / "car.urdf"
    file.write_text("<robot name='car'>\n<link/>\n<link/>\n</robot>\n")
    with pytest.raises(fp.InputError) as raised:
        fp.load(file)
    findings = raised.value.findings
    assert {finding.line for finding in findings} >= {2, 3}
    assert {finding.file for finding in findings} == {str(file)}
    assert all(finding.id in str(raised.value) for finding in findings)
    assert isinstance(raised.value, ValueError)


def test_warnings_of_a_file_are_those_of_python(tmp_path):
    file = tmp_path / "car.urdf"
    # A tag of someone else.
    text = (STARTER / "vehicle.urdf").read_text().replace("<robot ", '<robot xmlns:other="urn:other" ')
    file.write_text(text.replace("</robot>", "<other:tag/>\n</robot>"))
    with pytest.warns(fp.InputWarning) as caught:
        fp.load(file)
    assert caught[0].message.finding.id == "foreign-prefix" and caught[0].message.finding.line > 0


def test_check_is_that_of_the_program(car):
    assert car.check() == []
    odd = car.at(k="49 kN/m", m_body="200 kg").check()
    assert all(isinstance(finding, fp.Finding) for finding in odd)


def test_notebooks_see_names_and_numbers_escaped(tmp_path):
    file = tmp_path / "car.urdf"
    text = (STARTER / "vehicle.urdf").read_text()
    file.write_text(text.replace('<robot name="quarter_car"', '<robot name="a&lt;b&gt;"'))
    page = fp.load(file)._repr_html_()
    assert "a&lt;b&gt;" in page and "<b>" in page and "a<b>" not in page
    assert re.search(r"<th>k</th>\s*<td>2e\+04</td>", page)


def test_ids_raised_in_python_are_those_of_the_program():
    known = (SOURCE / "docs/findings.md").read_text()
    for file in (SOURCE / "python/fourpost").glob("*.py"):
        for id in re.findall(r'refuse\(\s*"([a-z-]+)"', file.read_text()):
            assert f"`{id}`" in known, f"{file.name}: {id}"
