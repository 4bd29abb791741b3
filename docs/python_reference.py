"""Prints docs/python_reference.md, from signatures and docstrings:

    PYTHONPATH=build/release/python /usr/bin/python3 docs/python_reference.py > docs/python_reference.md
"""
from __future__ import annotations

import ast
import dataclasses
import inspect
import re
import sys
import textwrap
from typing import Any, Iterator, NamedTuple

import fourpost
import fourpost_batch

INTRODUCTION = """# Reference of the Python module

Every public name with its signature. [python.md](python.md) is a guide, and [batch.md](batch.md) is one of batches.
`docs/python_reference.py` makes this page of the docstrings.

Shapes are S sensors, F frequencies, N samples or residuals, p parameters and n cars or points: an array of S x F numbers
has a row per sensor. Values are SI, angles radians, unless a name says otherwise (`_dB`, `_deg`). Of types:

- `ArrayLike`: what `numpy.asarray` takes: an array, a list, a number.
- `Values`: that, or a `pandas.DataFrame` whose columns are parameters.
- `Floats`, `Complexes`: `numpy.ndarray` of float64 and of complex128.
- `Quantity`: a number in SI, or a text with a unit: `"50 kN/m"`.
- `Path`: `str` or `os.PathLike`.
"""
MODULES = (fourpost, fourpost_batch)
SPECIAL = {"__getitem__": "{owner}[{arguments}]", "__len__": "len({owner})"}


class Item(NamedTuple):
    """A class, a function or a member, and its documentation."""

    owner: str
    """Empty of a class and a function."""
    name: str
    types: dict[str, str]
    """By parameter; "return" of what is returned, and of an attribute."""
    text: str
    shown: str
    """As a caller writes it."""


class _Shown:
    """Prints as a text without quotes."""

    def __init__(self, text: str):
        self.text = text

    def __repr__(self) -> str:
        return self.text


def _plain(annotation: str) -> str:
    """As a reader of the guide knows it."""
    return re.sub(r"\b(npt|pd)\.", "", annotation)


def _arguments(function: Any, is_typed: bool = True) -> str:
    """As `def` has them, without `self`; what a default does stands in the docstring where it is an object."""
    shown = []
    for one in inspect.signature(function).parameters.values():
        if one.name != "self":
            default = _Shown("...") if repr(one.default).startswith("<") and one.default is not one.empty else one.default
            kept = _Shown(_plain(one.annotation)) if is_typed else one.empty
            shown.append(one.replace(default=default, annotation=kept))
    return str(inspect.Signature(shown))[1:-1]


def _function(owner: str, name: str, function: Any, prefix: str = "") -> Item:
    types = {key: _plain(text) for key, text in inspect.get_annotations(function).items()}
    arguments, returned = _arguments(function), types.get("return", "None")
    shown = SPECIAL.get(name, f"{prefix}{name}({arguments})").format(owner=owner.lower(), arguments=arguments)
    return Item(owner, name, types, inspect.getdoc(function) or "", shown + f" -> {returned}" * (returned != "None"))


def _class(name: str, kind: type) -> Item:
    """With the arguments of its constructor, unless only the library calls it."""
    is_record = dataclasses.is_dataclass(kind) or issubclass(kind, tuple)  # whose attributes are the arguments
    init: Any = vars(kind).get("__init__")
    types = {} if is_record or init is None else inspect.get_annotations(init)
    if is_record or (init and not any("_core." in text for text in types.values())):
        name += f"({_arguments(kind, is_typed=not is_record)})"
    bases = [base.__name__ for base in kind.__bases__ if issubclass(base, Exception)]
    return Item("", kind.__name__, types, inspect.cleandoc(vars(kind).get("__doc__") or ""),
                f"class {name}" + (f", derived from {' and '.join(bases)}" if bases else ""))


def _default(value: ast.expr) -> str:
    return "..." if isinstance(value, ast.Call) else ast.unparse(value)


def _attributes(kind: type) -> Iterator[Item]:
    """Annotations in the class with the text after each, and what else __init__ sets."""
    tree = ast.parse(textwrap.dedent(inspect.getsource(kind))).body[0]
    assert isinstance(tree, ast.ClassDef)
    found = {}
    for node, after in zip(tree.body, [*tree.body[1:], ast.Pass()]):
        if isinstance(node, ast.AnnAssign):
            text = after.value.value if isinstance(after, ast.Expr) and isinstance(after.value, ast.Constant) else ""
            default = f" = {_default(node.value)}" if node.value else ""
            found[ast.unparse(node.target)] = (ast.unparse(node.annotation), text, default)
    for part in ast.walk(tree):
        if isinstance(part, ast.Attribute) and isinstance(part.ctx, ast.Store) and ast.unparse(part.value) == "self":
            found.setdefault(part.attr, ("", "", ""))
    for name, (annotation, text, default) in found.items():
        if not name.startswith("_"):
            plain = _plain(annotation)
            yield Item(kind.__name__, name, {"return": plain}, inspect.cleandoc(text), f"{name}: {plain}{default}")


def items(module: Any) -> Iterator[Item]:
    """All public names: functions, then classes with their members."""
    for name in sorted(module.__all__, key=lambda name: inspect.isclass(getattr(module, name))):
        value = getattr(module, name)
        if not inspect.isclass(value):
            yield _function("", name, value)
            continue
        yield _class(name, value)
        yield from _attributes(value)
        for member, what in vars(value).items():
            if isinstance(what, property):
                got = _function(name, member, what.fget)
                yield got._replace(shown=f"{member}: {got.types['return']}")
            elif (not member.startswith("_") or member in SPECIAL) and inspect.isroutine(what):
                yield _function(name, member, getattr(value, member), f"{name}." * isinstance(what, staticmethod))


def paragraphs(item: Item) -> tuple[str, dict[str, str]]:
    """What is said of all, as Markdown, and of each parameter."""
    prose, of_parameters, at = [], {}, None
    for line in inspect.cleandoc(item.text).splitlines() + [""]:
        named = re.match(r"(\w+(?:, \w+)*): (.*)", line)
        if named and set(named[1].split(", ")) <= set(item.types):
            at = named[1]
            of_parameters[at] = named[2]
        elif at and line:
            of_parameters[at] += " " + line.strip()
        else:
            at = None
            prose.append(line)
    return _linked("\n".join(prose).strip()), {name: _linked(said) for name, said in of_parameters.items()}


def _linked(text: str) -> str:
    """Paths are those of the checkout's root."""
    return re.sub(r"\b(\w+/README\.md)", r"[\1](../\1)", re.sub(r"\bdocs/(\w+\.md)", r"[\1](\1)", text))


def page() -> str:
    text = INTRODUCTION
    for module in MODULES:
        text += f"\n## {module.__name__}\n"
        for item in items(module):
            prose, of_parameters = paragraphs(item)
            indent = "  " if item.owner else ""
            text += f"- `{item.shown}`: {' '.join(prose.split())}\n" if item.owner else (
                f"\n### {item.name}\n\n`{item.shown}`\n\n{prose}\n\n")
            text += "".join(f"{indent}- *{name}*: {said}\n" for name, said in of_parameters.items())
    return re.sub("\n{3,}", "\n\n", text)


if __name__ == "__main__":
    sys.stdout.write(page())
