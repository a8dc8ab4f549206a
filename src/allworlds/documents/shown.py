"""Values with a text, a page or a picture, and the functions that write these forms.

These functions, the *writers*, are in ``allworlds.reports``, which this module does not import.
When the package ``allworlds`` is imported, it registers a function that loads the writers.  This
function is called when the first value is shown.
"""

from collections.abc import Callable
from functools import cache
from typing import Any, NamedTuple


class Writers(NamedTuple):
    """The functions that write a value in each form.

    Attributes:
        text: the function that returns the text of the command line, 100 columns wide.
        short_text: the function that returns at most 20 lines of this text.
        page: the function that returns the HTML element that notebooks show.
        picture: the function that returns the text of an SVG.
        records: the function that returns the rows of a CSV file, each as a dictionary by column.
    """

    text: Callable[[Any], str]
    short_text: Callable[[Any], str]
    page: Callable[[Any], str]
    picture: Callable[[Any], str]
    records: Callable[[Any], list[dict[str, Any]]]


_registered = list[Callable[[], Writers]]()


def register(load: Callable[[], Writers]) -> Callable[[], Writers]:
    """Register ``load``, the function that loads the writers, in place of an earlier function.

    Return ``load``, so that ``register`` can be used as a decorator.
    """
    _registered.append(load)
    return load


@cache
def writers() -> Writers:
    """Return the writers.

    The first call loads the writers: it calls the function that :func:`register` got last.
    """
    return _registered[-1]()


class Pictured:
    """A value that notebooks show as a picture."""

    __slots__ = ()

    def _repr_svg_(self) -> str:
        """The picture that notebooks show."""
        return writers().picture(self)


class Paged:
    """A value that Python prints as a text; notebooks show it as a page, or as part of a page."""

    __slots__ = ()

    def __str__(self) -> str:
        """The text of the command line, 100 columns wide."""
        return writers().text(self)

    def __repr__(self) -> str:
        """The text in at most 20 lines, as Python's prompt shows it."""
        return writers().short_text(self)

    def __init_subclass__(cls, **keywords: Any) -> None:
        super().__init_subclass__(**keywords)
        # IPython takes the first class in line that has this, or a repr as dataclasses have.
        cls._repr_pretty_ = Paged._repr_pretty_  # type: ignore[method-assign]

    def _repr_pretty_(self, printer: Any, cycle: bool) -> None:  # noqa: ARG002  # IPython's call
        """Print the text at IPython's prompt, where no page can be shown.

        IPython calls this method with its printer; ``cycle`` is not used.
        """
        printer.text(str(self))

    def _repr_html_(self) -> str:
        """The element that notebooks show."""
        return writers().page(self)
