"""Choices: where an explorer is free, it asks; a policy decides, or every option is tried.

Each call of :meth:`Choices.pick` is one choice; the index of the picked element is recorded.  The
recorded indices suffice to replay the run.  Together with the number of options at each choice they
suffice to enumerate all schedules.
"""

from collections.abc import Sequence, Sized
from random import Random
from typing import Literal, Protocol, TypeAlias, TypeVar, get_args

from typing_extensions import override

from allworlds.inputs.checks import not_one_of, show

T = TypeVar("T")

ChoiceKind: TypeAlias = Literal["edge", "hypothesis", "path", "transit"]
"""The kind of a choice: the dart to explore next, the hypothesis to test next, the next dart of a
path that tests a hypothesis, the next dart on the way to the dart to be explored."""

KINDS: tuple[ChoiceKind, ...] = get_args(ChoiceKind)


class Policy(Protocol):
    """A policy: it makes a choice from the choice's kind, the options and their costs."""

    def choose(self, kind: ChoiceKind, options: Sized, cost: Sequence[int] | None) -> int:
        """Return an index below ``len(options)``; any integer if there are no options.

        ``cost`` is the walking distance of each option; None or empty if the distances are unknown.
        """


class Fifo:
    """The policy that takes the first option.

    In Algorithm 1, the first of several darts is the one that came into the explored part S first,
    and the first of several paths is a shortest one.
    """

    def choose(self, kind: ChoiceKind, options: Sized, cost: Sequence[int] | None) -> int:
        """Return 0."""
        return 0


class Lifo:
    """The policy that takes the dart that came into the explored part S last.

    Only choices of the kind ``edge`` are made so; other choices are made like :class:`Fifo`.
    """

    def choose(self, kind: ChoiceKind, options: Sized, cost: Sequence[int] | None) -> int:
        """Return the last index for the kind ``edge``, and 0 for other kinds."""
        return len(options) - 1 if kind == "edge" else 0


class Nearest:
    """The policy that takes the nearest dart; of several, the first.

    Only choices of the kind ``edge`` are made so; other choices are made like :class:`Fifo`.
    """

    def choose(self, kind: ChoiceKind, options: Sized, cost: Sequence[int] | None) -> int:
        """Return the index of the first cheapest option for ``edge``, and 0 for other kinds."""
        if kind != "edge" or not cost:
            return 0
        _check_costs(options, cost)
        return min(range(len(cost)), key=cost.__getitem__)


class Seeded:
    """The policy that takes a random option, for every kind of choice.

    The seed determines the random numbers, which are the same on all machines.
    """

    def __init__(self, seed: str) -> None:
        self._random = Random(seed)  # noqa: S311  # reproducible, not secret

    def choose(self, kind: ChoiceKind, options: Sized, cost: Sequence[int] | None) -> int:
        """Return a uniformly drawn index."""
        return self._random.randrange(max(len(options), 1))


POLICIES: dict[str, type[Fifo | Lifo | Nearest]] = {"fifo": Fifo, "lifo": Lifo, "nearest": Nearest}
"""The policies without a seed, by their names."""

SEEDED = "random:SEED"
"""The form of the name of the policy with a seed."""

DEFAULT_POLICY = "fifo"
"""The name of the default policy."""


def policy_named(name: str, run: str = "") -> Policy:
    """A new policy of that name for one run.

    Args:
        name: the name, as on the command line.
        run: the name of the run, so that the draws of a random policy depend on the run and not on
            the order of runs.

    Raises:
        InputError: naming the legal policies.
    """
    if name in POLICIES:
        return POLICIES[name]()
    kind, _, seed = name.partition(":")
    if kind == "random" and seed.isascii() and seed.isdigit():
        return Seeded(f"{seed.lstrip('0') or '0'}/{run}")
    raise not_one_of("policy", name, [*POLICIES, SEEDED], " (SEED = 0, 1, 2, ...)")


class Choices:
    """The choices of one run: ``choices.pick(options, of="edge")``.

    Args:
        policy: the policy (default :class:`Fifo`).
        script: the index to take at each of the first choices; at later choices, or if an index is
            out of range, the policy decides.

    Attributes:
        record: the index taken at each choice so far.
        widths: the number of options at each choice; empty unless every schedule is tried.
    """

    def __init__(self, policy: Policy | None = None, script: Sequence[int] = ()) -> None:
        self._policy = policy or Fifo()
        self._script = script
        self.record: list[int] = []
        self.widths: list[int] = []

    def pick(self, options: Sequence[T], of: ChoiceKind, cost: Sequence[int] | None = None) -> T:
        """Return one of the options.

        Args:
            options: the options, not empty; the policies ``fifo`` and ``lifo`` depend on their
                order.
            of: the kind of the choice.
            cost: the walking distance of each option; None or empty if unknown.

        Raises:
            ValueError: if the kind is unknown; if there is no option; if the options or the costs
                are no sequence; or if there is not one cost for each option.  The choice is then
                not recorded.  In an explorer this is a ``crash``.
        """
        if of not in KINDS:
            raise ValueError(f"of={show(of)} is not one of {', '.join(KINDS)}")
        _check_sequence("options", options)
        if cost is not None:
            _check_sequence("cost", cost)
            # Other sequences may compute their length; a policy that reads the costs checks it.
            if type(cost) in (list, tuple):
                _check_costs(options, cost)
        turn = len(self.record)
        try:
            index = self._index(of, options, cost)
            picked = options[index]
        except IndexError:
            raise ValueError(f"there is nothing to choose from: no option of {of}") from None
        if len(self.record) != turn:
            raise ValueError("to look at the options was a choice of its own")
        self.record.append(index)
        return picked

    def _index(self, of: ChoiceKind, options: Sized, cost: Sequence[int] | None) -> int:
        turn = len(self.record)
        # Options may compute their number, so it is not asked without need.
        if turn < len(self._script) and 0 <= self._script[turn] < len(options):
            return self._script[turn]
        return self._policy.choose(of, options, cost)


def _check_sequence(name: str, given: object) -> None:
    """Raise ValueError unless ``given`` has the methods of a sequence: a length, and indices.

    A dictionary is refused, too.  ``name`` names the value in the message.
    """
    if not (hasattr(given, "__getitem__") and hasattr(given, "__len__")) or isinstance(given, dict):
        raise ValueError(f"{name} of the type {type(given).__name__} is no sequence, as a list is")


def _check_costs(options: Sized, cost: Sequence[int]) -> None:
    """Raise ValueError unless there is one cost for each option, or there are no costs."""
    if len(cost) not in (0, len(options)):
        raise ValueError(
            f"{len(cost)} costs for {len(options)} options; there must be one for each"
        )


def are_due(script: Sequence[int], record: Sequence[int], widths: Sequence[int]) -> bool:
    """Whether a run made the choices of its script, and took the first option at all later choices.

    ``record`` and ``widths`` are those of the run's :class:`Choices`.  The result is also false if
    ``widths`` does not have one number for each choice in ``record``: without these numbers,
    :func:`next_script` cannot find the next schedule.
    """
    length = max(len(script), len(record))
    due = (*script, *(0,) * (length - len(script)))
    return tuple(record) == due and len(widths) == len(record)


def next_script(
    script: Sequence[int], record: Sequence[int], widths: Sequence[int]
) -> tuple[int, ...] | None:
    """The script of the next schedule after that of a run; None after the last schedule.

    ``script``, ``record`` and ``widths`` are those of the run's :class:`Choices`.  The result is
    also None if :func:`are_due` is false, because the run did not follow its script.
    """
    if not are_due(script, record, widths):
        return None
    for turn in reversed(range(len(record))):
        if record[turn] < widths[turn] - 1:
            return (*record[:turn], record[turn] + 1)
    return None


class ScheduledChoices(Choices):
    """The choices of a run when all schedules are tried.

    At each choice the number of options is recorded, too.

    Args:
        script: the indices for the first choices; all later indices are 0.
    """

    def __init__(self, script: Sequence[int]) -> None:
        super().__init__(script=script)
        self._width = 0

    @override
    def pick(self, options: Sequence[T], of: ChoiceKind, cost: Sequence[int] | None = None) -> T:
        picked = super().pick(options, of, cost)
        self.widths.append(self._width)
        return picked

    @override
    def _index(self, of: ChoiceKind, options: Sized, cost: Sequence[int] | None) -> int:
        # It is asked only once, since the explorer's code may give another number the next time.
        self._width = len(options)
        return super()._index(of, range(self._width), cost)


Schedule: TypeAlias = Literal["one", "all"]
"""The schedules of a run that are tried: ``one`` is the policy's schedule, ``all`` is every one."""
