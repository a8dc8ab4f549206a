"""Certificates for Coq's kernel that say something else than what is right: coqc refuses each.

A certificate of Algorithm 1 is changed, one place at a time and in a fixed order.  A change need
not make it false: of a path with one edge both ends look alike.  So ``allworlds check`` is asked
whether the explorer that does as the changed tree says is still right, and coqc must say the same.
"""

import copy
import itertools
import shutil
from functools import cache
from itertools import islice
from pathlib import Path

import pytest

from allworlds import check
from allworlds.explorers.loading import load
from allworlds.maps import CombinatorialMap
from allworlds.protocol.actions import Estimate, Move
from proofs import test_corrupted_certificates as quick
from proofs.test_corrupted_certificates import EDGES, NOT_CLAIMED, OTHER_TEXTS, checked, code
from small import every, slowest

trees = quick.trees

COQ = Path(__file__).parents[3] / "proofs" / "coq"


COUNT = 100


needs_coq = pytest.mark.skipif(
    shutil.which("coqc") is None or not (COQ / "DecisionTrees.vo").exists(),
    reason="not built: make -C proofs/coq",
)


@cache
def honest(trees, edges=EDGES, map_class="maps"):
    return trees.tree_of(load("algorithm1"), edges, map_class)[0]


def places(trees, tree):
    """The way to each motion and to each answer: the percepts before it, in a fixed order."""
    for percept in sorted(tree):
        yield (percept,)
        if isinstance(tree[percept], trees.Node):
            yield from ((percept, *rest) for rest in places(trees, tree[percept].after))


def changed(trees, tree, way, change):
    """A copy in which the branches at the end of a way have been changed; None if that is none."""
    new = copy.deepcopy(tree)
    branches = new
    for percept in way[:-1]:
        branches = branches[percept].after
    change(branches, way[-1])
    return None if new == tree else new


def first_leaf(trees, branch):
    while isinstance(branch, trees.Node):
        branch = branch.after[min(branch.after)]
    return branch


class Changes:
    """Each takes the branches where something is done, and the percept after which it is."""

    def __init__(self, trees):
        self.trees = trees
        leaves = [first_leaf(trees, branch) for branch in honest(trees).values()]
        self.others = [
            *leaves,
            trees.Leaf((1, 2, 3, 0), (1, 0, 3, 2), 0),
            trees.Leaf((0, 1, 2, 3), (1, 0, 3, 2), 0),  # not connected
        ]

    def is_leaf(self, branches, percept):
        return isinstance(branches[percept], self.trees.Leaf)

    def here_moved(self, branches, percept):
        if self.is_leaf(branches, percept):
            leaf = branches[percept]
            for here in range(len(leaf.sigma)):
                if code(leaf, here) != code(leaf):
                    branches[percept] = self.trees.Leaf(leaf.sigma, leaf.alpha, here)

    def here_moved_to_the_next_dart(self, branches, percept):
        if self.is_leaf(branches, percept):
            leaf = branches[percept]
            here = (leaf.here + 1) % len(leaf.sigma)
            branches[percept] = self.trees.Leaf(leaf.sigma, leaf.alpha, here)

    def here_nowhere(self, branches, percept):
        if self.is_leaf(branches, percept):
            leaf = branches[percept]
            branches[percept] = self.trees.Leaf(leaf.sigma, leaf.alpha, len(leaf.sigma))

    def answer_of_another_leaf(self, branches, percept):
        if self.is_leaf(branches, percept):
            leaf = branches[percept]
            branches[percept] = next(o for o in self.others if o.sigma != leaf.sigma)

    def answer_no_permutation(self, branches, percept):
        if self.is_leaf(branches, percept):
            leaf = branches[percept]
            sigma = (leaf.sigma[0], *leaf.sigma[:-1])
            branches[percept] = self.trees.Leaf(sigma, leaf.alpha, leaf.here)

    def answer_with_ends_exchanged(self, branches, percept):
        if self.is_leaf(branches, percept):
            leaf = branches[percept]
            alpha = list(leaf.alpha)
            if len(alpha) > 2:
                other = next(d for d in range(1, len(alpha)) if d != alpha[0])
                for d, e in ((0, other), (alpha[0], alpha[other])):
                    alpha[d], alpha[e] = e, d
            branches[percept] = self.trees.Leaf(leaf.sigma, tuple(alpha), leaf.here)

    def answer_cut_short(self, branches, percept):
        if self.is_leaf(branches, percept):
            leaf = branches[percept]
            branches[percept] = self.trees.Leaf(leaf.sigma, leaf.alpha[:-1], leaf.here)

    def no_answer_but_a_motion(self, branches, percept):
        if self.is_leaf(branches, percept):
            branches[percept] = self.trees.Node(0)

    def motion_changed(self, branches, percept):
        if not self.is_leaf(branches, percept):
            node = branches[percept]
            branches[percept] = self.trees.Node((node.k + 1) % percept[0], node.after)

    def motion_with_a_turn_more(self, branches, percept):
        """Add one whole turn to the motion, which takes the same edge."""
        if not self.is_leaf(branches, percept):
            node = branches[percept]
            branches[percept] = self.trees.Node(node.k + percept[0], node.after)

    def branch_dropped(self, branches, percept):
        del branches[percept]

    def branches_swapped(self, branches, percept):
        other = max(branches)
        branches[percept], branches[other] = branches[other], branches[percept]

    def bearing_of_a_branch_moved(self, branches, percept):
        degree, bearing = percept
        moved = (degree, (bearing + 1) % degree if bearing >= 0 else 0)
        if moved not in branches:
            branches[moved] = branches.pop(percept)

    def answer_too_early(self, branches, percept):
        branches[percept] = first_leaf(self.trees, branches[percept])

    def a_detour(self, branches, percept):
        """There and back as often as it takes to break the limit."""
        for _ in range(4):
            branch = branches[percept]
            # of one dart the way back is known
            branches[percept] = self.trees.Node(
                0, {o: self.trees.Node(0, {percept: branch}) for o in ((1, -1), (2, 1), (2, 0))}
            )


def follower(trees, tree):
    """An explorer that does as the tree says, and gives no answer where it says nothing."""

    def explore(first):
        branches, percept = tree, first
        while True:
            branch = branches.get(trees.sensed(percept))
            if not isinstance(branch, trees.Node):
                break
            percept = yield Move(branch.k)
            branches = branch.after
        if branch is None:
            return None
        return Estimate(CombinatorialMap(branch.sigma, branch.alpha), branch.here)

    return explore


def by_the_package(trees, tree, edges=EDGES, map_class="maps", bound="paper"):
    """The answer that coqc must give, by the verdict of the package."""
    found = check(
        follower(trees, tree),
        edges=edges,
        map_class=map_class,
        laws=("map", "pose", "bound"),
        bound=bound,
    )
    return {"holds": "accepted", "refuted": "refused"}[found.verdict.value]


def changes(trees):
    """Each change of a place: its name, the changed tree."""
    kinds = Changes(trees)
    named = [name for name in vars(Changes) if not name.startswith("_") and name != "is_leaf"]
    ways = list(places(trees, honest(trees)))
    # one of each kind, then another of each: a hundred are of all kinds
    for turn in itertools.count():
        for step, name in enumerate(named):
            if turn >= len(ways):
                return
            way = ways[(turn + step) % len(ways)]
            tree = changed(trees, honest(trees), way, getattr(kinds, name))
            if tree is not None:
                yield name, tree


@cache
def false_ones(trees):
    """The first hundred changes that make the certificate false, each once."""
    seen, kept = [], []
    for name, tree in changes(trees):
        if tree not in seen and by_the_package(trees, tree) == "refused":
            kept.append((name, tree))
            if len(kept) == COUNT:
                break
        seen.append(tree)
    return kept


def asked(trees, folder, text):
    file = folder / "changed.v"
    file.write_text(text)
    return trees.asked_of_coq(file)


@pytest.mark.slowest
def test_there_are_a_hundred_changes_of_all_kinds(trees):
    kinds = {name for name, _ in false_ones(trees)}
    assert len(false_ones(trees)) == COUNT
    named = {name for name in vars(Changes) if not name.startswith("_") and name != "is_leaf"}
    assert kinds == named - {"motion_with_a_turn_more"}  # that one is always true


@needs_coq
@pytest.mark.parametrize("i", every(20, range(COUNT)))
def test_a_certificate_that_a_change_has_made_false_is_refused(trees, tmp_path, i):
    name, tree = false_ones(trees)[i]
    text = trees.certificate(tree, EDGES, name)
    assert asked(trees, tmp_path, text) == "refused", name


@needs_coq
@pytest.mark.slowest
def test_a_certificate_that_a_change_has_left_true_is_accepted(trees, tmp_path):
    """Else refusals would say nothing."""
    true = {
        name: tree
        for name, tree in islice(changes(trees), 200)
        if by_the_package(trees, tree) == "accepted"
    }
    assert {"motion_with_a_turn_more", "here_moved_to_the_next_dart"} <= set(true)
    for name, tree in true.items():
        assert asked(trees, tmp_path, trees.certificate(tree, EDGES, name)) == "accepted", name
    assert asked(trees, tmp_path, trees.certificate(honest(trees), EDGES, "itself")) == "accepted"


@needs_coq
@pytest.mark.parametrize(
    ("edges", "stated", "limit", "universe", "said"),
    [
        (1, 1, "paper", "all", "accepted"),
        (1, 2, "paper", "all", "refused"),  # m raised
        slowest(2, 3, "paper", "all", "refused"),
        (2, 1, "paper", "all", "accepted"),  # m lowered
        slowest(2, 2, "2*m*n", "all", "accepted"),
        slowest(2, 2, "m", "all", "refused"),
        (2, 2, "none", "all", "accepted"),
        slowest(2, 2, "2", "all", "refused"),
        (2, 2, "3", "all", "refused"),
        (2, 2, "4", "all", "accepted"),
        (2, 2, "d0 + 3*m", "all", "accepted"),
        (2, 2, "paper", "simple", "accepted"),
        slowest(2, 2, "none", "simple", "accepted"),
    ],
)
def test_the_bounds_that_are_stated_are_those_that_are_computed(
    trees, tmp_path, edges, stated, limit, universe, said
):
    text = trees.certificate(honest(trees, edges), stated, "algorithm1", limit, universe)
    assert asked(trees, tmp_path, text) == said


@needs_coq
def test_a_tree_of_simple_worlds_is_right_in_these_only(trees, tmp_path):
    tree = honest(trees, 3, "simple")
    for universe, said in (("simple", "accepted"), ("all", "refused")):
        text = trees.certificate(tree, 3, "algorithm1", universe=universe)
        assert asked(trees, tmp_path, text) == said


@needs_coq
@pytest.mark.parametrize("name", OTHER_TEXTS)
def test_a_certificate_whose_text_has_been_changed_is_not_accepted(trees, tmp_path, name):
    text = trees.certificate(honest(trees), EDGES, "algorithm1")
    old, new = OTHER_TEXTS[name]
    assert text.count(old) == 1
    if name == "it is assumed":  # an axiom that is used
        text = text.replace("vm_compute. reflexivity.", "by case: wish.")
    with pytest.raises(trees.NoVerdict, match="coqc"):
        asked(trees, tmp_path, text.replace(old, new))


@needs_coq
def test_coqc_accepts_any_statement_and_only_the_claimed_one_is_a_certificate(trees, tmp_path):
    """The last line that coqc prints is the same."""
    file = tmp_path / "certificate.v"
    text = trees.certificate(honest(trees), EDGES, "algorithm1")
    file.write_text(text)
    assert checked(trees, file) == 0
    file.write_text(text.replace(*NOT_CLAIMED["nothing is concluded"]))
    assert trees.asked_of_coq(file) == "accepted"
    assert checked(trees, file) == 1
