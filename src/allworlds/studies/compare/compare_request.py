"""What ``compare`` is asked for, as a value."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Annotated, Any

from allworlds.explorers import ExplorersWords
from allworlds.inputs import SCOPE, Named, Option, integer_of
from allworlds.maps import FORMS, AskedExtent
from allworlds.studies.check import ManyWorlds
from allworlds.world import HOLES


class CompareRequest(ManyWorlds, AskedExtent):
    """Explorers, and the worlds in which they are compared.

    Without ``to`` these are all worlds of a class, or one of a family.
    """

    explorers: Annotated[
        Sequence[str | Callable[..., Any]], Named(ExplorersWords, "names or generator functions")
    ] = ()
    family: Annotated[
        str | Sequence[str] | None,
        Option(
            SCOPE,
            "F[,F...]",
            f"One world of a family: {FORMS}; with --to one or more families that grow: "
            "lattice, torus, strip, dense (without 10% of its edges), cubic, regular:D, random "
            "(twice as many edges as vertices), bouquet, lollipop:D, prism, thick:D, cover.",
        ),
    ] = None
    holes: Annotated[str | None, HOLES] = None
    seed: Annotated[
        int | None,
        Option(
            SCOPE,
            "S",
            "For whatever is drawn of a family; with --to of the first world of a size, the others "
            "have the next [default: 0; with --to 1].",
            parse=integer_of,
        ),
    ] = None
    to: Annotated[
        int | None,
        Option(SCOPE, "M", "Worlds of the families up to M edges.", parse=integer_of),
    ] = None
    worlds: Annotated[
        int | None,
        Option(SCOPE, "K", "With --to: worlds of each size [default: 3].", parse=integer_of),
    ] = None
