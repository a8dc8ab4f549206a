"""What ``team``, and ``replay`` and ``explain`` of its findings, say in words, to the letter."""

from types import SimpleNamespace

import pytest

from allworlds.documents.document import replace
from allworlds.outcome import Verdict
from allworlds.reports.content import team as content
from allworlds.reports.content.team import (
    _cases,
    _gate,
    _rows_of,
    headline_of,
    sensed_in_words,
    sequence_of,
    team_content,
    team_explain_content,
    team_replay_content,
    verdict_of,
)
from allworlds.reports.formats import file_of, text
from allworlds.reports.parts import RunRow
from allworlds.reports.web.sections import _event
from allworlds.studies.team.finding_reports import TeamExplanation
from html_tree import read
from studies.test_team import PROGRAMS, team

HOLDS = """\
HOLDS      44 worlds with starts, 2 robots, every fsync schedule; 69 configurations; at most 5
           activations of a robot in a run that ends

What was searched

programs   PROGRAMS:waits, PROGRAMS:searches
model      meeting:apart=false
scope      every start that the model allows in every map of the class 'maps' with at most 2 edges;
           every fsync schedule
gate       no map was forgotten: the number equals an independent count (log-series of
           permutations)
schedules  44

Finished levels
edges  vertices  maps  worlds  configurations  in a world  longest run
    1         1     1       2               2           1            0
    1         2     1       2               3           2            1
    2         1     3      12              12           1            0
    2         2     5      20              34           6            5
    2         3     2       8              18           5            4
"""

ASYNC = """\
REFUTED    law progress is broken: the run goes on for ever without the goal; 14 configurations

Finding 1: progress, 1 edge and 2 vertices

broken     progress: the run goes on for ever without the goal
map        sigma [0, 1], alpha [1, 0]
starts     robot 0 at dart 0 of v0, robot 1 at dart 1 of v1
model      meeting, scheduler async

    robot 0               robot 1               world
1*  degree 1: move 0 ...  |
2*  |                     degree 1: move 0 ...
3*  '-> move 0            '-> move 0            0 at v1, 1 at v0
4*  degree 1: move 0 ...  degree 1: move 0 ...
5*  '-> move 0            '-> move 0            0 at v0, 1 at v1
(the events with * repeat for ever)

Again
  allworlds team PROGRAMS:other_end --model meeting --robots 2 --scheduler async --budget 1000 \
--world '{"sigma":[0,1],"alpha":[1,0]}' --starts 0,1

What was searched

programs   PROGRAMS:other_end, PROGRAMS:other_end
model      meeting
scope      every start that the model allows in every map of the class 'maps' with at most 1 edge;
           every async schedule
gate       no map was forgotten: the number equals an independent count (log-series of
           permutations)
numbers    starts that are equal but for the numbers of the robots are searched separately

Finished levels
edges  vertices  maps  worlds  configurations  in a world  longest run
    1         1     1       0               0           0            0
    1         2     1       1              14          14            0
"""

SEQUENCE = """\
@startuml
title progress: the run goes on for ever without the goal
participant "robot 0" as r0
participant "robot 1" as r1
participant "world" as w
loop for ever
r0 --> w : degree 1: move 0 ...
r1 --> w : degree 1: move 0 ...
r0 -> w : '-> move 0
r1 -> w : '-> move 0
r0 --> w : degree 1: move 0 ...
r1 --> w : degree 1: move 0 ...
r0 -> w : '-> move 0
r1 -> w : '-> move 0
end
@enduml
"""


@pytest.fixture(scope="module")
def holds():
    return team("waits", "searches", edges=2)


@pytest.fixture(scope="module")
def refuted():
    return team("other_end", model="meeting", scheduler="async", edges=1)


@pytest.fixture(scope="module")
def cut_off():
    return team("waits", "polls", edges=1, budget=4)


def shown(report):
    # The name of the file is of any length: lines are made anew with a short one.
    whole = text(report, 400 + len(str(PROGRAMS))).replace(str(PROGRAMS), "PROGRAMS")
    return whole.rstrip("\n")


def unfolded(expected):
    """An expected text, with each line that goes on in the column of words in one piece."""
    return expected.replace("\n           ", " ").rstrip("\n")


def test_what_holds_is_told_with_its_scope_and_its_counts(holds):
    assert shown(holds) == unfolded(HOLDS)


def test_a_finding_is_told_with_its_run(refuted):
    assert shown(refuted) == unfolded(ASYNC)


def test_a_run_is_a_sequence_diagram_of_plantuml(refuted):
    assert sequence_of(refuted.findings[0]) == SEQUENCE


def test_what_the_world_does_is_a_note_of_the_diagram(refuted):
    found = refuted.findings[0]
    events = [replace(event, world="edge 0 is missing") for event in found.events]
    lines = sequence_of(replace(found, events=events)).splitlines()
    assert lines.count("note over w : edge 0 is missing") == len(events)
    assert lines[-3:] == ["note over w : edge 0 is missing", "end", "@enduml"]


def test_a_finding_has_a_line_of_its_own(refuted):
    said = headline_of(refuted.findings[0]).replace(str(PROGRAMS), "PROGRAMS")
    assert said == "PROGRAMS:other_end breaks the law 'progress' with 1 edge and 2 vertices"


def test_the_events_of_a_run_are_rows_of_the_page(refuted):
    start, *_, before, last = _rows_of(refuted.findings[0])
    assert (start.name, start.robots, start.world, start.darts) == ("", (), "", (0, 1))
    assert (before.name, before.world, before.darts, before.moved) == ("0L+1L", "", (1, 0), [])
    assert last.name == "0M+1M"
    assert last.robots == ["robot 0: '-> move 0", "robot 1: '-> move 0"]
    assert (last.world, last.darts, last.moved) == ("0 at v0; 1 at v1", (0, 1), [0, 1])
    assert last.repeats


def test_a_run_that_is_cut_off_is_told_and_is_no_finding(cut_off):
    said = shown(cut_off)
    assert said.startswith(
        "INCONCLUSIVE no law is broken, but 1 run went on after 4 activations of each robot; "
        "4 worlds with starts, 2 robots, every fsync schedule; 8 configurations\n"
    )
    assert "\nA run that is cut off, with 1 edge and 2 vertices\n" in said
    assert "\n2  |                degree 1: wait\n" in said
    assert "schedules" not in said
    assert "repeat for ever" not in said


@pytest.mark.parametrize(
    ("options", "said"),
    [
        (
            {"configurations": 2},
            "INCONCLUSIVE no law is broken, but 1 world had more than 2 configurations, the limit ",
        ),
        (
            {"where": "cubic"},
            "VACUOUS    the scope holds no map in which the robots can start",
        ),
        ({"within": 4}, "REFUTED    law budget is broken: the goal is not reached within 4 "),
    ],
)
def test_the_first_line_says_what_came_out(options, said):
    assert shown(team("waits", "polls", edges=1, **options)).startswith(said)


def test_where_no_robot_is_activated_nobody_is_said_to_be():
    at_once = team("waits", "polls", edges=1, world="loop")
    assert verdict_of(at_once).text == (
        "2 worlds with starts, 2 robots, every fsync schedule; 2 configurations"
    )


@pytest.mark.parametrize(
    ("options", "said"),
    [
        ({"within": 1}, "within 1 activation of each robot"),
        ({"lead": 2, "scheduler": "ssync"}, "no robot more than 2 activations ahead of another"),
        ({"start_delay": 2}, "robot 1 begins up to 2 rounds later"),
    ],
)
def test_the_schedules_are_told_with_their_bounds(options, said):
    report = team("waits", "polls", edges=1, **({"budget": 4} | options))
    scope = dict(content.scope_words(report))["scope"]
    assert scope.endswith(f"; every {report.asked.timing.scheduler} schedule, {said}")


def test_of_given_starts_it_is_said_that_they_are_given():
    report = team("waits", world='{"sigma":[0,1],"alpha":[1,0]}', starts=(0, 1), budget=4)
    said = dict(content.scope_words(report))
    assert said["scope"].startswith("the given starts in ")
    assert said["numbers"] == ""
    assert said["gate"] == report.extent.given.gate


def test_robots_with_programs_of_their_own_are_not_anonymous(holds, refuted):
    assert dict(content.scope_words(holds))["numbers"] == ""
    assert dict(content.scope_words(refuted))["numbers"]


def test_the_gate_names_the_first_size_that_differs():
    cells = [
        SimpleNamespace(edges=2, vertices=n, agrees=n == 1, enumerated=n, counted=9, source="Tutte")
        for n in (1, 2, 3)
    ]
    report = SimpleNamespace(extent=SimpleNamespace(given=None), whole=True, cells=cells)
    assert _gate(report) == (
        "MISMATCH: the enumeration found 2 maps with 2 edges and 2 vertices, but the independent "
        "count (Tutte) is 9"
    )
    report.whole = False
    assert _gate(report) == "not for a shard: the merge of all shards compares the counts"


def test_each_number_of_edges_is_a_case(holds, refuted, cut_off):
    assert [(case.name, case.result) for case in _cases(holds)] == [
        ("every world with 1 edge", "passed"),
        ("every world with 2 edges", "passed"),
    ]
    (failed,) = _cases(refuted)
    assert (failed.result, failed.kind) == ("failure", "progress")
    assert failed.message == "the run goes on for ever without the goal"
    assert [section.name for section in failed.sections] == ["finding-1"]
    (left,) = _cases(cut_off)
    assert (left.result, left.message) == ("skipped", "the budget is too small for a verdict")


def test_the_command_names_each_program_once_where_all_are_one(refuted, holds):
    said = team_content(refuted).command.replace(str(PROGRAMS), "PROGRAMS")
    assert said == "PROGRAMS:other_end --edges 1 --scheduler async"
    assert team_content(holds).command.count(str(PROGRAMS)) == 2


def test_the_rows_have_the_counts_of_each_size(holds):
    rows = file_of("csv", holds).splitlines()
    assert rows[0].startswith("edges,vertices,maps,worlds,configurations,")
    assert rows[-1].startswith("2,3,2,8,18,")


REPLAYED = [
    ("progress", "reproduced", "REPRODUCED", "law 'progress' is broken again"),
    ("budget", "reproduced", "REPRODUCED", "law 'budget' is broken, not 'progress'"),
    (None, "reproduced", "REPRODUCED", "law 'progress' is broken again"),
    (None, "fixed", "FIXED", "a, b: no law is broken in the recorded world"),
    (
        *(None, "not-reproduced", "NOT REPRODUCED"),
        "a, b: the budget is too small to tell if the recorded world breaks a law",
    ),
]


@pytest.mark.parametrize(("now", "outcome", "word", "said"), REPLAYED)
def test_a_replay_says_what_is_broken_now(now, outcome, word, said):
    again = SimpleNamespace(explorers=["a", "b", "a"], findings=[])
    replay = SimpleNamespace(again=again, law="progress", law_now=now, outcome=outcome)
    told = team_replay_content(replay)
    assert (told.headline.word, told.headline.text) == (word, said)


def test_an_explanation_has_sentences_and_the_run(refuted):
    explained = TeamExplanation(finding=refuted.findings[0], number=1, findings=1)
    words, run = team_explain_content(explained).sections
    assert [block.text for block in words.blocks] == [*explained.sentences]
    assert (run.name, run.title) == ("run", "The run")


def test_a_percept_is_told_in_few_words():
    turn = SimpleNamespace(sensed={"degree": 3, "marks": 0, "bearing": None})
    assert sensed_in_words(turn, 7) == "degree 3"
    turn.sensed = [1, {"a": 2}]
    assert sensed_in_words(turn, 11) == '[1,{"a":2}]'
    assert sensed_in_words(turn, 10) == '[1,{"a":..'


def test_where_robots_come_or_go_no_move_is_told():
    assert [*content._moved((0, 1), (0, 1, 2), (0, 0, 1))] == []
    assert [*content._moved((0, 1), (2, None), (0, 0, 1))] == ["0 at v1", "1 is gone"]


def test_a_search_that_is_stopped_gives_its_reason(holds):
    ending = SimpleNamespace(stopped=True, reason="the time is over")
    stopped = SimpleNamespace(
        verdict=Verdict.INCONCLUSIVE,
        ending=ending,
        total=SimpleNamespace(worlds=3, configurations=4, longest=0, cut_off=1, full=1),
        explorers=("a", "b"),
        asked=holds.asked,
    )
    assert verdict_of(stopped).text == (
        "the time is over; 3 worlds with starts, 2 robots, every fsync schedule; 4 configurations"
    )


@pytest.mark.parametrize(("robots", "whole"), [(2, 19), (3, 8), (4, 7)])
def test_percepts_are_cut_where_the_columns_of_all_robots_would_be_too_wide(robots, whole):
    def cell(length):
        turn = SimpleNamespace(robot=0, phase="whole", sensed="x" * (length - 2), did="wait")
        event = SimpleNamespace(robots=[turn], darts=(), world="")
        found = SimpleNamespace(
            starts=(0,) * robots, map=SimpleNamespace(vertex_of=(0,)), loop=0, events=[event]
        )
        return content.diagram(found)[1].split()[1]

    assert cell(whole) == f'"{"x" * (whole - 2)}":'
    assert cell(whole + 1) == f'"{"x" * (whole - 3)}..:'


def test_the_page_of_a_run_has_its_events_one_after_the_other(refuted):
    viewer = read(file_of("html", refuted)).one(class_="viewer", role="group", tabindex="0")
    events = viewer.one("ol", class_="walk")
    assert (events.attributes["start"], events.attributes["role"]) == ("0", "list")
    start, first, *_, last = events.all("li")
    assert [each.text for each in start.children] == ["0", "start", "", ""]
    assert (start.attributes["data-robots"], "data-moved" in start.attributes) == ("0 1", False)
    assert first.one("a").attributes["href"] == f"#{first.attributes['id']}"
    assert [each.text for each in last.children] == [
        *("5*", "0M+1M", "0 at v0; 1 at v1"),
        "robot 0: '-> move 0; robot 1: '-> move 0",
    ]
    assert last.attributes["data-robots"] == "0 1"
    assert last.attributes["data-moved"] == "0 1"
    assert "data-vertices" not in last.attributes


def test_words_at_vertices_and_edges_are_data_of_an_event():
    row = RunRow("e", ("a", "b"), "", (0, None), (), {1: "token"}, {2: "cut"})
    event = _event(row, 3, "step-3")
    assert event.get("data-robots") == "0 -"
    assert event.get("data-vertices") == '{"1": "token"}'
    assert event.get("data-edges") == '{"2": "cut"}'
    assert event.find("span[@class='sensed']").text == "a; b"
    assert event.find("a").text == "3"


def test_a_finding_of_a_team_is_told_at_the_program_that_is_to_blame(refuted):
    said = file_of("annotations", refuted)
    assert said.startswith("::error file=tests/support/teams.py,line=1,title=")
    assert "teams.py%3Aother_end breaks the law 'progress' with 1 edge and 2 vertices::" in said


def test_without_a_finding_the_diagram_is_empty_or_that_of_the_run_that_is_cut_off(holds, cut_off):
    assert file_of("plantuml", holds) == "@startuml\n@enduml\n"
    assert "title budget: the run goes on" in file_of("plantuml", cut_off)
