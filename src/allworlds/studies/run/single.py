"""``run``: one episode, judged and reported."""

from __future__ import annotations

import os
import re

from allworlds.engines.single import SingleRun, single_run, subject_of, unused_choice
from allworlds.explorers.loading import HASH_SEED
from allworlds.inputs.checks import InputError
from allworlds.inputs.requests import answers
from allworlds.studies.run.run_request import RunRequest
from allworlds.world.lighthouses.kinds import kind_of


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
    told = single_run(subject, world, rules, request.choices, limits, asked_hash_seed())
    if unused := unused_choice(request.choices, told):
        raise InputError(unused)
    return told


def asked_hash_seed() -> int | None:
    """The hash seed that the environment names; None if it names none."""
    seed = os.environ.get(HASH_SEED, "")
    return int(seed) if re.fullmatch("[0-9]{1,9}", seed) else None
