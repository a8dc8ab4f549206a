"""What an explorer and the harness say to each other: small frozen values, nothing else.

An explorer is a **generator function** ``explore(first)``.  It gets percepts, yields actions
and returns an answer; it never holds a world.  Turning is free and has no action of its own:
it is folded into the next :class:`Move`, or into ``here`` of the answer.

``percept``, ``actions``, ``answers``, ``transcript``
    what is sensed, what is done, what is said of the world, and the log of it;
``choices``
    where an explorer is free: policies, and every answer in turn;
``faults``
    what went wrong with an explorer that is no generator.
"""

from allworlds.protocol.actions import Action, Drop, Move, Pick, action_numbered, number_of
from allworlds.protocol.answers import Ambiguous, Answer, Checkpoint, Estimate
from allworlds.protocol.choices import (
    DEFAULT_POLICY,
    KINDS,
    POLICIES,
    SEEDED,
    Choices,
    Kind,
    Policy,
    Schedules,
    next_script,
    policy_named,
)
from allworlds.protocol.faults import ANSWER_TIMEOUT, ExplorerFault
from allworlds.protocol.percept import Percept
from allworlds.protocol.transcript import Transcript, action_from_json

__all__ = [
    "ANSWER_TIMEOUT",
    "DEFAULT_POLICY",
    "KINDS",
    "POLICIES",
    "SEEDED",
    "Action",
    "Ambiguous",
    "Answer",
    "Checkpoint",
    "Choices",
    "Drop",
    "Estimate",
    "ExplorerFault",
    "Kind",
    "Move",
    "Percept",
    "Pick",
    "Policy",
    "Schedules",
    "Transcript",
    "action_from_json",
    "action_numbered",
    "next_script",
    "number_of",
    "policy_named",
]
