import json
import re

import pytest

from allworlds.evidence.bench import bench
from allworlds.evidence.bench.rounds import peer
from allworlds.inputs import InputError
from allworlds.reports import text as text_of

pytestmark = pytest.mark.usefixtures("compiled")

SLEEP = "python3 -c 'import time; time.sleep(0.05)'"


@pytest.fixture(scope="module")
def report():
    return bench(edges=4, rounds=2, peers=[f"sleeper={SLEEP}", f"early@3={SLEEP}"])


@pytest.mark.no_cover
def test_each_contender_takes_each_turn(report):
    names = [measured.name for measured in report.contenders]
    assert names == ["kernel", "kernel-2", "count", "judge", "python", "sleeper", "early"]
    assert all(len(measured.seconds) == 2 for measured in report.contenders)
    assert all(rate > 0 for measured in report.contenders for rate in measured.rates)


def test_a_rate_is_worlds_by_seconds(report):
    *_, sleeper, early = report.contenders
    # OEIS A000698: rooted maps with 4 and with 3 edges.
    assert (sleeper.worlds, early.worlds) == (706, 74)
    assert sleeper.seconds == tuple(round(706 / rate, 4) for rate in sleeper.rates)
    assert max(early.rates) < 74 / 0.05


def test_ratios_are_taken_within_a_round(report):
    ratio = report.ratios[-2]
    assert (ratio.of, ratio.to) == ("kernel", "sleeper")
    reference, sleeper = report.contenders[0].rates, report.contenders[-2].rates
    both = [a / b for a, b in zip(reference, sleeper, strict=True)]
    assert ratio.ratio.lowest == round(min(both), 4)
    assert ratio.ratio.highest == round(max(both), 4)


@pytest.mark.no_cover
def test_the_document_says_what_was_measured(report):
    document = json.loads(json.dumps(report.to_json()))
    assert document["schema"] == 1
    assert "commit" in document
    assert document["rounds"] == 2
    assert 10 < document["peak_mb"] < 100_000  # of this process, whatever else it has run


def test_the_text_names_every_contender(report):
    text = text_of("self bench", report, 100)
    for measured in report.contenders:
        assert re.search(rf"^{measured.name} ", text, re.MULTILINE)


@pytest.mark.parametrize("text", ["", "no command", "=x", "name@=x", "name="])
def test_a_peer_of_another_form_is_refused(text):
    with pytest.raises(InputError, match="NAME=COMMAND"):
        peer(text, 4)


@pytest.mark.parametrize("command", ["false", "/no/such/program", "'"])
def test_a_peer_that_fails_is_named(command):
    contender = peer(f"culprit={command}", 4)
    with pytest.raises(InputError, match="'culprit'"):
        contender.work()


@pytest.mark.parametrize("options", [{"edges": 3}, {"edges": 11}, {"rounds": 0}])
def test_options_out_of_range_are_refused(options):
    with pytest.raises(InputError):
        bench(**options)
