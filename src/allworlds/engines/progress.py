"""Listeners to the progress of a long job."""

from __future__ import annotations

import sys
from typing import Any, NamedTuple


class Listener:
    """A listener to the progress of a job; by default each event is ignored."""

    def level(self, edges: int, worlds: int) -> None:
        """Hear that a level begins, with its number of worlds (of a shard: about that many)."""

    def stage(self, name: str, total: int, of: str) -> None:
        """Hear that a part of another kind begins, with the number of its items, named ``of``."""

    def progress(self, count: int) -> None:
        """Hear how many more worlds, or other units of the stage, are done."""

    def notice(self, text: str) -> None:
        """Hear a message to the user."""


class Silent(Listener):
    """The listener that ignores all events."""


NOBODY = Silent()
"""The listener of a report, which is equal to another if all else is."""


class Once(Silent):
    """A listener that hands on notices alone, and each of them once."""

    def __init__(self, listener: Listener) -> None:
        self._listener, self._said = listener, set[str]()

    def notice(self, text: str) -> None:
        """Hear a message to the user."""
        if text not in self._said:
            self._said.add(text)
            self._listener.notice(text)


class InNotebook(Listener):
    """A listener that shows a bar below the cell of a notebook, and notices as lines."""

    def __init__(self) -> None:
        self._bar, self._shown = _Bar("", 0, 0, ""), 0
        self._display: Any = None

    def level(self, edges: int, worlds: int) -> None:
        """Begin the bar of a level."""
        self.stage(f"edges {edges}", worlds, "worlds")

    def stage(self, name: str, total: int, of: str) -> None:
        """Begin a bar."""
        self._bar = _Bar(name, 0, total, of)
        self._show()

    def progress(self, count: int) -> None:
        """Move the bar on, by a hundredth at least, and to its end."""
        bar = self._bar = self._bar._replace(done=self._bar.done + count)
        if 100 * (bar.done - self._shown) >= bar.total or self._shown < bar.total <= bar.done:
            self._show()

    def notice(self, text: str) -> None:
        """Show the message."""
        print(text)  # noqa: T201  # below the cell

    def _show(self) -> None:
        self._shown = self._bar.done
        if self._display is None:
            self._display = sys.modules["IPython"].display.display(self._bar, display_id=True)
        elif self._display:
            self._display.update(self._bar)


class _Bar(NamedTuple):
    """A bar with its numbers."""

    name: str
    done: int
    total: int
    of: str

    def _repr_html_(self) -> str:
        """The bar that notebooks show."""
        bar = f'<progress value="{self.done}" max="{self.total}"></progress>'
        import html  # loaded where a notebook asks

        return f"{bar} {html.escape(repr(self))}"

    def __repr__(self) -> str:
        return f"{self.name}: {self.done:,} of {self.total:,} {self.of}"


def usual_listener() -> Listener:
    """The listener where none is named: a bar in a notebook, else silence."""
    shell = getattr(sys.modules.get("IPython"), "get_ipython", lambda: None)()
    return InNotebook() if hasattr(shell, "kernel") else Silent()
