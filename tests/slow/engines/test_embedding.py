"""A published S is a part of the world, or breaks a law; as the Python laws say."""

from random import Random

import pytest
from numba import njit

from allworlds.engines.kernel.arrays import JUDGED, WORLD, new
from allworlds.engines.kernel.laws import INVARIANT_1, INVARIANT_2, VARIANT, answer_law
from allworlds.maps import random_map
from engines.test_embedding import look, published_as


@pytest.mark.slowest
def test_a_right_s_breaks_no_law():
    random = Random(1)
    for _ in range(30):
        map_, shown = grown(random)
        said, law = judge(shown, map_)
        assert (said[-1], law) == (0, 0)


@njit(error_model="numpy")
def answered(published, world, dart, judged):
    return answer_law(published, world, dart, judged)


class Growing:
    """The S of a robot in a map, whose darts are named as they come to be known.

    What has been walked is told now and as it was before the latest edge, and which that is.
    """

    def __init__(self, map_, random):
        self.map, self.random = map_, random
        self.true, self.name = [], {}
        self.explored = {}
        self.walked = self.before = 0
        self.add(0)

    def add(self, dart):
        first = dart
        while dart not in self.name:
            self.name[dart] = len(self.true)
            self.true.append(dart)
            dart = self.map.sigma[dart]
        assert dart == first

    def explore(self):
        unknown = [d for d in self.true if d not in self.explored]
        dart = self.random.choice(unknown)
        other = self.map.alpha[dart]
        if other not in self.name:
            self.add(other)
        self.explored[dart], self.explored[other] = other, dart
        self.before, self.latest = self.walked, (self.name[dart], self.name[other])
        self.walked |= 1 << dart | 1 << other
        return any(d not in self.explored for d in self.true)

    def shown(self):
        sigma = [self.name[self.map.sigma[d]] for d in self.true]
        alpha = [self.name[self.explored.get(d, d)] for d in self.true]
        here = self.random.randrange(len(sigma))
        return sigma, alpha, here, self.true[here], (self.walked, self.before, self.latest)


def renamed(random, sigma, alpha, here, dart, walked):
    names = list(range(len(sigma)))
    random.shuffle(names)
    new_sigma, new_alpha = [0] * len(names), [0] * len(names)
    for d, name in enumerate(names):
        new_sigma[name], new_alpha[name] = names[sigma[d]], names[alpha[d]]
    return new_sigma, new_alpha, names[here], dart, walked


def changed(which):
    def change(random, *shown):
        lists = [*map(list, shown[:2])]
        entries = lists[which]
        entries[random.randrange(len(entries))] = random.randrange(-1, len(entries) + 1)
        return *lists, *shown[2:]

    return change


def partner_open(random, sigma, alpha, here, dart, walked):
    d = random.randrange(len(alpha))
    return sigma, [*alpha[:d], d, *alpha[d + 1 :]], here, dart, walked


def elsewhere(random, sigma, alpha, here, dart, walked):
    return sigma, alpha, random.randrange(-1, len(sigma) + 1), dart, walked


def never_walked(_, sigma, alpha, here, dart, walked):
    _, before, latest = walked
    return sigma, alpha, here, dart, (before, before, latest)


def too_many(random, sigma, alpha, here, dart, walked):
    more = [len(sigma), len(sigma) + 1]
    return [*sigma, *more[::-1]], [*alpha, *more], here, dart, walked


def last_vertex(sigma):
    """Its first dart: its darts are those from there on."""
    return sigma[-1]


def a_dart_less(random, sigma, alpha, here, dart, walked):
    """The vertex that was found last has one dart less than in the world."""
    first, last = last_vertex(sigma), len(sigma) - 1
    if first == last or alpha[last] != last or here == last:
        return partner_open(random, sigma, alpha, here, dart, walked)
    return [*sigma[: last - 1], first], alpha[:last], here, dart, walked


def a_dart_more(_, sigma, alpha, here, dart, walked):
    """The vertex that was found last has one dart more than in the world."""
    size = len(sigma)
    return [*sigma[:-1], size, last_vertex(sigma)], [*alpha, size], here, dart, walked


def one_vertex_twice(random, sigma, alpha, here, dart, walked):
    """The latest edge leads to a vertex that is drawn anew, for it may be known."""
    size = len(sigma)
    d, e = random.choice((walked[2], walked[2][::-1]))
    old = e
    copies = {}
    while old not in copies:
        copies[old] = size + len(copies)
        old = sigma[old]
    new_sigma = [*sigma, *range(size + 1, size + len(copies)), size]
    new_alpha = [*alpha, *range(size, size + len(copies))]
    new_alpha[d], new_alpha[size], new_alpha[e] = size, d, e
    return new_sigma, new_alpha, here, dart, walked


CHANGES = [
    a_dart_less,
    a_dart_more,
    one_vertex_twice,
    renamed,
    changed(0),
    changed(1),
    partner_open,
    elsewhere,
    never_walked,
    too_many,
]


def judge(sequence, map_):
    """The laws that are broken after each S, as a set, and the law that the answer breaks."""
    world, judged, said = new(WORLD), new(JUDGED), []
    world.darts = len(map_.sigma)
    world.sigma[: world.darts], world.alpha[: world.darts] = map_.sigma, map_.alpha
    for sigma, alpha, here, dart, (walked, *_) in sequence:
        answer, _arrays = published_as(sigma, alpha, here)
        look(judged, answer, world, dart, walked)
        said.append(int(judged.broken))
    return said, answered(answer, world, dart, judged)


def grown(random):
    map_ = random_map(random.randrange(3, 9), random)
    growing, shown = Growing(map_, random), []
    more = True
    while more:
        more = growing.explore()
        if random.random() < 0.8 or not more:
            shown.append(growing.shown())
    return map_, shown


@pytest.mark.parametrize("change", CHANGES)
def test_a_changed_s_breaks_a_law(change):
    random, seen = Random(2), set()
    for _ in range(150 if change is one_vertex_twice else 40):
        map_, shown = grown(random)
        at = random.randrange(len(shown))
        shown[at] = change(random, *shown[at])
        said, _ = judge(shown, map_)
        seen |= {law for law in (INVARIANT_1, INVARIANT_2, VARIANT) if said[-1] >> law & 1}
    assert bool(seen) == (change is not renamed)
