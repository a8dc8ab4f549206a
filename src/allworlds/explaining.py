"""A finding in plain words: what the robot believed, what was true, and where they part."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property
from typing import Any

from allworlds.checker.belief import believed_percepts, believed_trail, recorded_trail
from allworlds.checker.finding import Finding
from allworlds.checker.parting import Parting, find_parting
from allworlds.errors import InputError, show
from allworlds.judge.folding import fold
from allworlds.maps.canonical import carries, numbering
from allworlds.maps.combinatorial import CombinatorialMap, Dart, cycles
from allworlds.protocol import Estimate, Move, Percept
from allworlds.world import World


@dataclass(frozen=True, slots=True)
class Explanation:
    """What a finding means.

    Vertices and darts are those of the world, in the numbering of the finding.

    Attributes:
        law: the broken law.
        sentences: in plain words.
        step: the first step at which belief and truth part; 0 is the start, None where they
            part at none.
        explorer: its name.
        world: where it happened.
        robot: its dart at the end of the walk.
        answer: the wrong answer; None where the finding holds none.
    """

    law: str
    sentences: tuple[str, ...]
    step: int | None
    explorer: str
    world: World
    robot: Dart
    answer: Estimate | None

    @property
    def exit_code(self) -> int:
        """The exit code of the command: a question was answered."""
        return 0

    def to_json(self) -> dict[str, Any]:
        """The document of ``explain --json``."""
        answer = self.answer
        return {
            "schema": 1,
            "explorer": self.explorer,
            "law": self.law,
            "step": self.step,
            "sentences": list(self.sentences),
            "world": self.world.to_json(),
            "robot": self.robot,
            "answer": {**answer.map.to_json(), "here": answer.here} if answer else None,
        }


def explain(finding: Finding) -> Explanation:
    """The finding in plain words.

    Raises:
        InputError: if its transcript is no walk in its world, or its answer is none.
    """
    story = _Story(finding)
    sentences = _TELLERS.get(finding.law, _tell_ending)(story)
    return Explanation(
        finding.law,
        tuple(sentences),
        story.step,
        finding.explorer,
        finding.world,
        story.walked[-1],
        story.answer,
    )


class _Story:
    """A finding with what follows from it."""

    def __init__(self, finding: Finding) -> None:
        self.finding = finding
        self.world = finding.world
        self.map = finding.world.map
        self.transcript = finding.transcript
        self.sensed = [self.transcript.first, *(percept for _, percept in self.transcript.steps)]
        self.walked = recorded_trail(self.world, self.transcript)

    @cached_property
    def answer(self) -> Estimate | None:
        """The wrong answer, under the laws that are about the answer."""
        seen = self.finding.seen
        if self.finding.law not in ("map", "pose"):
            return None
        if not isinstance(seen, Mapping):
            raise InputError(
                f"seen = {show(seen)} is no rooted map, but the law is about the answer"
            )
        map_, here = CombinatorialMap.from_json(seen), seen.get("here")
        if type(here) is not int or here not in map_.darts:
            raise InputError(f"seen.here = {show(here)} is no dart of the finding's answer")
        return Estimate(map_, here)

    @cached_property
    def expected(self) -> list[Percept]:
        """What the answer makes expect at each step, as far as that can be said."""
        assert self.answer
        map_, here = self.answer.map, self.answer.here
        percepts = believed_percepts(self.world, map_, here, self.transcript)
        if percepts is not None:
            return percepts
        # There is no place for the marker; what is left are the degrees.
        return [Percept(map_.degree_at[dart]) for dart in self._believed]

    @cached_property
    def misfits(self) -> list[int]:
        """The steps at which something else was sensed than the answer makes expect."""
        pairs = zip(self.expected, self.sensed, strict=True)
        return [step for step, (expected, sensed) in enumerate(pairs) if expected != sensed]

    @cached_property
    def parting(self) -> Parting | None:
        """Where the walk and the same walk in the answer part."""
        if self.answer is None:
            return None
        fits = [step not in self.misfits for step in range(len(self.walked))]
        return find_parting(self.map, self.walked, self.answer.map, self._believed, fits)

    @property
    def step(self) -> int | None:
        """The first step at which belief and truth part."""
        if self.finding.law.startswith("invariant"):
            return self.checkpoint
        return self.parting.step if self.parting else None

    @property
    def checkpoint(self) -> int | None:
        """The step before the checkpoint that breaks the law; None where none is named."""
        named = re.search(r"\bcheckpoint after step ([0-9]{1,9})\b", str(self.finding.seen))
        step = int(named[1]) if named else None
        return step if step is not None and step < len(self.walked) else None

    @property
    def _believed(self) -> list[Dart]:
        assert self.answer
        return believed_trail(self.answer.map, self.answer.here, self.transcript)

    def vertex(self, dart: Dart) -> str:
        """The vertex of a dart: ``v1``."""
        return f"v{self.map.vertex_of[dart]}"

    def place(self, dart: Dart) -> str:
        """A dart with its vertex: ``v1, dart 3``."""
        return f"{self.vertex(dart)}, dart {dart}"

    def last_left(self, dart: Dart, step: int) -> str:
        """When the robot had been at the dart's vertex before that step."""
        vertex = self.vertex(dart)
        last = max(i for i in range(step) if self.vertex(self.walked[i]) == vertex)
        just = last == step - 1
        return "which it had just left" if just else f"which it had left at step {last + 1}"


# ------------------------------------------------------------------- wrong answers


def _tell_map(story: _Story) -> list[str]:
    answer = story.answer
    assert answer
    return [
        f"The world has {_size(story.map)}; the answer has {_size(answer.map)} and is another map.",
        *_tell_parting(story),
    ]


def _tell_pose(story: _Story) -> list[str]:
    answer, robot, map_ = story.answer, story.walked[-1], story.map
    assert answer
    sigma, alpha = answer.map.sigma, answer.map.alpha
    order = numbering(sigma, alpha, answer.here)
    images = [d for d in map_.darts if carries(sigma, alpha, order, map_.sigma, map_.alpha, d)]
    if not images:
        raise InputError("the finding's answer is not the map of its world, so its law is not pose")
    near = [d for d in images if map_.vertex_of[d] == map_.vertex_of[robot]]
    believed = min(near, key=lambda d: map_.offset(d, robot)) if near else images[0]
    where = f"The robot stands at {story.place(robot)}; it believes to stand at "
    if near:
        turned, degree = map_.offset(believed, robot), map_.degree_at[robot]
        where += (
            f"dart {believed} of the same vertex: in truth it is turned further by {turned} of "
            f"{degree} darts clockwise."
        )
    else:
        where += f"{story.place(believed)}, which is another vertex."
    alike = len(images) - 1
    symmetry = [f"The map is symmetric: {_count(alike, 'other dart')} would do as well."]
    return [
        "The map is right, but the robot is not where the answer says.",
        where,
        *(symmetry if alike else []),
        *_tell_parting(story),
    ]


def _tell_parting(story: _Story) -> list[str]:
    parting, misfits = story.parting, story.misfits
    sentences = [
        "Follow the log in the world and, traced back from 'here', in the answer.",
    ]
    if parting is None:
        sentences.append(
            "They never part: the log fits the world and the answer, and the rest was guessed."
        )
        return sentences + _tell_open(story)
    sentences.append(_say_parting(story, parting))
    if parting.step in misfits:
        return sentences
    if misfits:
        step = misfits[0]
        sentences.append(
            f"The first percept against the answer came at step {step}: {_say_misfit(story, step)}."
        )
        return sentences
    sentences.append(
        "Every percept fits the answer all the same: the log does not tell them apart."
    )
    return sentences + _tell_open(story)


def _say_parting(story: _Story, parting: Parting) -> str:
    """The step at which they part, as one sentence."""
    step, robot, taken_for = parting.step, parting.robot, parting.taken_for
    vertex = story.vertex(robot)
    misfit = _say_misfit(story, step) if step in story.misfits else ""
    if step == 0:
        return f"They part at the start, at {vertex}: {misfit}."
    if parting.fresh:
        truth = f"At step {step} the robot came to {vertex} for the first time"
    else:
        truth = f"At step {step} the robot was back at {vertex}, {story.last_left(robot, step)}"
    if taken_for == (None if parting.fresh else robot):
        return f"{truth}, and so it is in its answer, but {misfit}."
    if taken_for is None:
        belief = "its answer takes the place for a new vertex"
    elif story.vertex(taken_for) != vertex:
        left = story.last_left(taken_for, step)
        belief = f"its answer takes the place for {story.vertex(taken_for)}, {left}"
    else:
        belief = f"its answer takes dart {robot}, by which it came, for dart {taken_for}"
    return f"{truth}, but {belief}{': ' if misfit else ''}{misfit}."


def _say_misfit(story: _Story, step: int) -> str:
    expected, sensed = story.expected[step], story.sensed[step]
    return f"it sensed '{sensed}', where the answer makes expect '{expected}'"


# ------------------------------------------------------------------- laws about the log


def _tell_folding(story: _Story) -> list[str]:
    return [
        "The log does not determine the map, so the answer, right or not, was guessed.",
        *_tell_open(story),
    ]


def _tell_open(story: _Story) -> list[str]:
    """What the log leaves open, and how it is in truth."""
    if not story.world.lighthouse.folds:
        return []
    folded, map_ = fold(story.transcript), story.map
    image = {0: story.world.start}
    for x in (queue := [0]):
        for y, true in ((folded.sigma[x], map_.sigma), (folded.alpha[x], map_.alpha)):
            if y not in image:
                image[y] = true[image[x]]
                queue.append(y)
    unsettled = sorted({image[x] for x, y in enumerate(folded.alpha) if x == y})
    if not unsettled:
        return []
    at: dict[str, list[str]] = {}
    for dart in unsettled:
        at.setdefault(story.vertex(dart), []).append(str(dart))
    names = _list([f"{vertex}: {_darts(darts)}" for vertex, darts in at.items()], "; ")
    leads = [
        f"dart {d} to dart {map_.alpha[d]} of {story.vertex(map_.alpha[d])}" for d in unsettled
    ]
    sentences = [
        f"It was never settled where these darts lead: {names}.",
        f"In the world they lead as follows: {', '.join(leads)}.",
    ]
    copies = Counter(story.vertex(image[group[0]]) for group in cycles(folded.sigma))
    for vertex, count in sorted(copies.items()):
        if count > 1:
            sentences.append(
                f"The robot came to {vertex} in {count} ways of which the log does not tell that "
                "they lead to one vertex."
            )
    return sentences


def _tell_bound(story: _Story) -> list[str]:
    cost, bound = story.transcript.cost, story.finding.expected
    map_, back, first = story.map, 0, 0
    path: list[Dart] = []
    known: set[Dart] = set()
    for (action, _), before, arrived in zip(
        story.transcript.steps, story.walked, story.walked[1:], strict=False
    ):
        if type(action) is not Move:
            continue
        if path and map_.turn(before, action.k) == path[-1]:
            path.pop()
            back += 1
        else:
            path.append(arrived)
        first += arrived not in known
        known |= {arrived, map_.alpha[arrived]}
    name, out = story.finding.rules.the_bound.name, cost - back
    return [
        f"The world has {_size(map_)}, for which the bound ({name}) allows {bound}.",
        f"The robot made {_count(cost, 'traversal')}: {out} out, {back} to take one back.",
        f"Of those out {first} went along an edge that was new.",
    ]


# ------------------------------------------------------------------- checkpoints, and no answer


def _tell_checkpoint(story: _Story) -> list[str]:
    sentences = [_CHECKPOINTS[story.finding.law]]
    step = story.checkpoint
    if step is not None:
        sentences.append(
            f"The checkpoint came after step {step}, where the robot stood at "
            f"{story.place(story.walked[step])}, and had sensed '{story.sensed[step]}'."
        )
    return [*sentences, *_tell_expected(story)]


def _tell_ending(story: _Story) -> list[str]:
    finding, steps = story.finding, story.transcript.steps
    sentences = [_ENDINGS.get(finding.law, f"The law '{finding.law}' is broken.")]
    place = story.place(story.walked[-1])
    if steps:
        action, percept = steps[-1]
        motion = f"move {action.k}" if type(action) is Move else type(action).__name__.lower()
        sentences.append(
            f"Its last step was step {len(steps)}, {motion}: to {place}, where it sensed "
            f"'{percept}'."
        )
    else:
        sentences.append(
            f"It made no step: it stood at the start, {place}, and sensed '{story.sensed[0]}'."
        )
    sentences += _tell_expected(story)
    lines = finding.detail.split("\n") if finding.detail else []
    last = next((line.strip() for line in reversed(lines) if line.strip()), "")
    if last:
        sentences.append(f"The last line of its traceback, or of what it wrote to stderr: {last}")
    return sentences


def _tell_expected(story: _Story) -> list[str]:
    finding = story.finding
    return [f"Expected was: {finding.expected}.", f"Seen was: {finding.seen}."]


_CHECKPOINTS = {
    "invariant-1": "What was published as S, the explored part, does not lie so in the world.",
    "invariant-2": "What was published as U, the unexplored darts, holds one that is explored.",
    "variant": "A pass brought no progress: the edges missing in S did not get fewer, or not none.",
}

_ENDINGS = {
    "crash": "The explorer crashed.",
    "timeout": "The explorer was silent for too long.",
    "illegal-action": "The explorer did what no robot can do here.",
    "no-estimate": "The explorer ended without an answer that could be judged.",
    "budget": "The explorer went on for longer than it may.",
    "nondeterministic": "Exploring the same world again, the explorer did something else.",
}

_TELLERS = {
    "map": _tell_map,
    "pose": _tell_pose,
    "folding": _tell_folding,
    "bound": _tell_bound,
    "invariant-1": _tell_checkpoint,
    "invariant-2": _tell_checkpoint,
    "variant": _tell_checkpoint,
}
"""The laws with a story of their own; the others end a run before it can be judged."""


# ------------------------------------------------------------------- words


def _size(map_: CombinatorialMap) -> str:
    vertices = _count(map_.vertex_count, "vertex", "vertices")
    return f"{vertices} and {_count(map_.edge_count, 'edge')}"


def _count(number: int, one: str, many: str = "") -> str:
    return f"{number} {one if number == 1 else many or one + 's'}"


def _darts(names: list[str]) -> str:
    return f"{'dart' if len(names) == 1 else 'darts'} {_list(names)}"


def _list(parts: list[str], comma: str = ", ") -> str:
    if comma != ", " or len(parts) == 1:
        return comma.join(parts)
    return f"{comma.join(parts[:-1])} and {parts[-1]}"
