"""The lemmas on words that lead home in corridors, on which the lower bound of testers rests.

Each is checked in whole worlds, for every dart, and stands beside a false cousin: other out-darts,
or a longer word, with which it fails.
Source: lower-bounds.md, 'Testers of home words'.
"""

from itertools import pairwise
from random import Random
from unittest.mock import patch

import numpy as np
import pytest

from allworlds.maps import families, family
from allworlds.maps.families import hub_types, out_darts, usual_degree
from corridors import Shape, drawn_corridor
from small import slow, slowest

ALL = 1000


def one_class(_kind):
    """All hubs have the class {4, 5, 6, 7}: motions do not tell the level."""
    return -4, -6


def neighbours(kind):
    """Two motions from out-darts to in-darts of one hub are equal."""
    return -4 * kind, -4 * kind - 1


def usual(far):
    return far, usual_degree(far)


class Drawn:
    """A corridor with a matching, and words that lead home in it.

    Args:
        size: F and R.
        seed: of loops and matching; 0: neighbouring free darts are matched.
        outs: the out-darts of a type of hubs.
    """

    def __init__(self, size, seed, outs=out_darts):
        self.shape, self.random = Shape(*size), Random(seed)
        with patch.object(families, "out_darts", outs):
            corridor = drawn_corridor(self.shape, seed)
        free = sorted(corridor.free) if seed == 0 else corridor.free
        self.map = corridor.matched(list(zip(free[::2], free[1::2], strict=True)))
        self.alpha = np.array(self.map.alpha)
        self.level = np.array([self.shape.level(d) for d in range(len(self.alpha))])
        self.far = [int(d) for d in np.flatnonzero(self.level > self.shape.near)]
        self.near = [
            int(d) for d in np.flatnonzero((self.level > 0) & (self.level <= self.shape.near))
        ]

    def after(self, darts, motion):
        """The darts of arrival of walkers at hubs that make this motion."""
        place = (darts - 2) % self.shape.degree
        return self.alpha[darts - place + (place + motion) % self.shape.degree]

    def first_of(self, dart):
        """The first in-dart of a dart's hub."""
        return dart - (dart - 2) % self.shape.degree

    def up(self, dart, avoided=frozenset()):
        """Every word of a simple path through far hubs, from a far dart to the last near hub."""
        here = self.level[dart]
        for motion in range(self.shape.degree):
            there = int(self.after(dart, motion))
            level = self.level[there]
            if level == self.shape.near:
                yield (motion,), there
            elif level > self.shape.near and level != here and level not in avoided:
                for word, end in self.up(there, avoided | {here}):
                    yield (motion, *word), end

    def down(self, dart):
        """A word of a drawn shortest path from a near dart to vertex 0: there are two a level."""
        word = []
        while dart > 1:
            motion = (self.first_of(dart) + self.random.randrange(2) - dart) % self.shape.degree
            word.append(int(motion))
            dart = int(self.after(dart, motion))
        return tuple(word)

    def words(self, dart, most):
        """Words that lead a far dart home, with the length of their part in far hubs; drawn."""
        ups = [*self.up(dart)]
        if len(ups) > most:
            ups = self.random.sample(ups, most)
        for u, end in ups:
            for _ in range(min(most, 4)):
                yield u + self.down(end), len(u)

    def met(self, walkers, word):
        """The number of walkers from these darts that a word leads to vertex 0, at any time."""
        darts, met = np.array(walkers), 0
        for motion in word:
            darts = self.after(darts, motion)
            met += int((darts < 2).sum())
            darts = darts[darts > 1]
        return met

    def wrong_walkers_at_home(self, most):
        """How many wrong walkers from far darts a home word of a far dart leads to vertex 0.

        The word is read from its beginning, and from every letter of its part in far hubs on: from
        there it is the home word of the far dart by which its own walker has come.
        """
        met = walks = 0
        for y in self.far:
            for word, in_far in self.words(y, most):
                own = y
                for i in range(in_far):
                    wrong = [d for d in self.far if d != own]
                    met += self.met(wrong, word[i:])
                    walks += len(wrong)
                    assert self.met([own], word[i:]) == 1
                    own = int(self.after(own, word[i]))
        return met, walks

    def far_walkers_at_home(self, extra=0):
        """How many far walkers a home word of a near dart leads to vertex 0.

        Those of darts by which a walker comes down are the ends of the home words of far darts.
        """
        return sum(self.met(self.far, self.down(y) + (0,) * extra) for y in self.near)

    def longest_common_prefix(self, most):
        """The largest number of first letters that a home word of a far dart shares with another.

        The other one is that of another far dart, or of any near dart.  In the order of the
        dictionary the longest common prefix is that of two neighbours.
        """
        words = [(word, y) for y in self.far for word, _ in self.words(y, most)]
        words += [(self.down(y), -1) for y in self.near for _ in range(min(most, 4))]
        longest = 0
        for (word, y), (other, z) in pairwise(sorted(words)):
            if y != z:
                same = [a == b for a, b in zip(word, other, strict=False)]
                longest = max(longest, same.index(False) if False in same else len(same))
        return longest

    @property
    def shared(self):
        """The number of letters that home words of different far darts share at most."""
        return self.shape.far + self.shape.window - 1


SIZES = [
    (usual(1), ALL),
    (usual(2), 6),
    ((1, 14), ALL),
    ((1, 22), ALL),
    ((2, 14), 6),
    ((2, 22), 6),
    slowest(usual(3), 3),
    slowest((3, 14), 3),
    slow((3, 22), 3),
]
"""F and R, and how many words of a dart: g = 1, 1, 1, 1, 3, 1, 1, 4 and 2."""


@pytest.mark.parametrize(("size", "most"), SIZES)
def test_no_wrong_walker_meets_vertex_0_on_a_word_that_leads_home(size, most):
    for seed in (0, 1, 2):
        met, walks = Drawn(size, seed).wrong_walkers_at_home(most)
        assert met == 0
        assert walks > 500


@pytest.mark.parametrize(
    ("outs", "size"),
    [
        *((outs, usual(2)) for outs in (one_class, neighbours)),
        *(slow(outs, usual(3)) for outs in (one_class, neighbours)),
        *((neighbours, usual(1)), (one_class, (2, 14))),
    ],
)
def test_wrong_walkers_meet_vertex_0_where_motions_are_not_apart(outs, size):
    assert any(Drawn(size, seed, outs).wrong_walkers_at_home(2)[0] for seed in range(1, 4))


@pytest.mark.parametrize("size", [size for size, _ in SIZES[:6]])
def test_no_far_walker_meets_vertex_0_on_a_word_that_leads_a_near_dart_home(size):
    assert all(Drawn(size, seed).far_walkers_at_home() == 0 for seed in (0, 1, 2))


def test_a_far_walker_meets_vertex_0_on_a_word_with_a_letter_more_than_there_are_near_hubs():
    drawn = Drawn(usual(2), 1)
    last = next(d for d in drawn.far if drawn.level[d] == drawn.shape.near + 1)
    (word, _), *_ = drawn.words(last, ALL)
    assert min(len(word) for word, _ in drawn.words(last, ALL)) == drawn.shape.near + 1
    assert drawn.met([last], word) == 1


@pytest.mark.parametrize(("size", "most"), SIZES)
def test_words_that_lead_home_from_different_darts_part_early(size, most):
    drawn = [Drawn(size, seed) for seed in (0, 1, 2)]
    assert all(one.longest_common_prefix(most) <= one.shared for one in drawn)


def test_with_one_far_hub_they_may_begin_with_the_same_letter():
    assert {Drawn(usual(1), seed).longest_common_prefix(ALL) for seed in range(1, 5)} == {1}


@pytest.mark.parametrize(
    ("outs", "size"), [(one_class, usual(2)), slow(one_class, usual(3)), (neighbours, usual(1))]
)
def test_words_part_later_where_motions_are_not_apart(outs, size):
    drawn = [Drawn(size, seed, outs) for seed in range(1, 4)]
    assert any(one.longest_common_prefix(40) > one.shared for one in drawn)


@pytest.mark.slow
def test_both_lemmas_with_every_way_through_two_far_hubs():
    drawn = Drawn(usual(2), 1)
    assert drawn.longest_common_prefix(ALL) == 2
    assert drawn.wrong_walkers_at_home(ALL)[0] == 0


@pytest.mark.parametrize("size", [usual(3), (3, 14), (5, 30)])
def test_no_window_of_types_occurs_twice_among_the_near_hubs(size):
    shape = Shape(*size)
    types, g = [*hub_types(shape)][: shape.near], shape.window
    windows = [tuple(types[i : i + g]) for i in range(len(types) - g + 1)]
    assert len(set(windows)) == len(windows)
    assert set(types) <= {*range(1, shape.types + 1)}
    # A smaller window would not do.
    assert g == 1 or shape.types ** (g - 1) < g * shape.far


def test_the_classes_of_different_hubs_are_disjoint_and_of_four_motions():
    map_, corridor = family("corridor:3"), drawn_corridor(Shape(*usual(3)), 0)
    fixed = corridor.alpha
    classes = []
    for hub in range(1, 9):
        first = 2 + (hub - 1) * 42
        outs = [d for d in range(first, first + 42) if corridor.shape.level(fixed[d]) == hub + 1]
        classes.append({map_.offset(d, first + k) for d in outs for k in (0, 1)})
        assert classes[-1] == {4 * hub + k for k in range(4)}
    assert len(set().union(*classes)) == 32


@pytest.mark.parametrize("size", [(0, 18), (1, 12), (2, 31)])
def test_another_corridor_is_refused(size):
    with pytest.raises(ValueError, match=r"at least 1, R even and at least 14"):
        Shape(*size)
