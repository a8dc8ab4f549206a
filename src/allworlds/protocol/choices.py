"""Where an algorithm is free it asks; a policy answers, or the harness tries every answer.

Every call of :meth:`Choices.pick` is one choice and is recorded by the index of the element
picked.  The record replays the run, and together with the number of options at each choice
it is all that is needed to enumerate every schedule.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence, Sized
from random import Random
from typing import Literal, Protocol, TypeAlias, TypeVar, cast, get_args, overload

from allworlds.inputs import InputError, show

T = TypeVar("T")

Kind: TypeAlias = Literal["edge", "hypothesis", "path", "transit"]
"""What is chosen: the dart to explore next, the hypothesis to test next, the next dart of a
path that tests a hypothesis, the next dart on the way to the dart to be explored."""

KINDS: tuple[Kind, ...] = get_args(Kind)


class Policy(Protocol):
    """Answers choices.  It sees how many options there are, their kind and their costs."""

    def choose(self, kind: Kind, options: Sized, cost: Sequence[int] | None) -> int:
        """An index below ``len(options)``; anything if that is 0."""


class Fifo:
    """The first option: darts in the order in which they came into S; cheapest way first."""

    def choose(self, kind: Kind, options: Sized, cost: Sequence[int] | None) -> int:
        """Always 0."""
        return 0


class Lifo:
    """The dart that came into S last; all else as :class:`Fifo`."""

    def choose(self, kind: Kind, options: Sized, cost: Sequence[int] | None) -> int:
        """The last edge, else 0."""
        return len(options) - 1 if kind == "edge" else 0


class Nearest:
    """The dart with the shortest walk, among equals the first; all else as :class:`Fifo`."""

    def choose(self, kind: Kind, options: Sized, cost: Sequence[int] | None) -> int:
        """The first of the cheapest edges, else 0."""
        if kind != "edge" or not cost:
            return 0
        _check_costs(options, cost)
        return min(range(len(cost)), key=cost.__getitem__)


class Seeded:
    """A random option of every kind, from a seed; the same on every machine."""

    def __init__(self, seed: str) -> None:
        self._random = Random(seed)  # noqa: S311  # reproducible, not secret

    def choose(self, kind: Kind, options: Sized, cost: Sequence[int] | None) -> int:
        """Uniform."""
        count = len(options)
        return self._random.randrange(count) if count else 0


POLICIES: dict[str, type[Fifo | Lifo | Nearest]] = {
    "fifo": Fifo,
    "lifo": Lifo,
    "nearest": Nearest,
}
"""Every policy that has no seed, by its name."""

SEEDED = "random:SEED"
"""How the one that has a seed is written."""

DEFAULT_POLICY = "fifo"
"""Answers where no policy is named."""


def policy_named(name: str, run: str = "") -> Policy:
    """The policy of that name, fresh for one run.

    Args:
        name: as on the command line.
        run: names the run, so that a random policy draws anew in each, whatever the order
            of the runs.

    Raises:
        InputError: naming the legal policies.
    """
    kind, _, seed = name.partition(":")
    if kind == "random" and seed.isascii() and seed.isdigit():
        return Seeded(f"{seed.lstrip('0') or '0'}/{run}")
    if name not in POLICIES:
        legal = ", ".join([*POLICIES, SEEDED])
        raise InputError(f"policy {show(name)} is not one of {legal} (SEED = 0, 1, 2, ...)")
    return POLICIES[name]()


class Choices:
    """The one door to freedom: ``choices.pick(options, of="edge")``.

    Args:
        policy: answers (default :class:`Fifo`).
        script: answers for the first choices, by index; where one does not fit, and when
            they are used up, the policy answers.

    Attributes:
        record: the index taken at each choice so far.
        widths: how many options there were, where every schedule is tried.
    """

    def __init__(self, policy: Policy | None = None, script: Sequence[int] = ()) -> None:
        self._policy = policy or Fifo()
        self._script = script
        self.record: list[int] = []
        self.widths: list[int] = []

    def pick(self, options: Sequence[T], of: Kind, cost: Sequence[int] | None = None) -> T:
        """One of the options.

        Args:
            options: in the canonical order of S; not empty.
            of: what is chosen.
            cost: the walking distance of each option; None or empty where it is not known.

        Raises:
            ValueError: for a kind that is none, no option at all, options or costs that are no
                sequence, or costs that are not one for each option; inside an explorer that is
                a ``crash``.  Nothing is recorded then.
        """
        if of not in KINDS:
            raise ValueError(f"of={show(of)} is not one of {', '.join(KINDS)}")
        _check_sequence("options", options)
        if cost is not None:
            _check_sequence("cost", cost)
            # Others may compute their length; a policy that looks at them checks it.
            if type(cost) in (list, tuple):
                _check_costs(options, cost)
        turn = len(self.record)
        try:
            # Options may compute their number; who need not know it does not ask.
            if turn < len(self._script) and 0 <= self._script[turn] < len(options):
                index = self._script[turn]
            else:
                index = self._policy.choose(of, options, cost)
            picked = options[index]
        except IndexError:
            raise ValueError(f"there is nothing to choose from: no option of {of}") from None
        if len(self.record) != turn:
            raise ValueError("to look at the options was a choice of its own")
        self.record.append(index)
        return picked


def _check_sequence(name: str, given: object) -> None:
    """Nothing for what has an element at each index; else raises ValueError."""
    if not (hasattr(given, "__getitem__") and hasattr(given, "__len__")) or isinstance(given, dict):
        raise ValueError(f"{name} of the type {type(given).__name__} is no sequence, as a list is")


def _check_costs(options: Sized, cost: Sequence[int]) -> None:
    """Nothing if there is one for each option, or none at all; else raises ValueError."""
    if len(cost) not in (0, len(options)):
        raise ValueError(
            f"{len(cost)} costs for {len(options)} options; there must be one for each"
        )


class Schedules:
    """Every schedule of one explorer on one world, in lexicographic order.

    Usage: iterate; give each :class:`Choices` to one run; when the run has ended the next
    one takes the next schedule.  An explorer that asks nothing has one schedule.
    """

    def __iter__(self) -> Iterator[Choices]:
        """Choices for one run after the other."""
        script: tuple[int, ...] | None = ()
        while script is not None:
            choices = _Counted(script)
            yield choices
            script = next_script(choices.record, choices.widths)


def next_script(record: Sequence[int], widths: Sequence[int]) -> tuple[int, ...] | None:
    """The first choices of the schedule after this one, all others being 0; None after the last."""
    for turn in reversed(range(min(len(record), len(widths)))):
        if record[turn] < widths[turn] - 1:
            return (*record[:turn], record[turn] + 1)
    return None


class _Counted(Choices):
    """Choices that also remember how many options there were."""

    def __init__(self, script: Sequence[int]) -> None:
        super().__init__(Fifo(), script)

    def pick(self, options: Sequence[T], of: Kind, cost: Sequence[int] | None = None) -> T:
        _check_sequence("options", options)
        # Asked once: it may be the explorer's code, and say something else the next time.
        count = len(options)
        picked = super().pick(_Fixed(options, count), of, cost)
        self.widths.append(count)
        return picked


class _Fixed(Sequence[T]):
    """Options that are as many as they were when they were counted."""

    def __init__(self, options: Sequence[T], count: int) -> None:
        self._options, self._count = options, count

    def __len__(self) -> int:
        return self._count

    @overload
    def __getitem__(self, index: int) -> T: ...
    @overload
    def __getitem__(self, index: slice) -> Sequence[T]: ...
    def __getitem__(self, index: int | slice) -> T | Sequence[T]:
        return self._options[index]


Schedule: TypeAlias = Literal["one", "all"]
"""Which schedules a run has: the policy's, or every one."""


def a_schedule(text: object) -> Schedule:
    """``one`` or ``all``.

    Raises:
        InputError: for anything else.
    """
    if text not in get_args(Schedule):
        raise InputError(f"schedules {show(text)} is not one of {', '.join(get_args(Schedule))}")
    return cast("Schedule", text)
