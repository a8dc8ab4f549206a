"""Every verb says what it is recorded to say."""

import importlib.util
from difflib import unified_diff
from itertools import islice
from pathlib import Path

import pytest

HERE = Path(__file__).parent


def recorder():
    spec = importlib.util.spec_from_file_location("record", HERE / "record.py")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def difference(kept: str, told: str) -> str:
    command, *_ = kept.splitlines()
    lines = unified_diff(kept.splitlines(), told.splitlines(), lineterm="", n=0)
    return "\n".join([command, *islice(lines, 2, 40)])


@pytest.mark.slow
def test_every_verb_says_what_is_recorded():
    record = recorder()
    told = record.records([*record.COMMANDS])
    kept = {path.stem: path.read_text(encoding="utf-8") for path in record.RECORDS.iterdir()}
    assert [*told] == [*record.COMMANDS]
    assert sorted(kept) == sorted(told)
    assert [difference(kept[name], told[name]) for name in told if told[name] != kept[name]] == []


def test_every_record_has_its_command():
    record = recorder()
    assert sorted(path.stem for path in record.RECORDS.iterdir()) == sorted(record.COMMANDS)
