"""The kernel's engines, run by Python from their sources, so that these can be changed first.

Numbers have no limit there.  There is a world or two a millisecond that is walked on demand, and a
run or two that is judged.
"""

from __future__ import annotations

import ast
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from itertools import islice
from pathlib import Path
from types import FunctionType, SimpleNamespace
from typing import Any, NamedTuple

import numpy as np

from allworlds.documents.document import replace
from allworlds.engines.compiled_engine import level_of
from allworlds.engines.kernel import compiling, engine
from allworlds.engines.kernel.arrays import JOB, ROBOT, Level, Sums
from allworlds.engines.kernel.capabilities import EXPLORERS, LIGHTHOUSES, POLICIES
from allworlds.engines.kernel.runs import UnitArrays
from allworlds.judging.rules import Rules
from allworlds.maps import MapClass
from allworlds.maps.classes import Extent
from allworlds.maps.enumeration import prefixes

KERNEL = "allworlds.engines.kernel"
FOLDER = Path(engine.__file__).parent
MODULES = ("code", "laws", "worlds", "algorithm1", "runs", "demand_driven")
"""The modules that are interpreted, each after those that it imports."""

NOTHING = Sums((), {}, (), (), ())
"""What an engine says that has gone astray."""


class Engines(NamedTuple):
    """The two engines: the walk on demand, and the judge of all runs."""

    walk: Callable[..., Sums]
    judge: Callable[..., Sums]


class _Zeros(dict[int, int]):
    """A long array of zeros."""

    def __missing__(self, _: int) -> int:
        return 0


def _put(array: Any, index: int, value: int) -> int:
    array[index] = value
    return value


def _neighbours(graph: Any, front: int) -> int:
    joined = 0
    while front:
        joined |= graph.adjacent[(front & -front).bit_length() - 1]
        front &= front - 1
    return joined


WORDS: dict[str, Any] = {
    **vars(compiling),
    **dict.fromkeys(("entry", "inner", "inlined"), lambda function: function),
    "lowest": lambda mask: (mask & -mask).bit_length() - 1,
    "highest": lambda mask: mask.bit_length() - 1,
    "size": int.bit_count,
    "copy": lambda target, other: vars(target).update(vars(other)),
    "neighbours": _neighbours,
    "call": lambda function, arguments: function(*arguments),
    "address_of": lambda array: array,
    "entry_of": lambda array, index: array[index],
    "byte_of": lambda array, index: array[index],
    "put_entry": _put,
}
"""The instructions; an address is what stands there."""


def interpreted(changed: Mapping[str, str] = {}) -> Engines:
    """The engines, with these sources of modules instead of their own.

    An engine that raises an error says :data:`NOTHING`: compiled it would go on, somewhere.
    """
    modules: dict[str, dict[str, Any]] = {"compiling": WORDS}
    for name in MODULES:
        source = changed.get(name) or FOLDER.joinpath(f"{name}.py").read_text(encoding="utf-8")
        modules[name] = _namespace(source, modules)
    modules["runs"]["play"] = modules["runs"]["_meet"]
    return Engines(_safe(_walk(modules)), _safe(_judge(modules)))


def _safe(engine_: Callable[..., Sums]) -> Callable[..., Sums]:
    def does(*question: Any, **options: Any) -> Sums:
        try:
            return engine_(*question, **options)
        except (ArithmeticError, AttributeError, LookupError, TypeError, ValueError):
            return NOTHING

    return does


def _namespace(source: str, modules: dict[str, dict[str, Any]]) -> dict[str, Any]:
    """The names of a module, which imports from these modules what is interpreted."""
    tree = ast.parse(source)
    names: dict[str, Any] = {}
    kept = []
    for each in tree.body:
        module = each.module or "" if isinstance(each, ast.ImportFrom) else ""
        inner = modules.get(module.removeprefix(f"{KERNEL}."))
        if inner is not None:
            assert isinstance(each, ast.ImportFrom)
            names |= {other.asname or other.name: inner[other.name] for other in each.names}
        else:
            kept.append(each)
    tree.body = kept
    exec(compile(tree, "kernel", "exec"), names)
    if "laws" in modules:
        names["laws"] = SimpleNamespace(**modules["laws"])
    return names


def plain(kind: np.dtype[Any]) -> Any:
    """A record of the kind in plain Python, all zero; arrays of two dimensions stay arrays."""
    if kind.subdtype is not None:
        inner, shape = kind.subdtype
        if len(shape) == 2:
            return np.zeros(shape, np.int64)
        return _Zeros() if shape[0] > 1000 else [plain(inner) for _ in range(shape[0])]
    if kind.names is None:
        return 0
    return SimpleNamespace(**{name: plain(kind.fields[name][0]) for name in kind.names})


def _with(function: Any, **names: Any) -> Any:
    """The function of the engine, which means others by these names."""
    again = FunctionType(function.__code__, {**function.__globals__, **names}, function.__name__)
    again.__kwdefaults__ = function.__kwdefaults__
    return again


def _walk(modules: dict[str, dict[str, Any]]) -> Callable[..., Sums]:
    return _with(  # type: ignore[no-any-return]  # as the kernel
        engine.walk,
        walks=SimpleNamespace(**modules["demand_driven"]),
        new=plain,
        array=lambda values, _type: list(map(int, values)),
    )


def _judge(modules: dict[str, dict[str, Any]]) -> Callable[..., Sums]:
    worlds, robots = modules["worlds"], modules["algorithm1"]

    def explorer(name: str) -> tuple[Any, Any, Any]:
        kind = "" if name == "algorithm1" else "_undirected"
        return robots[f"start{kind}"], robots[f"step{kind}"], robots["answer"]

    set_up = _with(
        engine.set_up,
        lighthouse_address=lambda kind: worlds[kind.replace("-", "_")],
        rule_address=lambda: worlds["rule"],
        explorer_addresses=explorer,
        asarray=lambda robot: SimpleNamespace(ctypes=SimpleNamespace(data=robot)),
    )

    def judge(level: Level, prefix: Sequence[int], *, keep: int = 1) -> Sums:
        job, robot = plain(JOB), plain(ROBOT)
        set_up(job, robot, level)
        arrays = engine.unit_of(level, prefix, keep)
        own = {"prefix": [*map(int, prefix)], "budgets": [*level.budgets]}
        unit = UnitArrays(**{**arrays._asdict(), **own})
        modules["runs"]["examine"](job, job.explorer, unit, [0])
        robot.events = np.array(robot.events)
        return engine.sums_of(unit, job, robot)

    return judge


# ---- What the engines are asked ----


class Question(NamedTuple):
    """A question to an engine."""

    engine: str
    level: Level
    prefix: tuple[int, ...]
    keep: int = 1

    def answered(self, engines: Engines) -> Sums:
        """The rows."""
        does: Callable[..., Sums] = getattr(engines, self.engine)
        return does(self.level, self.prefix, keep=self.keep)


COMPILED = Engines(engine.walk, engine.judge)


def small_questions(policy: str) -> Iterator[Question]:
    """Questions about worlds with at most 4 edges: what quick tests and each check compare."""
    for m in range(1, 5):
        level = asked(m, policy=policy)
        table = [[[m * n - 2]] for n in range(m + 2)]
        broken = replace(level, bounds=table)
        starved = replace(level, budgets=(2 * m,) * (m + 2))
        few = asked(m, policy=policy, vertices=2)
        for prefix in prefixes(m, depth=1):
            for each in (level, broken, starved):
                yield Question("walk", each, prefix, keep=3)
            yield Question("judge", level, prefix)
            if m < 4:
                yield Question("judge", broken, prefix, keep=3)
                yield Question("judge", starved, prefix, keep=3)
        for prefix in prefixes(m, vertices=2, depth=1):
            yield Question("walk", few, prefix)
            yield Question("judge", few, prefix)
    for kind in MapClass:
        for m in range(1, 5 if kind.simple else 4):
            for prefix in prefixes(m, kind, depth=1):
                yield Question("judge", asked(m, kind, policy=policy), prefix)
    for m in range(1, 4):
        by_degrees = asked(m, policy=policy, bound="n + D - d0")
        for prefix in prefixes(m, depth=1):
            yield Question("judge", by_degrees, prefix, keep=3)
    yield from _others(policy)


def _others(policy: str) -> Iterator[Question]:
    """Other explorers and lighthouses, also where an explorer goes wrong."""
    for explorer in EXPLORERS:
        for lighthouse in sorted(LIGHTHOUSES):
            simple = lighthouse in ("cluster-single", "natural")
            for m in range(1, 5 if simple else 4 if lighthouse == "compass" else 3):
                kind = MapClass.SIMPLE if simple else MapClass.MAPS
                level = replace(
                    asked(m, kind, policy=policy, bound="none"),
                    explorer=explorer,
                    lighthouse=lighthouse,
                    budgets=(60,) * (m + 2),
                )
                for prefix in prefixes(m, kind, depth=1):
                    yield Question("judge", level, prefix, keep=4)


def asked(
    edges: int,
    kind: MapClass = MapClass.MAPS,
    *,
    policy: str,
    vertices: int | None = None,
    bound: str = "paper",
) -> Level:
    """The question of a level of Algorithm 1."""
    rules = Rules(policy=policy, bound=bound)
    return level_of("algorithm1", rules, Extent(kind, edges, vertices), edges)


def sampled_questions(policy: str) -> Iterator[Question]:
    """Questions about the units that ``certified.py --sample`` draws."""
    from certified_sample import MOST, UNITS, units_drawn

    for piece in islice(units_drawn(0, policy, MOST), UNITS // len(POLICIES)):
        yield Question("walk", piece.level(policy), piece.unit.prefix)


_ANSWERS = "        action.kind = names.ANSWER_READY"
_SHOWS_AGAIN = """\
        if robot.tried != 99:
            robot.tried, robot.goal = 99, robot.alpha[0]
            action.kind = names.CHECKPOINT
            return
        robot.alpha[0] = robot.goal
        action.kind = names.ANSWER_READY"""
_WITH_AN_OPEN_DART = _SHOWS_AGAIN.replace(
    "= 99, robot.alpha[0]", "= 99, robot.alpha[0]\n            robot.alpha[0] = 0"
)
_HERE = "= robot.darts, robot.here"
_HALF_OPEN_AT_LAST = """
    if robot.known == 0:
        other = robot.alpha[robot.goal]
        robot.alpha[other] = robot.goal if robot.tried == 99 else other
        robot.tried = 99"""
_WITH_ONE_BEYOND = _WITH_AN_OPEN_DART.replace("robot.alpha[0] = 0", "robot.alpha[0] = 99")

WRONG_ROBOTS = (
    ("    _explore(robot, goal, partner)\n", "    _explore(robot, goal, goal)\n"),
    (_HERE, "= robot.darts, (robot.here + 1) % robot.darts"),
    (_HERE, "= robot.darts - 2, robot.here"),
    (_HERE, f"{_HERE}{_HALF_OPEN_AT_LAST}"),
    ("robot.turned = -robot.motions[robot.done]", "robot.turned = robot.motions[robot.done]"),
    (_ANSWERS, "        action.kind = names.DROP"),
    (_ANSWERS, _SHOWS_AGAIN),
    (_ANSWERS, _WITH_AN_OPEN_DART),
    (_ANSWERS, _WITH_ONE_BEYOND),
)
"""Changes of Algorithm 1 after which it breaks laws: what the judge says of it is compared."""


def _robots_apart(changed: Mapping[str, str], policy: str) -> str:
    """The first question about a wrong robot that is answered otherwise after a change."""
    source = changed.get("algorithm1", FOLDER.joinpath("algorithm1.py").read_text(encoding="utf-8"))
    for number, (before, after) in enumerate(WRONG_ROBOTS):
        robot = {"algorithm1": source.replace(before, after, 1)}
        right, wrong = interpreted(robot), interpreted({**changed, **robot})
        for m in range(1, 4):
            every = replace(asked(m, policy=policy), budgets=(40,) * (m + 2))
            for level in (every, replace(every, laws=("variant",))):
                for prefix in prefixes(m, depth=1):
                    if right.judge(level, prefix, keep=9) != wrong.judge(level, prefix, keep=9):
                        return f"small judge {policy} {m}:{prefix}, wrong robot {number}"
    return ""


def seen(changed: Mapping[str, str], policies: Iterable[str] = POLICIES) -> str:
    """By what wrong engines are seen: the small questions, the sample; empty: by nothing."""
    engines = interpreted(changed)
    for name, questions in (("small", small_questions), ("sample", sampled_questions)):
        for policy in policies:
            for each in questions(policy):
                if each.answered(engines) != each.answered(COMPILED):
                    return f"{name} {each.engine} {policy} {each.level.edges}:{each.prefix}"
            if name == "small" and (found := _robots_apart(changed, policy)):
                return found
    return ""
