"""The meaning of the loss of a player, row by row of its table; no process is started."""

from types import SimpleNamespace

import pytest

from allworlds.engines import losses
from allworlds.engines.losses import Losses, Meaning, meaning
from allworlds.engines.players import Lost, Unsettled
from allworlds.engines.tally import Tally
from allworlds.judging.episode import fault_of
from allworlds.log import Log

LOG = "the log of a fresh player"


@pytest.mark.parametrize("law", ["crash", "timeout"])
@pytest.mark.parametrize("machine", [True, False])
@pytest.mark.parametrize("again", [True, False])
@pytest.mark.parametrize("before", [0, 1, 2])
def test_each_row_of_the_table(law, machine, again, before):
    found = meaning(Lost(law, "it ended", machine=machine), again=again, before=before)
    if again:
        assert found is Meaning.BROKEN
    elif not machine or (law == "timeout" and before > 0):
        assert found is Meaning.BROKEN_AFTER_OTHERS
    else:
        assert found is Meaning.REMARK


@pytest.mark.parametrize(
    ("silences", "timeout", "ends"), [(4, 15, True), (3, 100, False), (4, 14.9, False)]
)
def test_silence_is_given_up_after_enough_runs_and_enough_seconds(silences, timeout, ends):
    said = losses.given_up(silences, timeout)
    assert (type(said), bool(said)) == (str, ends)


@pytest.fixture
def batch():
    return SimpleNamespace(work=SimpleNamespace(tally=Tally(1)), lost=set())


def test_a_loss_that_is_repeated_is_the_runs_and_the_next_one_counts_at_once(batch):
    lost, all_losses = Lost("crash", "it ended", machine=True), Losses()
    assert all_losses.log_of(lost, batch, 3, lambda: ([LOG], lost)) == LOG
    log = all_losses.log_of(lost, batch, 5, lambda: pytest.fail("it was tried again"))
    assert (batch.lost, "it ended" in str(Log(log).ending)) == ({3, 5}, True)
    assert not batch.work.tally.remarks


def test_the_second_silence_that_no_fresh_player_repeats_is_that_of_a_run_after_others(batch):
    lost, all_losses = Lost("timeout", "silent for 1 s", machine=True), Losses()
    assert all_losses.log_of(lost, batch, 0, lambda: ([LOG], None)) == LOG
    assert (batch.lost, sum(batch.work.tally.remarks.values())) == (set(), 1)
    log = all_losses.log_of(lost, batch, 1, lambda: ([LOG], None))
    assert (batch.lost, losses.AFTER in str(Log(log).ending)) == ({1}, True)
    assert not fault_of(Log(log)).machine
    assert all_losses.silences == 2


def test_too_many_remarks_are_no_result(batch):
    lost, all_losses = Lost("crash", "it ended", machine=True), Losses()
    for _ in range(losses.MOST_LOSSES):
        all_losses.remark(batch.work, lost)
    with pytest.raises(Unsettled, match="21 players were lost, the last by it ended"):
        all_losses.remark(batch.work, lost)
