"""The schemas against real documents, and against the same documents spoilt."""

import pytest

from schemas.test_schemas import DOCUMENTS, document, wrongs

pytestmark = pytest.mark.usefixtures("compiled")


# Keys that may be missing, and objects whose keys are data.
OPTIONAL = {
    *("after", "believed", "best_cost", "checkpoints", "code", "covered", "detail", "distinct"),
    *("fingerprint", "given", "labelled", "lead", "listed", "others", "start_delay", "step"),
    *("stopped", "tried", "twins", "within", "wrong_checkpoint"),
}


# What a percept that is read may leave out, or call by another name.
LEFT_OUT = {f"without {key}" for key in ("marks", "bearing")}
LEFT_OUT |= {f"{key} misspelt" for key in ("marks", "bearing")}


# What a document may leave out: the walk is long, and not every census has a pair.
NOT_ALWAYS = {
    "run.schema.json": {"without transcript"},
    "replay.schema.json": {"without transcript"},
    "ambiguity-census.schema.json": {"without pair", "without bisimulation"},
    "teamreplay.schema.json": {"without world", "without starts"},
}


TABLES = {
    *("witnesses", "by_vertices", "by_genus", "labelled", "expected", "parameters"),
    *("expected_witnesses", "figures", "expected_figures"),
    # By the explorer.
    *("explorers", "mean", "worst", "less", "equal", "more", "costs", "ratio"),
}


OF_MODELS = {"sensed", "vertices", "edges"}
"""Keys in events of teams with any JSON value of their model, or with texts that may be missing."""


def spoilt(value, path=()):
    """Every document with one key missing, one misspelt, or one value of another type.

    The fields of a lighthouse of the user's own, which has a digest, are the user's.
    """
    if isinstance(value, dict) and "digest" in value:
        return
    if isinstance(value, dict) and (not path or path[-1] not in TABLES):
        for key in value:
            rest = {other: value[other] for other in value if other != key}
            if key not in OPTIONAL:
                yield (*path, f"without {key}"), rest
            yield (*path, f"{key} misspelt"), {**rest, f"{key}s": value[key]}
            yield (*path, f"{key} an odd value"), {**rest, key: [[{"odd": 1.5}]]}
            for where, inner in spoilt(value[key], (*path, key)):
                yield where, {**rest, key: inner}
    if isinstance(value, list):
        for i, entry in enumerate(value[:2]):
            for where, inner in spoilt(entry, (*path, i)):
                yield where, [*value[:i], inner, *value[i + 1 :]]


@pytest.mark.slowest
@pytest.mark.parametrize("name", DOCUMENTS)
def test_a_missing_misspelt_or_odd_key_is_refused(name):
    reference, found = document(name)
    if "transcript" in found:
        # A row of a transcript is like another.
        found = {**found, "transcript": found["transcript"][:3]}
    tried = 0
    for where, wrong in spoilt(found):
        if name == "transcript" and where[-1] in LEFT_OUT:
            continue
        if where[-1] in NOT_ALWAYS.get(reference, ()):
            continue
        if "events" in where and OF_MODELS & {word for part in where for word in str(part).split()}:
            continue
        assert wrongs(reference, wrong), where
        tried += 1
    assert tried > 5
