"""The verb ``run``."""

from __future__ import annotations

from typing import Annotated

import allworlds
from allworlds.cli.files import PageFile
from allworlds.cli.options import OutputGroup
from allworlds.cli.output import emit
from allworlds.explorers import DEFAULT_EXPLORER, ProgramWords, names_explorer, own_lighthouse
from allworlds.inputs import Argument, InputError, answer, show, values_of
from allworlds.studies.run import AskedRun, RunRequest
from allworlds.world import FamilyWords, World


class RunWords(FamilyWords, ProgramWords):
    """The explorer and its world, as the command line names them."""

    arguments: Annotated[
        list[str] | None,
        Argument(
            "",
            "[EXPLORER] WORLD",
            "WORLD: inline JSON, @file, or a name such as k4, wheel-4, theta-torus; "
            "left out with --family.",
            repeated=True,
        ),
    ] = None

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
        world: World | str = place
        if self.family is not None:
            world = self.world(own_lighthouse(name))
        elif self.holes is not None:
            raise InputError(f"holes {self.holes} has no effect without --family")
        return RunRequest(name, world, **values_of(AskedRun, asked))


def run(words: RunWords, *, asked: AskedRun, page: PageFile, output: OutputGroup) -> int:
    """Example: allworlds run algorithm1 theta

    Run an explorer once in one world, tell it step by step, and judge it.
    """
    page.ensure_writable()
    told = answer(allworlds.run, words.request(asked))
    page.write("run", told)
    return emit(told, "run", output)


_WORLDS = "a WORLD is inline JSON, @file, or a name such as k4, wheel-4, theta-torus"


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
