"""The form of a result in a run directory, which follows from the types of its fields."""

import json
from collections import Counter

import pytest
from msgspec import Struct

from allworlds import check
from allworlds.documents.document import replace
from allworlds.engines.kept_units import from_kept, to_kept
from allworlds.engines.kernel.schedules import ScheduleCosts
from allworlds.engines.tally import AtRun, Row, Tally
from allworlds.inputs.checks import InputError
from allworlds.maps import Quotient, named_map
from allworlds.protocol.actions import Percept
from allworlds.studies.ambiguity.census_sweep import SensedParts
from allworlds.studies.compare.entrants import CostsOfAll, CostTally
from allworlds.studies.count import Counted
from allworlds.studies.worst.compiled_engine import ScheduleCostsBySize
from allworlds.world import Directional, World

ROW = Row(1, 2, 3, 4, 5, 6, -7, AtRun((0, 1), (1, 0), 0, (1,)))
HALF_EDGE = Quotient((0,), (0,), (3,), (Percept(3, 1),), 4)


def tally(kind=Tally):
    (finding,) = check(edges=2, bound="m", max_findings=1, engine="python").findings
    return kind(
        1,
        {(1, 2): ROW},
        Counter({"loop-edge": 2}),
        3,
        4,
        [replace(finding, machine=True)],
        Counter({"a remark": 1}),
    )


def costs():
    found = tally(CostTally)
    found.costs[1, 2, (0, 1), (1, 0)] = {0: 3}
    return found


RESULTS = {
    "counted": lambda: Counted(Counter({(2, 0): 3}), Counter({(2, 0): 4})),
    "parts": lambda: SensedParts(5, {"a": (2, 1)}, {"look": "a"}, {("a", "b")}, {"look": 3}),
    "schedules": lambda: ScheduleCostsBySize({2: ScheduleCosts(2, 1, 3, 2, 1, 0, (0, 1), (1, 0))}),
    "tally": tally,
    "costs": costs,
    "side by side": lambda: CostsOfAll({0: costs(), 2: CostTally(1)}),
}


@pytest.fixture(params=RESULTS)
def result(request):
    return RESULTS[request.param]()


def test_what_is_kept_is_read_back(result):
    again = from_kept(json.loads(json.dumps(to_kept(result))), type(result))
    assert type(again) is type(result)
    assert json.dumps(to_kept(again)) == json.dumps(to_kept(result))
    for found, told in zip(
        getattr(again, "findings", ()), getattr(result, "findings", ()), strict=True
    ):
        assert (found.key, found.machine) == (told.key, told.machine)


def damaged(value):
    """The value with one part of it gone, added, or of another type, each way once."""
    if isinstance(value, dict):
        for key, inner in value.items():
            yield {name: other for name, other in value.items() if name != key}
            yield from ({**value, key: broken} for broken in damaged(inner))
        yield {**value, "another key": 0}
    elif isinstance(value, list):
        for i, inner in enumerate(value[:3]):
            yield from ([*value[:i], broken, *value[i + 1 :]] for broken in damaged(inner))
    if not isinstance(value, dict):
        yield {"no": "such thing"}


@pytest.mark.parametrize("name", ["counted", "schedules"])
def test_what_is_damaged_is_refused(name):
    result = RESULTS[name]()
    for told in damaged(json.loads(json.dumps(to_kept(result)))):
        with pytest.raises(InputError):
            from_kept(told, type(result))


@pytest.mark.parametrize("name", ["parts", "tally", "costs", "side by side"])
def test_of_what_is_larger_every_field_is_checked(name):
    result = RESULTS[name]()
    whole = json.loads(json.dumps(to_kept(result)))
    for told in [None, [], {}, {**whole, "more": 0}, *({**whole, key: 1.5} for key in whole)]:
        with pytest.raises(InputError):
            from_kept(told, type(result))


class Pairs(Struct):
    """A result of pairs, and of a world that reads itself."""

    pairs: dict[tuple[int, int], int]
    world: World


def test_what_reads_itself_is_kept_as_it_writes_itself():
    pairs = Pairs({(1, 2): 3}, World(named_map("edge"), Directional(0)))
    told = json.loads(json.dumps(to_kept(pairs)))
    assert told["world"] == pairs.world.to_json()
    assert from_kept(told, Pairs) == pairs


class Line(Struct):
    """A result with pairs of an entry that msgspec cannot read."""

    lines: list[tuple[World, int]]


def test_a_tuple_has_as_many_entries_as_it_says():
    world = World(named_map("edge"), Directional(0))
    told = json.loads(json.dumps(to_kept(Line([(world, 3)]))))
    assert from_kept(told, Line) == Line([(world, 3)])
    for wrong in ([[told["lines"][0][0]]], [[*told["lines"][0], 4]]):
        with pytest.raises(InputError, match=r" does not have 2 entries$"):
            from_kept({"lines": wrong}, Line)
