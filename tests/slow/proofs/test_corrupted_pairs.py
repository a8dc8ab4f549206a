"""No change of a pair that says something else is accepted.

The claims' own checkers are called, which know nothing of digests: so what is asked is whether a
producer that is wrong would be noticed, not whether a file is the one that was committed.
"""

import pytest

from proofs.test_corrupted_pairs import PAIRS, accepted_changes, is_harmless


@pytest.mark.slowest
@pytest.mark.parametrize("name", PAIRS)
def test_no_change_of_one_part_of_a_pair_is_accepted_in_the_long_run(
    checkers, checker_of, proofs, name
):
    for document, path, value in accepted_changes(checkers, checker_of, proofs, name, None):
        assert is_harmless(document, path, value), (path, value)
