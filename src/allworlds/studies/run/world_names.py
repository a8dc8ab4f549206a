"""The legal names of a WORLD, as a result."""

from __future__ import annotations

from typing import Annotated

from allworlds.document import Report, Text, about


class WorldNames(Report):
    """Report of 'run --list'.

    The names that a WORLD can have; a capital letter stands for a number.
    """

    maps: Annotated[tuple[Text, ...], about("small maps")]
    families: Annotated[tuple[Text, ...], about("families of maps, small or large")]
    corpus: Annotated[tuple[Text, ...], about("worlds of the corpus")]
