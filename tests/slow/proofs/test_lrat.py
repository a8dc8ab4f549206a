import random

import pytest


def committed(lrat, proofs, name):
    variables, clauses = lrat.read_formula(lrat.read(proofs / f"{name}.cnf.xz"))
    return variables, clauses, lrat.read(proofs / f"{name}.lrat.xz").splitlines()


@pytest.mark.slowest
@pytest.mark.parametrize("seed", range(60))
def test_a_committed_proof_with_one_line_changed_is_refused(checkers, proofs, seed):
    lrat = checkers("lrat")
    variables, clauses, proof = committed(lrat, proofs, "no-twins-directional/m3")
    chance = random.Random(seed)
    i = chance.randrange(len(proof))
    words = proof[i].split()
    end = words.index("0")
    damage = seed % 6
    if damage == 0:
        del proof[i]
    elif damage == 1:
        del words[-2]  # the last hint
    elif damage == 2:
        words[-2] = str(int(words[-2]) + 1 + chance.randrange(5))
    elif damage == 3:
        words[0] = str(int(words[0]) - 1)
    elif damage == 4:
        words[-1] = words[-2]  # no end
    else:
        words.insert(1, str(-int(words[1])) if end > 1 else "1")
    if damage:
        proof[i] = " ".join(words)
    with pytest.raises(lrat.Refused, match="line"):
        lrat.check(variables, clauses, proof)
