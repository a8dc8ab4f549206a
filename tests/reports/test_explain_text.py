"""The text of explain."""

import pytest

from allworlds import CombinatorialMap, Estimate
from allworlds.judging.walk import Walk
from allworlds.maps import named_map
from allworlds.protocol.actions import Drop
from allworlds.reports.drawing.text import draw
from allworlds.reports.formats import text as text_of
from allworlds.reports.parts import walk_in_answer, walk_in_world
from allworlds.studies.explain import explain
from allworlds.studies.run import run
from allworlds.world import Directional, Movable, World
from mutant_findings import finding_of


def explain_text(explanation, width):
    return text_of(explanation, width)


def explanation_of(name):
    return explain(finding_of(name))


@pytest.mark.parametrize("width", [40, 80, 200])
@pytest.mark.parametrize("name", ["wrong-entry-label", "pose-lost"])
def test_a_wrong_answer_is_drawn_beside_the_world(name, width):
    explanation = explanation_of(name)
    text = explain_text(explanation, width)
    walk = Walk.of(explanation.world, explanation.finding.transcript.actions)
    assert draw(walk_in_world(walk), width) in text
    assert draw(walk_in_answer(walk, explanation.answer), width) in text


def test_without_an_answer_only_the_world_is_drawn():
    text = explain_text(explanation_of("crashes-at-leaves"), 80)
    assert "The world\n" in text
    assert "The answer (R" not in text


def test_the_first_line_names_explorer_and_law():
    assert explain_text(explanation_of("pose-lost"), 80).startswith(
        "mutants:pose-lost breaks the law 'pose' in a world"
    )


def test_two_answers_have_two_texts():
    world = World(CombinatorialMap([0, 2, 1, 3], [1, 0, 3, 2]), Directional(0))

    def text(sigma, alpha):
        def explore(first):
            return Estimate(CombinatorialMap(sigma, alpha), 0)
            yield

        return explain_text(explain(run(explore, world).finding), 80)

    assert text([0, 1], [1, 0]) != text([1, 0], [1, 0])


def test_markers_are_drawn_where_they_lie_at_the_end_of_a_walk():
    world = World(named_map("edge"), Movable(), 0)
    marks = [walk_in_world(Walk.of(world, actions)).marks for actions in ((), (Drop(),))]
    assert marks == [{}, {0: 1}]
