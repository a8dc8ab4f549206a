"""The checker of bisimulations: what proves that no motion tells two worlds apart, and no more."""

from itertools import product

from allworlds.maps import named_map
from allworlds.maps.build import cycle
from allworlds.studies.ambiguity import class_of, twins
from allworlds.world import Nothing, Position, World
from allworlds.world.bisimulation import flaw


def test_every_certificate_with_one_class_changed_is_refused():
    a = World(named_map("k4"), Position(0))
    b = class_of(a).worlds[1]
    good = twins(a, b).bisimulation
    assert flaw((a, b), good) is None
    for part, dart in product((0, 1), a.map.darts):
        for q in [q for q in range(5) if q != good[part][dart]]:
            bad = [list(classes) for classes in good]
            bad[part][dart] = q
            assert flaw((a, b), bad) is not None


def test_the_verifier_says_what_is_wrong():
    a, b = World(cycle(3), Nothing()), World(cycle(4), Nothing())
    assert flaw((a, b), [[0] * 6, [0] * 8]) is None
    assert flaw((a, b), [[0] * 6, [0] * 7]) == "there must be one class for each dart of each world"
    assert flaw((a, b), [[0] * 6]) == "there must be one class for each dart of each world"
    assert flaw((a, b), [[0] * 6, [1] * 8]) == "the starts are in different classes"
    c = World(cycle(3), Position(0))
    assert "differ in sense" in flaw((c, c), [[0] * 6, [0] * 6])
    assert "differ in sigma" in flaw((a, a), [[0, 0, 0, 1, 0, 0], [0] * 6])
    assert "differ in alpha" in flaw((a, a), [[0, 1, 1, 0, 0, 1]] * 2)


def test_a_finer_partition_than_the_coarsest_is_a_proof_too():
    a = World(cycle(3), Position(0))
    assert flaw((a, a), [range(6), range(6)]) is None
