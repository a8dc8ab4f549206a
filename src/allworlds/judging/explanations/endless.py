"""Sentences about a run without an end: its repeated steps, its last lines, edges left out.

The functions ``tell_...`` return a list of sentences; it is empty if there is nothing to say.
"""

import os
import re
from collections.abc import Sequence
from typing import Any

from msgspec import Struct

from allworlds.judging.explanations.story import Story
from allworlds.judging.findings.finding import Finding
from allworlds.maps.combinatorial import Dart
from allworlds.protocol.actions import Move
from allworlds.protocol.code_lines import is_users
from allworlds.words import listed, plural

TIMES = 3
"""If a walk ends with the same steps this number of times, or more often, these steps are called a
round."""

SHOWN = 8
"""The largest number of darts of a round, of lines of code, or of edges that sentences name; the
others are left out, or counted."""


class Round(Struct, frozen=True):
    """A round: a sequence of steps that the robot repeats up to the end of its walk.

    Attributes:
        first: the number of the step with which the repetition begins; steps count from 1.
        steps: the number of steps of the sequence.
        times: how often the whole sequence occurs, one after the other.
    """

    first: int
    steps: int
    times: int


def round_of(walk: Sequence[Any]) -> Round | None:
    """The round with which a walk ends; None if the walk ends in no round.

    A walk ends in a round if from some step on it repeats a sequence, at least :data:`TIMES` times
    in full; after these, the end of the walk may cut off one more repetition.  ``walk`` holds a
    value for each step; equal values stand for equal steps.  If several rounds are possible, the
    one whose repetition begins earliest is returned.

    Cost: linear, by the borders of the reversed walk (Knuth, Morris and Pratt).
    """
    back = walk[::-1]
    border, found = [0] * len(back), None
    for i in range(1, len(back)):
        k = border[i - 1]
        while k and back[i] != back[k]:
            k = border[k - 1]
        border[i] = k + (back[i] == back[k])
        length = i + 1
        period = length - border[i]
        if length >= TIMES * period:
            found = Round(len(back) - length + 1, period, length // period)
    return found


def tell_round(story: Story) -> list[str]:
    """Say at which step the round at the end of the walk begins, and how often it occurs.

    The sentence names the robot's darts after the steps of the round, and the lines of the user's
    code that ran in these steps, if they are known.  The result is empty if the walk ends in no
    round.
    """
    walk = story.walk
    found = round_of([*zip(map(str, walk.actions), walk.darts[1:], strict=True)])
    if found is None:
        return []
    steps = range(found.first, found.first + found.steps)
    places = [story.spot(walk.darts[step]) for step in steps]
    more = "; ..." if len(places) > SHOWN else ""
    where = "; ".join(places[:SHOWN]) + more
    code = story.finding.code
    lines = code.steps[found.first - 1 : found.first - 1 + found.steps] if code else ()
    named = [line for line in dict.fromkeys(lines) if line][:SHOWN]
    at = f" ({'lines' if len(named) > 1 else 'line'} {', '.join(named)})" if named else ""
    walked = f"{plural(found.steps, 'step')}, {found.times} times in all: to {where}"
    return [f"From step {found.first} on the robot repeated {walked}{at}."]


def tell_way_back(story: Story) -> list[str]:
    """Say at which step the explorer seems to count doors from a wrong door.

    If a robot leaves a vertex through a door, and next comes to this vertex through the same door
    (a way back), it faces this door, and ``Move(k)`` counts from there.  Some explorers count from
    another door instead: the one by which the robot had come in before it left.  For each motion of
    the walk this function finds the door that ``k`` names by this wrong count: the *meant* door.

    The mistake shows at a motion after a way back, if the robot left along an edge that it had
    walked before, but the meant door led along a new edge: the explorer seems to have wanted the
    new edge.  The sentence names the first such motion.

    The mistake does not explain the walk if, at any motion, the robot left along a new edge while
    the meant door led along a walked edge.  Then the result is empty.
    """
    map_, darts = story.map, story.walk.darts
    came, left, walked, remarks = dict[int, Dart](), dict[int, Dart](), set[Dart](), list[str]()
    for step, action in enumerate(story.walk.actions, 1):
        if type(action) is not Move:
            continue
        here, out = darts[step - 1], map_.alpha[darts[step]]
        vertex = map_.vertex_of[here]
        back = left.get(vertex) == here
        by_loop = vertex in left and map_.vertex_of[map_.alpha[here]] == vertex
        if not (back or by_loop):
            came[vertex] = here
        meant = map_.turn(came[vertex], action.k)
        if (out in walked) < (meant in walked):
            return []
        if back and (out in walked) > (meant in walked) and not remarks:
            remarks.append(
                f"Before step {step} the robot was back at {story.vertex(here)} and faced dart "
                f"{here}, by which it had left. Doors count from this dart, so {action} led along "
                f"dart {out}, which was already walked. Counted from dart {came[vertex]}, where "
                f"the robot stood before it left, {action} would lead along dart {meant}, which "
                "was new. Does the explorer count from the wrong door?"
            )
        walked |= {out, darts[step]}
        if not (by_loop and out == here):  # it is on its way back through the loop
            left[vertex] = out
    return remarks


def tell_open(story: Story) -> list[str]:
    """Name the edges that the robot never walked along; the result is empty if there are none."""
    edges = story.unwalked
    if len(edges) > SHOWN:
        edges[SHOWN:] = [f"{len(edges) - SHOWN} more"]
    return [f"The robot never walked along {listed(edges)}."] if edges else []


FRAME = re.compile(r'^  File "(.*)", line ([0-9]+) in (.*)$', re.MULTILINE)
"""The pattern for a frame of a stack that Python's faulthandler has printed, the innermost frame
first."""


def stack_of(finding: Finding) -> list[tuple[str, str]]:
    """The user's lines in the stack of a run that breaks the law ``timeout``, innermost first.

    The result holds pairs: a line as ``FILE:LINE``, and the name of the function.  If an explorer
    in Python is silent for too long, its process prints the stack, which the finding holds if the
    prints of the run are recorded.  Without such a stack, or for another law, the result is empty.
    """
    if finding.law != "timeout":
        return []
    here = f"{os.getcwd()}{os.sep}"  # noqa: PTH109  # a text, as the files are
    return [
        (f"{file.removeprefix(here)}:{line}", function)
        for file, line, function in FRAME.findall(finding.output)
        if is_users(file)
    ]


def tell_stack(finding: Finding) -> list[str]:
    """Name the lines and functions of :func:`stack_of`, which ran when the explorer was silent.

    The result is empty if no such line is known.
    """
    frames = [f"{function} ({line})" for line, function in stack_of(finding)[:SHOWN]]
    return [f"It was then in the function {', called by '.join(frames)}."] if frames else []
