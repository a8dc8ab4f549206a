"""The census of any lighthouse."""

import pytest

import allworlds
from allworlds.engines import units
from allworlds.inputs.checks import InputError
from allworlds.reports.formats import text
from allworlds.studies.ambiguity import census_sweep, sensed_classes
from allworlds.world import worlds
from allworlds.world.lighthouses.kinds import lighthouse_kind
from bruteforce import rooted_maps_by_permutations
from models import HEARD, PARITY

census, twins = allworlds.ambiguity.census, allworlds.twins


@pytest.fixture
def folder(tmp_path, monkeypatch):
    (tmp_path / "parity.py").write_text(PARITY)
    (tmp_path / "heard.py").write_text(HEARD)
    monkeypatch.chdir(tmp_path)
    return tmp_path


def test_a_copy_of_position_has_the_census_of_position(folder):
    ours, theirs = census(edges=4), census(edges=4, lighthouse="parity.py:Copy")
    assert ours.rows == theirs.rows
    assert ours.by_vertices == theirs.by_vertices
    assert [world.map for world in ours.pair] == [world.map for world in theirs.pair]
    assert ours.bisimulation == theirs.bisimulation
    assert ours.scope.lighthouse == "position"
    assert ours.rows[-1].ambiguous_worlds > 0


@pytest.mark.parametrize("kind", ["directional", "cluster:single=true", "labels"])
def test_where_every_world_can_be_known_none_is_ambiguous(kind):
    report = census(edges=3, lighthouse=kind)
    assert [row.ambiguous_worlds for row in report.rows] == [0, 0, 0]
    assert report.pair == ()
    assert all(row.marked_worlds for row in report.rows)


def marked(kind, edges):
    """The worlds, in groups of those that are the same but for the start."""
    groups = {}
    for world in worlds(edges=edges, lighthouse=kind, places="all"):
        alike = groups.setdefault(f"{world.told}, {sorted(map(str, world.percepts))}", [])
        for group in alike:
            if twins(world, group[0]).relation != "different":
                group.append(world)
                break
        else:
            alike.append([world])
    return [group for alike in groups.values() for group in alike]


def ambiguous(one, other):
    """Whether no motion tells the first world of a group from one of the other, by bisimulation."""
    seen = one[0].told, one[0].first
    return any(not twins(one[0], b).distinguishable for b in other if (b.told, b.first) == seen)


def parted(kind, edges):
    """The parts of all marked worlds; every two of these are compared, from every start."""
    parts = []
    for world in marked(kind, edges):
        found = [[ambiguous(world, other) for other in part] for part in parts]
        assert all(len(set(answers)) == 1 for answers in found)
        mine = [part for part, answers in zip(parts, found, strict=True) if answers[0]]
        if mine:
            (part,) = mine
            part.append(world)
        else:
            parts.append([world])
    return parts


@pytest.mark.parametrize(
    ("kind", "edges"),
    [
        *((kind, 2) for kind in ("none", "compass", "position", "position+told:n,m")),
        ("natural", 3),
        ("heard.py:Words", 2),
        ("heard.py:Neighbour", 2),
    ],
)
def test_parts_are_those_that_comparing_every_two_worlds_gives(folder, kind, edges):
    parts = [[world.map for world, *_ in part] for part in parted(kind, edges)]
    report = census(edges=edges, lighthouse=kind)
    sizes = {(m.edge_count, m.vertex_count) for part in parts for m in part}
    assert [(cell.edges, cell.vertices) for cell in report.by_vertices] == sorted(sizes)
    for cell in report.by_vertices:
        size = cell.edges, cell.vertices
        here = [[(m.edge_count, m.vertex_count) == size for m in part] for part in parts]
        shared = [members for members in here if len(members) > 1 and any(members)]
        assert cell.marked_worlds == sum(map(sum, here))
        assert cell.ambiguous_worlds == sum(map(sum, shared))
        assert cell.classes == len(shared)
        assert cell.largest_class == max(map(len, shared), default=0)


def code_from(map_, dart):
    order = [dart]
    for x in order:
        order += [y for y in (map_.sigma[x], map_.alpha[x]) if y not in order]
    return [order.index(to[x]) for to in (map_.sigma, map_.alpha) for x in order]


def numbers_by_hand(edges, told):
    """The numbers of worlds, and of ambiguous ones, with so many edges; nothing here is allworlds'.

    Maps come from all permutations, and what can be sensed from all words of motions. Only degrees
    are sensed; ``told(map_)`` gives all that can be told at the start 0.
    """
    maps = [m for e in range(1, edges + 1) for m in rooted_maps_by_permutations(e, "maps")]
    colours = {(i, d): map_.degree_at[d] for i, map_ in enumerate(maps) for d in map_.darts}
    around = {
        (i, d): [(i, map_.alpha[map_.turn(d, k)]) for k in range(map_.degree_at[d])]
        for i, map_ in enumerate(maps)
        for d in map_.darts
    }
    for _ in range(4 * edges):
        names = {}
        colours = {
            at: names.setdefault((colour, *(colours[to] for to in around[at])), len(names))
            for at, colour in colours.items()
        }
    worlds, looks = {}, {}
    for i, map_ in enumerate(maps):
        for said in told(map_):
            name = f"{min(code_from(map_, dart) for dart in map_.darts)} {said}"
            worlds[name] = map_.edge_count
            looks.setdefault((colours[i, 0], said), set()).add(name)
    ambiguous = {name for names in looks.values() if len(names) > 1 for name in names}
    return [
        ([*worlds.values()].count(e), sum(worlds[name] == e for name in ambiguous))
        for e in range(1, edges + 1)
    ]


def degrees_of_natural(map_):
    """The degrees of neighbours of v0, where no other vertex has the same, nor that of v0."""
    v0 = map_.vertex_of[0]
    beyond = {map_.vertex_of[map_.alpha[d]] for d in map_.vertices[v0]} - {v0}
    found = {map_.degrees[v] for v in beyond if map_.degrees.count(map_.degrees[v]) == 1}
    return found if map_.degrees.count(map_.degrees[v0]) == 1 else set()


@pytest.mark.parametrize(
    ("kind", "told"), [("natural", degrees_of_natural), ("heard.py:Told", lambda _: [0, 1])]
)
@pytest.mark.parametrize("edges", [3])
def test_what_is_told_is_a_part_of_a_world(folder, kind, told, edges):
    rows = census(edges=edges, lighthouse=kind).rows
    found = [(row.marked_worlds, row.ambiguous_worlds) for row in rows]
    assert found == numbers_by_hand(edges, told)


@pytest.mark.parametrize(
    ("kind", "edges"), [("natural", 4), ("heard.py:Words", 2), ("heard.py:Six", 4)]
)
def test_the_pair_is_told_the_same_from_a_start_where_the_lighthouse_can_stand(folder, kind, edges):
    report = census(edges=edges, lighthouse=kind)
    one, other = report.pair
    assert one.told == other.told
    assert twins(one, other).twins


def test_worlds_of_different_sizes_are_twins_where_nothing_is_marked():
    # A loop, and a cycle of two edges: a robot that senses degrees goes round either for ever.
    report = census(edges=2, lighthouse="none")
    assert [row.ambiguous_worlds for row in report.rows] == [1, 3]
    assert [world.map.edge_count for world in report.pair] == [2, 2]
    # One after the other alone they would be missed.
    assert [row.ambiguous_worlds for row in census(edges=1, lighthouse="none").rows] == [0]


def test_the_smallest_pair_is_told_with_its_pictures_and_its_proof():
    told = text(census(edges=2), 100)
    assert "The smallest worlds that no motion tells apart" in told
    assert told.count(" a a a a") == 2
    assert "smallest worlds" not in text(census(edges=1), 100)


def test_the_smallest_pair_comes_with_a_proof(folder):
    report = census(edges=3, lighthouse="parity.py:Parity")
    one, other = report.pair
    assert twins(one, other).distinguishable is False
    assert report.bisimulation == twins(one, other).bisimulation
    first = next(row for row in report.rows if row.classes)
    assert one.map.edge_count == first.edges
    assert text(report, 100)


def test_what_is_told_tells_worlds_apart():
    free, told = (census(edges=3, lighthouse=kind) for kind in ("none", "told:n,m,g"))
    assert free.rows[-1].classes > 0
    assert told.rows[-1].ambiguous_worlds < free.rows[-1].ambiguous_worlds


def test_it_is_the_same_from_a_run_directory(folder):
    asked = {"edges": 3, "lighthouse": "parity.py:Parity"}
    whole = census(**asked)
    assert census(run="rd", **asked).to_json() == census(run="rd", **asked).to_json()
    assert census(run="rd", **asked).rows == whole.rows
    (folder / "parity.py").write_text(PARITY + "\n")
    with pytest.raises(InputError, match="is of another text of 'parity"):
        census(run="rd", **asked)


def test_where_the_robot_leaves_marks_there_is_no_census():
    for kind in ("movable", "whiteboard", "compass+doormarks"):
        with pytest.raises(InputError, match="leaves marks itself"):
            census(edges=2, lighthouse=kind)


def test_a_census_of_a_narrower_class_is_compared_with_its_own_source():
    report = census(edges=3, where="trees")
    assert report.to_json()["gate"] == {"source": "Catalan numbers", "agrees": True}
    assert report.exit_code == 0
    assert report.rows[-1].marked_worlds < census(edges=3).rows[-1].marked_worlds


def test_verbs_of_ambiguity_are_imported_from_a_package_of_that_name():
    from allworlds.ambiguity import census as imported

    assert imported is census
    assert allworlds.ambiguity.census is census


def made_twice(kind, edges, map_class):
    """The worlds of a level by compiled code, and one by one, each with the number of maps."""
    kind = lighthouse_kind(kind)
    request = census_sweep.CensusRequest(lighthouse=kind, edges=5, map_class=map_class)
    maps, several = [0, 0], ([], [])
    for unit in units.units_of_level(request.extent, edges):
        compiled = sensed_classes.laid_out(unit, request.extent, kind.as_class)
        plain = census_sweep.batches(unit, request.extent, kind)
        found = compiled, ((count, sensed_classes.matrices(some)) for count, some in plain)
        for i, parts in enumerate(found):
            for count, part in parts:
                maps[i] += count
                matrices = (each.reshape(-1, 2 * edges).tolist() for each in part[:3])
                several[i].extend(zip(*matrices, part.told, part.vertices, strict=True))
    return maps, several


@pytest.mark.parametrize(
    "kind",
    [
        *("none", "position", "directional", "door", "natural", "cluster", "cluster:single=true"),
        *("compass", "labels", "word:12", "word:10*", "word:021*"),
    ],
)
@pytest.mark.parametrize(("edges", "map_class"), [(3, "maps"), (4, "simple")])
def test_worlds_of_compiled_code_are_those_that_are_made_one_by_one(kind, edges, map_class):
    pytest.importorskip("numba")
    (one, other), (compiled, plain) = made_twice(kind, edges, map_class)
    assert one == other > 0
    assert compiled == plain


def test_letters_that_are_turned_the_other_way_are_noticed(monkeypatch):
    pytest.importorskip("numba")
    turned = lambda pattern, degree: word_of(pattern, degree)[::-1]  # noqa: E731  # short
    word_of = sensed_classes.word_of
    monkeypatch.setattr(sensed_classes, "word_of", turned)
    _, (compiled, plain) = made_twice("word:10*", 3, "maps")
    assert compiled != plain


def test_which_censuses_are_made_by_compiled_code(folder, monkeypatch):
    pytest.importorskip("numba")

    def name(kind, **asked):
        request = census_sweep.CensusRequest(lighthouse=kind, **{"edges": 5, **asked})
        return sensed_classes.compiled_name(request.lighthouse.as_class, request.extent)

    assert name("position") == "position"
    assert name("word:12") == "door"
    assert name("cluster:single=true") == "cluster-single"
    assert not any([name("movable"), name("position+told:n"), name("parity.py:Copy")])
    assert not any([name("door", edges=4), name("door", edges=13), name("door", where="trees")])
    monkeypatch.setattr(sensed_classes, "lack_of", lambda *_: "lacks numba")
    assert not name("door")


def test_names_do_not_depend_on_how_many_codes_are_made_at_once(monkeypatch):
    kind = lighthouse_kind("position")
    extent = census_sweep.CensusRequest(lighthouse=kind, edges=3).extent
    unit = next(iter(units.units_of_level(extent, 3)))
    (_, some), *_ = census_sweep.batches(unit, extent, kind)
    made = sensed_classes.matrices(some)
    whole = [*sensed_classes.named(made)]
    monkeypatch.setattr(sensed_classes, "ENTRIES", 13)
    assert len(whole) > 3
    assert [*sensed_classes.named(made)] == whole
