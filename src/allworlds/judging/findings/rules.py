"""How a run is played and judged: the rules, which ``check``, ``fuzz`` and ``run`` all take."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Annotated, TypedDict

from allworlds.document import Different, Document, Positive, Text, about
from allworlds.inputs import InputError, a_text, an_integer, show
from allworlds.judging.episode import default_step_budget
from allworlds.judging.laws.bounds import Bound, bound_named, paper_bound
from allworlds.judging.laws.law_table import LAWS, JudgedLaw, Setting
from allworlds.maps import CombinatorialMap
from allworlds.protocol import DEFAULT_POLICY, Choices, policy_named
from allworlds.world import Lighthouse, World, lighthouse_named


class RulesOptions(TypedDict, total=False):
    """Options of every verb that plays and judges runs.

    Attributes:
        policy: answers the explorer's choices: one of :data:`allworlds.protocol.choices.POLICIES`
            (default ``fifo``), or ``random:SEED``.
        bound: on the traversals: ``paper``, ``two-vertices``, ``none``, an expression or an
            integer; None (default) takes the explorer's own, else the lighthouse's.
        laws: those to check; None (default) takes all that apply.
        step_budget: the largest legal number of traversals; None (default) takes
            8 x ((1)+(2)) + 100.
    """

    policy: str
    bound: str | int | None
    laws: Iterable[str] | None
    step_budget: int | None


@dataclass(frozen=True)
class Rules:
    """How one run is played and judged, whatever the world.

    Attributes:
        lighthouse: the kind of lighthouse.
        policy, bound, laws, step_budget: see :class:`RulesOptions`.
        promised: the worlds keep a promise, such as planarity, that can make an explorer right
            without folding.
        own_bound: the bound that the explorer brings for this lighthouse; None if it has none.
    """

    lighthouse: str = "directional"
    policy: str = DEFAULT_POLICY
    bound: str | None = None
    laws: tuple[str, ...] | None = None
    step_budget: int | None = None
    promised: bool = False
    own_bound: str | None = None

    def __post_init__(self) -> None:
        lighthouse_named(a_text("lighthouse", self.lighthouse))
        policy_named(a_text("policy", self.policy))
        bound_named("none" if self.bound is None else a_text("bound", self.bound))
        for law in self.laws or ():
            if law not in list(LAWS):  # a key would have to be hashable
                raise InputError(f"law {show(law)} is not one of {', '.join(LAWS)}")
        if self.laws == ():
            raise InputError(f"laws = () names no law; legal are {', '.join(LAWS)}")
        for law in self.laws or ():
            if not LAWS[law].applies(self._setting):
                raise InputError(f"law {law!r} {LAWS[law].idle}")
        if self._names_an_idle_bound:
            raise InputError(
                f"bound {show(self.bound)} has no effect without the law 'bound'; the laws are "
                f"{', '.join(self.laws or ())}"
            )
        if self.step_budget is not None:
            object.__setattr__(self, "step_budget", an_integer("step_budget", self.step_budget))
            if self.step_budget < 1:
                raise InputError(f"step budget {show(self.step_budget)} is not positive")

    @property
    def kind(self) -> type[Lighthouse]:
        """The kind of lighthouse as a type."""
        return lighthouse_named(self.lighthouse)

    @cached_property
    def the_bound(self) -> Bound:
        """The bound on traversals; none where that law is not checked."""
        return self._named_bound if "bound" in self.applying else bound_named("none")

    @property
    def default_bound(self) -> str:
        """The bound where none is named."""
        return self.own_bound or self.kind.default_bound

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
            folds=self.kind.folds and not self.promised, bounded=self._named_bound.name != "none"
        )

    @cached_property
    def applying(self) -> tuple[str, ...]:
        """The laws that are checked, in the order of precedence."""
        if self.laws is not None:
            return tuple(law for law in LAWS if law in self.laws)
        return tuple(name for name, law in LAWS.items() if law.applies(self._setting))

    def budget(self, map_: CombinatorialMap) -> int:
        """The largest legal number of traversals in a world."""
        if self.step_budget is not None:
            return self.step_budget
        return default_step_budget(paper_bound(map_.vertex_count, map_.edge_count))

    def choices(self, name: str, script: Sequence[int] = ()) -> Choices:
        """Fresh choices for the run of that name, which a random policy draws anew for."""
        return Choices(policy_named(self.policy, name), script)

    def arguments(self, script: Sequence[int] = ()) -> list[str]:
        """The options of ``run`` that give these rules, and these answers to the first choices."""
        given: list[str] = []
        if self.policy != DEFAULT_POLICY:
            given += ["--policy", self.policy]
        if any(script) or (script and self.policy != DEFAULT_POLICY):
            given += ["--choices", ",".join(map(str, script))]
        if self.bound and self.bound != self.default_bound:
            given += ["--bound", self.bound]
        if self.step_budget is not None:
            given += ["--step-budget", str(self.step_budget)]
        alike = Rules(self.lighthouse, bound=self.bound, own_bound=self.own_bound)
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

    def rules(self, world: World, own_bound: str | None = None) -> Rules:
        """The rules in a world; the explorer of a finding may bring a bound of its own.

        A bound without its law, or the law without a bound, was not checked: it is left out.

        Raises:
            InputError: naming the option that is none.
        """
        bound, laws = self.bound, self.laws
        if laws is not None:
            default = own_bound or world.lighthouse.default_bound
            if (default if bound is None else bound) == "none":
                laws = tuple(law for law in laws if law != "bound")
            elif "bound" not in laws:
                bound = None
        return make_rules(
            {
                "policy": self.policy,
                "bound": bound,
                "laws": laws,
                "step_budget": self.step_budget,
            },
            world.lighthouse.kind,
            own_bound,
        )


def make_rules(
    options: RulesOptions,
    lighthouse: str,
    own_bound: str | None = None,
    *,
    promised: bool = False,
) -> Rules:
    """The rules of a verb's options.

    Raises:
        InputError: naming the offending option and what would be legal.
    """
    bound, laws = options.get("bound"), options.get("laws")
    if bound is not None and not isinstance(bound, str):
        bound = str(an_integer("bound", bound))
    if laws is not None:
        laws = _names("laws", laws)
    return Rules(
        lighthouse,
        options.get("policy", DEFAULT_POLICY),
        bound,
        laws,
        options.get("step_budget"),
        promised,
        own_bound,
    )


def _names(what: str, given: object) -> tuple[str, ...]:
    """The names of laws, each once."""
    if isinstance(given, str) or not isinstance(given, Iterable):
        raise InputError(f"{what} = {show(given)} is not a list of names of {', '.join(LAWS)}")
    names = tuple(given)
    for name in names:
        if names.count(name) > 1:
            raise InputError(f"law {show(name)} is named twice")
    return names
