"""The verb ``run``."""

from __future__ import annotations

from typing import Annotated

import typer

from allworlds.cli import options as opt
from allworlds.cli.files import PageFile
from allworlds.cli.output import emit
from allworlds.cli.values import index_list
from allworlds.explorers import names_explorer
from allworlds.inputs import InputError, show


def run(
    arguments: Annotated[
        list[str] | None,
        typer.Argument(
            metavar="[EXPLORER] WORLD",
            help="WORLD: inline JSON, @file, or a name such as k4, wheel-4, theta-torus; "
            "left out with --family.",
            show_default=False,
        ),
    ] = None,
    *,
    command: opt.Exec = None,
    native: opt.Native = None,
    drawn: opt.FamilyGroup,
    choices: Annotated[
        str | None,
        opt.option(
            opt.RULES,
            "I,I,...",
            "Answers to the first choices, by index; then the policy goes on.",
        ),
    ] = None,
    rules: opt.RulesGroup,
    page: PageFile,
    output: opt.OutputGroup,
) -> int:
    """Example: allworlds run algorithm1 theta

    Run an explorer once in one world, tell it step by step, and judge it.
    """
    import allworlds
    from allworlds.explorers import own_lighthouse
    from allworlds.world import World, world_of_family

    page.ensure_writable()

    explorer, place = explorer_and_world(
        list(arguments or []),
        family=drawn.family is not None,
        program=any(given is not None for given in (command, native)),
    )
    name = opt.explorer_name(explorer, command, native)
    world: World | str = place
    if drawn.family is not None:
        world = world_of_family(drawn.family, drawn.holes, drawn.seed, own_lighthouse(name))
    elif drawn.holes is not None:
        raise InputError(f"holes {drawn.holes} has no effect without --family")
    told = allworlds.run(name, world, choices=index_list(choices), **rules.options())
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
