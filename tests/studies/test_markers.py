"""Explorers of others under the lighthouses with markers in hand, and under labels."""

import json
import sys
from pathlib import Path

import pytest

import allworlds
from allworlds.inputs.checks import InputError
from allworlds.judging.belief import believed_percepts, trail_to
from allworlds.judging.findings.finding import Finding
from allworlds.judging.walk import Walk
from allworlds.maps import MapClass
from allworlds.protocol.actions import Drop, Move, Percept, Pick
from allworlds.reports.formats import text
from allworlds.world import Movable, World
from allworlds.world.lighthouses.marked import Labels
from small import EDGE, LOLLIPOP, PATH

pytestmark = pytest.mark.usefixtures("without_workers")

FILE = str(Path(__file__).parents[1] / "support" / "explorers_for_tests" / "markers.py")


def in_answer(walk, map_, here):
    """The percepts to expect in an answer, by the walk that ends at ``here``."""
    return believed_percepts(walk, map_, trail_to(map_, here, walk))


def found(name, lighthouse, edges=2, **options):
    """The finding of an explorer of the file."""
    report = allworlds.check(
        f"{FILE}:{name}", edges=edges, lighthouse=lighthouse, workers=1, **options
    )
    assert report.verdict.value == "refuted"
    return report.findings[0]


def test_a_cluster_that_the_robot_lays_itself_is_a_lighthouse_in_simple_worlds():
    report = allworlds.check(
        f"{FILE}:lays_a_cluster",
        edges=4,
        map_class=MapClass.SIMPLE.value,
        lighthouse="movable:markers=3,pick=false",
    )
    assert (report.verdict.value, report.exit_code) == ("holds", 0)


def test_with_fewer_markers_it_does_what_is_illegal():
    finding = found("lays_a_cluster", "movable:markers=2", map_class="simple")
    assert finding.law == "illegal-action"
    assert finding.expected == "a Drop only with a marker in hand"
    assert finding.seen == "Drop()"
    assert finding.confirmed


@pytest.mark.parametrize(
    ("name", "lighthouse", "expected"),
    [
        ("drops_two", "movable", "a Drop only with a marker in hand"),
        ("drops_two", "labels", "the labels lighthouse gives no markers"),
        ("drops_two", "directional", "the directional lighthouse gives no markers"),
        ("takes_at_once", "movable", "a Pick only where a marker lies"),
        ("takes_where_none_lies", "movable", "a Pick only where a marker lies"),
        ("drops_and_takes", "movable:pick=false", "no Pick: under pick=false a marker stays"),
        ("drops_a_class", "movable", "a Move, Drop, Pick, Write or Checkpoint"),
        ("drops_something_else", "movable", "a Move, Drop, Pick, Write or Checkpoint"),
    ],
)
def test_what_the_lighthouse_does_not_allow_is_an_illegal_action(name, lighthouse, expected):
    finding = found(name, lighthouse, map_class="simple")
    assert finding.law == "illegal-action"
    assert finding.expected.startswith(expected)
    assert finding.confirmed


def test_markers_are_free_but_not_for_ever():
    finding = found("plays_with_its_marker", "movable", step_budget=3)
    assert (finding.law, finding.transcript.cost) == ("budget", 0)
    assert finding.expected == "at most 40 markers dropped and picked up"
    assert len(finding.transcript.steps) == 40
    assert finding.confirmed


def test_who_drops_otherwise_the_second_time_is_nondeterministic():
    assert found("drops_now_and_then", "movable").law == "nondeterministic"


def test_a_finding_with_markers_is_written_read_replayed_drawn_and_explained():
    finding = found("drops_and_takes", "movable")
    assert finding.law == "map"
    assert finding.confirmed
    document = finding.to_json()
    assert document["world"]["lighthouse"] == {"kind": "movable", "markers": 1, "pick": True}
    steps = [next(iter(step)) for step in document["transcript"][1:]]
    assert steps == ["drop", "move", "move", "pick"]
    again = Finding.from_json(json.loads(json.dumps(document)))
    assert again.transcript == finding.transcript
    assert allworlds.replay(again).outcome == "reproduced"
    told = text(allworlds.explain(again), 100)
    assert "differ" in told
    assert text(allworlds.run(f"{FILE}:drops_and_takes", finding.world), 100)


def test_a_marker_that_lies_at_the_end_of_the_walk_is_in_the_picture():
    lying = text(allworlds.run(f"{FILE}:marks_its_start", World(PATH, Movable())), 100)
    assert "●" in lying
    taken = text(allworlds.run(f"{FILE}:drops_and_takes", World(PATH, Movable())), 100)
    assert "●" not in taken


def test_a_transcript_that_drops_what_there_is_not_is_no_walk():
    finding = found("drops_two", "movable").to_json()
    finding["transcript"].append({"drop": True, "percept": {"degree": 1, "marks": 2}})
    with pytest.raises(InputError, match="no walk in its world: a Drop only with"):
        allworlds.replay(Finding.from_json(finding))


def test_the_fuzzer_shrinks_worlds_with_markers():
    report = allworlds.fuzz(
        f"{FILE}:drops_and_takes", edges=8, runs=20, seed=1, lighthouse="movable", workers=1
    )
    finding = report.findings[0]
    assert (finding.law, finding.world.map.edge_count) == ("map", 1)
    assert finding.world.lighthouse == Movable()


def test_an_answer_makes_expect_the_markers_where_it_takes_them_to_lie():
    world = World(LOLLIPOP, Movable())
    walk = Walk.of(world, [Drop(), Move(0), Move(1)])
    assert [percept.marks for percept in walk.percepts] == [0, 1, 0, 0]
    assert [state.lying for state in walk.states] == [(), (0,), (0,), (0,)]
    # The answer takes every motion for one along the only edge.
    believed = in_answer(walk, EDGE, 0)
    assert believed == [Percept(1, marks) for marks in (0, 1, 0, 1)]
    # There the robot takes up a marker where it has dropped none.
    more = Walk.of(world, [Drop(), Move(0), Move(1), Move(1), Pick()])
    assert [percept.marks for percept in more.percepts] == [0, 1, 0, 0, 1, 0]
    assert [percept.marks for percept in in_answer(more, EDGE, 0)] == [0, 1, 0, 1, 0, 0]


def test_under_labels_an_answer_makes_expect_what_was_first_sensed_at_each_vertex():
    (place,) = Labels.places(PATH, 0)
    world = World(PATH, place)
    walk = Walk.of(world, [Move(0), Move(1)])
    assert [percept.marks for percept in walk.percepts] == [1, 2, 3]
    believed = in_answer(walk, EDGE, 0)
    assert [percept.marks for percept in believed] == [1, 2, 1]
    assert in_answer(walk, PATH, walk.here) == walk.percepts


def test_a_program_drops_and_picks_up(tmp_path):
    script = tmp_path / "program.py"
    script.write_text(
        """
import json, sys
EDGE = {"sigma": [0, 1], "alpha": [1, 0], "here": 0}
walk = []
for line in sys.stdin:
    message = json.loads(line)
    if "episode" in message:
        walk = [{"drop": True}, {"move": 0}, {"move": 0}, {"pick": True}, {"estimate": EDGE}]
    print(json.dumps(walk.pop(0)), flush=True)
"""
    )
    report = allworlds.check(f"exec:{sys.executable} {script}", edges=1, lighthouse="movable")
    finding = report.findings[0]
    assert (finding.law, finding.world.map.vertex_count) == ("map", 1)
    steps = [next(iter(step)) for step in finding.to_json()["transcript"][1:]]
    assert steps == ["drop", "move", "move", "pick"]
    held = allworlds.run(f"exec:{sys.executable} {script}", World(EDGE, Movable()))
    assert held.verdict.value == "holds"
    assert [percept.marks for percept in held.outcome.episode.transcript.percepts] == [
        *(0, 1, 0, 1, 0)
    ]


def test_a_cluster_has_no_place_in_a_world_of_one_vertex_which_is_counted():
    report = allworlds.check("algorithm1-cluster", edges=2, lighthouse="cluster:single=true")
    alone = sum(row.worlds for row in report.tally.rows.values() if not row.runs)
    assert report.tally.left_out >= alone > 0
    for row in report.to_json()["rows"]:
        if row["vertices"] == 1:
            assert (row["runs"], row["worlds"] > 0) == (0, True)


def test_a_natural_lighthouse_whose_promise_is_false_is_refused():
    with pytest.raises(InputError, match="natural cannot stand at dart 0"):
        World.from_json({**PATH.to_json(), "lighthouse": {"kind": "natural", "dart": 0}})


def test_who_is_told_nothing_where_something_is_needed_is_refuted_and_does_not_crash():
    report = allworlds.check("algorithm1-natural", edges=1, lighthouse="position")
    assert report.findings[0].law == "budget"


def test_twins_are_not_compared_where_the_robot_has_markers():
    with pytest.raises(InputError, match="the robot leaves marks itself"):
        allworlds.twins(World(PATH, Movable()), World(PATH, Movable()))


@pytest.mark.parametrize(
    ("explorer", "options", "verdict"),
    [
        (FILE + ":in_a_cluster", {"lighthouse": "cluster:single=true"}, "holds"),
        (FILE + ":in_a_cluster", {"lighthouse": "position"}, "refuted"),
        (FILE.replace("markers", "folding") + ":explore", {"bound": "none"}, "holds"),
        (FILE.replace("markers", "folding") + ":explore", {"bound": "m"}, "refuted"),
    ],
)
def test_explorers_of_others_get_their_verdicts_under_other_lighthouses(explorer, options, verdict):
    assert allworlds.check(explorer, edges=3, **options).verdict.value == verdict
