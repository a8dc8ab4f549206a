"""The files about cycles can say nothing else than they should.

The claims' own checkers are called, which know nothing of digests: so what is asked is whether a
producer that is wrong would be noticed, not whether a file is the one that was committed.
"""

import re

import pytest

from proofs.test_corrupted_cycles import FILES


@pytest.mark.parametrize("file", FILES)
def test_no_word_of_a_file_on_cycles_can_be_left_out_doubled_or_replaced(
    checkers, checker_of, proofs, file
):
    require = checker_of("cycles")._require_condition
    text = re.sub(r";.*", "", (proofs / "cycles" / file).read_text())
    words = re.findall(r"[()]|[^\s()]+", text)
    changes = 0
    for i, word in enumerate(words):
        for new in ([], [word, word], ["0" if word != "0" else "1"]):
            with pytest.raises(checkers("lrat").Refused):
                require(file, " ".join([*words[:i], *new, *words[i + 1 :]]))
            changes += 1
    assert changes > 600
