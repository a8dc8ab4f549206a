"""The verb ``run`` on the command line."""

from __future__ import annotations

from typing import Annotated

import allworlds
from allworlds.cli.files import Files
from allworlds.cli.options import OutputGroup
from allworlds.cli.output import emit
from allworlds.document import replace
from allworlds.explorers import DEFAULT_EXPLORER, ProgramWords, names_explorer, own_lighthouse
from allworlds.inputs import (
    OUTPUT,
    SCOPE,
    Argument,
    InputError,
    Option,
    Request,
    answer,
    integer_of,
    show,
    values_of,
)
from allworlds.studies.run import AskedRun, RunRequest, WorldNames
from allworlds.world import (
    PREFIX,
    Adversary,
    Directional,
    FamilyWords,
    World,
    adversary_named,
    at_place,
    names_of_worlds,
    world_named,
)


class WordsOfLighthouse(Request):
    """The lighthouse for a world that names none."""

    lighthouse: Annotated[
        str | None,
        Option(
            SCOPE,
            "KIND",
            "The lighthouse for a world that names none [default: the explorer's own].",
        ),
    ] = None


class WordsOfPlace(Request):
    """The place of the lighthouse in a world that does not name it."""

    place: Annotated[
        int | None,
        Option(
            SCOPE,
            "P",
            "The place of the lighthouse, by its number in the rows of --csv [default: its "
            "usual one].",
            parse=integer_of,
        ),
    ] = None


class RunWords(WordsOfPlace, FamilyWords, ProgramWords, WordsOfLighthouse):
    """The explorer and its world, as the command line names them."""

    arguments: Annotated[
        list[str] | None,
        Argument(
            "",
            "[EXPLORER] WORLD",
            "EXPLORER as in check, also shield:EXPLORER (default: algorithm1). WORLD: inline JSON, "
            "@file, a code of --csv, or a name such as k4, wheel:4, cycle:5; "
            "adversary:corridor:F (or FxR) makes a world that is bad for the explorer; left out "
            "with --family.",
            repeated=True,
        ),
    ] = None
    listed: Annotated[
        bool,
        Option(SCOPE, "", "List the names that a WORLD can have, and run no explorer.", "list"),
    ] = False
    without_walk: Annotated[
        bool,
        Option(
            OUTPUT,
            "",
            "Leave out the walk: the steps in the text, and transcript in the JSON.",
            "no-walk",
        ),
    ] = False

    def request(self, asked: AskedRun) -> RunRequest:
        """One run of that explorer in that world.

        Raises:
            InputError: naming the words of which nothing can be made.
        """
        explorer, place = explorer_and_world(
            list(self.arguments or []),
            family=self.family is not None,
            program=self.named(None) is not None,
        )
        name = self.named(explorer) or DEFAULT_EXPLORER
        kind = own_lighthouse(name) if self.lighthouse is None else self.lighthouse
        world: World | Adversary | str = place
        if self.family is not None:
            world = self.world(kind)
        elif self.holes is not None:
            raise InputError(f"holes {self.holes} has no effect without --family")
        elif place.startswith(PREFIX):
            if kind != Directional.kind:
                raise InputError(f"{place} is under the lighthouse directional, not {show(kind)}")
            world = adversary_named(place, self.seed)
        elif self.lighthouse is not None or self.place is not None:
            world = world_named(place, kind)
        if self.place is not None:
            if not isinstance(world, World):
                raise InputError(f"place {self.place} has no effect on {place}")
            world = at_place(world, self.place)
        return RunRequest(name, world, **values_of(AskedRun, asked))


def run(words: RunWords, *, asked: AskedRun, files: Files, output: OutputGroup) -> int:
    """Example: allworlds run algorithm1 theta

    Run an explorer once in one world, tell it step by step, and judge it.
    """
    if words.listed:
        return emit(_listed(), "run", output)
    told = answer(allworlds.run, words.request(asked))
    if words.without_walk:
        told = replace(told, shows_walk=False)
    files.write("run", told)
    return emit(told, "run", output)


def _listed() -> WorldNames:
    names = names_of_worlds()
    return WorldNames(maps=names["maps"], families=names["families"], corpus=names["corpus"])


_WORLDS = "a WORLD is inline JSON, @file, or a name such as k4, wheel:4, theta-torus"


def explorer_and_world(words: list[str], *, family: bool, program: bool) -> tuple[str | None, str]:
    """The EXPLORER and the WORLD among the arguments of ``run``, where they are given.

    With a family there is no WORLD: it is the empty text.
    """
    wanted = 0 if family else 1
    if not wanted <= len(words) <= wanted + (not program):
        given = " ".join(words) or "nothing"
        raise InputError(f"run takes [EXPLORER] and a WORLD or --family, not {show(given)}")
    explorer = words[0] if len(words) > wanted else None
    world = "" if family else words[-1]
    if names_explorer(world):
        if explorer is None:
            raise InputError(f"WORLD is missing: {show(world)} is an explorer; {_WORLDS}")
        if not names_explorer(explorer):
            raise InputError(
                f"{show(world)} is an explorer and stands in the place of WORLD; EXPLORER comes "
                "first, then WORLD"
            )
    return explorer, world
