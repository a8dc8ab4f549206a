"""No changed formula is accepted, and no changed proof proves what is not so.

The claims' own checkers are called, which know nothing of digests: so what is asked is whether a
producer that is wrong would be noticed, not whether a file is the one that was committed.
"""

import lzma
import random
import re
import shutil

import pytest

SEED = 18
FORMULAS = [
    *(f"no-twins-directional/m{m}" for m in range(1, 6)),
    "smallest-pairs/maps-m1",
    *(f"smallest-pairs/simple-m{m}" for m in range(1, 6)),
    *(f"smallest-pairs/planar-simple-m{m}" for m in range(1, 8)),
    "fig1/search-m8",
]
QUICK = [name for name in FORMULAS if name[-1] in "123" and "fig1" not in name]


def text_of(path):
    return lzma.decompress(path.read_bytes()).decode()


def write(path, text):
    path.write_bytes(lzma.compress(text.encode(), preset=0))


@pytest.fixture
def refuted(checkers, checker_of, proofs):
    """A function that checks formula and proof of a claim, in whatever folder they are."""
    refute = checkers("lrat_claims").refuted
    world = checkers("world_clauses")

    def check(name, folder=proofs):
        claim, _, file = name.partition("/")
        if claim == "fig1":
            asked, edges, most = checker_of("fig1").CAPTION, 8, 5
        elif claim == "no-twins-directional":
            asked, edges, most = checker_of(claim).ASKED, int(file[1:]), None
        else:
            map_class, _, edges = file.rpartition("-m")
            asked, edges, most = world.Asked("position", map_class), int(edges), None
        size = world.size_of(asked, edges, most)
        files = (folder / f"{name}.{kind}.xz" for kind in ("cnf", "lrat"))
        return refute(*files, asked, (size, size))

    return check


@pytest.fixture
def copied(proofs, tmp_path):
    """A function that copies formula and proof, to be damaged, and names the new folder."""

    def copy(name, instead_of=None):
        for kind in ("cnf", "lrat"):
            path = tmp_path / f"{instead_of or name}.{kind}.xz"
            path.parent.mkdir(exist_ok=True)
            shutil.copyfile(proofs / f"{name}.{kind}.xz", path)
        return tmp_path

    return copy


@pytest.mark.parametrize("name", QUICK)
def test_every_formula_on_file_is_the_one_that_the_checkers_write(refuted, name):
    assert refuted(name) > 0


# ---------------------------------------------------------------- formulas, by name


def parts(text):
    lines = text.splitlines()
    comments = [line for line in lines if line[0] == "c"]
    (header,) = [line for line in lines if line[0] == "p"]
    return comments, header.split()[2], [line for line in lines if line[0] not in "cp"]


def joined(comments, variables, clauses):
    return "\n".join([*comments, f"p cnf {variables} {len(clauses)}", *clauses]) + "\n"


def shifted(proof, old, by):
    """The proof for a formula with more clauses at its end."""

    def moved(word):
        return str(int(word) + by) if int(word) > old else word

    for line in proof.splitlines():
        number, *words = line.split()
        if words[0] == "d":
            yield " ".join([moved(number), "d", *map(moved, words[1:-1]), "0"])
        else:
            end = words.index("0")
            yield " ".join(
                [moved(number), *words[: end + 1], *map(moved, words[end + 1 : -1]), "0"]
            )


@pytest.mark.parametrize(
    ("old", "new", "message"),
    [
        (" 1..16 sigma1[4][4]: ", " 17..32 sigma1[4][4]: ", "no such variables: c variables"),
        (" 1..16 sigma1[4][4]: ", " 1..16 sigma1[16]: ", "no such variables: c variables"),
        (" sigma1[4][4]: ", " alpha1[4][4]: ", "no such variables: c variables"),
        (" sigma1[4][4]: ", " beta1[4][4]: ", "there are no such variables: c variables 1..16 be"),
        (" sigma1[4][4]: ", " sigma1: ", "there are no such variables: c variables 1..16 sigma1:"),
    ],
)
def test_comments_that_name_variables_wrongly_are_refused(
    copied, refuted, checkers, old, new, message
):
    name = "no-twins-directional/m2"
    folder = copied(name)
    path = folder / f"{name}.cnf.xz"
    text = text_of(path)
    assert old in text
    write(path, text.replace(old, new))
    with pytest.raises(checkers("lrat").Refused, match=re.escape(message)):
        refuted(name, folder)


def test_a_formula_without_comments_says_the_same(copied, refuted):
    name = "no-twins-directional/m2"
    folder = copied(name)
    path = folder / f"{name}.cnf.xz"
    write(path, joined([], *parts(text_of(path))[1:]))
    assert refuted(name, folder) == refuted(name)


@pytest.mark.parametrize(
    ("line", "message"),
    [
        ("c variables 1..4 carried8[2][2]: F", "the darts are 0 to 3"),
        ("c variables 1..4 carried1[2][2]: F", "variables, not"),
        ("c variables 1..4 carried1[2][2]: F\nc variables 1..4 carried1[2][2]: F", "twice"),
    ],
)
def test_other_starts_that_a_file_names_wrongly_are_refused(
    copied, refuted, checkers, line, message
):
    name = "no-twins-directional/m2"
    folder = copied(name)
    path = folder / f"{name}.cnf.xz"
    write(path, f"{line}\n{text_of(path)}")
    with pytest.raises(checkers("lrat").Refused, match=message):
        refuted(name, folder)


# ---------------------------------------------------------------- formulas, at random


def changed_formula(chance, variables, clauses):
    """The clauses with one change."""
    clauses = [list(clause) for clause in clauses]
    clause = chance.choice([c for c in clauses if c])
    literal = chance.randrange(len(clause))
    match chance.randrange(7):
        case 0:
            clauses.remove(clause)
        case 1:
            del clause[literal]
        case 2:
            clause[literal] = -clause[literal]
        case 3:
            clause[literal] = chance.choice([1, -1]) * chance.randint(1, variables)
        case 4:
            clause.append(chance.choice([1, -1]) * chance.randint(1, variables))
        case 5:
            size = chance.randint(0, 3)
            clauses.append(
                [chance.choice([1, -1]) * v for v in chance.sample(range(1, variables + 1), size)]
            )
        case 6:  # two variables are exchanged
            one, two = chance.sample(range(1, variables + 1), 2)
            other = {one: two, two: one, -one: -two, -two: -one}
            clauses = [[other.get(x, x) for x in c] for c in clauses]
    return clauses


def refused_formulas(checkers, proofs, refuted, name, tries):
    """How many of so many changed formulas differ, and how many of those are refused."""
    lrat, lrat_claims = checkers("lrat"), checkers("lrat_claims")
    variables, clauses = lrat.read_formula(text_of(proofs / f"{name}.cnf.xz"))
    wanted = {}
    require_same = lrat_claims.require_same

    def remembered(clauses_, *formula):
        wanted["clauses"] = clauses_
        require_same(clauses_, *formula)

    lrat_claims.require_same = remembered
    try:
        refuted(name)
    finally:
        lrat_claims.require_same = require_same
    chance = random.Random(f"{SEED} {name}")
    right = set(map(frozenset, clauses))
    differ = refused = 0
    for _ in range(tries):
        changed = changed_formula(chance, variables, clauses)
        if set(map(frozenset, changed)) != right:
            differ += 1
            with pytest.raises(lrat.Refused):
                require_same(wanted["clauses"], variables, changed)
            refused += 1
    return differ, refused


@pytest.mark.parametrize("name", [name for name in QUICK if name[-1] != "3"])
def test_no_changed_formula_is_accepted(checkers, proofs, refuted, name):
    differ, refused = refused_formulas(checkers, proofs, refuted, name, 60)
    assert differ == refused > 30


# ---------------------------------------------------------------- LRAT proofs


def changed_proof(chance, lines):
    """The lines of a proof with one change."""
    lines = list(lines)
    i = chance.randrange(len(lines))
    words = lines[i].split()
    j = chance.randrange(len(words))
    match chance.randrange(8):
        case 0:
            del lines[i]
        case 1:
            lines.insert(i, chance.choice(lines))
        case 2:
            del words[j]
        case 3:
            words.insert(j, chance.choice(chance.choice(lines).split()))
        case 4:
            words[j] = str(chance.randint(-50, 500))
        case 5:
            words[j] = words[j][1:] if words[j][0] == "-" else f"-{words[j]}"
        case 6:
            k = chance.randrange(len(words))
            words[j], words[k] = words[k], words[j]
        case 7:
            words = chance.choice(lines).split()
    if i < len(lines):
        lines[i] = " ".join(words)
    return lines


def accepted_proofs(checkers, formula, proof, tries, seed):
    """The changed proofs that are accepted for the formula."""
    lrat = checkers("lrat")
    chance = random.Random(seed)
    for _ in range(tries):
        changed = proof
        for _ in range(chance.randint(1, 3)):
            changed = changed_proof(chance, changed)
        try:
            lrat.check(*formula, changed)
        except lrat.Refused:
            continue
        yield changed


@pytest.mark.parametrize("name", ["no-twins-directional/m1", "smallest-pairs/maps-m1"])
def test_each_line_of_a_changed_proof_that_is_accepted_follows_from_the_formula(
    checkers, proofs, name
):
    solver = pytest.importorskip("pysat.solvers", reason="python-sat is not installed").Solver
    formula = checkers("lrat").read_formula(text_of(proofs / f"{name}.cnf.xz"))
    proof = text_of(proofs / f"{name}.lrat.xz").splitlines()
    accepted = list(accepted_proofs(checkers, formula, proof, 400, SEED))
    assert 0 < len(accepted) < 200
    with solver("g4", bootstrap_with=formula[1]) as solving:
        for lines in accepted:
            for line in lines:
                number, *words = line.split()
                if words[0] != "d":
                    clause = [int(word) for word in words[: words.index("0")]]
                    assert not solving.solve(assumptions=[-literal for literal in clause]), number


@pytest.mark.parametrize("tries", [150])
def test_no_proof_however_changed_refutes_a_formula_that_has_a_model(checkers, proofs, tries):
    world = checkers("world_clauses")
    asked = world.Asked("position", "maps")
    size = world.size_of(asked, 2)  # there the two loops in the plane and on the torus look alike
    clauses = checkers("twin_clauses").twin_clauses(asked, (size, size))
    satisfiable = clauses.variables, [sorted(clause) for clause in clauses.sentences]
    lrat = checkers("lrat")
    borrowed = []
    for name in ("no-twins-directional/m2", "smallest-pairs/simple-m2", "smallest-pairs/maps-m1"):
        formula = lrat.read_formula(text_of(proofs / f"{name}.cnf.xz"))
        by = len(satisfiable[1]) - len(formula[1])
        proof = text_of(proofs / f"{name}.lrat.xz")
        borrowed += [proof.splitlines(), list(shifted(proof, len(formula[1]), by))]
    for number, proof in enumerate(borrowed):
        assert list(accepted_proofs(checkers, satisfiable, proof, tries, number)) == []


@pytest.mark.parametrize("word", ["-0", "00", "+0", "0_0", "\u0660", "0."])
def test_a_proof_or_formula_with_a_number_that_is_none_is_refused(checkers, word):
    lrat = checkers("lrat")
    with pytest.raises(lrat.Refused, match="line 1"):
        lrat.check(1, [[1], [-1]], [f"3 0 1 2 {word}"])
    with pytest.raises(lrat.Refused, match="line 2"):
        lrat.read_formula(f"p cnf 1 1\n1 {word}\n")
    assert lrat.check(1, [[1], [-1]], ["3 0 1 2 0"]) == 1
