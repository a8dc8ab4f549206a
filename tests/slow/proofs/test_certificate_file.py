"""A certificate that someone else has written, and Coq itself."""

from random import Random

import pytest

from proofs import test_certificate_file as quick
from proofs.test_certificate_file import COQ, TWELVE, mutated

files = quick.files
mine = quick.mine
verified = quick.verified

needs_coq = pytest.mark.skipif(
    not (COQ / "DecisionTrees.vo").exists(), reason="not built: make -C proofs/coq"
)


@needs_coq
@pytest.mark.slowest
def test_coq_accepts_what_is_claimed_and_twelve_and_three_hundred_changed_files_are_refused(
    verified, mine
):
    assert verified(mine, "--against", "algorithm1")[0] == 0
    random = Random(52)
    changed = [mine.replace(*change) for change in TWELVE.values()]
    changed += [mutated(mine, random) for _ in range(300)]
    codes = [verified(text, "--against", "algorithm1")[0] for text in changed]
    accepted = [text for text, code in zip(changed, codes, strict=True) if code == 0]
    assert accepted == []
    assert codes.count(1) > 300


@needs_coq
@pytest.mark.slowest
def test_coq_alone_refuses_a_tree_that_lacks_a_percept(verified, mine):
    there = "((2, Some 1), Node 0 [::\n ((2, Some 0), Leaf (NumberedMap [:: 1; 0] [:: 1; 0] 1))])"
    assert mine.count(f";\n{there}") == 1
    code, said = verified(mine.replace(f";\n{there}", ""), "--against", "algorithm1")
    assert code == 1
    assert said.startswith("REFUSED    ")
