"""The two facts about words that lead home in corridors, on which the lower bound m^2 n rests.

Each stands beside a false cousin: other out-darts, with which it fails.
Source: docs/theory.md, 'Lower bounds'; proved in Coq for matchings of every size.
"""

from itertools import pairwise, product
from random import Random

import pytest

from allworlds.maps import family
from allworlds.maps.corridor import apart, corridor_skeleton


def one_class(_hub):
    """All hubs have the class {4, 5, 6, 7}: motions do not tell the level."""
    return -4, -6


def neighbours(hub):
    """Two motions from out-darts to in-darts of one hub are equal."""
    return -4 * hub, -4 * hub - 1


class Drawn:
    """A corridor with a drawn matching, its far darts, and words that lead home from there."""

    def __init__(self, far, seed, outs=apart):
        random = Random(seed)
        self.corridor = corridor_skeleton(far, random, outs)
        darts = self.corridor.open
        self.map = self.corridor.matched(list(zip(darts[::2], darts[1::2], strict=True)))
        self.level = [self.corridor.level(d) for d in range(len(self.map.sigma))]
        self.near = 2 * far
        self.far = [d for d, level in enumerate(self.level) if level > self.near]
        self.random = random

    def after(self, dart, motion):
        return self.map.alpha[self.map.turn(dart, motion)]

    def up(self, dart, avoided=frozenset()):
        """Every word of a simple path through far hubs, from a far dart to the last near hub."""
        here = self.level[dart]
        for motion in range(self.map.degree_at[dart]):
            there = self.after(dart, motion)
            level = self.level[there]
            if level == self.near:
                yield (motion,), there
            elif level > self.near and level != here and level not in avoided:
                for word, end in self.up(there, avoided | {here}):
                    yield (motion, *word), end

    def down(self, dart):
        """Every word of a simple path from a near dart to vertex 0."""
        if self.level[dart] == 0:
            yield ()
            return
        first = 2 + (self.level[dart] - 1) * self.map.degree_at[dart]
        for k in (0, 1):
            motion = self.map.offset(dart, first + k)
            for rest in self.down(self.after(dart, motion)):
                yield (motion, *rest)

    def words(self, dart, most):
        """Pairs of a word through far hubs and one down, drawn if there are more than ``most``."""
        ups = list(self.up(dart))
        if len(ups) > most:
            ups = self.random.sample(ups, most)
        for u, end in ups:
            downs = list(self.down(end))
            if most < len(downs):
                downs = self.random.sample(downs, most)
            yield from product([u], downs)

    def wrong_walkers_at_home(self, most):
        """How often a walker from another far dart meets vertex 0, and the number of walks."""
        met = walks = 0
        for y in self.far:
            for u, down in self.words(y, most):
                walkers, last = {d: d for d in self.far if d != y}, y
                for motion in u + down:
                    walkers = {start: self.after(d, motion) for start, d in walkers.items()}
                    last = self.after(last, motion)
                    gone = [start for start, d in walkers.items() if self.level[d] == 0]
                    met += len(gone)
                    for start in gone:
                        del walkers[start]
                assert self.level[last] == 0
                walks += len(self.far) - 1
        return met, walks

    def longest_common_prefix(self, most):
        """The largest number of letters that words of two different far darts begin with.

        In the order of the dictionary the longest common prefix is that of two neighbours.
        """
        words = sorted((u + down, y) for y in self.far for u, down in self.words(y, most))
        longest = 0
        for (word, y), (other, z) in pairwise(words):
            if y != z:
                same = [a == b for a, b in zip(word, other, strict=False)]
                longest = max(longest, same.index(False) if False in same else len(same))
        return longest


@pytest.mark.parametrize(
    ("far", "most"), [(1, 1000), (2, 2), pytest.param(3, 1, marks=pytest.mark.slow)]
)
def test_no_wrong_walker_meets_vertex_0_on_a_word_that_leads_home(far, most):
    for seed in (1, 2):
        met, walks = Drawn(far, seed).wrong_walkers_at_home(most)
        assert met == 0
        assert walks > 500


@pytest.mark.parametrize(("outs", "far"), [(one_class, 2), (neighbours, 1)])
def test_wrong_walkers_meet_vertex_0_where_motions_are_not_apart(outs, far):
    assert any(Drawn(far, seed, outs).wrong_walkers_at_home(5)[0] for seed in range(1, 4))


@pytest.mark.parametrize(
    ("far", "most"), [(1, 1000), (2, 40), pytest.param(3, 20, marks=pytest.mark.slow)]
)
def test_words_that_lead_home_from_different_darts_part_after_f_letters(far, most):
    found = {Drawn(far, seed).longest_common_prefix(most) for seed in (1, 2)}
    assert max(found) <= far
    assert far > 1 or found == {1}


@pytest.mark.parametrize(("outs", "far"), [(one_class, 2), (neighbours, 1)])
def test_words_part_later_where_motions_are_not_apart(outs, far):
    assert any(Drawn(far, seed, outs).longest_common_prefix(1000) > far for seed in range(1, 4))


@pytest.mark.slow
def test_both_facts_with_every_word_of_two_far_hubs():
    drawn = Drawn(2, 1)
    assert drawn.longest_common_prefix(10_000) == 2
    assert drawn.wrong_walkers_at_home(12)[0] == 0


def test_the_classes_of_different_hubs_are_disjoint_and_of_four_motions():
    map_, corridor = family("corridor:3"), Drawn(3, 1).corridor
    fixed = corridor.alpha
    classes = []
    for hub in range(1, 9):
        first = 2 + (hub - 1) * 42
        outs = [d for d in range(first, first + 42) if corridor.level(fixed[d]) == hub + 1]
        classes.append({map_.offset(d, first + k) for d in outs for k in (0, 1)})
        assert classes[-1] == {4 * hub + k for k in range(4)}
    assert len(set().union(*classes)) == 32


def test_a_corridor_of_no_far_hub_is_refused():
    with pytest.raises(ValueError, match="at least 1"):
        corridor_skeleton(0, Random(1))
