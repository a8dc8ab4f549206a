"""The request of 'compare'."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from typing import Annotated, Any

from allworlds.document.struct import Natural, Positive, Some, Text, about
from allworlds.engines.effort import AskedCluster, AskedDirectory
from allworlds.engines.swept_report import AskedRows
from allworlds.engines.units import AskedShard
from allworlds.explorers.asked import ExplorersWords
from allworlds.inputs.checks import InputError, a_text, integer_of, show
from allworlds.inputs.requests import RARE_SCOPE, SCOPE, Named, Option, Taken
from allworlds.maps.classes import ExtentOptions
from allworlds.maps.families import FORMS
from allworlds.studies.check.requests import ManyWorlds
from allworlds.world.named import HOLES
from allworlds.world.selection import WhereOptions


def _families(given: object) -> tuple[str, ...] | None:
    """The names of families, each once."""
    if given is None:
        return None
    names = given.split(",") if isinstance(given, str) else given
    if not isinstance(names, Iterable):
        raise InputError(f"family = {show(given)} is neither a name nor a list of names")
    return tuple(dict.fromkeys(a_text("family", name) for name in names))


class AskedContestWorlds(WhereOptions, ExtentOptions):
    """The worlds in which explorers are compared.

    Without ``to`` these are all worlds of a class, or one of a family.
    """

    family: Annotated[
        Taken[str | Sequence[str] | None, tuple[str, ...] | None],
        Option(
            SCOPE,
            "F[,F...]",
            f"One world of a family: {FORMS}; with --to one or more families that grow: "
            "lattice, torus, strip, dense (without 10% of its edges), cubic, regular:D, random "
            "(twice as many edges as vertices), bouquet, lollipop:D, prism, thick:D, cover, "
            "corridor.",
            told=Annotated[
                Some[Text] | None,
                about("the families; with `to` null one, of which one world; null: a class"),
            ],
        ),
    ] = Taken(_families, None)
    holes: Annotated[str | None, HOLES] = None
    seed: Annotated[
        int | None,
        Option(
            SCOPE,
            "S",
            "The seed for worlds drawn from a family; with --to of the first world of a size, the "
            "others have the next ones [default: 0; with --to 1].",
            parse=integer_of,
            told=Annotated[
                Natural | None,
                about("of the world of a family, or of the first of each size; null: a class"),
            ],
        ),
    ] = None
    to: Annotated[
        int | None,
        Option(
            SCOPE,
            "M",
            "Worlds of the families up to M edges.",
            parse=integer_of,
            told=Annotated[
                Positive | None, about("the most edges of worlds that grow; null: they do not")
            ],
        ),
    ] = None
    worlds: Annotated[
        int | None,
        Option(
            RARE_SCOPE,
            "K",
            "With --to: seeds of each size; isomorphic worlds count once [default: 10].",
            parse=integer_of,
            told=Annotated[
                Positive | None, about("seeds of each size; null: worlds that do not grow")
            ],
        ),
    ] = None
    places: Annotated[
        int | None,
        Option(
            RARE_SCOPE,
            "P",
            "With --to: places of the lighthouse in each world; of more, such as the directions "
            "of a marker, P are drawn by the seed [default: 8].",
            parse=integer_of,
            told=Annotated[
                Positive | None,
                about("at most so many places in a world; null: worlds that do not grow"),
            ],
        ),
    ] = None


class CompareRequest(
    AskedRows, AskedDirectory, AskedCluster, ManyWorlds, AskedShard, AskedContestWorlds
):
    """Explorers, and the worlds in which they are compared."""

    explorers: Annotated[
        Sequence[str | Callable[..., Any]],
        Named(
            ExplorersWords,
            "names, as on the command line, or generator functions; two or more, with ``to`` one "
            "or more.",
        ),
    ] = ()
