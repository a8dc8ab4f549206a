import json
from random import Random

import networkx as nx
import pytest

from allworlds.inputs.checks import InputError, show
from allworlds.maps import InvalidMap, from_cycles, from_networkx, named_map, rooted_maps
from allworlds.protocol.actions import Drop, Move, Percept, Pick
from allworlds.world import LIGHTHOUSES, Directional, IllegalAction, InvalidWorld, World
from allworlds.world.lighthouses.kinds import lighthouse_from_json, lighthouse_kind
from small import EDGE, PATH, stepped

DOCUMENT = {"sigma": [0, 2, 1, 3], "alpha": [1, 0, 3, 2]}
HUGE = 10**5000  # more digits than Python turns into text by default


def small_worlds(largest=3):
    for m in range(1, largest + 1):
        for map_ in rooted_maps(m):
            for place in Directional.places(map_, 0):
                yield World(map_, place)


def walked(map_, dart, k):
    """sigma k times (k >= 0), or its inverse, one dart at a time; then across the edge."""
    for _ in range(abs(k)):
        dart = map_.sigma[dart] if k >= 0 else map_.sigma.index(dart)
    return map_.alpha[dart]


def at_v0(world):
    dart, cycle = world.start, set()
    while dart not in cycle:
        cycle.add(dart)
        dart = world.map.sigma[dart]
    return cycle


def naive_percept(world, dart):
    degree, other = 1, world.map.sigma[dart]
    while other != dart:
        degree, other = degree + 1, world.map.sigma[other]
    if dart not in at_v0(world):
        return Percept(degree, 0, None)
    bearing, other = 0, dart
    while other != world.lighthouse.dart:
        bearing, other = bearing + 1, world.map.sigma[other]
    return Percept(degree, 1, bearing)


def test_the_bearing_is_the_offset_from_the_dart_arrived_by_to_the_pointed_dart():
    for world in small_worlds():
        assert world.percepts == tuple(naive_percept(world, d) for d in world.map.darts)
        assert world.first == naive_percept(world, world.start)


def test_there_is_one_place_for_each_bearing_in_ascending_order():
    for m in (1, 2, 3):
        for map_ in rooted_maps(m):
            places = list(Directional.places(map_, 0))
            bearings = [World(map_, place).first.bearing for place in places]
            assert bearings == list(range(map_.degree_at[0]))


def test_places_stand_at_the_vertex_of_any_start():
    for start in PATH.darts:
        for place in Directional.places(PATH, start):
            assert PATH.vertex_of[place.dart] == PATH.vertex_of[start]


def test_a_step_leaves_by_the_kth_dart_clockwise_and_arrives_at_its_other_end():
    for world in small_worlds():
        for dart in world.map.darts:
            for k in range(-7, 8):
                arrived, percept = stepped(world, dart, Move(k))
                assert arrived == walked(world.map, dart, k)
                assert percept == naive_percept(world, arrived)


def test_motion_zero_goes_back_and_k_counts_modulo_the_degree():
    for world in small_worlds():
        for dart in world.map.darts:
            degree = world.percepts[dart].degree
            assert stepped(world, dart, Move(0))[0] == world.map.alpha[dart]
            for k in (1, -1, HUGE):
                assert stepped(world, dart, Move(k)) == stepped(world, dart, Move(k % degree))


@pytest.mark.parametrize("seed", range(8))
def test_motion_is_reversible(seed):
    random = Random(seed)
    for world in small_worlds():
        motions = [random.randrange(-9, 10) for _ in range(random.randrange(1, 9))]
        dart = start = random.choice(world.map.darts)
        for k in motions:
            dart, _ = stepped(world, dart, Move(k))
        for k in [0, *(-k for k in motions[:0:-1])]:
            dart, _ = stepped(world, dart, Move(k))
        assert world.map.turn(dart, -motions[0]) == start


def test_a_step_changes_nothing_in_the_world():
    for world in small_worlds(2):
        before = World.from_json(world.to_json())
        for dart in world.map.darts:
            assert stepped(world, dart, Move(1)) == stepped(world, dart, Move(1))
        assert world == before


@pytest.mark.parametrize("action", [Drop(), Pick(), 1, None, "move"])
def test_a_directional_world_knows_moves_only(action):
    with pytest.raises(IllegalAction, match="directional lighthouse gives no markers"):
        stepped(World(EDGE, Directional(0)), 0, action)


def test_a_subclass_of_move_is_no_move_of_the_world():
    class Jump(Move):
        pass

    with pytest.raises(IllegalAction):
        stepped(World(EDGE, Directional(0)), 0, Jump(0))


def test_the_directional_lighthouse_tells_nothing_before_the_start():
    assert World(EDGE, Directional(0)).told is None


@pytest.mark.parametrize("seed", range(5))
def test_relabelling_the_darts_changes_no_percept(seed):
    random = Random(seed)
    for world in small_worlds():
        names = list(world.map.darts)
        random.shuffle(names)
        renamed = world.relabelled(names)
        assert renamed.first == world.first
        assert renamed.start == names[world.start]
        for dart in world.map.darts:
            assert renamed.percepts[names[dart]] == world.percepts[dart]
            for k in range(3):
                arrived, percept = stepped(world, dart, Move(k))
                assert stepped(renamed, names[dart], Move(k)) == (names[arrived], percept)


def test_a_relabelling_that_is_no_permutation_is_refused():
    with pytest.raises(ValueError, match="no permutation"):
        World(EDGE, Directional(0)).relabelled([0, 0])


def test_the_mirrored_world_takes_motions_and_bearings_the_other_way_round():
    for world in small_worlds():
        mirrored = world.mirrored()
        assert mirrored.mirrored() == world
        for dart in world.map.darts:
            here, there = world.percepts[dart], mirrored.percepts[dart]
            assert (there.degree, there.marks) == (here.degree, here.marks)
            if here.bearing is not None:
                assert there.bearing == -here.bearing % here.degree
            for k in range(3):
                assert stepped(mirrored, dart, Move(k))[0] == stepped(world, dart, Move(-k))[0]


def test_json_goes_there_and_back_as_a_document_and_as_text():
    for world in small_worlds():
        for start in at_v0(world):
            moved = World(world.map, world.lighthouse, start)
            assert World.from_json(moved.to_json()) == moved
            assert World.from_json(json.dumps(moved.to_json())) == moved


def test_json_names_the_four_parts():
    assert World(PATH, Directional(2), 1).to_json() == {
        **DOCUMENT,
        "start": 1,
        "lighthouse": {"kind": "directional", "dart": 2},
    }


def test_start_and_lighthouse_may_be_missing():
    assert World.from_json(DOCUMENT) == World(PATH, Directional(0), 0)
    assert World.from_json({**DOCUMENT, "start": 2}) == World(PATH, Directional(2), 2)
    document = {**DOCUMENT, "start": 1, "lighthouse": {"kind": "directional"}}
    assert World.from_json(document) == World(PATH, Directional(1), 1)


@pytest.mark.parametrize("key", ["start", "lighthouse"])
def test_null_is_not_missing(key):
    with pytest.raises(InvalidWorld, match=f"{key} = None"):
        World.from_json({**DOCUMENT, key: None})


@pytest.mark.parametrize(
    ("key", "document"),
    [
        ("strat", {**DOCUMENT, "strat": 1}),
        ("here", {**DOCUMENT, "here": 1}),
        ("drat", {**DOCUMENT, "lighthouse": {"kind": "directional", "drat": 0}}),
        ("darts", {**DOCUMENT, "lighthouse": {"kind": "directional", "darts": [0]}}),
        ("dart", {**DOCUMENT, "lighthouse": {"kind": "none", "dart": 0}}),
        ("dart", {**DOCUMENT, "lighthouse": {"kind": "compass", "dart": 0}}),
    ],
)
def test_an_unknown_key_is_refused_with_the_legal_ones(key, document):
    with pytest.raises(InvalidWorld, match=f"'{key}' is no key of a .*; legal are"):
        World.from_json(document)


def test_a_key_that_stands_twice_is_refused():
    text = '{"sigma": [0, 1], "alpha": [1, 0], "start": 0, "start": 1}'
    with pytest.raises(InvalidWorld, match="'start' stands twice"):
        World.from_json(text)


def directional(dart):
    return {"kind": "directional", "dart": dart}


@pytest.mark.parametrize(
    ("change", "named"),
    [
        ({"start": True}, "start = True"),
        ({"start": 1.0}, "start = 1.0"),
        ({"start": "1"}, "start = '1'"),
        ({"start": None}, "start = None"),
        ({"start": [1]}, r"start = \[1\]"),
        ({"start": 4}, r"start = 4 .*0\.\.3"),
        ({"start": -1}, r"start = -1 .*0\.\.3"),
        ({"lighthouse": directional(0), "start": 1}, "dart 0.*legal are 1, 2"),
        ({"lighthouse": directional(9)}, "dart 9.*legal are 0"),
        ({"lighthouse": directional(-1)}, "dart -1.*legal are 0"),
        ({"lighthouse": directional(dart=False)}, "lighthouse.dart = False"),
        ({"lighthouse": directional(0.0)}, "lighthouse.dart = 0.0"),
        ({"lighthouse": directional("0")}, "lighthouse.dart = '0'"),
        ({"lighthouse": directional(None)}, "lighthouse.dart = None"),
        ({"lighthouse": {"kind": "lamp"}}, "'lamp' is not one of .*directional"),
        ({"lighthouse": {"kind": ""}}, "'' is not one of .*directional"),
        ({"lighthouse": {"kind": "directional:x=1"}}, "is more than a name; its options are keys"),
        ({"lighthouse": {"kind": 3}}, "'kind', not {'kind': 3}"),
        ({"lighthouse": {}}, "'kind', not {}"),
        ({"lighthouse": "directional"}, "'kind', not 'directional'"),
        ({"lighthouse": [0]}, r"'kind', not \[0\]"),
        ({"lighthouse": False}, "'kind', not False"),
    ],
)
def test_a_bad_start_or_lighthouse_is_named(change, named):
    document = {**DOCUMENT, **change}
    for form in (document, json.dumps(document)):
        with pytest.raises(InvalidWorld, match=named) as caught:
            World.from_json(form)
        assert "\n" not in str(caught.value)


@pytest.mark.parametrize(
    ("change", "named"),
    [
        ({"sigma": None}, "'sigma' must be a list of darts, not None"),
        ({"alpha": "10"}, "'alpha' must be a list of darts, not '10'"),
        ({"sigma": [0, True, 2, 3]}, r"sigma\[1\] = True"),
        ({"sigma": [0, 2, 1.0, 3]}, r"sigma\[2\] = 1.0"),
        ({"alpha": [1, 0, 3, 9]}, r"alpha\[3\] = 9 .*0\.\.3"),
        ({"alpha": [1, 0, 3]}, "4 darts and alpha 3"),
        ({"sigma": [0, 1, 2, 3]}, "dart 2 cannot be reached"),
        ({"sigma": [], "alpha": []}, "not 0"),
    ],
)
def test_a_bad_map_is_named_before_anything_else(change, named):
    document = {**DOCUMENT, "start": "nowhere", **change}
    for form in (document, json.dumps(document)):
        with pytest.raises(InvalidMap, match=named):
            World.from_json(form)


def test_every_truncation_of_the_text_is_refused():
    text = json.dumps(World(PATH, Directional(2), 1).to_json())
    for end in range(len(text)):
        with pytest.raises(InvalidWorld, match="not JSON"):
            World.from_json(text[:end])


@pytest.mark.parametrize("text", ["[]", "3", "null", '"{}"', "true"])
def test_text_that_holds_no_object_is_refused(text):
    for form in (text, json.loads(text)):
        if form == "{}":  # text again, of an object this time
            continue
        with pytest.raises(InvalidWorld, match="a world is an object"):
            World.from_json(form)


@pytest.mark.parametrize("key", ["sigma", "alpha"])
def test_a_missing_permutation_is_named(key):
    document = {k: v for k, v in DOCUMENT.items() if k != key}
    with pytest.raises(InvalidMap, match=f"'{key}' is missing"):
        World.from_json(document)


@pytest.mark.parametrize(
    "change",
    [
        {"start": HUGE},
        {"lighthouse": directional(HUGE)},
        {"sigma": [0, HUGE, 1, 3]},
    ],
    ids=["start", "lighthouse", "sigma"],
)
def test_a_number_of_thousands_of_digits_is_refused_like_any_other(change):
    with pytest.raises((InvalidWorld, InvalidMap)):
        World.from_json({**DOCUMENT, **change})


def test_text_with_a_number_of_thousands_of_digits_is_refused():
    with pytest.raises((InvalidWorld, InvalidMap)):
        World.from_json('{"sigma": [0, 1], "alpha": [1, 0], "start": ' + "1" * 5000 + "}")


def test_text_that_is_nested_too_deeply_is_refused():
    with pytest.raises(InvalidWorld):
        World.from_json("[" * 100_000)


@pytest.mark.parametrize("start", [4, -1, "0", None])
def test_a_world_starts_at_a_dart(start):
    with pytest.raises(InvalidWorld, match=r"start = .* is (no dart|not an integer)"):
        World(PATH, Directional(0), start)


@pytest.mark.parametrize("dart", [1, 3, 4, -4, "0", None])
def test_a_lighthouse_points_to_a_dart_of_the_starts_vertex(dart):
    with pytest.raises(InvalidWorld, match=r"legal are 0|not an integer"):
        World(PATH, Directional(dart), 0)


@pytest.mark.parametrize(
    ("lighthouse", "start"),
    [
        (Directional(0), 0.0),
        (Directional(0), False),
        (Directional(0.0), 0),
        (Directional(dart=False), 0),
    ],
    ids=["float start", "bool start", "float dart", "bool dart"],
)
def test_equal_to_a_dart_is_not_enough_to_be_one(lighthouse, start):
    with pytest.raises(InvalidWorld):
        World(PATH, lighthouse, start)


def test_kinds_are_found_by_name():
    assert all(LIGHTHOUSES[kind.kind] is kind for kind in LIGHTHOUSES.values())
    assert lighthouse_kind("directional").as_class is Directional
    assert lighthouse_from_json({"kind": "directional", "dart": 2}, PATH, 1) == Directional(2)
    with pytest.raises(InvalidWorld, match=r"'Directional' is not one of .*directional"):
        lighthouse_kind("Directional")
    with pytest.raises(InvalidWorld, match="'directional' has no option 'markers'; legal: start"):
        lighthouse_kind("directional:markers=2")


@pytest.mark.parametrize("kind", LIGHTHOUSES)
@pytest.mark.parametrize("start", [4, 5, -1, -(10**21), 10**21, HUGE], ids=show)
@pytest.mark.parametrize("place", [{}, {"dart": 0}])
def test_a_start_that_is_no_dart_is_refused_whatever_the_lighthouse(kind, start, place):
    place = {"darts": [0, 1, 3]} if place and kind == "compass" else place
    place = {} if kind == "none" else place
    document = {**DOCUMENT, "start": start, "lighthouse": {"kind": kind, **place}}
    with pytest.raises(InvalidWorld, match=r"^start = .* is no dart; darts are 0\.\.3$"):
        World.from_json(document)
    del document["lighthouse"]
    with pytest.raises(InvalidWorld, match=r"^start = "):
        World.from_json(document, missing=kind)


@pytest.mark.parametrize("kind", LIGHTHOUSES.values())
def test_a_kind_is_put_where_a_world_that_names_no_place_has_it(kind):
    map_ = from_cycles(["a", "ab", "bcc"])
    read = World.from_json({**map_.to_json(), "start": 2}, missing=kind.kind)
    assert World(map_, kind.kind, 2) == World(map_, kind, 2) == read


def test_without_a_lighthouse_a_world_has_the_directional_one_of_a_document_without_one():
    assert World(PATH) == World(PATH, None) == World.from_json(PATH.to_json())
    assert World(PATH, start=2).lighthouse == Directional(2)


@pytest.mark.parametrize(
    ("given", "said"),
    [
        ((PATH, "lamp"), "'lamp'"),
        ((PATH, 5), "lighthouse = 5 is not a text"),
        ((PATH, "directional", 9), r"start = 9 is no dart; darts are 0\.\.3"),
        (("theta",), "map = 'theta' is no CombinatorialMap"),
    ],
)
def test_what_makes_no_world_is_named(given, said):
    with pytest.raises(InputError, match=said):
        World(*given)


@pytest.mark.parametrize(
    ("change", "said"),
    [
        (lambda g: g.add_edge(0, 1), "the edge from 0 to 1 has no attribute 'darts'"),
        (lambda g: g.remove_edge(0, 1), "no edge has dart 0 of node 0"),
        (lambda g: g.clear_edges(), "node 0 has no edge"),
    ],
)
def test_a_graph_of_a_world_that_was_changed_is_refused(change, said):
    graph = World(named_map("k4"), "directional").to_networkx()
    change(graph)
    with pytest.raises(InvalidMap, match=said):
        World.from_networkx(graph)


def test_a_world_is_not_made_of_a_graph_without_an_order_unless_one_is_named():
    for graph in (nx.Graph([(0, 0), (0, 1)]), nx.triangular_lattice_graph(2, 2)):
        with pytest.raises(InvalidMap, match=r"maps\.from_cycles"):
            World.from_networkx(graph)
    world = World.from_networkx(graph, "position", 3, order="positions")
    assert world == World(from_networkx(graph, "positions"), "position", 3)
