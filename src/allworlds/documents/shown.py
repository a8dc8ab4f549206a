"""Values with a text, a page or a picture, and the writers of these forms.

A writer is a function of ``allworlds.reports``, which this module does not import.  The import of
the package ``allworlds`` registers a function that loads the writers.  The first value that is
shown calls this function.
"""

from collections.abc import Callable
from functools import cache
from typing import Any, NamedTuple


class Writers(NamedTuple):
    """The writer of each form.

    Attributes:
        text: the text of the command line, 100 columns wide.
        short_text: at most 20 lines of this text.
        page: the element that notebooks show.
        picture: the text of an SVG.
        records: the rows for programs, by the names of their columns.
    """

    text: Callable[[Any], str]
    short_text: Callable[[Any], str]
    page: Callable[[Any], str]
    picture: Callable[[Any], str]
    records: Callable[[Any], list[dict[str, Any]]]


_registered = list[Callable[[], Writers]]()


def register(load: Callable[[], Writers]) -> Callable[[], Writers]:
    """Register the function that loads the writers, in place of an earlier function."""
    _registered.append(load)
    return load


@cache
def writers() -> Writers:
    """The registered writers, loaded."""
    return _registered[-1]()


class Pictured:
    """A value that notebooks show as a picture."""

    __slots__ = ()

    def _repr_svg_(self) -> str:
        """The picture that notebooks show."""
        return writers().picture(self)


class Paged:
    """A value that Python prints as a text, and that notebooks show as a page or part of a page."""

    __slots__ = ()

    def __str__(self) -> str:
        """The text of the command line, 100 columns wide."""
        return writers().text(self)

    def __repr__(self) -> str:
        """The text in at most 20 lines, for a plain Python."""
        return writers().short_text(self)

    def __init_subclass__(cls, **keywords: Any) -> None:
        super().__init_subclass__(**keywords)
        # IPython takes the first class in line that has this, or a repr as dataclasses have.
        cls._repr_pretty_ = Paged._repr_pretty_  # type: ignore[method-assign]

    def _repr_pretty_(self, printer: Any, cycle: bool) -> None:  # noqa: ARG002  # IPython's call
        """Print the text in a plain IPython."""
        printer.text(str(self))

    def _repr_html_(self) -> str:
        """The element that notebooks show."""
        return writers().page(self)
