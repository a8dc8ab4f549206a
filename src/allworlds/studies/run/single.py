"""``run``: one episode, judged and told."""

from __future__ import annotations

from allworlds.engines import (
    Limits,
    SingleRun,
    single_run,
    subject_of,
    unused_choice,
)
from allworlds.inputs import InputError, answers, show
from allworlds.studies.run.run_request import RunRequest
from allworlds.world import World, world_named


@answers(RunRequest)
def run(request: RunRequest) -> SingleRun:
    """One episode, judged.

    An explorer that is not ours and that another process can import is played in one of its
    own, as in a check; any other in this process.

    Raises:
        InputError: naming the offending option and what would be legal, or the first choice
            that was not taken.
    """
    limits, world = Limits(answer_timeout=request.answer_timeout), request.world
    subject = subject_of(request.explore, limits)
    if isinstance(world, str):
        world = world_named(world, subject.lighthouse)
    if not isinstance(world, World):
        raise InputError(f"world = {show(world)} is no World; World.from_json makes one")
    rules = request.rules_of(subject, world.lighthouse.kind)
    told = single_run(subject, world, rules, request.choices, limits)
    if unused := unused_choice(request.choices, told):
        raise InputError(unused)
    return told
