"""docs/python_reference.md, and the docstrings that it is made of."""
import inspect
import re
import sys

from conftest import SOURCE

sys.path.insert(0, str(SOURCE / "docs"))
import python_reference  # noqa: E402

ARRAY = re.compile(r"\b(ArrayLike|Floats|Complexes|Values|DataFrame)\b")
SHAPE = re.compile(r"\b[nNSFp]\b|\brow per\b|\bcolumns?\b")
UNIT = re.compile(r"\[[^\]]+\]|\bSI\b|\bHz\b|\bm\b|\bunits?\b|\bpercent\b")


def all_items():
    return [(module.__name__, item) for module in python_reference.MODULES for item in python_reference.items(module)]


def test_the_page_is_that_of_the_docstrings():
    assert (SOURCE / "docs/python_reference.md").read_text() == python_reference.page(), (
        "docs/python_reference.md is old; renew it: "
        "PYTHONPATH=build/release/python /usr/bin/python3 docs/python_reference.py > docs/python_reference.md")


def test_every_public_name_is_explained():
    items = all_items()
    for module in python_reference.MODULES:
        assert set(module.__all__) == {item.name for name, item in items if name == module.__name__ and not item.owner}
        # What a user sees in the module beside its files.
        assert set(module.__all__) == {name for name, value in vars(module).items()
                                       if not name.startswith("_") and not inspect.ismodule(value)}
    assert {(item.owner, item.name) for _, item in items} >= {
        ("", "load"), ("Run", "draws"), ("Run", "cost"), ("Response", "frf"), ("Response", "sensors"),
        ("Response", "__getitem__"), ("Study", "name"), ("Store", "make")}
    assert [f"{name}: {item.shown}" for name, item in items if not item.text] == []


def test_arrays_have_shapes_and_units():
    missing, count = [], 0
    for _, item in all_items():
        prose, of_parameters = python_reference.paragraphs(item)
        by_name = {name: said for names, said in of_parameters.items() for name in names.split(", ")}
        for name, annotation in item.types.items():
            if ARRAY.search(annotation):
                count += 1
                said = item.text if name == "return" else by_name.get(name, "")
                # [N] is a unit, N a shape.
                if not SHAPE.search(re.sub(r"\[.*?\]", "", said)) or not UNIT.search(said):
                    missing.append(f"{item.owner}.{item.name}, {name}: {said!r}")
    assert missing == [] and count > 40
