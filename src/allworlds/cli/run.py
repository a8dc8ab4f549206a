"""The verb ``run`` on the command line."""

from typing import Annotated

import allworlds
from allworlds.cli.output import OutputGroup, emit
from allworlds.document import replace
from allworlds.explorers.sources import ProgramWords, names_explorer
from allworlds.inputs.checks import InputError, show
from allworlds.inputs.requests import OUTPUT, SCOPE, Argument, Option, answer, values_of
from allworlds.studies.run import RunOptions, RunRequest, WorldNames
from allworlds.world.named import names_of_worlds


class RunWords(ProgramWords):
    """The explorer and its world, as the command line names them."""

    arguments: Annotated[
        list[str] | None,
        Argument(
            "",
            "[EXPLORER] WORLD",
            "EXPLORER as in check, also shield:EXPLORER (default: algorithm1). WORLD: inline JSON, "
            "@file, a code of -o FILE.csv, or a name such as k4, wheel:4, cycle:5; left out with "
            "--family.",
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

    def request(self, asked: RunOptions) -> RunRequest:
        """One run of that explorer in that world.

        Raises:
            InputError: naming the words of which nothing can be made.
        """
        explorer, world = explorer_and_world(
            list(self.arguments or []),
            family=asked.family is not None,
            program=self.named(None) is not None,
        )
        return RunRequest(self.named_or_default(explorer), world, **values_of(RunOptions, asked))


def run(words: RunWords, *, asked: RunOptions, output: OutputGroup) -> int:
    """Example: allworlds run algorithm1 theta

    Run an explorer once in one world, tell it step by step, and judge it.
    """
    told = _listed() if words.listed else answer(allworlds.run, words.request(asked))
    if words.without_walk and not isinstance(told, WorldNames):
        told = replace(told, shows_walk=False)
    return emit(told, output)


def _listed() -> WorldNames:
    names = names_of_worlds()
    return WorldNames(maps=names["maps"], families=names["families"], corpus=names["corpus"])


_WORLDS = "a WORLD is inline JSON, @file, or a name such as k4, wheel:4, theta-torus"


def explorer_and_world(
    words: list[str], *, family: bool, program: bool
) -> tuple[str | None, str | None]:
    """The EXPLORER and the WORLD among the arguments of ``run``, where they are given.

    With a family there is no WORLD.
    """
    wanted = 0 if family else 1
    if not wanted <= len(words) <= wanted + (not program):
        given = f"not {show(' '.join(words))}" if words else "and nothing is given"
        raise InputError(f"run takes [EXPLORER] and a WORLD or --family, {given}")
    explorer = words[0] if len(words) > wanted else None
    world = None if family else words[-1]
    if world is not None and names_explorer(world):
        if explorer is None:
            raise InputError(f"WORLD is missing: {show(world)} is an explorer; {_WORLDS}")
        if not names_explorer(explorer):
            raise InputError(
                f"{show(world)} is an explorer and stands in the place of WORLD; EXPLORER comes "
                "first, then WORLD"
            )
    return explorer, world
