"""The list of equivalent mutants, as far as known: each entry names one place of the source."""

import importlib.util
import sys
import tomllib
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]


@pytest.fixture(scope="module")
def mutants():
    """The program that makes mutants."""
    path = ROOT / "benchmarks" / "mutants.py"
    specification = importlib.util.spec_from_file_location("benchmarks_mutants", path)
    module = importlib.util.module_from_spec(specification)
    sys.modules["benchmarks_mutants"] = module
    specification.loader.exec_module(module)
    yield module
    del sys.modules["benchmarks_mutants"]


@pytest.fixture(scope="module")
def entries(mutants):
    return tomllib.loads(mutants.EQUIVALENT.read_text(encoding="utf-8"))["mutant"]


def places(mutants, entry):
    """The mutants of today's source that an entry names."""
    text = (ROOT / entry["file"]).read_bytes()
    every = [
        each
        for compiled in (False, True)
        for each in mutants.mutants_of(entry["file"], text, compiled=compiled)
    ]
    return [each for each in every if each.among([entry])]


def test_each_entry_names_exactly_one_place(mutants, entries):
    found = [(entry, places(mutants, entry)) for entry in entries]
    others = [(entry, len(there)) for entry, there in found if len(there) != 1]
    assert not others
    named = [(each.file, each.start, each.end, each.after) for _, there in found for each in there]
    assert len({*named}) == len(named)


def test_each_entry_has_known_keys_and_a_reason(mutants, entries):
    keys = {"file", "line", "before", "after", "within", "nth", "reason"}
    for entry in entries:
        assert {"file", "before", "after"} < entry.keys() <= keys, entry
        assert len(entry["reason"].split()) > 2, entry


def test_equal_changes_of_equal_lines_are_told_apart(mutants):
    text = b"def f():\n    return 0\n    return 0\nclass C:\n    def f(self):\n        return 0\n"
    found = [each for each in mutants.mutants_of("a.py", text) if each.after == "1"]
    assert [(each.within, each.nth) for each in found] == [("f", 1), ("f", 2), ("C.f", 1)]
    assert [each.among([{"within": "f", "nth": 2}]) for each in found] == [False, True, False]


def test_what_numba_compiles_is_changed_by_itself(mutants):
    text = b"A = 1\ndef f(x):\n    return x + 2\ndef g(x: int) -> int:\n    return x + 3\n"
    in_kernel = "src/allworlds/engines/kernel/a.py"
    found = [
        {each.before for each in mutants.mutants_of(in_kernel, text, compiled=compiled)}
        for compiled in (False, True)
    ]
    assert found == [{"1", "x + 3", "3"}, {"x + 2", "2"}]
    elsewhere = mutants.mutants_of("src/allworlds/a.py", text, compiled=True)
    assert not [*elsewhere]
