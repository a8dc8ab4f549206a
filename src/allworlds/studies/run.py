"""``run``: one world, told step by step."""

from __future__ import annotations

import os
import re
from collections.abc import Callable, Iterable, Sequence
from typing import Annotated, Any

from allworlds.document.report import Report
from allworlds.document.struct import Text, about
from allworlds.engines.limits import TimeoutOptions
from allworlds.engines.single import SingleRun, single_run, subject_of, unused_choice
from allworlds.explorers.loading import HASH_SEED
from allworlds.inputs.checks import InputError, an_integer, show
from allworlds.inputs.requests import RULES, Converted, Option, answers
from allworlds.judging.findings.rules import RuleOptions
from allworlds.world.lighthouses.kinds import kind_of
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


class RunOptions(TimeoutOptions, RuleOptions, WorldOptions):
    """Options for one run: the world, how it is played and judged."""

    choices: Annotated[
        Converted[Sequence[int], tuple[int, ...]],
        Option(
            RULES,
            "I,I,...",
            "Answers to the first choices, by index; then the policy goes on.",
            parse=index_list,
        ),
    ] = Converted(_indices, ())


class RunRequest(RunOptions, kw_only=False):
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


@answers(RunRequest)
def run(request: RunRequest) -> SingleRun:
    """Run an explorer once, and judge the run.

    A user's explorer that another process can import is played in a process of its own, as in a
    check; any other one in this process. Its hash seed is the one in the environment variable
    ``PYTHONHASHSEED``, if it is set.

    Raises:
        InputError: naming the offending option and what would be legal, or the first choice
            that was not taken.
    """
    limits = request.patience
    subject = subject_of(request.explore, limits)
    world = request.meant(request.world, subject.lighthouse)
    rules = request.rules_of(subject, kind_of(world.lighthouse))
    played = single_run(subject, world, rules, request.choices, limits, _asked_hash_seed())
    if unused := unused_choice(request.choices, played):
        raise InputError(unused)
    return played


def _asked_hash_seed() -> int | None:
    """The hash seed that the environment names; None if it names none."""
    seed = os.environ.get(HASH_SEED, "")
    return int(seed) if re.fullmatch("[0-9]{1,9}", seed) else None
