"""The package's types, by mypy."""
import os
import subprocess
import sys

from conftest import SOURCE


def test_package_is_strictly_typed(tmp_path):
    (tmp_path / "mypy.ini").write_text("[mypy]\nstrict = True\n[mypy-distributed.*,cloudpickle.*,yaml.*]\n"
                                       "ignore_missing_imports = True\nfollow_imports = skip\n"
                                       "follow_imports_for_stubs = True\n"
                                       "[mypy-fourpost_batch.dask_plant]\ndisallow_subclassing_any = False\n")
    cache = f"--cache-dir={os.environ['FOURPOST_BUILD']}/mypy/batch"
    outcome = subprocess.run([sys.executable, "-m", "mypy", cache, SOURCE / "python/fourpost_batch"],
                             cwd=tmp_path, capture_output=True, text=True)
    assert outcome.returncode == 0, outcome.stdout
