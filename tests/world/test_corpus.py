import hashlib

import pytest

from allworlds.judging.findings.finding import Finding
from allworlds.maps import CombinatorialMap, automorphisms, unrooted_code
from allworlds.studies.ambiguity import twins
from allworlds.studies.check.exhaustive import check
from allworlds.studies.count import count
from allworlds.studies.run import replay, run
from allworlds.world import World
from allworlds.world.bisimulation import flaw
from allworlds.world.named import MANIFEST, own_corpus

CORPUS = own_corpus()


def entries(kind):
    """A test of each entry of a kind."""
    return pytest.mark.parametrize("entry", CORPUS.of_kind(kind), ids=lambda entry: entry.name)


@entries("world")
def test_a_named_world_is_what_it_is_said_to_be(entry):
    world, expected = World.from_json(CORPUS.document(entry)), entry.expected
    map_ = world.map
    assert (map_.edge_count, map_.vertex_count) == (expected["edges"], expected["vertices"])
    assert (len(map_.faces), map_.genus) == (expected["faces"], expected["genus"])
    assert automorphisms(map_) == expected["automorphisms"]


@entries("world")
def test_algorithm_1_explores_a_named_world_at_the_known_cost(entry):
    told = run("algorithm1", World.from_json(CORPUS.document(entry)))
    assert told.verdict.value == entry.expected["verdict"]
    assert told.outcome.cost == entry.expected["cost"]


@entries("finding")
def test_a_finding_is_fixed_by_algorithm_1(entry):
    finding = Finding.from_json(CORPUS.document(entry))
    assert replay(finding, "algorithm1").outcome == "fixed"


@entries("pair")
def test_the_worlds_of_a_pair_are_different_and_no_motion_tells_them_apart(entry):
    document = CORPUS.document(entry)
    worlds = [World.from_json(world) for world in document["worlds"]]
    assert flaw(worlds, document["bisimulation"]) is None
    assert unrooted_code(worlds[0].map) != unrooted_code(worlds[1].map)
    assert twins(*worlds).twins == entry.expected["twins"]


@entries("pair")
def test_a_pair_with_one_class_changed_is_no_longer_proved(entry):
    document = CORPUS.document(entry)
    worlds = [World.from_json(world) for world in document["worlds"]]
    left, right = document["bisimulation"]
    for d in range(len(left)):
        changed = [*left[:d], max(left) + 1, *left[d + 1 :]]
        assert flaw(worlds, [changed, right]) is not None


@pytest.mark.parametrize("most", [4])
@entries("counts")
def test_the_enumeration_gives_the_known_numbers(entry, most):
    known = CORPUS.document(entry)
    rooted, unrooted = known["rooted"][:most], known["unrooted"][:most]
    census = count(edges=len(rooted), map_class=known["class"])
    assert [row.rooted for row in census.rows] == rooted
    assert [row.unrooted for row in census.rows][: len(unrooted)] == unrooted


@pytest.mark.early
@entries("check")
def test_an_explorer_gets_its_verdict_at_the_known_cost(entry):
    expected = dict(entry.expected)
    report = check(**CORPUS.document(entry), workers=2).to_json()
    most_expensive = dict.fromkeys(range(1, report["scope"]["edges"] + 1), 0)
    for row in report["rows"]:
        most_expensive[row["edges"]] = max(most_expensive[row["edges"]], row["max_cost"])
    found = [finding["world"] for finding in report["findings"]]
    sizes = [(len(world["sigma"]) // 2, World.from_json(world).map.vertex_count) for world in found]
    smallest = [report["findings"][0]["law"], *sizes[0]] if found else None
    told = {**report, "dearest": [*most_expensive.values()], "smallest": smallest}
    told["bound"] = report["scope"]["bound"]
    assert {key: told[key] for key in expected} == expected


@pytest.mark.parametrize("entry", CORPUS.entries, ids=lambda entry: entry.name)
def test_a_file_has_the_digest_of_the_manifest(entry):
    content = (CORPUS.directory / entry.file).read_bytes()
    assert hashlib.sha256(content).hexdigest() == entry.sha256


def test_no_two_entries_have_one_name():
    assert len({entry.name for entry in CORPUS.entries}) == len(CORPUS.entries)


def test_every_file_of_the_corpus_stands_in_its_manifest():
    files = {str(path.relative_to(CORPUS.directory)) for path in CORPUS.directory.rglob("*.json")}
    assert files == {entry.file for entry in CORPUS.entries} | {MANIFEST}


def test_the_worlds_of_the_corpus_are_maps():
    for entry in CORPUS.of_kind("world"):
        assert CombinatorialMap.from_json(CORPUS.document(entry)).edge_count >= 1
