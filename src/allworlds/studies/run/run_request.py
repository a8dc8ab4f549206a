"""Request of ``run``: an explorer, a world and the rules."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Sequence
from typing import Annotated, Any

from allworlds.document.report import Report
from allworlds.document.struct import Text, about
from allworlds.engines.effort import AskedPatience
from allworlds.inputs.checks import InputError, an_integer, show
from allworlds.inputs.requests import RULES, Option, Taken
from allworlds.judging.findings.rules import AskedRules
from allworlds.world.named import WorldOptions
from allworlds.world.world import World


def index_list(text: str) -> tuple[int, ...]:
    """The indices of a text, integers from 0 on with commas between."""
    if not re.fullmatch(r"[0-9]{1,9}(,[0-9]{1,9})*", text):
        raise InputError(f"choices {show(text)} are not indices from 0 on with commas")
    return tuple(int(part) for part in text.split(","))


def _indices(choices: object) -> tuple[int, ...]:
    if isinstance(choices, str) or not isinstance(choices, Iterable):
        raise InputError(f"choices = {show(choices)} is not a list of indices")
    return tuple(an_integer(f"choices[{i}]", index) for i, index in enumerate(choices))


class AskedRun(AskedPatience, AskedRules, WorldOptions):
    """Options for one run: the world, how it is played and judged."""

    choices: Annotated[
        Taken[Sequence[int], tuple[int, ...]],
        Option(
            RULES,
            "I,I,...",
            "Answers to the first choices, by index; then the policy goes on.",
            parse=index_list,
        ),
    ] = Taken(_indices, ())


class RunRequest(AskedRun, kw_only=False):
    """Request of ``run``: an explorer, a world and the rules."""

    explore: Annotated[str | Callable[..., Any], "a name or a generator function"]
    world: Annotated[
        World | str | None,
        "map, lighthouse and start; or what :func:`allworlds.world.named.world_named` reads; None: "
        "the one of ``family``",
    ] = None


class WorldNames(Report):
    """Report of 'run --list'.

    The names that a WORLD can have; a capital letter stands for a number.
    """

    maps: Annotated[tuple[Text, ...], about("small maps")]
    families: Annotated[tuple[Text, ...], about("families of maps, small or large")]
    corpus: Annotated[tuple[Text, ...], about("worlds of the corpus")]
