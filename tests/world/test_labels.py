"""Names and positions of vertices: they stay with their vertices, and decide nothing."""

import pickle
from random import Random

import networkx as nx
import pytest

from allworlds.inputs.checks import InputError
from allworlds.judging.findings.finding import canonical_world, labelled
from allworlds.maps import family
from allworlds.world import InvalidWorld, Labelling, World, at_place
from small import EDGE, PATH

NAMED = {
    "sigma": [0, 2, 1, 3],
    "alpha": [1, 0, 3, 2],
    "name": "tower",
    "names": ["hall", "F", "bath"],
    "positions": [[0.0, 0.0], [1.5, 0.0], [1.5, -2.0]],
}


def corridor():
    """A world whose vertices are called by what tells them apart, whatever their numbers."""
    map_ = family("random:5x7", holes=0, seed=1)
    names = tuple(f"room {darts}" for darts in map_.vertices)
    places = tuple((float(darts[0]), -float(darts[-1])) for darts in map_.vertices)
    return World(map_, "directional", 3, labels=Labelling("tower", names, places))


def called(world, names=None):
    """For each dart, as it is called in the first world, the name and position of its vertex."""
    map_, labels = world.map, world.labels
    names = names or [*map_.darts]
    owner = [map_.vertex_of[names[dart]] for dart in map_.darts]
    return [(labels.vertices[v], labels.positions[v]) for v in owner]


def test_a_vertex_keeps_its_labels_whatever_its_darts_are_called():
    world = corridor()
    for seed in range(5):
        names = [*world.map.darts]
        Random(seed).shuffle(names)
        other = world.relabelled(names)
        assert other.labels.name == "tower"
        assert called(other, names) == called(world)
        assert canonical_world(other).labels == canonical_world(world).labels
    assert at_place(world, 1).labels == world.labels
    assert pickle.loads(pickle.dumps(world)).labels == world.labels


def test_left_becomes_right_in_the_mirror():
    world = corridor()
    mirrored = world.mirrored()
    assert [name for name, _ in called(mirrored)] == [name for name, _ in called(world)]
    for (_, (x, y)), (_, place) in zip(called(world), called(mirrored), strict=True):
        assert place == (-x, y)
    assert mirrored.mirrored().labels == world.labels


def test_labels_decide_nothing():
    world = corridor()
    plain = World(world.map, world.lighthouse, world.start)
    assert world == plain
    assert hash(world) == hash(plain)
    assert repr(world) == repr(plain)
    assert world.percepts == plain.percepts
    assert {"name", "names", "positions"}.isdisjoint(plain.to_json())


def test_a_document_holds_them_and_is_read_again():
    world = World.from_json(NAMED)
    document = world.to_json()
    assert {key: document[key] for key in NAMED} == NAMED
    assert World.from_json(document).labels == world.labels
    half = World.from_json({key: NAMED[key] for key in ("sigma", "alpha", "name")})
    assert half.labels == Labelling("tower")
    assert half.in_words == "the world tower, with 2 edges and 3 vertices"
    assert World(PATH).in_words == "a world with 2 edges and 3 vertices"


@pytest.mark.parametrize(
    ("key", "given", "said"),
    [
        ("name", 7, "name = 7: expected str, got int"),
        ("name", "a\nb", "name = 'a\\nb' is no printable text"),
        ("names", "abc", "names = 'abc': expected array, got str"),
        ("names", ["a"], "names = ['a'] is no list of 3, one for each vertex of the map"),
        ("names", ["a", "", "c"], "names[1] = '' is no printable text"),
        ("names", ["a", " ", "c"], "names[1] = ' ' is no printable text"),
        ("names", ["a", "b", 3], "names[2] = 3: expected str, got int"),
        ("names", ["a", "b\u202e", "c"], "names[1] = 'b\\u202e' is no printable text"),
        ("names", ["a", "b", "a"], "names[2] = 'a' is no printable text of its own"),
        ("positions", None, "positions = None: expected array, got null"),
        ("positions", [[0, 0]] * 2, "is no list of 3"),
        (
            "positions",
            [[0, 0], [1, 2, 3], [1, 1]],
            "positions[1] = [1, 2, 3]: expected array of length 2, got 3",
        ),
        ("positions", [[0, 0], [1, 0], [1, "1"]], "positions[2][1] = '1': expected float, got str"),
        ("positions", [[0, float("nan")], [1, 0], [1, 1]], "positions[0][1] = nan: expected float"),
        ("positions", [[0, 0], [1, 0], [1, 10**400]], "number out of range"),
        ("label", "a", "legal are sigma, alpha, start, lighthouse, name, names, positions"),
    ],
)
def test_a_label_that_is_none_is_refused_by_name(key, given, said):
    with pytest.raises(InputError) as error:
        World.from_json({**NAMED, key: given})
    assert said in str(error.value)
    assert "\n" not in str(error.value)


def test_labels_that_are_none_are_refused_in_python():
    with pytest.raises(InvalidWorld, match=r"labels = \['a', 'b'\] is no Labelling"):
        World(EDGE, labels=["a", "b"])


def test_a_finding_gets_the_labels_of_the_first_given_world_that_is_the_same():
    given = [World(PATH, None, start, labels=Labelling(f"{start}")) for start in PATH.darts]
    bare = World(PATH, None, 1)
    plain = canonical_world(bare)
    # The path looks alike from both ends: dart 2 is as good as dart 1, and stands behind it.
    for order, name in ((given, "1"), (given[::-1], "2")):
        found = labelled(plain, order)
        assert found == plain
        assert found.labels.name == name
    elsewhere = [World(PATH, "position", start, labels=Labelling("x")) for start in PATH.darts]
    assert labelled(plain, elsewhere) is plain


def test_a_graph_has_the_labels_and_gives_them_back():
    world = corridor()
    graph = world.to_networkx()
    assert nx.get_node_attributes(graph, "pos") == dict(enumerate(world.labels.positions))
    again = World.from_networkx(graph)
    assert (again, again.labels) == (world, world.labels)
    nodes = [*graph.nodes(data=True)]
    other = nx.MultiGraph(**graph.graph)
    other.add_nodes_from(reversed(nodes))  # in another order than the vertices
    other.add_edges_from(world.to_networkx().edges(keys=True, data=True))
    assert World.from_networkx(other).labels == world.labels
    assert World.from_networkx(World(PATH).to_networkx()).labels == Labelling()


def test_nodes_of_a_plan_are_the_names_and_its_positions_are_kept():
    plan = nx.Graph([("hall", "bath"), ("F", "hall")], name="tower")
    places = {"hall": (0, 0), "bath": (0, 1), "F": (1, 0)}
    nx.set_node_attributes(plan, places, "pos")
    for order in ("positions", "planar"):
        labels = World.from_networkx(plan, order=order).labels
        assert labels == Labelling("tower", ("hall", "bath", "F"), (*places.values(),))


@pytest.mark.parametrize("nodes", [(0, 1), (1, "1"), ("a\nb", "c"), (float("nan"), " ")])
def test_nodes_that_can_be_no_names_are_none(nodes):
    graph = nx.Graph([nodes])
    graph.nodes[nodes[0]]["pos"] = "here"
    assert World.from_networkx(graph, order="planar").labels == Labelling()


@pytest.mark.parametrize("far", [1e300, -1e300])
def test_a_vertex_stands_at_most_so_far_away(far):
    positions = [[0, 0], [1, 0], [far, 1]]
    assert World.from_json({**NAMED, "positions": positions}).labels.positions[2] == (far, 1)
    positions[2][0] = 2 * far
    with pytest.raises(
        InputError, match=r"positions\[2\]\[0\] = -?2e\+300: expected float [<>]= -?1e\+300"
    ):
        World.from_json({**NAMED, "positions": positions})
