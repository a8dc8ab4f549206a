"""Request of ``run``: an explorer, a world and the rules."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Sequence
from typing import Annotated, Any

from allworlds.engines import AskedPatience
from allworlds.inputs import RULES, InputError, Option, Taken, an_integer, show
from allworlds.judging import AskedRules
from allworlds.world import PREFIX, Adversary, AskedWorld, World, adversary_named


def index_list(text: str) -> tuple[int, ...]:
    """The indices of a text, integers from 0 on with commas between."""
    if not re.fullmatch(r"[0-9]{1,9}(,[0-9]{1,9})*", text):
        raise InputError(f"choices {show(text)} are not indices from 0 on with commas")
    return tuple(int(part) for part in text.split(","))


def _indices(choices: object) -> tuple[int, ...]:
    if isinstance(choices, str) or not isinstance(choices, Iterable):
        raise InputError(f"choices = {show(choices)} is not a list of indices")
    return tuple(an_integer(f"choices[{i}]", index) for i, index in enumerate(choices))


class AskedRun(AskedPatience, AskedRules, AskedWorld):
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
        World | Adversary | str | None,
        "map, lighthouse and start; or what :func:`allworlds.world.named.world_named` reads; or "
        "``adversary:corridor:F`` (or ``FxR``), which makes a world that is bad for this explorer; "
        "None: the one of ``family``",
    ] = None

    @property
    def adversary(self) -> Adversary | None:
        """The adversary that makes the world, if one does.

        Raises:
            InputError: if there is none of that name, or an option has no effect on one.
        """
        named = isinstance(self.world, str) and self.world.startswith(PREFIX)
        if not (named or isinstance(self.world, Adversary)):
            return None
        self.refuse(("family", "holes", "place"), str(self.world))
        if isinstance(self.world, Adversary):
            self.refuse(["seed"], f"{self.world}, which has one")
            return self.world
        return adversary_named(str(self.world), self.seed or 0)
