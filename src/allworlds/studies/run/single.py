"""``run``: one episode, judged and reported."""

from __future__ import annotations

import os
import re

from allworlds.engines import (
    SingleRun,
    adversarial_run,
    single_run,
    subject_of,
    unused_choice,
)
from allworlds.explorers import HASH_SEED, Subject
from allworlds.inputs import InputError, answers
from allworlds.studies.run.run_request import RunRequest
from allworlds.world import Adversary, Directional, kind_of


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
    adversary = request.adversary
    if adversary is not None:
        return _against(request, subject, adversary)
    world = request.meant(request.world, subject.lighthouse)
    rules = request.rules_of(subject, kind_of(world.lighthouse))
    told = single_run(subject, world, rules, request.choices, limits, asked_hash_seed())
    if unused := unused_choice(request.choices, told):
        raise InputError(unused)
    return told


def _against(request: RunRequest, subject: Subject, adversary: Adversary) -> SingleRun:
    """The run in the world that the adversary makes."""
    kind = request.lighthouse or subject.lighthouse
    if str(kind) != Directional.kind:
        who = subject.name if request.lighthouse is None else "what is asked for"
        raise InputError(f"{adversary} is under the lighthouse directional; {who} needs {kind}")
    rules = request.rules_of(subject, kind_of(Directional(0)))
    told = adversarial_run(
        subject, adversary, rules, request.choices, request.patience, asked_hash_seed()
    )
    if unused := unused_choice(request.choices, told):
        raise InputError(unused)
    return told


def asked_hash_seed() -> int | None:
    """The hash seed that the environment names; None if it names none."""
    seed = os.environ.get(HASH_SEED, "")
    return int(seed) if re.fullmatch("[0-9]{1,9}", seed) else None
