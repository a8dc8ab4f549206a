"""Every verb says what it is recorded to say."""

from difflib import unified_diff
from itertools import islice

import pytest

from allworlds.verbs import VERBS
from recorded.test_recorded import recorder


def difference(kept: str, told: str) -> str:
    command, *_ = kept.splitlines()
    lines = unified_diff(kept.splitlines(), told.splitlines(), lineterm="", n=0)
    return "\n".join([command, *islice(lines, 2, 40)])


def differences(record, names):
    told = record.records(names)
    assert [*told] == names
    kept = {name: (record.RECORDS / f"{name}.txt").read_text(encoding="utf-8") for name in names}
    return [difference(kept[name], told[name]) for name in names if told[name] != kept[name]]


def test_every_verb_says_what_is_recorded():
    record = recorder()
    first = {}
    for name, words in record.COMMANDS.items():
        for verb in VERBS:
            if f"{words} ".startswith(f"{verb.name} "):
                first.setdefault(verb.name, name)
    assert first.keys() >= {verb.name for verb in VERBS}
    assert differences(record, [*first.values()]) == []


@pytest.mark.long
def test_every_command_says_what_is_recorded():
    record = recorder()
    assert differences(record, [*record.COMMANDS]) == []
