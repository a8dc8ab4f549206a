"""The compiled search of the optimum beside its readable twin, and bounds from both sides."""

from functools import cache
from random import Random

import pytest
from allworlds.studies.optimum.bouquets import bouquets, cautious_cost, told_apart
from allworlds.studies.optimum.bracket import WIDEST, Bracket
from allworlds.studies.optimum.fewest_traversals import Search
from allworlds.studies.optimum.in_every_world import most_expensive
from allworlds.studies.optimum.knowledge import Places
from allworlds.studies.optimum.place_tables import place_table
from allworlds.studies.optimum.strategy_making import made_strategy

from allworlds.engines import MinimaxSearch, TimeIsUp, tables_of
from allworlds.world import worlds
from small import long


def nothing():
    pass


def everything(edges):
    return [world for world in worlds(edges=edges, places="all") if world.map.edge_count == edges]


GIVEN = {
    "bouquets with 2 loops": (lambda: [*bouquets(2)], told_apart),
    "bouquets with 3 loops": (lambda: [*bouquets(3)], told_apart),
    "the same, nothing known before": (lambda: [*bouquets(3)], None),
    "all worlds with 2 edges": (lambda: everything(2), None),
    "all worlds with 3 edges": (lambda: everything(3), None),
}


@cache
def tried(name):
    """Places, the states at the start, and the table."""
    made, told = GIVEN[name]
    places = Places()
    given = [places.number(w.map, w.start, w.lighthouse.dart) for w in made()]
    starts = places.parted(given)
    return places, starts, place_table(places, told, nothing)


@cache
def twin_of_worlds(same):
    """The twin, whose bounds all tests use."""
    return Search(tried(same)[0])


def twin_of(name):
    """The twin for these worlds; whatever is known before, places have the same numbers."""
    return twin_of_worlds("bouquets with 3 loops" if "nothing known" in name else name)


NAMES = [long(name) if "3 loops" in name or "nothing" in name else name for name in GIVEN]


def states(name, number):
    """States of knowledge: those at the start, and drawn ones in which one percept is sensed."""
    places, starts, _ = tried(name)
    random = Random(name)
    found = [part.known for part in starts]
    for _ in range(number):
        drawn = random.sample(range(len(places.places)), 8)
        found += [part.known for part in places.parted(drawn)]
    return [known for known in found if not places.settled(known)]


@pytest.mark.parametrize("name", NAMES)
def test_the_compiled_search_says_the_same_as_its_twin(name):
    places, _, table = tried(name)
    twin, compiled = twin_of(name), MinimaxSearch(tables_of(table))
    for known in states(name, 20):
        value = twin.value(known)
        for most in range(value + 3):
            assert compiled.within(known, most, nothing) == (most >= value), (known, most)
        enough, motion = compiled.motion(known, value, nothing)
        assert enough == value
        parts = places.moved(known, motion)
        assert max(twin.value(part.known) for part in parts) == value - 1


@pytest.mark.parametrize("name", NAMES)
def test_a_search_that_is_stopped_at_every_state_says_the_same(name):
    _, _, table = tried(name)
    straight, stopped = MinimaxSearch(tables_of(table)), MinimaxSearch(tables_of(table))
    for known in states(name, 10):
        for most in range(6):
            answer = stopped.ask(known, most)
            while answer is None:
                answer = stopped.go_on(1)
            assert answer == straight.within(known, most, nothing)
    assert stopped.states == straight.states


@pytest.mark.parametrize("name", NAMES)
def test_what_a_narrow_search_finds_is_enough(name):
    _, _, table = tried(name)
    twin = twin_of(name)
    for width in range(1, WIDEST + 1):
        narrow = MinimaxSearch(tables_of(table), width)
        for known in states(name, 8):
            value = twin.value(known)
            assert not any(narrow.within(known, most, nothing) for most in range(value))


@pytest.mark.parametrize("limit", [lambda percept, left: left, lambda percept, left: 2 * left])
def test_a_limit_that_is_too_low_is_noticed(limit):
    places, starts, _ = tried("bouquets with 3 loops")
    wrong = MinimaxSearch(tables_of(place_table(places, limit, nothing)))
    assert not wrong.within(starts[0].known, 9, nothing)


def test_places_that_are_taken_for_mirror_images_are_noticed():
    _, _, table = tried("all worlds with 3 edges")
    least = int(tables_of(table).random[:, 0].argmin())
    wrong = MinimaxSearch(tables_of(table._replace(mirror=[least] * len(table.mirror))))
    twin = twin_of("all worlds with 3 edges")
    said = [
        wrong.within(known, most, nothing) == twin.within(known, most)
        for known in states("all worlds with 3 edges", 40)
        for most in range(6)
    ]
    assert not all(said)


@pytest.mark.parametrize("name", NAMES)
def test_the_strategies_of_both_cost_what_the_search_says(name):
    places, starts, table = tried(name)
    twin = twin_of(name)
    value = max(twin.value(part.known) for part in starts)
    bracket = Bracket(table, [part.known for part in starts], 0, 40)
    bracket.close(nothing)
    assert bracket.at_least == bracket.at_most == value
    for motion in (twin.motion, bracket.motion):
        made = made_strategy(places, starts, value, motion)
        assert made.cost == most_expensive(made.strategy, GIVEN[name][0]()) == value


# 16: found by an independent program, too (1,412 states there).
@pytest.mark.parametrize(("loops", "best"), [(2, 4), (3, 9), (4, 16)])
def test_the_optimum_of_bouquets(loops, best):
    made = bracket_of(loops)
    made.close(nothing)
    assert (made.at_least, made.at_most) == (best, best)


def bracket_of(loops):
    places = Places()
    given = [places.number(w.map, w.start, w.lighthouse.dart) for w in bouquets(loops)]
    (start,) = places.parted(given)
    table = place_table(places, told_apart, nothing)
    return Bracket(table, [start.known], 0, cautious_cost(loops))


# The optimum is 26; see docs/figures/optimum-bouquets.csv.
@pytest.mark.slow
@pytest.mark.long
def test_the_bounds_of_five_loops_hold_whenever_the_search_is_stopped():
    made, seen = bracket_of(5), set()

    def tick():
        seen.add((made.at_least, made.at_most))
        if made.at_least == 24 and made.at_most == 26:
            raise TimeIsUp

    with pytest.raises(TimeIsUp):
        made.close(tick)
    assert all(least <= 26 and (most is None or most >= 26) for least, most in seen)
    assert made.motion(made._starts[0], 26)
