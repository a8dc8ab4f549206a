"""Request of ``compare``: explorers, worlds, rules and effort."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Annotated, Any, Literal, TypeAlias

from allworlds.engines import AskedCluster, AskedDirectory, AskedShard
from allworlds.explorers import ExplorersWords
from allworlds.inputs import OUTPUT, SCOPE, InputError, Named, Option, Taken, integer_of, show
from allworlds.maps import FORMS, AskedExtent
from allworlds.studies.check import ManyWorlds
from allworlds.world import HOLES, AskedWhere

By: TypeAlias = Literal["world", "run"]
"""Rows for programs: one for each world, or each run, and explorer."""


def _by(given: str | None) -> By | None:
    if given in (None, "world", "run"):
        return given  # type: ignore[return-value]  # one of the three
    raise InputError(f"by {show(given)} is not one of world, run")


class CompareRequest(AskedDirectory, AskedCluster, ManyWorlds, AskedShard, AskedWhere, AskedExtent):
    """Explorers, and the worlds in which they are compared.

    Without ``to`` these are all worlds of a class, or one of a family.
    """

    explorers: Annotated[
        Sequence[str | Callable[..., Any]],
        Named(
            ExplorersWords,
            "names, as on the command line, or generator functions; two or more, with ``to`` one "
            "or more.",
        ),
    ] = ()
    family: Annotated[
        str | Sequence[str] | None,
        Option(
            SCOPE,
            "F[,F...]",
            f"One world of a family: {FORMS}; with --to one or more families that grow: "
            "lattice, torus, strip, dense (without 10% of its edges), cubic, regular:D, random "
            "(twice as many edges as vertices), bouquet, lollipop:D, prism, thick:D, cover, "
            "corridor.",
        ),
    ] = None
    holes: Annotated[str | None, HOLES] = None
    seed: Annotated[
        int | None,
        Option(
            SCOPE,
            "S",
            "The seed for worlds drawn from a family; with --to of the first world of a size, the "
            "others have the next ones [default: 0; with --to 1].",
            parse=integer_of,
        ),
    ] = None
    to: Annotated[
        int | None,
        Option(SCOPE, "M", "Worlds of the families up to M edges.", parse=integer_of),
    ] = None
    worlds: Annotated[
        int | None,
        Option(
            SCOPE,
            "K",
            "With --to: seeds of each size; isomorphic worlds count once [default: 10].",
            parse=integer_of,
        ),
    ] = None
    places: Annotated[
        int | None,
        Option(
            SCOPE,
            "P",
            "With --to: places of the lighthouse in each world; of more, such as the directions "
            "of a marker, P are drawn by the seed [default: 8].",
            parse=integer_of,
        ),
    ] = None
    by: Annotated[
        Taken[str | None, By | None],
        Option(
            OUTPUT,
            "world|run",
            "Rows of --csv: one for each world, or each run, and explorer [default: by size; with "
            "--to by run].",
            apart=True,
        ),
    ] = Taken(_by, None)
