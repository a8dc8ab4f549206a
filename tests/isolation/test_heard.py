"""A player is heard, and not trusted."""

import os
import pickle
from collections import OrderedDict
from pathlib import Path

import pytest

from allworlds.checker import check
from allworlds.episode import Fault, Log, LostRun, Said
from allworlds.inputs import InputError
from allworlds.isolation.heard import Garbled, read
from allworlds.isolation.jobs import Described, HarnessError, Played, Told
from allworlds.protocol import Percept

LOG = Log((0, 1), ((1, (0,), (0,), 0),), Said((1, 0), (1, 0), 0), (0,), (2,))


class Bomb:
    def __init__(self, file):
        self.file = str(file)

    def __reduce__(self):
        return os.mkdir, (self.file,)


@pytest.mark.parametrize(
    "message",
    [
        Described(frozenset({"choices"}), "00"),
        Played([(3, LOG)], [3]),
        [LOG, LOG._replace(ending=Fault("crash", "an answer", "none", "", machine=True))],
        Told(None),
        Told(3),
        Told((1, Percept(2, 1, 0))),
        10**30,
    ],
)
def test_what_a_player_has_to_say_is_heard(message):
    assert read(pickle.dumps(message)) == message


@pytest.mark.parametrize("error", [InputError("m"), HarnessError("m")])
def test_its_errors_are_heard(error):
    heard = read(pickle.dumps(error))
    assert (type(heard), str(heard)) == (type(error), "m")


@pytest.mark.parametrize("protocol", range(pickle.HIGHEST_PROTOCOL + 1))
def test_what_would_act_when_it_is_read_does_not(tmp_path, protocol):
    words = pickle.dumps([3, Bomb(tmp_path / "there")], protocol)
    with pytest.raises(Garbled, match="mkdir is no part of a message"):
        read(words)
    assert [*tmp_path.iterdir()] == []
    pickle.loads(words)
    assert [*tmp_path.iterdir()] == [tmp_path / "there"]


@pytest.mark.parametrize(
    "words", [b"", b"garbage", pickle.dumps(LOG)[:-3], pickle.dumps([OrderedDict(), Path()])]
)
def test_what_is_no_message_is_garbled(words):
    with pytest.raises(Garbled):
        read(words)


def test_a_player_does_not_say_that_a_run_is_lost():
    with pytest.raises(Garbled):
        read(pickle.dumps(LostRun("crash", "", "")))


def test_an_explorer_that_writes_into_the_pipe_is_refuted_and_nothing_is_done(tmp_path):
    module = tmp_path / "writes.py"
    module.write_text(
        "import gc, os\n"
        "from multiprocessing.connection import Connection\n"
        "from allworlds.explorers import algorithm1\n"
        "class Bomb:\n"
        f"    def __reduce__(self): return os.mkdir, ({str(tmp_path / 'there')!r},)\n"
        "def explore(first):\n"
        "    for pipe in [one for one in gc.get_objects() if isinstance(one, Connection)]:\n"
        "        pipe.send(Bomb())\n"
        "    return (yield from algorithm1(first))\n"
    )
    report = check(f"{module}:explore", edges=1)
    (finding,) = report.findings
    assert (finding.law, finding.confirmed) == ("crash", True)
    assert "words of its own in the pipe of its process" in finding.seen
    assert not (tmp_path / "there").exists()
