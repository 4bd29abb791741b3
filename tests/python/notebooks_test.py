"""The notebooks run from the first cell to the last, and are committed without outputs."""
import nbclient
import nbformat
import pytest

from conftest import SOURCE

NOTEBOOKS = sorted((SOURCE / "python/notebooks").glob("*.ipynb"))


@pytest.mark.parametrize("file", NOTEBOOKS, ids=lambda file: file.stem)
def test_it_runs(file):
    book = nbformat.read(file, as_version=4)
    assert all(not cell.get("outputs") and not cell.get("execution_count") for cell in book.cells)
    beside = {"metadata": {"path": file.parent}}
    nbclient.NotebookClient(book, timeout=600, kernel_name="python3", resources=beside).execute()


def test_they_are_found():
    assert len(NOTEBOOKS) >= 3
