"""Too many traversals in words."""

from allworlds.checker import run
from allworlds.explaining import explain
from allworlds.world import Directional, World
from small import PATH


def test_the_bound_is_told_with_the_moves_out_and_back(told):
    # One loop: (1)+(2) is 1; it walks the loop, back, and on again.
    law, _, text = told("walks-too-much")
    assert law == "bound"
    assert "the bound (paper) allows 1" in text
    assert "3 traversals: 2 out, 1 to take one back" in text
    assert "Of those out 1 went along an edge that was new" in text


def test_a_way_back_takes_back_every_move_out(answering):
    # Along a path to its end and back again.
    finding = run(answering(PATH, 0, 0, 1, 0, 1), World(PATH, Directional(0)), bound="1").finding
    assert "The robot made 4 traversals: 2 out, 2 to take one back." in explain(finding).sentences
