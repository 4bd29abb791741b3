"""The package's types and its stubs, by mypy."""
import os
import re
import subprocess
import sys

from conftest import SOURCE
from fourpost import _core

PACKAGE = SOURCE / "python/fourpost"


def test_package_and_callers_are_strictly_typed(tmp_path):
    # Debian's pandas and xarray have no types.
    (tmp_path / "mypy.ini").write_text(
        "[mypy]\nstrict = True\n[mypy-pandas.*,xarray.*]\nignore_missing_imports = True\n")
    (tmp_path / "caller.py").write_text(
        "import fourpost as fp\n"
        "run = fp.fit('study.yaml', threads=2, progress=print)\n"
        "gain = abs(run.vehicle.response('roll', k='50 kN/m')['a'])\n"
        "x: float = run.cost\n"
        "fp.fit('study.yaml', threads='two')\n")
    # The links of the build point to the same files.
    environment = {**os.environ, "MYPYPATH": str(SOURCE / "python")}
    # What mypy knows of numpy stays in the build, which saves nine tenths of its time.
    cache = f"--cache-dir={os.environ['FOURPOST_BUILD']}/mypy/python"
    outcome = subprocess.run([sys.executable, "-m", "mypy", cache, PACKAGE, "caller.py"], cwd=tmp_path,
                             env=environment, capture_output=True, text=True)
    # A text is no number of threads; nothing else is wrong.
    lines = outcome.stdout.splitlines()
    assert len(lines) == 2 and lines[0].startswith("caller.py:5") and "[arg-type]" in lines[0], outcome.stdout


def test_the_stubs_name_what_the_module_has():
    text = (PACKAGE / "_core.pyi").read_text()
    classes = re.split(r"^class (\w+):", text, flags=re.M)
    functions = set(re.findall(r"^def (\w+)\(", text, re.M))
    assert functions | set(classes[1::2]) == {name for name in dir(_core) if not name.startswith("_")}
    for name, body in zip(classes[1::2], classes[2::2]):
        members = set(re.findall(r"^    (?:def (\w+)\(|(\w+):)", body, re.M))
        stubbed = {a or b for a, b in members} - {"__init__"}
        assert stubbed == {member for member in dir(getattr(_core, name)) if not member.startswith("_")}, name
