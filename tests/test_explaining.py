"""The findings of wrong explorers in words, for every law."""

import json
from dataclasses import replace
from functools import cache

import pytest

import allworlds
from allworlds import CombinatorialMap, Estimate, Move
from allworlds.checker import Finding, check, run
from allworlds.errors import InputError
from allworlds.explaining import explain
from allworlds.judge import LAWS, PRECEDENCE
from allworlds.maps import from_cycles
from allworlds.mutation.explorers import WRONG_EXPLORERS
from allworlds.protocol import Percept, Transcript
from allworlds.world import Directional, World

# One mutant is first wrong in a world with four edges.
MUTANTS = {m.name: m for m in WRONG_EXPLORERS if m.name != "confirmed-too-early"}
EDGE = CombinatorialMap([0, 1], [1, 0])
LOOP = CombinatorialMap([1, 0], [1, 0])
PATH = CombinatorialMap([0, 2, 1, 3], [1, 0, 3, 2])
TRIANGLE = CombinatorialMap([1, 0, 3, 2, 5, 4], [2, 5, 0, 4, 3, 1])


@cache
def finding_of(name):
    return check(MUTANTS[name].explorer(), edges=3).findings[0]


def told(name):
    explanation = explain(finding_of(name))
    return explanation.law, explanation.step, " ".join(explanation.sentences)


def answering(map_, here, *motions):
    """An explorer that walks and answers whatever it senses."""

    def explore(first):
        for k in motions:
            yield Move(k)
        return Estimate(map_, here)

    return explore


def explained(map_, explore):
    return explain(run(explore, World(map_, Directional(0))).finding)


@pytest.mark.parametrize("name", MUTANTS)
def test_every_mutants_finding_is_explained_under_its_law(name):
    finding = finding_of(name)
    explanation = explain(finding)
    assert explanation.law == finding.law
    assert len(explanation.sentences) >= 2
    assert all(s and s[0].isupper() for s in explanation.sentences)
    assert (explanation.answer is not None) == (finding.law in ("map", "pose"))
    assert explanation.exit_code == 0


def test_the_mutants_break_every_law_but_timeout():
    assert {finding_of(name).law for name in MUTANTS} == {*PRECEDENCE} - {"timeout"}


# ---------------------------------------------------------------- map


def test_a_known_place_taken_for_a_new_vertex_is_where_they_part():
    law, step, text = told("wrong-entry-label")
    assert (law, step) == ("map", 2)
    assert "back at v1" in text
    assert "takes the place for a new vertex" in text
    # The wrong place is sensed to be wrong only later.
    assert "first percept against the answer came at step 7" in text


def test_a_known_place_left_some_time_ago_is_named_with_the_step():
    # A triangle on a stalk, walked once round; the answer goes on instead of closing it.
    world = from_cycles(["a", "abd", "bc", "cd"])
    answer = from_cycles(["a", "abe", "bc", "cd", "dfg", "e", "f", "g"])
    explanation = explained(world, answering(answer, 8, 0, 1, 1, 1))
    assert explanation.step == 4
    text = " ".join(explanation.sentences)
    assert "step 4 the robot was back at v1, which it had left at step 2, but its answer " in text
    assert "takes the place for a new vertex" in text
    assert "Every percept fits the answer all the same" in text
    assert "never settled where these darts lead" in text


def test_a_new_vertex_taken_for_a_known_one_is_where_they_part():
    answer = CombinatorialMap([1, 0, 3, 2], [2, 3, 0, 1])
    explanation = explained(TRIANGLE, answering(answer, 2, 0, 1, 1))
    assert explanation.step == 2
    text = " ".join(explanation.sentences)
    assert "step 2 the robot came to v2 for the first time" in text
    assert "takes the place for v0, which it had left at step 1" in text


def test_another_dart_of_the_same_vertex_is_where_they_part():
    law, step, text = told("bearing-ignored")
    assert (law, step) == ("map", 1)
    # The two loops cross: in truth the robot comes out at dart 2.
    assert "takes dart 2, by which it came, for dart 1" in text
    assert "it sensed 'degree 4, marked, bearing 2'" in text


def test_a_start_of_another_degree_parts_at_once():
    explanation = explained(LOOP, answering(EDGE, 0))
    assert explanation.step == 0
    assert "part at the start, at v0" in explanation.sentences[-1]


def test_an_answer_that_fits_the_log_never_parts_and_the_open_darts_are_named():
    explanation = explained(PATH, answering(EDGE, 0))
    assert explanation.step is None
    text = " ".join(explanation.sentences)
    assert "They never part" in text
    assert "never settled where these darts lead: v0: dart 0" in text
    assert "dart 0 to dart 1 of v1" in text


# ---------------------------------------------------------------- pose


def test_a_lost_pose_says_where_the_robot_is_and_how_far_it_is_turned():
    law, step, text = told("pose-lost")
    assert (law, step) == ("pose", 1)
    # Two loops side by side, at dart 3; 'here' is dart 0, which the symmetry takes to dart 2.
    assert "stands at v0, dart 3; it believes to stand at dart 2 of the same vertex" in text
    assert "turned further by 1 of 4 darts clockwise" in text
    assert "symmetric: 1 other dart" in text


def test_a_robot_at_another_vertex_is_told_so():
    # A vertex of degree 3 with a loop and a leaf: no symmetry.
    lollipop = CombinatorialMap([1, 2, 0, 3], [1, 0, 3, 2])
    explanation = explained(lollipop, answering(lollipop, 3, 0))
    assert explanation.law == "pose"
    assert "it believes to stand at v1, dart 3, which is another vertex" in explanation.sentences[1]


# ---------------------------------------------------------------- the other laws


def test_folding_names_the_open_darts_and_the_vertex_seen_as_several():
    law, step, text = told("no-retracing")
    assert (law, step) == ("folding", None)
    assert "v1: darts 1, 3 and 5" in text
    assert "dart 3 to dart 5 of v1" in text
    assert "came to v1 in 2 ways" in text


def test_the_bound_is_told_with_the_moves_out_and_back():
    # One loop: (1)+(2) is 1; it walks the loop, back, and on again.
    law, _, text = told("walks-too-much")
    assert law == "bound"
    assert "the bound (paper) allows 1" in text
    assert "3 traversals: 2 out, 1 to take one back" in text
    assert "Of those out 1 went along an edge that was new" in text


def test_a_way_back_takes_back_every_move_out():
    # Along a path to its end and back again.
    finding = run(answering(PATH, 0, 0, 1, 0, 1), World(PATH, Directional(0)), bound="1").finding
    assert "The robot made 4 traversals: 2 out, 2 to take one back." in explain(finding).sentences


@pytest.mark.parametrize(
    ("name", "law"), [("place-shown-wrong", "invariant-1"), ("partner-shown-in-U", "invariant-2")]
)
def test_a_wrong_checkpoint_is_told_with_its_step(name, law):
    found, step, text = told(name)
    assert (found, step) == (law, 1)
    assert "checkpoint came after step 1, where the robot stood at v0, dart 1" in text


def test_a_pass_without_progress_is_told():
    law, step, text = told("pass-without-progress")
    assert (law, step) == ("variant", None)
    assert "no progress" in text
    assert "after step 1" in text


def test_a_crash_is_told_with_its_last_step_and_the_last_line_of_the_traceback():
    law, _, text = told("crashes-at-leaves")
    assert law == "crash"
    assert "step 1, move 0: to v1, dart 1, where it sensed 'degree 1'" in text
    assert text.endswith("stderr: IndexError: a vertex without another dart")


def test_a_run_that_ends_at_the_start_has_no_last_step():
    law, _, text = told("drops-markers")
    assert law == "illegal-action"
    assert "It made no step" in text
    assert "Seen was: Drop()." in text


@pytest.mark.parametrize(
    ("name", "law", "words"),
    [
        ("no-answer", "no-estimate", "Seen was: None."),
        ("never-stops", "budget", "Seen was: traversal 109."),
        ("state-kept", "nondeterministic", "differs at step 1"),
    ],
)
def test_other_endings_say_what_was_expected_and_seen(name, law, words):
    found, step, text = told(name)
    assert (found, step) == (law, None)
    assert "Expected was: " in text
    assert words in text


def test_a_timeout_is_told():
    finding = replace(finding_of("crashes-at-leaves"), law="timeout", seen="silent", detail="")
    text = " ".join(explain(finding).sentences)
    assert "silent for too long" in text
    assert "The last line" not in text


def test_a_law_that_only_later_versions_know_is_told_by_its_sentences():
    finding = replace(finding_of("no-answer"), law="ambiguity")
    assert "The law 'ambiguity' is broken." in explain(finding).sentences


# ---------------------------------------------------------------- values and bad input


@pytest.mark.parametrize("name", MUTANTS)
def test_a_finding_read_from_its_file_is_explained_alike(name):
    finding = finding_of(name)
    again = Finding.from_json(json.dumps(finding.to_json()))
    assert explain(again) == explain(finding)


def test_relabelling_the_world_does_not_move_the_parting():
    finding = finding_of("wrong-entry-label")
    names = list(reversed(finding.world.map.darts))
    turned = replace(finding, world=finding.world.relabelled(names))
    assert explain(turned).step == explain(finding).step


def test_the_package_offers_it():
    assert allworlds.explain is explain


def test_a_transcript_that_is_no_walk_in_the_world_is_refused():
    finding = finding_of("pose-lost")
    with pytest.raises(InputError, match="at step 0 it has degree 9"):
        explain(replace(finding, transcript=Transcript(Percept(9))))


@pytest.mark.parametrize("here", [99, -1, None, True, "0"])
def test_an_answer_without_a_place_is_refused(here):
    finding = finding_of("pose-lost")
    with pytest.raises(InputError, match=r"seen\.here"):
        explain(replace(finding, seen={**finding.seen, "here": here}))


def test_a_pose_finding_whose_answer_is_another_map_is_refused():
    finding = finding_of("pose-lost")
    with pytest.raises(InputError, match="not pose"):
        explain(replace(finding, seen={**EDGE.to_json(), "here": 0}))


def test_laws_with_a_story_of_their_own_are_those_of_finished_runs():
    assert set(allworlds.explaining._TELLERS) == set(LAWS)
