"""The rules by which a run is played and judged, which ``check``, ``fuzz`` and ``run`` all take."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import field
from functools import cached_property
from pathlib import Path
from typing import Annotated, NamedTuple

from allworlds.document import Different, Document, IfAny, Positive, Text, about
from allworlds.explorers import Subject
from allworlds.inputs import (
    RULES,
    InputError,
    Option,
    Request,
    Taken,
    a_text,
    an_integer,
    integer_of,
    one_of,
    show,
    values_of,
)
from allworlds.judging.episode import default_step_budget
from allworlds.judging.laws.bounds import Bound, bound_named, paper_bound
from allworlds.judging.laws.law_table import LAWS, JudgedLaw, Setting
from allworlds.judging.tasks import MAP, TASKS, Judge, Task, task_named
from allworlds.maps import CombinatorialMap, Condition
from allworlds.protocol import DEFAULT_POLICY, POLICIES, SEEDED, Choices, policy_named
from allworlds.world import (
    Directional,
    GivenLighthouse,
    Lighthouse,
    LighthouseKind,
    World,
    kind_of,
    lighthouse_kind,
)


def law_names(text: str) -> tuple[str, ...]:
    """The laws of a list with commas."""
    return tuple(part.strip() for part in text.split(","))


def _policy(given: object) -> str:
    policy = a_text("policy", given)
    policy_named(policy)
    return policy


def _bound(given: object) -> str | None:
    if given is None:
        return None
    return bound_named(given if isinstance(given, str) else str(an_integer("bound", given))).name


def _laws(given: object) -> tuple[str, ...] | None:
    """The names of laws, each once."""
    if given is None:
        return None
    if isinstance(given, str) or not isinstance(given, Iterable):
        raise InputError(f"laws = {show(given)} is not a list of names of {', '.join(LAWS)}")
    names = tuple(given)
    for name in names:
        if names.count(name) > 1:
            raise InputError(f"law {show(name)} is named twice")
        if name not in list(LAWS):  # a key would have to be hashable
            raise InputError(f"law {show(name)} is not one of {', '.join(LAWS)}")
    if not names:
        raise InputError(f"laws = () names no law; legal are {', '.join(LAWS)}")
    return names


def _step_budget(given: object) -> int | None:
    if given is None:
        return None
    budget = an_integer("step_budget", given)
    if budget < 1:
        raise InputError(f"step budget {show(budget)} is not positive")
    return budget


class AskedRules(Request):
    """The part of a request that says how runs are played and judged."""

    task: Annotated[
        Taken[str | Judge | Task, Task],
        Option(
            RULES,
            "TASK",
            f"What counts as done: {one_of(TASKS)}, or path/to/file.py:judge, a function of the "
            "world, the transcript and the answer that returns None or what is wrong.",
        ),
    ] = Taken(task_named, MAP)

    policy: Annotated[
        Taken[str, str],
        Option(
            RULES,
            "POLICY",
            f"Who answers the explorer's choices: {one_of([*POLICIES, SEEDED])}.",
        ),
    ] = Taken(_policy, DEFAULT_POLICY)
    bound: Annotated[
        Taken[str | int | None, str | None],
        Option(
            RULES,
            "BOUND",
            "Largest number of traversals: paper (the sum of the paper's bounds (1) and (2)), "
            "two-vertices, none, or an expression over n, m, d0, D, d, g, paper with + - * // **, "
            "min, max (default: the explorer's own, else the lighthouse's).",
        ),
    ] = Taken(_bound, None)
    laws: Annotated[
        Taken[Iterable[str] | None, tuple[str, ...] | None],
        Option(
            RULES,
            "LAWS",
            f"Of {', '.join(LAWS)}, with commas (default: all that apply).",
            parse=law_names,
        ),
    ] = Taken(_laws, None)
    step_budget: Annotated[
        Taken[int | None, int | None],
        Option(
            RULES,
            "B",
            "More traversals break the law 'budget' (default: 8 x the bound paper + 100).",
            parse=integer_of,
        ),
    ] = Taken(_step_budget, None)

    def rules_of(
        self,
        subject: Subject,
        lighthouse: GivenLighthouse,
        *,
        promised: bool = False,
        among: Among | None = None,
    ) -> Rules:
        """The rules under a lighthouse, with the bound and the budget that the explorer brings.

        Raises:
            InputError: naming the offending option and what would be legal.
        """
        told = values_of(AskedRules, self)
        if self.step_budget is None:
            told["step_budget"] = subject.step_budget
        own = subject.bound_under(str(lighthouse_kind(lighthouse)))
        return Rules(lighthouse, promised=promised, own_bound=own, among=among, **told)


class Among(NamedTuple):
    """A condition on the maps of a check: among these its findings are minimal.

    Attributes:
        name: as ``--where`` takes it.
        digest: of the predicate's file, where it is the user's.
    """

    name: str
    digest: str | None = None

    @classmethod
    def of(cls, where: Condition | None) -> Among | None:
        """The condition of a request."""
        if where is None:
            return None
        return cls(where.name, next((code.digest for code in getattr(where, "codes", ())), None))


class Rules(AskedRules, kw_only=False):
    """The rules by which a run is played and judged, in any world.

    Attributes:
        lighthouse: the kind of lighthouse.
        promised: whether the worlds keep a promise, such as planarity, that can make an explorer
            right without folding.
        own_bound: the explorer's own bound for this lighthouse; None if it has none.
        among: the condition on the maps, for findings; runs do not depend on it.
    """

    lighthouse: Taken[GivenLighthouse, LighthouseKind] = Taken(lighthouse_kind, Directional.kind)
    promised: bool = field(default=False, kw_only=True)
    own_bound: str | None = field(default=None, kw_only=True)
    among: Among | None = field(default=None, kw_only=True)

    def __post_init__(self) -> None:
        for law in self.laws or ():
            if not LAWS[law].applies(self._setting):
                raise InputError(f"law {law!r} {LAWS[law].idle}")
        if self._names_an_idle_bound:
            raise InputError(
                f"bound {show(self.bound)} has no effect without the law 'bound'; the laws are "
                f"{', '.join(self.laws or ())}"
            )

    @property
    def kind(self) -> type[Lighthouse]:
        """The kind of lighthouse as a type."""
        return self.lighthouse.as_class

    @property
    def files(self) -> tuple[Path, ...]:
        """The files of the user's from which code is loaded where runs are judged."""
        codes = (*self.lighthouse.codes, *self.task.codes)
        return tuple(file for code in codes for file in code.files)

    @cached_property
    def the_bound(self) -> Bound:
        """The bound on traversals; no bound if that law is not checked."""
        return self._named_bound if "bound" in self.applying else bound_named("none")

    @property
    def default_bound(self) -> str:
        """The bound where none is named; those that are known are about the task map."""
        return (self.own_bound or self.kind.default_bound) if self.task.is_map else "none"

    @cached_property
    def _brought(self) -> Bound:
        return bound_named(self.own_bound or "none")

    @property
    def _named_bound(self) -> Bound:
        return bound_named(self.default_bound if self.bound is None else self.bound)

    @property
    def _names_an_idle_bound(self) -> bool:
        named = self.bound not in (None, "none", self.default_bound)
        return named and self.laws is not None and "bound" not in self.laws

    @property
    def _setting(self) -> Setting:
        return Setting(
            folds=self.kind.folds and not self.promised,
            bounded=self._named_bound.name != "none",
            maps=self.task.is_map,
        )

    @cached_property
    def applying(self) -> tuple[str, ...]:
        """The laws that are checked, in the order of precedence."""
        if self.laws is not None:
            return tuple(law for law in LAWS if law in self.laws)
        return tuple(name for name, law in LAWS.items() if law.applies(self._setting))

    @property
    def judged(self) -> tuple[str, ...]:
        """The laws that are checked, with the task where it is no law by itself."""
        return self.applying if self.task.is_map else ("task", *self.applying)

    def budget(self, map_: CombinatorialMap) -> int:
        """The largest legal number of traversals in a world."""
        return self.budget_by_size(map_.vertex_count, map_.edge_count)

    def budget_by_size(self, vertices: int, edges: int) -> int:
        """The largest legal number of traversals in a world of that size.

        The number is not below the explorer's own bound, if that depends on the size alone.
        """
        if self.step_budget is not None:
            return self.step_budget
        usual = default_step_budget(paper_bound(vertices, edges))
        if self._brought.variables <= {"n", "m"}:
            return max(usual, self._brought.value(vertices, edges, 0, 0, 0, 0) or 0)
        return usual

    def choices(self, name: str, script: Sequence[int] = ()) -> Choices:
        """Fresh choices for the run of that name; a random policy draws anew for each name."""
        return Choices(policy_named(self.policy, name), script)

    def arguments(self, script: Sequence[int] = ()) -> list[str]:
        """The options of ``run`` that give these rules, and these answers to the first choices."""
        given: list[str] = [] if self.task.is_map else ["--task", self.task.name]
        if self.policy != DEFAULT_POLICY:
            given += ["--policy", self.policy]
        if any(script) or (script and self.policy != DEFAULT_POLICY):
            given += ["--choices", ",".join(map(str, script))]
        if self.bound and self.bound != self.default_bound:
            given += ["--bound", self.bound]
        if self.step_budget is not None:
            given += ["--step-budget", str(self.step_budget)]
        alike = Rules(self.lighthouse, task=self.task, bound=self.bound, own_bound=self.own_bound)
        if self.applying != alike.applying:
            given += ["--laws", ",".join(self.applying)]
        return given

    @property
    def recorded(self) -> RecordedRules:
        """The options as they stand in a finding."""
        return RecordedRules(
            policy=self.policy,
            bound=self.the_bound.name,
            step_budget=self.step_budget,
            laws=self.applying,
            task=None if self.task.is_map else self.task.name,
            task_digest=self.task.code.digest if self.task.code else None,
            where=self.among.name if self.among else None,
            where_digest=self.among.digest if self.among else None,
        )


class RecordedRules(Document, forbid_unknown_fields=False):
    """Options of a run.

    How it was played and judged.
    """

    policy: Annotated[Text, about("who answered the explorer's choices; else `fifo`")] = (
        DEFAULT_POLICY
    )
    bound: Annotated[
        Text | None,
        about(
            "the bound on the traversals; `none` where the law was not checked; else the "
            "explorer's own, or the lighthouse's"
        ),
    ] = None
    step_budget: Annotated[
        Positive | None, about("the largest legal number of traversals; null: default")
    ] = None
    laws: Annotated[
        Different[JudgedLaw] | None, about("those that were checked; else all that apply")
    ] = None
    task: Annotated[
        IfAny[Text | None], about("what counted as done; where it is left out, the map")
    ] = None
    task_digest: Annotated[
        IfAny[Text | None], about("SHA-256 of the judge's file, where it is the user's")
    ] = None
    where: Annotated[
        IfAny[Text | None], about("the condition on the maps among which it is minimal, if any")
    ] = None
    where_digest: Annotated[
        IfAny[Text | None], about("SHA-256 of the predicate's file, where it is the user's")
    ] = None

    def rules(self, world: World, own_bound: str | None = None) -> Rules:
        """The rules in a world; the explorer of a finding may bring a bound of its own.

        A bound without its law, or the law without a bound, was not checked: it is left out.

        Raises:
            InputError: naming the offending option.
        """
        bound, laws, task = self.bound, self.laws, task_named(self.task or MAP)
        if task.code:
            task.code.ensure_recorded(self.task_digest)
        if laws is not None:
            default = (own_bound or world.lighthouse.default_bound) if task.is_map else "none"
            if (default if bound is None else bound) == "none":
                laws = tuple(law for law in laws if law != "bound")
            elif "bound" not in laws:
                bound = None
        if not task.is_map:
            laws = laws or None
        return Rules(
            kind_of(world.lighthouse),
            task=task,
            policy=self.policy,
            bound=bound,
            laws=laws,
            step_budget=self.step_budget,
            own_bound=own_bound,
            among=Among(self.where, self.where_digest) if self.where else None,
        )
