"""JSON files are read strictly, and SMT-LIB scripts are evaluated as solvers do."""

import random
import re

import pytest
import z3

DEEP = "[" * 100_000


@pytest.fixture
def read_json(checkers, tmp_path):
    """A function that reads a text as a JSON file."""

    def read(text):
        (tmp_path / "file.json").write_bytes(text.encode())
        return checkers("documents").read_json(tmp_path / "file.json")

    return read


@pytest.mark.parametrize(
    ("text", "message"),
    [
        (DEEP, "file.json is nested too deeply to be read"),
        ('{"a":' * 100_000, "file.json is nested too deeply to be read"),
        ("", "file.json is no JSON"),
        ("[1,]", "file.json is no JSON"),
        ("[1] 2", "file.json is no JSON"),
        ('{"a": 1, "a": 2}', "the name 'a' stands twice"),
        ('{"x": {"a": 1, "b": 0, "a": 1}}', "the name 'a' stands twice"),
        ("[0.0]", "the number 0.0 is no integer"),
        ("[1e3]", "the number 1e3 is no integer"),
        ("[NaN]", "the number NaN is no integer"),
        ("[-Infinity]", "the number -Infinity is no integer"),
        (f"[{'1' * 5000}]", "file.json is no JSON"),
        ('["\u00e9"]', "file.json is damaged"),
    ],
)
def test_what_is_not_exactly_a_document_is_refused_in_one_line(checkers, read_json, text, message):
    with pytest.raises(checkers("lrat").Refused) as error:
        read_json(text)
    assert message in str(error.value)
    assert len(str(error.value)) < 200
    assert "\n" not in str(error.value)


def test_what_is_a_document_is_read(read_json):
    assert read_json('{"a": [1, -2, "x", null, true]}\n') == {"a": [1, -2, "x", None, True]}


WORLD = {"sigma": [1, 0], "alpha": [1, 0], "start": 0}


@pytest.mark.parametrize(
    ("lighthouse", "shown", "message"),
    [
        ("none", {}, None),
        ("position", {"dart": 1}, None),
        ("directional", {"dart": 1}, None),
        ("compass", {"darts": [1]}, None),
        ("none", {"dart": 0}, "with the names kind alone"),
        ("position", {"dart": 2}, "a reference dart is 2, but the darts are 0 to 1"),
        ("directional", {"dart": False}, "not a list of integers"),
        ("directional", {"darts": [0]}, "with the names dart, kind alone"),
        ("compass", {"darts": [0, 1]}, "not exactly one reference dart"),
        ("compass", {"darts": []}, "not exactly one reference dart"),
        ("compass", {"darts": 0}, "not a list of integers"),
    ],
)
def test_a_lighthouse_has_exactly_the_darts_that_its_kind_has(checkers, lighthouse, shown, message):
    world_of = checkers("documents").world_of
    document = {**WORLD, "lighthouse": {"kind": lighthouse, **shown}}
    if message is None:
        assert world_of(document, lighthouse).lighthouse == lighthouse
        return
    with pytest.raises(checkers("lrat").Refused, match=message):
        world_of(document, lighthouse)


def test_a_lighthouse_that_there_is_not_shows_nothing_and_is_refused(checkers):
    maps = checkers("maps")
    world = maps.World([1, 0], [1, 0], 0, "xyz", (0,))
    with pytest.raises(checkers("lrat").Refused, match="there is no lighthouse 'xyz'"):
        maps.percepts(world)


# ---------------------------------------------------------------- SMT-LIB


@pytest.fixture
def opinions(checker_of, proofs):
    """The checker of the second opinions, and its folder."""
    return checker_of("second-opinions"), proofs / "second-opinions"


def test_every_model_is_evaluated_and_one_statement_is_settled_by_it(opinions):
    module, folder = opinions
    statements, models, others = module.check(folder)
    assert statements.startswith("31 statements, word for word")
    assert models.startswith("none vacuous")
    assert others.startswith("1 is settled by its model")
    assert others.endswith(": 30")


@pytest.mark.parametrize(
    ("file", "old", "new", "message"),
    [
        ("model", "(assert (home x))\n", "", "the model has other hypotheses"),
        (
            "model",
            "(define-fun x () Dart a1)",
            "(declare-const x Dart)",
            "not a logic, definitions",
        ),
        ("model", "(define-fun x () Dart a1)", "", "x is not defined"),
        ("model", "(define-fun x () Dart a1)", "(define-fun x () Turn one)", "home of ['Turn']"),
        ("model", "((x Dart)) Bool", "((x Turn)) Bool", "= of ['Turn', 'Dart']"),
        ("model", "(define-fun x () Dart a1)", "(define-fun x () Dart b1)", "a hypothesis false"),
        ("model", "(check-sat)", "", "not a logic, definitions"),
        ("model", "(check-sat)", "(check-sat", "a parenthesis is not closed"),
        ("model", "(check-sat)", "(check-sat))", "that was not opened"),
        ("model", "(check-sat)", "(check-sat) sat", "'sat' stands outside"),
        ("model", "Dart a1)", "Dart z9)", "z9 is not defined"),
        ("statement", "(assert (home x))\n", "", "command 13 is (assert (home y))"),
        ("statement", "(assert (home x))", "(assert (not (home x)))", "command 13 is"),
        ("statement", "(set-logic UF)", "(set-logic UF)\n(push 1)", "command 2 is (push 1)"),
        ("statement", "; Expected: unsat", "; Expected: nothing", "does not say '; Expected"),
        ("statement", "; Expected: unsat", "; Expected: sat", "does not say '; Expected: unsat'"),
    ],
)
def test_a_statement_or_model_that_was_damaged_is_refused(
    checkers, opinions, file, old, new, message
):
    module, folder = opinions
    texts = {
        "statement": (folder / "key-lemma-base.smt2").read_text(),
        "model": (folder / "key-lemma-base.model.smt2").read_text(),
    }
    module.require_statement("key-lemma-base", *texts.values())
    assert old in texts[file]
    texts[file] = texts[file].replace(old, new, 1)
    with pytest.raises(checkers("lrat").Refused, match=re.escape(message)):
        module.require_statement("key-lemma-base", *texts.values())


def test_a_definition_that_is_another_in_the_model_is_refused(checkers, opinions):
    module, folder = opinions
    statement, model = (
        (folder / f"bound-pass-grows{kind}.smt2").read_text() for kind in ("", ".model")
    )
    with pytest.raises(checkers("lrat").Refused, match="as it should: pass_bound"):
        module.require_statement("bound-pass-grows", statement, model.replace("(- s 1.0)", "s"))


@pytest.mark.parametrize("name", ["bound-terms.smt2", "bound-terms.model.smt2"])
def test_a_statement_or_model_that_is_missing_or_too_many_is_named(
    checkers, opinions, tmp_path, name
):
    module, folder = opinions
    for path in folder.glob("*.smt2"):
        (tmp_path / path.name).write_bytes(path.read_bytes())
    module.check(tmp_path)
    (tmp_path / name).rename(tmp_path / "a-other.smt2")
    with pytest.raises(checkers("lrat").Refused, match="is no statement of ours"):
        module.check(tmp_path)
    (tmp_path / "a-other.smt2").unlink()
    with pytest.raises(checkers("lrat").Refused, match=f"{name} is missing"):
        module.check(tmp_path)


def text_of(term):
    return term if isinstance(term, str) else f"({' '.join(map(text_of, term))})"


def variants(term, sorts):
    """The term with one constant or number replaced by another of its sort, in every way."""
    if isinstance(term, list):
        for i, part in enumerate(term):
            for other in variants(part, sorts):
                yield [*term[:i], other, *term[i + 1 :]]
        return
    number = re.fullmatch(r"\d+\.\d", term)
    numbers = ["0.0", "1.0", "3.0"] if number else []
    same = next((values for values in sorts.values() if term in values), numbers)
    yield from (value for value in same if value != term)


@pytest.mark.slow
@pytest.mark.long
def test_models_with_one_value_changed_are_true_exactly_where_z3_says_so(checkers, proofs):
    smtlib = checkers("smtlib")
    chance = random.Random(18)
    verdicts = []
    for path in sorted((proofs / "second-opinions").glob("*.model.smt2")):
        script = smtlib.commands(path.read_text())
        sorts = smtlib.definitions(script).sorts
        changes = [
            [*script[:i], [*command[:4], body], *script[i + 1 :]]
            for i, command in enumerate(script)
            if command[0] == "define-fun"
            for body in variants(command[4], sorts)
        ]
        for changed in chance.sample(changes, min(6, len(changes))):
            defined = smtlib.definitions(changed)
            mine = all(defined.value(term, {}) for term in smtlib.assertions(changed))
            solver = z3.Solver()
            solver.from_string(" ".join(map(text_of, changed[:-1])))
            assert mine == (solver.check() == z3.sat), (path.name, text_of(changed))
            verdicts.append(mine)
    assert verdicts.count(True) > 20
    assert verdicts.count(False) > 30
