"""What a notebook shows."""
from __future__ import annotations

import html
from typing import Iterable, Sequence

import pandas as pd


def heading(title: str, facts: Iterable[str]) -> str:
    """A title and what is to know at first sight."""
    return f"<p><b>{html.escape(title)}</b><br>{html.escape('; '.join(facts))}</p>"


def frame(rows: pd.DataFrame, digits: int = 4) -> str:
    """A table whose numbers have so many digits; texts are escaped."""
    return str(rows.to_html(float_format=lambda number: f"{number:.{digits}g}", escape=True, na_rep="", border=0))


def findings(lines: Sequence[object]) -> str:
    """A list; nothing for none."""
    return "<ul>" + "".join(f"<li>{html.escape(str(line))}</li>" for line in lines) + "</ul>" if lines else ""
