"""Worlds of files and embeddings of graphs, in the verbs that go through many worlds."""

import json
import pickle

import networkx as nx
import pytest

import allworlds
from allworlds import World
from allworlds.inputs.checks import InputError
from allworlds.maps.build import from_cycles, named_map
from allworlds.maps.combinatorial import rooted_code, unrooted_code
from allworlds.maps.enumeration import history, rooted_maps
from allworlds.maps.networks import embeddings
from allworlds.notations.given import embeddings_of, files_of, worlds_of_files
from allworlds.notations.table import graph_in
from allworlds.reports.formats import file_of, text
from allworlds.studies.check.time_estimate import estimate
from allworlds.studies.worst.every_schedule import EverySchedule
from allworlds.testing import assert_explores, levels_of
from allworlds.world.labels import Labelling
from allworlds.world.lighthouses.marked import Directional, Position
from plan_files import NAMES, WRONG, as_json, of, write


@pytest.fixture
def plans(tmp_path, monkeypatch):
    """A file of worlds whose sizes are in no order."""
    monkeypatch.chdir(tmp_path)
    return write(tmp_path / "plans.jsonl", *map(as_json, NAMES)).rpartition("/")[2]


def test_every_start_and_place_of_the_petersen_graph_holds_by_one_command(tmp_path, cli):
    file = write(tmp_path / "petersen.jsonl", as_json("petersen"))
    code, out, _ = cli("check", "algorithm1", "--worlds", file, "--json")
    document = json.loads(out)
    assert (code, document["verdict"]) == (0, "holds")
    # 30 darts, and the three places of a directional lighthouse at a vertex of degree 3.
    assert (document["worlds"], document["runs"]) == (30, 90)


def test_worlds_of_a_file_are_tried_as_worlds_that_are_given(plans):
    report = allworlds.check("folding", worlds=plans)
    every = [
        World(named_map(name), place, start)
        for name in NAMES
        for start in named_map(name).darts
        for place in allworlds.world.Directional.places(named_map(name), start)
    ]
    made = allworlds.check("folding", worlds=every)
    assert (report.runs, report.traversals) == (made.runs, made.traversals)
    assert report.worlds == sum(2 * named_map(name).edge_count for name in NAMES)
    scope = report.to_json()["scope"]
    assert (scope["given"], scope["gate"], scope["finished_levels"]) == (
        6,
        "absent",
        [2, 3, 5, 6, 8],
    )
    assert scope["worlds"] == ["plans.jsonl"]
    assert len(scope["sha256"]["plans.jsonl"]) == 64
    said = text(report, 1000)
    assert (
        "every start and place of the lighthouse 'directional' in each of 6 maps of plans" in said
    )
    assert "absent, as the maps come from a file" in said
    assert "every given world with 8 edges" in file_of("junit", report)


def test_several_files_are_one_scope(tmp_path):
    one = write(tmp_path / "a.jsonl", as_json("k4"), as_json("theta"))
    other = write(tmp_path / "b.jsonl", as_json("wheel-4"))
    together = allworlds.check("folding", worlds=[one, other])
    apart = [allworlds.check("folding", worlds=file) for file in (one, other)]
    assert together.runs == sum(report.runs for report in apart)
    assert [*together.to_json()["scope"]["sha256"]] == [one, other]


def test_what_a_file_fixes_is_not_varied(tmp_path):
    position = {"kind": "position", "dart": 4}
    started = write(tmp_path / "start.jsonl", as_json("k4", start=3))
    placed = write(tmp_path / "place.jsonl", as_json("k4", lighthouse=position), as_json("theta"))
    both = write(tmp_path / "both.jsonl", as_json("k4", start=3, lighthouse=position))
    assert allworlds.check("folding", worlds=started).runs == 3
    # Of K4 the three starts at the vertex of the marker; of theta, whose place is open, every one.
    assert allworlds.check("quotient", worlds=placed).runs == 3 + 6
    report = allworlds.check("quotient", worlds=both)
    assert (report.runs, str(report.asked.rules.lighthouse)) == (1, "position")
    assert "one start and place of the lighthouse 'position' in the map of" in text(report, 1000)
    marked = write(tmp_path / "marked.jsonl", as_json("k4", lighthouse=position))
    report = allworlds.check("quotient", worlds=marked)
    assert report.runs == 3
    assert "every start and place of the lighthouse 'position' in the map of" in text(report, 1000)
    (given,) = worlds_of_files(files_of(both), "clockwise", None).piece(6, 0)
    ((map_, [(_, place)]),) = given.placed(Position)
    # Where v0 is, is kept: its distance from the start, and the degree.
    old = World(named_map("k4"), Position(4), 3)
    assert World(map_, place, 0).percepts[0] == old.percepts[3]
    assert [p.marks for p in World(map_, place, 0).percepts].count(1) == 3


def test_the_smallest_world_refutes_first_whatever_its_place_in_the_file(plans, tmp_path):
    (tmp_path / "mine.py").write_text(WRONG)
    report = allworlds.check("mine.py:goes_on", worlds=plans, task="cover:edges", workers=1)
    (finding,) = report.findings
    assert (finding.world.map.edge_count, report.levels) == (2, (2,))
    assert finding.confirmed
    assert finding.world.labels.name == "two-loops-torus"
    assert "the world two-loops-torus" in text(report, 1000)


def test_findings_are_told_in_the_names_of_the_file(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "mine.py").write_text(WRONG)
    plans = [
        {"lodge": {"hall": ["a", "b"], "a": ["hall"], "b": ["hall"]}},
        {"tower": {"top": ["stair"], "stair": ["top"]}},
    ]
    for plan in plans:
        (name,) = plan
        (tmp_path / f"{name}.json").write_text(json.dumps(plan))
    report = allworlds.check(
        "mine.py:goes_on",
        worlds=["lodge.json", "tower.json"],
        max_findings=9,
        task="map",
        workers=1,
    )
    worlds = {
        finding.world.labels.name: finding.world.labels.vertices for finding in report.findings
    }
    assert {name: {*rooms} for name, rooms in worlds.items()} == {
        "tower": {"top", "stair"},
        "lodge": {"hall", "a", "b"},
    }
    # Dart 0 of the finding's world is at the vertex of its start, whatever the file's numbers are.
    for finding in report.findings:
        map_, rooms = finding.world.map, finding.world.labels.vertices
        for room, darts in zip(rooms, map_.vertices, strict=True):
            assert (room == "hall") == (len(darts) == 2)
    compared = allworlds.compare("folding", "algorithm1", worlds=["lodge.json"])
    if compared.differ_most:
        assert compared.differ_most.world.labels.name == "lodge"


def test_the_order_of_a_file_is_told_and_turns_it(tmp_path):
    chiral = next(m for m in rooted_maps(4) if unrooted_code(m) != unrooted_code(m.mirrored()))
    file = write(tmp_path / "a.jsonl", {"sigma": [*chiral.sigma], "alpha": [*chiral.alpha]})
    for order, meant in (("clockwise", chiral), ("anticlockwise", chiral.mirrored())):
        (given,) = worlds_of_files(files_of(file), order, None).piece(4, 0)
        assert unrooted_code(given.map) == unrooted_code(meant)
        report = allworlds.check("folding", worlds=file, order=order)
        assert report.to_json()["scope"]["order"] == order
        assert f"--order {order}" in text(report, 1000)
        run = next(iter(report.tally.rows.values())).most_expensive
        assert (run.sigma, run.alpha) in {
            rooted_code(meant.sigma, meant.alpha, d) for d in meant.darts
        }


def test_lighthouses_must_agree(tmp_path, refused):
    position = {"kind": "position", "dart": 0}
    worlds = as_json("k4", lighthouse=position), as_json("theta", lighthouse={"kind": "none"})
    one, two = (write(tmp_path / f"{n}.jsonl", *worlds[:n]) for n in (1, 2))
    said = refused("check", "--worlds", two)
    assert f"k4 of {two} has 'position', and theta of {two} has 'none'" in said
    for verb in (["check", "folding"], ["ambiguity", "census"]):
        said = refused(*verb, "--worlds", one, "--lighthouse", "directional")
        assert "lighthouse = 'directional', but 1 map of" in said
    assert "have 'position'" in refused("worst", "--worlds", one)


@pytest.mark.parametrize(
    ("options", "said"),
    [
        (["--worlds", "nowhere.jsonl"], "file 'nowhere.jsonl' cannot be read: No such file"),
        (["--worlds", "plans.jsonl", "--edges", "1"], "6 maps of plans.jsonl have at least 2"),
        (["--order", "anticlockwise"], "has no effect without worlds of a file"),
        (["--embeddings", "all"], "embeddings = 'all' has no effect without a graph"),
        (["--graph", "k4", "--embeddings", "plane"], "'plane' is not one of all, genus:G"),
        (["--graph", "k4", "--worlds", "plans.jsonl"], "cannot be given together with worlds"),
        (["--graph", "nothing"], "no map is called 'nothing'"),
        (["--graph", "k5", "--embeddings", "genus:0"], "there is no embedding of k5 of genus 0"),
    ],
)
def test_what_is_no_file_of_worlds_is_refused_in_one_line(options, said, plans, refused):
    assert said in refused("check", *options)


def test_a_file_goes_with_condition_class_and_bounds(plans):
    def runs(**options):
        return allworlds.check("folding", worlds=plans, **options).runs

    assert runs(where="cubic") == 3 * (2 * 6 + 2 * 6 + 2 * 3)
    assert runs(map_class="planar", where="cubic") == 3 * (2 * 6 + 2 * 3)
    assert runs(edges=3) == 3 * 2 * 3 + 4 * 2 * 2
    assert allworlds.check("folding", worlds=plans, vertices=1).worlds == 4


# ---------------------------------------------------------------- runs, shards, workers


def test_a_level_is_cut_into_pieces_and_dealt_to_shards(tmp_path):
    file = write(tmp_path / "many.jsonl", *[as_json("edge", name=str(i)) for i in range(120)])
    pieces = worlds_of_files(files_of(file), "clockwise", None)
    assert pieces.weights(1) == [100, 100, 40]
    assert [len(pieces.piece(1, i)) for i in range(3)] == [50, 50, 20]
    assert pieces.piece(1, 2)[-1].labels.name == "119"
    runs = [tmp_path / "one", tmp_path / "other"]
    shards = [allworlds.check("folding", worlds=file, shard=(k, 2), run=runs[k]) for k in range(2)]
    assert [shard.worlds for shard in shards] == [140, 100]
    assert of(allworlds.merge(*runs)) == of(allworlds.check("folding", worlds=file))


def test_a_run_is_resumed_and_not_with_a_changed_file(plans, tmp_path, refused, cli):
    whole = allworlds.check("folding", worlds=plans, run="rd")
    assert of(allworlds.check("folding", worlds=plans, run="rd")) == of(whole)
    code, out, _ = cli("status", "rd")
    assert (code, "--worlds plans.jsonl" in out) == (0, True)
    write(tmp_path / "plans.jsonl", *map(as_json, NAMES[1:]))
    assert "is of another text of 'plans.jsonl'" in refused(
        "check", "folding", "--worlds", "plans.jsonl", "--run", "rd"
    )
    for verb in ("status", "merge"):
        assert "worlds 'plans.jsonl' has another text now" in refused(verb, "rd")


# ---------------------------------------------------------------- other verbs


def test_compare_goes_through_a_file(plans):
    report = allworlds.compare("folding", "algorithm1", worlds=plans, by="world")
    assert {row.edges for row in report.rows} == {2, 3, 5, 6, 8}
    # Starts from which a world looks the same count once: those of K4 are one.
    assert {(row.edges, row.vertices): row.worlds for row in report.rows}[6, 4] == 1 + 3
    assert "every start in each of 6 maps of plans.jsonl" in text(report, 1000)
    with pytest.raises(InputError, match=r"worlds = .* has no effect on family"):
        allworlds.compare("folding", "algorithm1", worlds=plans, family="k:4")
    with pytest.raises(InputError, match=r"worlds = .* has no effect on worlds that grow"):
        allworlds.compare("folding", worlds=plans, family="lattice", to=12)


def test_the_census_counts_worlds_once(tmp_path):
    file = write(
        tmp_path / "a.jsonl", as_json("k4"), as_json("k4", name="again"), as_json("wheel-4")
    )
    report = allworlds.ambiguity.census(worlds=file)
    assert [(row.edges, row.marked_worlds) for row in report.rows] == [(6, 1), (8, 2)]
    assert report.to_json()["gate"] is None
    look_alike = [from_cycles(["aa"]), from_cycles(["abba"])]
    worlds = [{"sigma": [*map_.sigma], "alpha": [*map_.alpha]} for map_ in look_alike]
    none = allworlds.ambiguity.census(
        worlds=write(tmp_path / "b.jsonl", *worlds), lighthouse="none"
    )
    assert sum(row.marked_worlds for row in none.rows) == 2


@pytest.mark.usefixtures("compiled")
def test_every_schedule_is_searched_in_given_worlds(tmp_path):
    names = "cycle-5", "theta", "two-loops-torus", "dipole-2"
    report = allworlds.worst(worlds=write(tmp_path / "small.jsonl", *map(as_json, names)))
    rows = {(row.edges, row.vertices): (row.worst, row.best, row.worlds) for row in report.rows}
    for name in names:
        map_ = named_map(name)
        here = [EverySchedule(map_, start) for start in map_.darts]
        costs = max(each.worst for each in here), max(each.best for each in here), len(here)
        assert rows.pop((map_.edge_count, map_.vertex_count)) == costs
    assert (rows, report.to_json()["scope"]["edges"]) == ({}, 5)
    with pytest.raises(InputError, match="edges = 15, but there is room for 12"):
        allworlds.worst(graph="petersen", embeddings="genus:1")


def test_rooted_embeddings_are_as_many_as_are_known():
    """K4 has 16 rotations, and 24 automorphisms: of 16 x 12 rooted ones 8 differ."""
    report = allworlds.compare("folding", "folding-oldest", graph="k4")
    assert sum(row.worlds for row in report.rows) == 16 * 12 // 24 == 8
    assert "every start in each of 3 embeddings of k4 of the class 'maps'" in text(report, 1000)


def test_a_world_without_a_name_has_a_number(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "mine.py").write_text(WRONG)
    file = write(tmp_path / "a.jsonl", as_json("k4", name=""), as_json("theta", name=""))
    report = allworlds.check("mine.py:goes_on", worlds="a.jsonl", task="cover:edges", workers=1)
    assert report.findings[0].world.labels.name == "2 of a.jsonl"
    with pytest.raises(InputError, match="estimate is for a class, not for 2 maps of"):
        estimate("folding", worlds=file)


def test_a_finding_has_the_name_of_the_world_with_its_place(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "mine.py").write_text(WRONG)
    place = [{"kind": "directional", "dart": dart} for dart in (1, 0)]
    worlds = [as_json("k4", name=f"at {p['dart']}", start=0, lighthouse=p) for p in place]
    file = write(tmp_path / "a.jsonl", *worlds)
    report = allworlds.check("mine.py:goes_on", worlds=file, task="cover:edges", workers=1)
    assert report.findings[0].world.labels.name == "at 0"


@pytest.mark.parametrize("edges", [1, 2, 3])
def test_a_history_makes_its_map_again(edges):
    for map_ in rooted_maps(edges):
        assert [*rooted_maps(edges, prefix=history(map_))] == [map_]


@pytest.mark.parametrize(("which", "maps"), [("all", 3), ("genus:0", 1), ("genus:1", 2)])
def test_every_embedding_of_a_graph_is_tried(which, maps):
    report = allworlds.check("algorithm1", graph="k4", embeddings=which)
    assert (report.verdict.value, report.worlds, report.runs) == ("holds", 12 * maps, 36 * maps)
    assert "absent, as the maps are embeddings of a graph" in text(report, 1000)
    assert report.to_json()["scope"]["graph"] == "k4"


MULTIGRAPH = nx.MultiGraph([("hall", "den"), ("den", "hall"), ("hall", "hall"), ("den", "yard")])
YED = "xmlns:y='http://www.yworks.com/xml/graphml'"
EDGES = {
    "petersen.g6": (nx.petersen_graph(), nx.to_graph6_bytes(nx.petersen_graph())),
    "plain.g6": (nx.path_graph(3), nx.to_graph6_bytes(nx.path_graph(3), header=False)),
    "house.graphml": (MULTIGRAPH, "\n".join(nx.generate_graphml(MULTIGRAPH)).encode()),
    "house.gml": (MULTIGRAPH, "\n".join(nx.generate_gml(MULTIGRAPH)).encode()),
    "yed.graphml": (
        MULTIGRAPH,
        "\n".join(nx.generate_graphml(MULTIGRAPH)).replace("<graphml", f"<graphml {YED}").encode(),
    ),
}


@pytest.mark.parametrize("name", EDGES)
def test_a_file_of_edges_alone_has_every_embedding_of_its_graph(name, tmp_path):
    graph, content = EDGES[name]
    (tmp_path / name).write_bytes(content)
    genus = 1 if "petersen" in name else None
    which = "genus:1" if genus else "all"
    given = embeddings_of(str(tmp_path / name), files_of(str(tmp_path / name)), which, None, None)
    expected = [*embeddings(graph, genus=genus)]
    [level] = {map_.edge_count for map_ in expected}
    assert [each.map for each in given.piece(level, 0)] == expected
    assert given.piece(level, 0)[0].labels.vertices == tuple(map(str, graph))
    with pytest.raises(InputError, match=r"legal are .*; --graph FILE takes edges alone"):
        worlds_of_files(files_of(str(tmp_path / name)), None, None)


def test_several_graphs_in_one_file_are_refused(tmp_path):
    (tmp_path / "two.g6").write_bytes(nx.to_graph6_bytes(nx.path_graph(3), header=False) * 2)
    with pytest.raises(InputError, match=r"two\.g6': 2 graphs stand in it; legal is 1"):
        allworlds.check("algorithm1", graph=str(tmp_path / "two.g6"))


# ---------------------------------------------------------------- tests of users


def test_a_mark_makes_a_test_for_each_size_of_a_file(plans):
    assert [*levels_of({"worlds": plans})] == [2, 3, 5, 6, 8]
    assert [*levels_of({"worlds": plans, "edges": 5})] == [2, 3, 5]
    assert assert_explores("folding", worlds=plans).worlds == 60


def test_the_starts_of_each_size_are_added_up(plans):
    twice_the_edges = {2: 4, 3: 6, 5: 10, 6: 12 + 12, 8: 16}
    assert worlds_of_files(files_of(plans), None, None).starts == twice_the_edges


def test_a_lighthouse_without_a_place_is_at_the_first_dart(tmp_path):
    file = write(tmp_path / "one.jsonl", as_json("path-3", lighthouse={"kind": "directional"}))
    (one,) = worlds_of_files(files_of(file), None, None).piece(2, 0)
    assert one.lighthouse == Directional(0)


def test_a_finding_of_a_comparison_has_the_names_of_the_file(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "mine.py").write_text(WRONG)
    plan = {"lodge": {"hall": ["dining room"], "dining room": ["hall"]}}
    (tmp_path / "lodge.json").write_text(json.dumps(plan))
    report = allworlds.compare("algorithm1", "mine.py:goes_on", worlds="lodge.json")
    (finding,) = report.findings
    assert finding.world.labels.name == "lodge"
    assert {*finding.world.labels.vertices} == {"hall", "dining room"}


def test_the_graph_of_a_file_with_rotations_is_the_graph_of_its_map(tmp_path):
    file = write(tmp_path / "plan.json", as_json("k4"))
    graph, labels = graph_in(file)
    assert sorted(map(sorted, graph.edges())) == [[v, w] for v in range(4) for w in range(v + 1, 4)]
    assert labels.vertices == ()
    (tmp_path / "named.csv").write_text("from,to,from_rank,to_rank\nhall,bath,0,0\n")
    assert graph_in(tmp_path / "named.csv")[1] == Labelling("", ("hall", "bath"))


def test_other_processes_get_what_is_told_of_given_maps_and_not_the_maps(plans):
    given = worlds_of_files(files_of(plans), None, None)
    sent = pickle.loads(pickle.dumps(given))
    assert {**vars(sent), "codes": 0} == {**vars(given), "_at": None, "_find": None, "codes": 0}
    assert (sent.words, sent.codes) == (f"{len(NAMES)} maps of plans.jsonl", given.codes)
