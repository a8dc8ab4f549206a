"""The explanation that each law gives of a run that breaks it."""

import re
from pathlib import Path

import pytest

from allworlds.documents.document import replace
from allworlds.inputs.checks import InputError
from allworlds.judging.explanations.by_law import TELLERS, _say_sizes, tell_whose_bound
from allworlds.judging.explanations.story import Story
from allworlds.judging.findings.finding import Finding
from allworlds.judging.laws.bounds import BOUNDS
from allworlds.judging.laws.law_table import PRECEDENCE
from allworlds.judging.rules import Rules
from allworlds.maps import CombinatorialMap
from allworlds.protocol.actions import Estimate, Move
from allworlds.studies.explain import explain
from allworlds.studies.run import run
from allworlds.world import Directional, World
from small import EDGE, LASSO, PATH, TRIANGLE

VERDICTS = Path(__file__).parents[2] / "docs" / "verdicts.md"

# ---------------------------------------------------------------- the run ended too early


def test_a_crash_is_told_with_its_last_step_and_the_last_line_of_the_traceback(told):
    law, _, text = told("crashes-at-leaves")
    assert law == "crash"
    assert "step, 1 (move 0), the robot was at v1, dart 1, and sensed 'degree 1'" in text
    # It stands in what was seen, and is not said twice.
    assert text.count("IndexError: a vertex without another dart") == 1


def test_of_what_a_program_wrote_the_line_that_tells_is_told(finding_of):
    wrote = "/mine.js:3\n\nReferenceError: f is not defined\n    at g (/mine.js:3:1)\n\nNode.js v20"
    finding = replace(finding_of("crashes-at-leaves"), seen="the end of its output", detail=wrote)
    assert explain(finding).sentences[-1] == (
        "The explorer's last message: ReferenceError: f is not defined"
    )


@pytest.mark.parametrize(
    ("end", "advised"),
    [("signal 11", True), ("signal 6", False), ("signal 9", False), ("exit code 6", False)],
)
def test_an_end_by_damaged_memory_tells_how_its_place_is_found(end, advised, finding_of):
    seen = f"the end of its process ({end})"
    told = explain(replace(finding_of("crashes-at-leaves"), seen=seen, detail="")).sentences
    assert ("-fsanitize=address" in " ".join(told)) == advised


def test_a_line_without_an_action_tells_where_output_for_debugging_goes(finding_of):
    finding = replace(finding_of("drops-markers"), explorer="exec:./mine", detail="")
    for seen in ("a line that is no JSON: 'x'", "the line {'a': 1}: it has none of the keys move"):
        assert "debugging to stderr" in explain(replace(finding, seen=seen)).sentences[1]
    assert "stderr" not in " ".join(explain(replace(finding, seen="a Drop")).sentences)


def test_a_program_that_prints_out_of_turn_is_told_so_even_where_its_plays_differ(finding_of):
    seen = "the second answer differs; the second ended with: a line before it was asked"
    finding = replace(
        finding_of("crashes-at-leaves"), law="nondeterministic", seen=seen, explorer="exec:./mine"
    )
    assert "debugging to stderr" in explain(finding).sentences[1]
    kept = explain(replace(finding, seen="the second answer differs")).sentences[1]
    assert "Does the explorer keep something" in kept


def test_a_run_that_ends_at_the_start_has_no_last_step(told):
    law, _, text = told("drops-markers")
    assert law == "illegal-action"
    assert "The robot made no step" in text


@pytest.mark.parametrize(
    ("name", "law", "words"),
    [
        ("no-answer", "no-estimate", "without an answer that could be judged"),
        ("never-stops", "budget", "did not end within its step budget"),
        ("state-kept", "nondeterministic", "the explorer acted differently"),
    ],
)
def test_other_endings_are_told(name, law, words, told):
    found, step, text = told(name)
    assert (found, step) == (law, None)
    assert words in text


def test_a_timeout_is_told(finding_of):
    finding = replace(finding_of("crashes-at-leaves"), law="timeout", seen="silent", detail="")
    text = " ".join(explain(finding).sentences)
    assert "silent for too long" in text
    assert "last message" not in text
    assert "flush" not in text


def test_a_program_that_was_silent_is_asked_whether_it_flushes(finding_of):
    finding = finding_of("crashes-at-leaves")
    silent = replace(finding, explorer="exec:./mine", law="timeout", seen="silent", detail="")
    assert "newline after every line, and then flush its output?" in " ".join(
        explain(silent).sentences
    )


# ---------------------------------------------------------------- the answer is wrong


def test_a_lost_pose_says_where_the_robot_is_and_how_far_it_is_turned(told):
    law, step, text = told("pose-lost")
    assert (law, step) == ("pose", 2)
    # Two loops side by side, at dart 3; 'here' is dart 0, which the symmetry takes to dart 2.
    assert "stands at v0, dart 3; the answer says dart 0 of the same vertex" in text
    assert "the same vertex, 1 dart too far clockwise" in text
    assert "As the map is symmetric, 1 other dart would be right besides dart 3." in text


def test_a_robot_at_another_vertex_is_told_so(explained, answering):
    # A vertex of degree 3 with a loop and a leaf: no symmetry.
    explanation = explained(LASSO, answering(LASSO, 3, 0))
    assert explanation.law == "pose"
    assert "stands at v0, dart 1; the answer says v1, dart 3." in explanation.sentences[0]
    assert explanation.slip == "another vertex"


def test_where_bearings_may_be_counted_the_wrong_way_a_pose_finding_says_so():
    # Two vertices with a loop each; read anticlockwise, the bearings fit a walk to dart 1.
    map_ = CombinatorialMap((1, 2, 0, 4, 5, 3), (2, 3, 0, 1, 5, 4))

    def explore(_):
        yield Move(0)
        yield Move(1)
        return Estimate(map_, 1)

    explanation = explain(run(explore, World(map_, Directional(0)), laws=["pose"]).finding)
    assert explanation.slip == "bearings anticlockwise"
    assert explanation.sentences[0].startswith("The map is right, but 'here' is wrong: the robot s")
    assert explanation.sentences[1].startswith("Or: The explorer seems to count bearings anticlock")


def test_a_checkpoint_behind_the_walk_is_refused(finding_of):
    finding = finding_of("pose-lost")
    steps = len(finding.transcript.steps)
    assert Story(replace(finding, step=steps)).checkpoint == steps
    with pytest.raises(
        InputError, match=rf"^step = {steps + 1} is behind the walk, which has {steps} steps$"
    ):
        Story(replace(finding, step=steps + 1))


def test_a_pose_finding_whose_answer_is_another_map_is_refused(finding_of):
    finding = finding_of("pose-lost")
    with pytest.raises(InputError, match="not pose"):
        explain(replace(finding, seen=Estimate(EDGE, 0)))


@pytest.mark.parametrize("here", [99, -1, None, True, "0"])
def test_an_answer_without_a_place_is_refused(here, finding_of):
    told = finding_of("pose-lost").to_json()
    with pytest.raises(InputError, match=r"seen\.here"):
        Finding.from_json({**told, "seen": {**told["seen"], "here": here}})


# ---------------------------------------------------------------- a checkpoint is wrong


@pytest.mark.parametrize(
    ("name", "law"), [("place-shown-wrong", "invariant-1"), ("partner-shown-in-U", "invariant-2")]
)
def test_a_wrong_checkpoint_is_told_with_its_step(name, law, told):
    found, step, text = told(name)
    assert (found, step) == (law, 1)
    assert "checkpoint came after step 1, where the robot stood at v0, dart 1" in text


def test_a_pass_without_progress_is_told(told):
    law, step, text = told("pass-without-progress")
    assert (law, step) == ("variant", None)
    assert "S must gain an edge from each checkpoint to the next; here it did not" in text
    assert "after step 1" in text


# ---------------------------------------------------------------- the answer was guessed


def test_folding_counts_the_open_darts_and_names_the_vertex_seen_as_several(told):
    law, step, text = told("no-retracing")
    assert (law, step) == ("folding", None)
    assert re.search(
        r"it is not known where dart \d of v\d, dart \d of v\d and dart \d of v\d lead", text
    )
    assert (
        "came to v1 by 2 paths, and the log does not show that this was always the same vertex"
        in text
    )


# ---------------------------------------------------------------- the answer was dear


def test_the_bound_is_told_with_what_the_traversals_found(told):
    # One loop: (1)+(2) is 1; it walks the loop, back, and on again.
    law, _, text = told("walks-too-much")
    assert law == "bound"
    assert "The map and the pose are right" in text
    assert "The bound 'paper' is (1) + (2), which the paper proves for its Algorithm 1" in text
    assert "In a world with 1 edge and 1 vertex (1) + (2) is 0 + 1 = 1." in text
    assert "With --edges 3 --bound none no law is broken" in text
    assert "The robot made 3 traversals, of which 1 found a new edge." in text


@pytest.mark.parametrize(
    ("rules", "said"),
    [
        (
            {"bound": "m - 1"},
            "The bound that was asked for is m - 1, which is 1 in",
        ),
        (
            {"bound": "m - 1", "laws": ("map", "bound")},
            "law that was checked holds: map.",
        ),
        ({"bound": "m - 1", "laws": ("bound",)}, "The walk is longer than the bound allows."),
    ],
)
def test_it_is_told_whose_the_bound_is(rules, said, answering):
    finding = run(answering(PATH, 0, 0, 1, 0, 1), World(PATH, Directional(0)), **rules).finding
    assert said in " ".join(explain(finding).sentences)
    assert ("the pose are right" in " ".join(explain(finding).sentences)) == ("laws" not in rules)


def test_the_bound_of_an_explorer_is_called_its_own(finding_of):
    rules = Rules(own_bound="2*m", bound=None)
    finding = replace(finding_of("walks-too-much"), world=World(PATH, Directional(0)))
    told = tell_whose_bound(replace(finding, under=rules, expected=4))
    assert "The explorer's own bound is 2*m, which is 4" in " ".join(told)


def test_the_bound_with_the_tests_is_told_with_both_parts(finding_of):
    finding = replace(finding_of("walks-too-much"), world=World(PATH, Directional(0)))
    rules = Rules(bound="two-vertices")
    told = tell_whose_bound(replace(finding, under=rules, expected=20))
    assert "two traversals for each test" in " ".join(told)
    assert "the bound 'two-vertices' is 20." in " ".join(told)


@pytest.mark.parametrize("name", sorted(BOUNDS.keys() - {"none"}))
def test_every_bound_with_a_name_is_told_and_explained(name, finding_of):
    assert f"`--bound {name}`" in VERDICTS.read_text(encoding="utf-8")
    finding = replace(finding_of("walks-too-much"), world=World(PATH, Directional(0)))
    told = tell_whose_bound(replace(finding, under=Rules(bound=name), expected=20))
    assert f"The bound '{name}' is (1) + (2)" in " ".join(told)


# ---------------------------------------------------------------- the table


def test_every_law_of_the_judge_has_its_entry_in_the_judges_order():
    assert tuple(TELLERS) == PRECEDENCE


def test_a_law_that_only_later_versions_know_is_told_by_its_sentences(finding_of):
    finding = replace(finding_of("no-answer"), law="harmony")
    assert "The law 'harmony' is broken." in explain(finding).sentences


def test_another_map_of_the_same_size_is_called_that():
    assert _say_sizes(TRIANGLE, TRIANGLE) == (
        "The answer has 3 edges and 3 vertices, as the world has, but is another map."
    )


def test_of_the_edges_that_were_walked_along_none_is_named_as_left_out():
    def explore(first):
        yield Move(0)
        return Estimate(EDGE, 0)

    told = run(explore, World(PATH, Directional(0), 0), task="cover:edges")
    (left,) = [line for line in explain(told.finding).sentences if "never walked" in line]
    assert left.count("the edge from") == 1
