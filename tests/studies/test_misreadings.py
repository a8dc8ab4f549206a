"""A wrong convention is named: the explorer is right behind a translator, and only behind that."""

import re
import shutil

import pytest

from allworlds import explain
from allworlds.document.struct import replace
from allworlds.engines.tally import finding_from_record, finding_to_record
from allworlds.explorers.translated import CONVENTIONS
from allworlds.inputs.checks import InputError
from allworlds.judging.explanations.explanation import MOST, explain as told_of_run, trial_worlds
from allworlds.judging.findings.finding import Finding, canonical_world
from allworlds.maps import CombinatorialMap, MapClass, rooted_maps
from allworlds.maps.classes import Extent
from allworlds.maps.conditions import condition_named
from allworlds.studies.check.exhaustive import check
from allworlds.world import World
from native_libraries import EXAMPLES

pytestmark = pytest.mark.usefixtures("without_workers")

MISREADING = """
from allworlds import Estimate, Move, Percept
from allworlds.explorers.builtin.algorithm1 import algorithm1


def reading(motion, bearing):
    def turned(percept):
        if percept is None or percept.bearing is None:
            return percept
        return Percept(percept.degree, percept.marks, bearing(percept.bearing) % percept.degree)

    def explore(first):
        explorer, percept = algorithm1(turned(first)), None
        while True:
            try:
                action = explorer.send(percept)
            except StopIteration as end:
                return end.value
            if isinstance(action, Move):
                percept = turned((yield Move(motion(action.k))))
            elif POINTS:
                percept = yield action
            else:
                percept = None

    return explore


POINTS = False
anticlockwise = reading(lambda k: -k, lambda b: b)
from_1 = reading(lambda k: k + 1, lambda b: b)
from_next = reading(lambda k: k - 1, lambda b: b)
bearings = reading(lambda k: k, lambda b: -b)
twice = reading(lambda k: 2 * k, lambda b: b)


def raising(first):
    edges = {}
    walk = anticlockwise(first)
    percept = None
    for step in range(50):
        try:
            percept = yield walk.send(percept)
        except StopIteration as end:
            return end.value
    return edges["lost"]


def forgetful(first):
    estimate = yield from algorithm1(first)
    return Estimate(estimate.map, estimate.map.sigma[estimate.here])


def hand(side):
    def follow(first):
        yield Move(0)
        while True:
            yield Move(side)

    return follow


left, right = hand(1), hand(-1)


def in_one_schedule(first, *, choices):
    yield Move(0)
    side = choices.pick([1, 0], of="edge")
    while True:
        yield Move(side)


def once(ending):
    def explore(first):
        estimate = yield from anticlockwise(first)
        return ending(estimate)

    return explore


@once
def no_star(estimate):
    assert estimate.map.edge_count < 3 or 3 not in estimate.map.degree_at
    return estimate


@once
def no_tree_of_4_edges(estimate):
    assert (estimate.map.edge_count, estimate.map.vertex_count) != (4, 5)
    return estimate


def cubic_alone(first):
    assert first.degree == 3
    return (yield from anticlockwise(first))
"""

SLIPS = {
    "anticlockwise": "motions-anticlockwise",
    "from_1": "motions-from-1",
    "from_next": "motions-from-next",
    "bearings": "bearings-anticlockwise",
    "raising": "motions-anticlockwise",
}


@pytest.fixture(scope="module")
def file(tmp_path_factory):
    """A file of explorers, each with one slip."""
    file = tmp_path_factory.mktemp("misreading") / "misreading.py"
    file.write_text(MISREADING, encoding="utf-8")
    return file


TRIANGLE_AND_LEAF = World(CombinatorialMap([1, 0, 4, 5, 6, 3, 2, 7], [2, 3, 0, 1, 5, 4, 7, 6]))
FIVE_EDGES = World(CombinatorialMap([1, 0, 4, 5, 6, 7, 2, 3, 9, 8], [2, 3, 0, 1, 5, 4, 8, 9, 6, 7]))
"""Worlds that an explorer which counts motions anticlockwise gets wrong."""


def first_finding(name, **rules):
    return check(name, **{"edges": 3, **rules}).findings[0]


def test_there_is_a_slip_for_each_convention():
    assert {*SLIPS.values()} == {*CONVENTIONS}


def test_the_page_names_each_convention():
    page = (EXAMPLES.parent / "docs" / "protocol.md").read_text(encoding="utf-8")
    told = page.partition("`translated:CONVENTION:EXPLORER`")[2].partition("##")[0]
    assert re.findall("`(motions-[^`]+|bearings-[^`]+)`", told) == [*CONVENTIONS]


@pytest.mark.parametrize("slip", SLIPS)
def test_the_slip_is_named_first_and_the_translator_shows_it(slip, file):
    finding = first_finding(f"{file}:{slip}")
    told = told_of_run(finding)
    assert told.slip == SLIPS[slip].replace("-", " ")
    assert told.sentences[0].startswith(f"The explorer {CONVENTIONS[SLIPS[slip]].wrong}")
    name = f"translated:{SLIPS[slip]}:{file}:{slip}"
    assert name in told.sentences[2]
    assert check(name, edges=3).exit_code == 0


def test_checkpoints_do_not_hide_it(tmp_path):
    file = tmp_path / "pointing.py"
    file.write_text(MISREADING.replace("POINTS = False", "POINTS = True"), encoding="utf-8")
    finding = first_finding(f"{file}:anticlockwise")
    assert finding.step is not None
    assert told_of_run(finding).slip == "motions anticlockwise"


@pytest.mark.parametrize("slip", ["twice", "forgetful"])
def test_another_slip_is_none_of_these(slip, file):
    finding = first_finding(f"{file}:{slip}")
    assert finding.misreading is None
    assert "right for it" not in " ".join(explain(finding).sentences)


@pytest.mark.parametrize("convention", CONVENTIONS)
def test_a_translator_makes_a_right_explorer_wrong(convention):
    report = check(
        f"translated:{convention}:allworlds.explorers.builtin.algorithm1:algorithm1", edges=3
    )
    assert report.exit_code == 1


def test_all_small_worlds_of_the_class_were_tried(file):
    misreading = first_finding(f"{file}:anticlockwise").misreading
    worlds = [map_ for m in (1, 2, 3) for map_ in rooted_maps(m)]
    assert (misreading.edges, misreading.among) == (3, "maps")
    assert misreading.runs == sum(map_.degree_at[0] for map_ in worlds)


def runs_of(edges, map_class, where=None):
    """The number of runs in all maps of the class with so many edges, under a directional one."""
    return sum(map_.degree_at[0] for map_ in rooted_maps(edges, map_class, where=where))


@pytest.mark.parametrize(
    ("map_class", "edges", "where", "tried"),
    [
        ("maps", 5, None, 4),
        ("planar", 4, None, 4),
        ("planar-simple", 5, None, 5),  # up to 4 edges there are too few
        ("planar-simple", 4, None, 4),
        ("maps", 4, "trees", 4),
    ],
)
def test_a_trial_is_in_all_worlds_of_the_class_and_condition(map_class, edges, where, tried, file):
    found = replace(first_finding(f"{file}:twice"), world=TRIANGLE_AND_LEAF)
    extent = Extent(MapClass(map_class), edges, where=condition_named(where) if where else None)
    trial = trial_worlds(found, extent)
    due = sum(runs_of(m, extent.map_class, extent.where) for m in range(1, tried + 1))
    assert len({*trial}) == len(trial) == due <= MOST
    assert max(world.map.edge_count for world in trial) == tried
    if where is None:
        assert canonical_world(found.world.mirrored()) in map(canonical_world, trial)


# ---------------------------------------------------------------- what looks like it, and is not


@pytest.mark.parametrize("hand", ["left", "right"])
def test_a_wall_follower_counts_as_it_should_though_a_mirror_image_were_right(hand, file):
    finding = first_finding(f"{file}:{hand}", edges=5, map_class="planar-simple", task="cover")
    assert (finding.law, finding.world.map.edge_count) == ("budget", 4)
    assert told_of_run(finding).slip is None
    assert "counts" not in " ".join(told_of_run(finding).sentences)


def test_a_convention_is_told_only_if_the_explorer_as_it_is_fails_in_the_trial(file):
    options = {"map_class": "planar-simple", "task": "cover", "schedules": "all"}
    finding = first_finding(f"{file}:in_one_schedule", **options)
    assert finding.choices == (1,)
    # In the other schedule, that of the trial, both hands are right up to three edges.
    assert finding.misreading is None


def test_a_convention_is_told_only_if_the_translated_explorer_is_right_in_all_small_worlds(file):
    finding = first_finding(f"{file}:no_star")
    assert finding.world.map.edge_count < 3
    assert finding.misreading is None


@pytest.mark.slow
def test_worlds_as_large_as_that_of_the_finding_are_among_them(file):
    given = {"worlds": [TRIANGLE_AND_LEAF], "edges": None}
    assert first_finding(f"{file}:no_tree_of_4_edges", **given).misreading is None
    told = first_finding(f"{file}:anticlockwise", map_class="planar-simple", **given).misreading
    assert (told.convention, told.edges) == ("motions-anticlockwise", 4)


def test_a_slip_that_shows_only_in_worlds_of_four_edges_is_told(file):
    scope = {"edges": 5, "map_class": "planar-simple", "engine": "python"}
    finding = first_finding(f"{file}:anticlockwise", **scope)
    assert finding.world.map.edge_count == 4
    assert finding.misreading.convention == "motions-anticlockwise"
    assert finding.misreading.edges == 5


def test_of_a_world_too_large_for_all_of_its_size_no_convention_is_told(file):
    finding = first_finding(f"{file}:anticlockwise", worlds=[FIVE_EDGES], edges=None)
    assert finding.world.map.edge_count == 5
    assert finding.misreading is None


def test_an_explorer_for_a_condition_is_tried_under_it(file):
    finding = first_finding(f"{file}:cubic_alone", where="cubic")
    assert finding.misreading.among == "maps, cubic,"
    assert "in the class maps, cubic, with up to 3 edges" in told_of_run(finding).sentences[0]


def test_what_was_seen_is_kept_with_the_finding_and_not_in_its_document(file):
    finding = first_finding(f"{file}:from_1")
    assert finding_from_record(finding_to_record(finding)).misreading == finding.misreading
    assert "misreading" not in finding.to_json()


def test_a_finding_that_was_read_is_tried_anew_unless_its_explorer_has_changed(file, tmp_path):
    own = tmp_path / "own.py"
    shutil.copy(file, own)
    finding = first_finding(f"{own}:from_1")
    read = Finding.from_json(finding.to_json())
    assert read.misreading is None
    told, anew = told_of_run(finding).sentences, explain(read).sentences
    # The class of its check is not in its document.
    assert [anew[0].replace("206 runs in the class planar", "309 runs in the class maps")] == [
        told[0]
    ]
    assert anew[1:] == told[1:]
    own.write_text(MISREADING.replace("k + 1", "k + 2"), encoding="utf-8")
    assert explain(read).slip is None


def test_a_finding_without_its_explorer_is_explained_all_the_same(file):
    finding = replace(first_finding(f"{file}:from_1"), explorer="gone.py:explore")
    assert explain(Finding.from_json(finding.to_json())).slip is None


def test_a_convention_that_is_none_is_refused():
    with pytest.raises(InputError, match=r"convention 'x' is not one of motions-anticlockwise, "):
        check("translated:x:folding")
    with pytest.raises(InputError, match=r"convention '' is not one of"):
        check("translated:")


@pytest.mark.slow
def test_the_slip_of_a_program_is_named(tmp_path):
    if shutil.which("node") is None:
        pytest.skip("there is no node")
    text = (EXAMPLES / "javascript" / "algorithm1.js").read_text(encoding="utf-8")
    right = "{ move: value }"
    assert right in text
    file = tmp_path / "slip.js"
    file.write_text(text.replace(right, "{ move: -value }"), encoding="utf-8")
    finding = first_finding(f"exec:node {file}")
    assert told_of_run(finding).slip == "motions anticlockwise"
