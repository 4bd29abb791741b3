"""The package's types and its stubs, by mypy."""
import os
import pathlib
import subprocess
import sys

import fourpost
from conftest import SOURCE

PACKAGE = SOURCE / "python/fourpost"


def mypy(*words, folder):
    # The links of the build point to the same files.
    environment = {**os.environ, "MYPYPATH": str(SOURCE / "python")}
    outcome = subprocess.run([sys.executable, "-m", *words], cwd=folder, env=environment, capture_output=True, text=True)
    assert outcome.returncode == 0, outcome.stdout + outcome.stderr


def settings(folder):
    # Debian's pandas and xarray have no types.
    file = folder / "mypy.ini"
    file.write_text("[mypy]\nstrict = True\n[mypy-pandas.*,xarray.*]\nignore_missing_imports = True\n")
    return f"--config-file={file}"


def test_the_package_is_strictly_typed(tmp_path):
    mypy("mypy", settings(tmp_path), "--no-incremental", PACKAGE, folder=tmp_path)


def test_a_caller_is_checked(tmp_path):
    script = tmp_path / "caller.py"
    script.write_text("import fourpost as fp\n"
                      "run = fp.fit('study.yaml', threads=2, progress=print)\n"
                      "reveal_type(run.vehicle.response('roll', k='50 kN/m')['a'])\n"
                      "x: float = run.cost\n")
    mypy("mypy", settings(tmp_path), "--no-incremental", script, folder=tmp_path)
    script.write_text("import fourpost as fp\nfp.fit('study.yaml', threads='two')\n")
    try:
        mypy("mypy", settings(tmp_path), "--no-incremental", script, folder=tmp_path)
    except AssertionError as wrong:
        assert "arg-type" in str(wrong)
    else:
        raise AssertionError("a text was taken for a number of threads")


def test_the_stubs_name_what_the_module_has():
    import re
    from fourpost import _core
    text = (PACKAGE / "_core.pyi").read_text()
    classes = re.split(r"^class (\w+):", text, flags=re.M)
    functions = set(re.findall(r"^def (\w+)\(", text, re.M))
    assert functions | set(classes[1::2]) == {name for name in dir(_core) if not name.startswith("_")}
    for name, body in zip(classes[1::2], classes[2::2]):
        members = set(re.findall(r"^    (?:def (\w+)\(|(\w+):)", body, re.M))
        stubbed = {a or b for a, b in members} - {"__init__"}
        assert stubbed == {member for member in dir(getattr(_core, name)) if not member.startswith("_")}, name
