"""Single runs, and findings that are played again."""

import pytest

from allworlds import Estimate, Move
from allworlds.documents.document import replace
from allworlds.engines import single
from allworlds.engines.limits import Limits
from allworlds.engines.single import subject_of
from allworlds.inputs.checks import InputError
from allworlds.log import Log, answer
from allworlds.studies.run import run
from allworlds.world import Directional, World
from small import EDGE, PATH

AGAIN = Log(bytes((0,)) + answer((0, 1), (1, 0), 0))


def explore(_first):
    yield Move(0)
    return Estimate(PATH, 0)


@pytest.fixture
def finding():
    found = run(explore, World(EDGE, Directional(0))).finding
    return replace(found, confirmed=True)


def test_an_explorer_is_a_name_or_a_function():
    assert subject_of(explore, Limits()).name.endswith("test_single:explore")
    with pytest.raises(InputError, match=r"^explore = 3 is neither a name nor a function$"):
        subject_of(3, Limits())


@pytest.mark.parametrize("law", ["crash", "timeout"])
def test_a_loss_that_is_not_repeated_is_not_confirmed(finding, law):
    lost = replace(finding, law=law)
    assert single._unlike(lost, AGAIN) == replace(lost, confirmed=False)


@pytest.mark.parametrize("law", ["crash", "timeout", "illegal-action", "budget", "no-estimate"])
def test_a_play_with_an_answer_contradicts_a_law_of_runs_without_one(finding, law):
    assert single._ends_alike(replace(finding, law="pose", seen=""), AGAIN)
    assert not single._ends_alike(replace(finding, law=law, seen=""), AGAIN)


def test_another_law_that_is_not_repeated_is_nondeterministic(finding):
    found = single._unlike(finding, AGAIN)
    assert (found.law, found.confirmed) == ("nondeterministic", True)
    assert found.seen == "it breaks the law map in some plays only"


def test_a_finding_of_an_explorer_that_cannot_be_loaded_any_more_is_not_confirmed(
    finding, monkeypatch
):
    def refused(*_):
        raise InputError("it has another text here")

    for name in ("again", "in_world"):
        monkeypatch.setattr(single.Plays, name, refused)
    found = single.played_again(finding, subject_of("algorithm1", Limits()), Limits())
    assert found == replace(finding, confirmed=False)
