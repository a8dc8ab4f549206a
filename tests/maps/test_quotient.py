from itertools import product
from math import log2
from random import Random

import pytest

from allworlds.maps import (
    CombinatorialMap,
    named_map,
    project,
    quotient as refinement,
    rooted_code,
    rooted_maps,
)
from allworlds.maps.build import cycle, lattice
from allworlds.maps.quotient import coarsest_partition


def moore(labels, permutations):
    """Refinement until it is stable: darts are told apart by label, then by where they lead."""
    colour = list(labels)
    while True:
        signs = [(colour[x], *(colour[p[x]] for p in permutations)) for x in range(len(colour))]
        finer = list(map({sign: i for i, sign in enumerate(dict.fromkeys(signs))}.get, signs))
        if len(set(finer)) == len(set(colour)):
            return finer
        colour = finer


def same_partition(one, other):
    return len(set(one)) == len(set(other)) == len(set(zip(one, other, strict=True)))


def marked(map_, vertex=0):
    """Labels of a map in which one vertex can be seen."""
    return [int(v == vertex) for v in map_.vertex_of]


def labelled_maps(largest):
    for m in range(1, largest + 1):
        for map_ in rooted_maps(m):
            yield (map_, marked(map_), 0)
            yield (map_, [0] * (2 * m), 0)


def test_hopcrofts_partition_is_moores_for_every_small_map():
    for map_, labels, _ in labelled_maps(4):
        degrees = list(zip(map_.degree_at, labels, strict=True))
        permutations = (map_.sigma, map_.alpha)
        assert same_partition(
            coarsest_partition(degrees, permutations), moore(degrees, permutations)
        )


@pytest.mark.parametrize("seed", range(60))
def test_hopcrofts_partition_is_moores_for_random_permutations(seed):
    random = Random(seed)
    size = random.randrange(1, 60)
    permutations = [random.sample(range(size), size) for _ in range(random.randrange(1, 4))]
    labels = [random.random() < 0.1 for _ in range(size)]
    assert same_partition(coarsest_partition(labels, permutations), moore(labels, permutations))


def test_a_partition_that_forgets_a_permutation_is_coarser():
    map_ = cycle(6)
    labels = marked(map_)
    whole = coarsest_partition(labels, (map_.sigma, map_.alpha))
    half = coarsest_partition(labels, (map_.sigma,))
    assert len(set(half)) < len(set(whole))


def test_a_quotient_keeps_what_its_darts_have_in_common():
    for labelled in labelled_maps(4):
        map_, labels, root = labelled
        quotient, classes = project(labelled)
        assert classes[root] == 0
        for d, q in enumerate(classes):
            assert quotient.sigma[q] == classes[map_.sigma[d]]
            assert quotient.alpha[q] == classes[map_.alpha[d]]
            assert (quotient.degree[q], quotient.labels[q]) == (map_.degree_at[d], labels[d])


def test_over_each_class_lie_k_darts_and_over_each_vertex_k_by_b_vertices():
    for labelled in labelled_maps(4):
        map_, _, _ = labelled
        quotient, classes = project(labelled)
        k = quotient.sheets
        assert all(classes.count(q) == k for q in range(len(quotient.sigma)))
        for vertex, b in zip(quotient.vertices, quotient.cone_indices, strict=True):
            assert k % b == 0
            over = {map_.vertex_of[d] for d, q in enumerate(classes) if q in vertex}
            assert len(over) * b == k
        if quotient.semi_edges:
            assert k % 2 == 0
        assert len(quotient.cotree) == quotient.beta1


def test_classes_are_numbered_breadth_first_from_the_root():
    for labelled in labelled_maps(3):
        quotient, _ = project(labelled)
        assert quotient == quotient.rerooted(0)
        assert (quotient.sigma, quotient.alpha) == rooted_code(quotient.sigma, quotient.alpha, 0)


@pytest.mark.parametrize("seed", range(5))
def test_relabelling_the_darts_keeps_the_quotient(seed):
    random = Random(seed)
    for map_, labels, _ in list(labelled_maps(3))[seed::5]:
        names = random.sample(map_.darts, len(labels))
        other = [0] * len(labels)
        for d, name in enumerate(names):
            other[name] = labels[d]
        mine, theirs = (
            project((map_, labels, 0)),
            project((map_.relabelled(names), other, names[0])),
        )
        assert mine.quotient == theirs.quotient
        assert mine.classes == tuple(theirs.classes[name] for name in names)


def test_a_quotient_of_itself_under_another_root_is_another_rooted_quotient():
    map_ = CombinatorialMap((0, 2, 1, 3), (1, 0, 3, 2))
    whole = project((map_, [0, 1, 2, 3], 0)).quotient
    assert whole.rerooted(3) == project((map_, [0, 1, 2, 3], 3)).quotient
    assert whole.rerooted(3) != whole


def test_an_unlabelled_cycle_has_one_class_which_is_a_semi_edge():
    quotient, _ = project((cycle(5), [0] * 10, 0))
    assert (quotient.sigma, quotient.alpha, quotient.sheets) == ((0,), (0,), 10)
    assert (quotient.cone_indices, quotient.semi_edges, quotient.beta1) == ((2,), (0,), 0)


def test_the_quotient_of_the_fig1_pair_has_four_sheets_and_one_semi_edge():
    # Two candidates for the drawn pair: eight vertices of degree 3, all four darts of the
    # marked vertex alike (III, Fig. 1 of the paper: 'facing one of the edges').
    for name in ("fig1-left", "fig1-right"):
        map_ = named_map(name)
        quotient, _ = project((map_, marked(map_), 0))
        assert (quotient.sheets, len(quotient.semi_edges), quotient.beta1) == (4, 1, 1)
        assert quotient.cone_indices == (4, 1, 1)


def test_darts_of_different_degree_are_never_alike_whatever_their_labels():
    map_ = lattice(2, 3)
    _, classes = project((map_, [0] * 14, 0))
    for d, e in product(map_.darts, repeat=2):
        assert classes[d] != classes[e] or map_.degree_at[d] == map_.degree_at[e]


def test_splitting_by_every_block_again_looks_more_often(monkeypatch):
    split = refinement._Partition.split

    def everything_waits(self, chosen):
        return list(range(len(self.first))) if split(self, chosen) else []

    monkeypatch.setattr(refinement._Partition, "split", everything_waits)
    assert looked_at(named_map("cycle-200"), monkeypatch) > 2 * 400 * (log2(400) + 1)


def looked_at(map_, monkeypatch):
    count = 0
    split = refinement._Partition.split

    def counted(self, chosen):
        nonlocal count
        count += len(chosen)
        return split(self, chosen)

    monkeypatch.setattr(refinement._Partition, "split", counted)
    project((map_, marked(map_), 0))
    return count
