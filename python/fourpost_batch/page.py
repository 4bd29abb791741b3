"""progress.html of a batch: how far it is, for a browser, wherever units run. It loads itself again while they do."""
from __future__ import annotations

import html
import time

from .run import Tally
from .store import Store, write_whole

STYLE = ("body{font:16px system-ui,sans-serif;max-width:44em;margin:2em auto;padding:0 1em;color-scheme:light dark}"
         "progress{width:100%;height:1.5em}td{padding:.2em 1.5em .2em 0}li{margin:.4em 0}")


class ProgressPage:
    def __init__(self, store: Store, total: int, where: str, link: str = ""):
        self.store, self.total, self.where, self.link = store, total, where, link
        self._begin, self._last = time.monotonic(), 0.0

    def __call__(self, tally: Tally, left: int) -> None:
        if time.monotonic() - self._last > 2:
            self.write(tally, left)

    def write(self, tally: Tally, left: int, is_over: bool = False) -> None:
        self._last = time.monotonic()
        try:
            write_whole(self.store.folder / "progress.html", self._text(tally, left, is_over).encode())
        except OSError:
            # Results matter more; they will say that the disk is full.
            pass

    def _text(self, tally: Tally, left: int, is_over: bool) -> str:
        seconds = max(time.monotonic() - self._begin, 1e-9)
        rate = tally.paid / seconds
        rows = [("units", self.total), ("there before", tally.found), ("computed now", tally.paid), ("to come", left),
                ("tried again", tally.tried_again), ("given up", len(tally.lost)), ("a second", f"{rate:.3g}"),
                ("seconds so far", f"{seconds:.0f}")]
        if rate > 0 and not is_over:
            rows.append(("seconds to come, about", f"{left / rate:.0f}"))
        cells = "".join(f"<tr><td>{name}</td><td>{value}</td></tr>" for name, value in rows)
        warnings = "".join(f"<li>{html.escape(str(finding))}</li>" for finding in tally.warnings[-50:])
        link = f'<p><a href="{html.escape(self.link)}">Dashboard of the scheduler</a></p>' if self.link else ""
        refresh = "" if is_over else '<meta http-equiv="refresh" content="3">'
        done = tally.found + tally.paid
        return (f'<!DOCTYPE html><html lang="en"><head><meta charset="utf-8">{refresh}<title>{done} of {self.total} '
                f"units</title><style>{STYLE}</style></head><body><h1>{html.escape(self.store.folder.name)}</h1>"
                f"<p>{'Ended' if is_over else 'Running'} on {html.escape(self.where)}</p>"
                f'<progress max="{max(self.total, 1)}" value="{done}"></progress><table>{cells}</table>{link}'
                f"<ul>{warnings}</ul></body></html>\n")
