"""The lighthouses without a direction: v0 and a neighbour v1, by markers or by their degrees."""

from collections import Counter
from random import Random

import pytest

from allworlds.maps import from_cycles, named_map
from allworlds.protocol.actions import Drop, Percept
from allworlds.world import LIGHTHOUSES, Cluster, IllegalAction, InvalidWorld, Natural, World
from allworlds.world.lighthouses.kinds import kind_of, lighthouse_kind
from small import LASSO, PATH, all_maps, stepped

SINGLE = lighthouse_kind("cluster:single=true").as_class
KINDS = [Cluster, SINGLE, Natural]
DOUBLE = named_map("theta")


def worlds(kind, largest=4):
    return [World(map_, place) for map_ in all_maps(largest) for place in kind.places(map_, 0)]


def graph(map_):
    """Which vertices are joined how often, v0's neighbours, and all degrees, from the edges."""
    owner, around = {}, 0
    for dart in map_.darts:
        if dart not in owner:
            other = dart
            while other not in owner:
                owner[other] = around
                other = map_.sigma[other]
            around += 1
    ends = [(owner[d], owner[e]) for d, e in map_.edges]
    degrees = Counter(v for pair in ends for v in pair)
    beyond = Counter(b if a == owner[0] else a for a, b in ends if a != b and owner[0] in (a, b))
    return owner, degrees, beyond


def alone(degrees, vertex):
    """No other vertex has its degree."""
    return list(degrees.values()).count(degrees[vertex]) == 1


def test_a_cluster_has_a_place_for_each_dart_that_leads_away_from_v0():
    for map_ in all_maps(4):
        _, _, beyond = graph(map_)
        places = list(Cluster.places(map_, 0))
        assert len(set(places)) == len(places) == beyond.total()


def test_a_single_cluster_has_a_place_for_each_neighbour_that_one_edge_joins_to_v0():
    for map_ in all_maps(4):
        owner, _, beyond = graph(map_)
        places = list(SINGLE.places(map_, 0))
        reached = [owner[map_.alpha[place.dart]] for place in places]
        assert sorted(reached) == sorted(v for v, times in beyond.items() if times == 1)
        assert {Cluster(place.dart) for place in places} <= {*Cluster.places(map_, 0)}


def test_a_natural_lighthouse_has_a_place_for_each_neighbour_if_both_degrees_are_unique():
    for map_ in all_maps(4):
        owner, degrees, beyond = graph(map_)
        wanted = [v for v in beyond if alone(degrees, owner[0]) and alone(degrees, v)]
        places = list(Natural.places(map_, 0))
        assert sorted(owner[map_.alpha[place.dart]] for place in places) == sorted(wanted)
        assert {place.told(map_) for place in places} == {degrees[v] for v in wanted}


@pytest.mark.parametrize("kind", KINDS)
def test_places_come_clockwise_from_the_start(kind):
    for map_ in all_maps(3):
        for start in map_.darts:
            bearings = [map_.offset(start, p.dart) for p in kind.places(map_, start)]
            assert bearings == sorted(set(bearings))


def test_a_natural_lighthouse_stands_at_the_first_dart_to_its_neighbour():
    for world in worlds(Natural):
        map_, found = world.map, world.lighthouse.dart
        v1 = map_.vertex_of[map_.alpha[found]]
        earlier = range(map_.offset(0, found))
        assert all(map_.vertex_of[map_.alpha[map_.turn(0, k)]] != v1 for k in earlier)


@pytest.mark.parametrize("kind", KINDS)
def test_places_have_the_same_order_whatever_the_darts_are_called(kind):
    random = Random(4)
    for map_ in all_maps(4)[::5]:
        names = list(map_.darts)
        random.shuffle(names)
        renamed = [place.relabelled(names) for place in kind.places(map_, 0)]
        assert renamed == list(kind.places(map_.relabelled(names), names[0]))


def test_a_cluster_is_one_mark_at_v0_and_two_at_v1_and_no_bearing():
    for world in worlds(Cluster):
        owner, degrees, _ = graph(world.map)
        v1 = owner[world.map.alpha[world.lighthouse.dart]]
        for dart in world.map.darts:
            marks = {owner[world.start]: 1, v1: 2}.get(owner[dart], 0)
            assert world.percepts[dart] == Percept(degrees[owner[dart]], marks, None)
        assert world.told is None


def test_under_a_natural_lighthouse_only_the_degree_is_sensed_and_that_of_v1_is_told():
    for world in worlds(Natural):
        owner, degrees, _ = graph(world.map)
        assert world.percepts == tuple(Percept(degrees[owner[d]]) for d in world.map.darts)
        assert world.told == degrees[owner[world.map.alpha[world.lighthouse.dart]]]
        # What the explorer can rely on: the two degrees tell where it is.
        seen = {v for v in degrees if degrees[v] in (world.first.degree, world.told)}
        assert len(seen) == 2


@pytest.mark.parametrize("kind", KINDS)
def test_relabelling_the_darts_changes_no_percept(kind):
    random = Random(1)
    for world in worlds(kind)[::3]:
        names = list(world.map.darts)
        random.shuffle(names)
        renamed = world.relabelled(names)
        assert renamed.told == world.told
        for dart in world.map.darts:
            assert renamed.percepts[names[dart]] == world.percepts[dart]


@pytest.mark.parametrize("kind", KINDS)
def test_json_goes_there_and_back_and_its_options_are_keys_beside_the_kind(kind):
    options = {"single": True} if kind is SINGLE else {}
    for world in worlds(kind, 3):
        document, dart = world.to_json(), world.lighthouse.dart
        assert document["lighthouse"] == {"kind": kind.kind, "dart": dart, **options}
        assert World.from_json(document) == world


def test_no_marker_can_be_taken_or_laid():
    for kind in (Cluster, Natural):
        with pytest.raises(IllegalAction, match=f"the {kind.kind} lighthouse gives no markers"):
            stepped(worlds(kind, 2)[0], 0, Drop())


# ---------------------------------------------------------------- default places, and none


@pytest.mark.parametrize("kind", ["cluster", "cluster:single=true", "natural"])
def test_without_a_dart_a_lighthouse_stands_at_its_first_place(kind):
    document = LASSO.to_json()
    assert World.from_json(document, missing=kind).lighthouse.dart == 2
    name, _, single = kind.partition(":")
    told = {"kind": name, "single": True} if single else {"kind": name}
    assert World.from_json({**document, "lighthouse": told}).lighthouse.dart == 2


def test_a_single_cluster_passes_over_a_neighbour_with_two_edges():
    # v0 is joined to a by two edges, and to b by one.
    map_ = from_cycles(["abc", "ab", "c"])
    assert World.from_json(map_.to_json(), missing="cluster").lighthouse.dart == 0
    assert World.from_json(map_.to_json(), missing="cluster:single=true").lighthouse.dart == 2


@pytest.mark.parametrize(
    ("map_", "kind"),
    [
        (named_map("loop"), "cluster"),
        (DOUBLE, "cluster:single=true"),
        (DOUBLE, "natural"),
        (PATH, "natural"),
    ],
)
def test_a_world_without_a_place_is_named(map_, kind):
    assert not list(lighthouse_kind(kind).as_class.places(map_, 0))
    with pytest.raises(InvalidWorld, match=f"lighthouse {kind} has no place .* start 0"):
        World.from_json(map_.to_json(), missing=kind)


# ---------------------------------------------------------------- options


def test_options_choose_places_and_nothing_else():
    for name in ("cluster:single=false", "cluster"):
        assert lighthouse_kind(name).as_class is Cluster
    assert issubclass(SINGLE, Cluster)
    assert (SINGLE.kind, SINGLE.default_bound, SINGLE.folds) == ("cluster", "none", False)
    assert all(type(world.lighthouse) is Cluster for world in worlds(SINGLE, 3))


@pytest.mark.parametrize(
    ("text", "named"),
    [
        ("cluster:single=maybe", "option single = 'maybe' is neither true nor false"),
        ("cluster:single=", "option single = '' is neither true nor false"),
        ("cluster:twins=true", "has no option 'twins'; legal: single"),
        ("cluster:single", "'single' .* is not of the form key=value"),
        ("cluster:", "'' .* is not of the form key=value"),
        ("cluster:single=true,single=false", "names 'single' twice"),
        ("natural:single=true", "the lighthouse 'natural' has no option 'single'; it has none"),
        (
            "clusters",
            f"'clusters' is not one of {', '.join(LIGHTHOUSES)}, path/to/file.py:",
        ),
    ],
)
def test_an_option_that_is_none_is_named(text, named):
    with pytest.raises(InvalidWorld, match=named):
        lighthouse_kind(text)


# ---------------------------------------------------------------- what does not fit


@pytest.mark.parametrize(
    ("map_", "lighthouse", "named"),
    [
        (LASSO, {"kind": "cluster", "dart": 0}, "cannot stand at dart .* legal are 2"),
        (LASSO, {"kind": "natural", "dart": 1}, "cannot stand at dart .* legal are 2"),
        (LASSO, {"kind": "cluster", "dart": 3}, "dart 3 with start 0; legal are 2"),
        (LASSO, {"kind": "natural", "dart": 9}, "dart 9 with start 0; legal are 2"),
        (LASSO, {"kind": "cluster", "dart": "0"}, "lighthouse.dart = '0' is not an integer"),
        (LASSO, {"kind": "natural", "dart": True}, "lighthouse.dart = True is not an integer"),
        (named_map("loop"), {"kind": "cluster", "dart": 0}, "legal are none"),
        (PATH, {"kind": "natural", "dart": 0}, "natural cannot stand at dart 0 .*legal are none"),
        (
            named_map("star-4"),
            {"kind": "natural", "dart": 0},
            "legal are none",
        ),
        (
            DOUBLE,
            {"kind": "cluster", "dart": 0, "single": True},
            "cluster:single=true cannot stand at dart 0 .*legal are none",
        ),
        (DOUBLE, {"kind": "cluster", "dart": 0, "single": 1}, "single = 1 is neither"),
        (DOUBLE, {"kind": "cluster:single=true", "dart": 0}, "is more than a name; its options"),
    ],
)
def test_a_lighthouse_that_does_not_fit_is_named(map_, lighthouse, named):
    with pytest.raises(InvalidWorld, match=named):
        World.from_json({**map_.to_json(), "lighthouse": lighthouse})


def test_a_world_keeps_the_word_single():
    document = {**LASSO.to_json(), "lighthouse": {"kind": "cluster", "dart": 2, "single": True}}
    world = World.from_json(document)
    assert world == World(LASSO, Cluster(2, single=True)) != World(LASSO, Cluster(2))
    assert world.to_json() == {**document, "start": 0}
    assert str(kind_of(world.lighthouse)) == "cluster:single=true"
    with pytest.raises(InvalidWorld, match="cluster:single=true cannot stand at dart 0"):
        World(DOUBLE, Cluster(0, single=True))


def test_any_dart_to_the_neighbour_will_do_for_a_natural_lighthouse():
    double = from_cycles(["ab", "abcde", "c", "d", "e"])
    first, second = (World(double, Natural(dart)) for dart in (0, 1))
    assert first.told == second.told == 5
    assert first.percepts == second.percepts
    assert [place.dart for place in Natural.places(double, 0)] == [0]
