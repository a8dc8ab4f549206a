"""``run``: one episode, judged and told."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from typing import Any, Unpack

from allworlds.engines import Limits, SingleRun, single_run, subject_of, unused_choice
from allworlds.inputs import InputError, an_integer, show
from allworlds.protocol import ANSWER_TIMEOUT
from allworlds.studies.check import RunOptions, own_rules, refuse_others
from allworlds.world import World, world_named


def run(
    explore: str | Callable[..., Any],
    world: World | str,
    *,
    choices: Sequence[int] = (),
    **options: Unpack[RunOptions],
) -> SingleRun:
    """One episode, judged.

    An explorer that is not ours and that another process can import is played in one of its
    own, as in a check; any other in this process.

    Args:
        explore: a name or a generator function.
        world: map, lighthouse and start; or what :func:`allworlds.world.named.world_named` reads,
            under the explorer's own lighthouse where none is named.
        choices: answers to the first choices, by index; then the policy goes on.
        options: see :class:`~allworlds.studies.check.options.RunOptions` and
            :class:`~allworlds.judging.findings.rules.RulesOptions`.

    Raises:
        InputError: naming the offending option and what would be legal, or the first choice
            that was not taken.
    """
    refuse_others("run", options, RunOptions)
    script = _indices(choices)
    limits = Limits(answer_timeout=options.get("answer_timeout", ANSWER_TIMEOUT))
    subject = subject_of(explore, limits)
    if isinstance(world, str):
        world = world_named(world, subject.lighthouse)
    if not isinstance(world, World):
        raise InputError(f"world = {show(world)} is no World; World.from_json makes one")
    kind = world.lighthouse.kind
    rules = own_rules(subject, options, kind)
    told = single_run(subject, world, rules, script, limits)
    if unused := unused_choice(script, told):
        raise InputError(unused)
    return told


def _indices(choices: object) -> tuple[int, ...]:
    if isinstance(choices, str) or not isinstance(choices, Iterable):
        raise InputError(f"choices = {show(choices)} is not a list of indices")
    return tuple(an_integer(f"choices[{i}]", index) for i, index in enumerate(choices))
