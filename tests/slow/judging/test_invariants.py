import pytest

from allworlds.documents.document import replace
from allworlds.judging.laws.law_table import invariant_1
from judging.test_invariants import embeds, every, kept, put, runs, single, up_to


@pytest.mark.parametrize("m", [1, 2, 3, 4])
def test_algorithm_1_keeps_every_invariant(m):
    for case in runs(m):
        assert len(case.checkpoints) == m
        assert kept(case)


@pytest.mark.slowest
def test_the_whole_map_glued_otherwise_breaks_invariant_1_unless_it_is_the_same():
    same = 0
    for case in up_to(3):
        i = len(case.checkpoints) - 1
        checkpoint = case.checkpoints[i][1]
        alpha = checkpoint.alpha
        for a in range(len(alpha)):
            for b in range(a):
                if alpha[a] == b:
                    continue
                changes = {a: b, b: a, alpha[a]: alpha[b], alpha[b]: alpha[a]}
                glued = replace(checkpoint, alpha=put(alpha, changes))
                fits = embeds(case, i, glued)
                same += fits
                violation = invariant_1(single(case, i, alpha=glued.alpha))
                assert (violation is None) == fits
    assert same  # two leaves may be exchanged


@pytest.mark.slowest
def test_another_here_breaks_invariant_1_unless_it_is_the_same_by_symmetry():
    wrong = 0
    for case, i, checkpoint in every(3):
        for here in range(len(checkpoint.sigma)):
            fits = embeds(case, i, replace(checkpoint, here=here))
            wrong += not fits
            violation = invariant_1(single(case, i, here=here))
            assert (violation is None) == fits
    assert wrong > 1000


def test_a_tree_edge_forgotten_at_both_ends_breaks_invariant_1():
    met = 0
    for case, i, checkpoint in every(3):
        for d, e in enumerate(checkpoint.alpha):
            cut = put(checkpoint.alpha, {d: d, e: e})
            fits = embeds(case, i, replace(checkpoint, alpha=cut))
            met += d != e and not fits
            assert (invariant_1(single(case, i, alpha=cut)) is None) == fits
    assert met
