"""`pip install .` in the root of the checkout, with the module as it is built: nothing is compiled."""
import os
import subprocess
import sys

from conftest import SOURCE, STARTER

PYTHON = SOURCE / "python"


def files(folder):
    """What a package consists of beside its compiled module."""
    return {path.name for path in folder.iterdir() if path.suffix in (".py", ".pyi") or path.name == "py.typed"}


def test_pip_installs_a_package_that_loads_a_car(tmp_path):
    before = sorted(PYTHON.rglob("*"))
    outcome = subprocess.run([sys.executable, "-m", "pip", "install", "--no-build-isolation", "--no-deps", "--no-index",
                              "--prefix", tmp_path, SOURCE], capture_output=True, text=True)
    assert outcome.returncode == 0, outcome.stdout + outcome.stderr
    # Debian has it in local/lib/python3.11/dist-packages.
    [site] = {path.parents[1] for path in tmp_path.rglob("fourpost/__init__.py")}
    for package in ("fourpost", "fourpost_batch"):
        assert files(site / package) == files(PYTHON / package)
    assert sorted(PYTHON.rglob("*")) == before
    # Away from the source and its build.
    probe = ("import fourpost, fourpost_batch, sys; assert fourpost.load(sys.argv[1]).posts; "
             "print(fourpost.__version__, fourpost.__file__, fourpost_batch.__file__, fourpost.vehicle._core.__file__)")
    outcome = subprocess.run([sys.executable, "-c", probe, STARTER / "vehicle.urdf"], cwd=tmp_path, text=True,
                             env={**os.environ, "PYTHONPATH": str(site)}, stdout=subprocess.PIPE, check=True)
    version, *places = outcome.stdout.split()
    assert (site / f"fourpost-{version}.dist-info").is_dir()
    assert all(place.startswith(f"{site}/") for place in places), places


def test_a_build_without_the_module_is_refused(tmp_path):
    outcome = subprocess.run([sys.executable, "setup.py", "-q", "build_ext", "--build-lib", tmp_path], cwd=PYTHON,
                             env={**os.environ, "FOURPOST_BUILD": str(tmp_path)}, capture_output=True, text=True)
    assert outcome.returncode == 1
    assert f"there is no {tmp_path}/python/fourpost/_core." in outcome.stderr and "fourpost_python" in outcome.stderr
