"""Players as their owner sees them, and a player's own part in this process."""

import marshal
import os
import select
import signal
import sys
from pathlib import Path
from types import SimpleNamespace
from typing import ClassVar

import pytest

from allworlds import log as entries
from allworlds.engines import linux, player, players
from allworlds.engines.batch import Due
from allworlds.engines.judge import PythonJudge
from allworlds.engines.limits import Limits
from allworlds.engines.players import (
    HarnessError,
    Logs,
    Lost,
    PlayerHere,
    PlayerProcess,
    Setup,
    answered,
    lost_log,
)
from allworlds.engines.tally import RunCounter
from allworlds.engines.units import Scope
from allworlds.explorers.loading import Subject, load, source_of
from allworlds.inputs.checks import InputError
from allworlds.judging.rules import Rules
from allworlds.log import Log
from allworlds.maps import MapClass
from allworlds.maps.classes import Extent
from allworlds.protocol.actions import Drop, ExplorerFault, Move
from allworlds.world import Directional, World
from small import EDGE

pytestmark = pytest.mark.processes

PROGRAM = Path(__file__).parents[1] / "support" / "explorers_for_tests" / "program.py"
WORLD = World(EDGE, Directional(0))
RIGHT = """
import gc

from allworlds import CombinatorialMap, Estimate, Move

COLLECTED = gc.isenabled()

def explore(first):
    yield Move(0)
    return Estimate(CombinatorialMap((0, 1), (1, 0)), 1)

def collected(first):
    assert COLLECTED
    return (yield from explore(first))

def dies(first):
    import os
    yield Move(0)
    os._exit(3)

def prints(first):
    print("here")
    return (yield from explore(first))

def floods(first):
    print(200_000 * "x")
    return (yield from explore(first))

def forks(first):
    import os
    os.fork()
    return (yield from explore(first))

def hangs(first):
    import time
    yield Move(0)
    while True:
        time.sleep(1)
"""


@pytest.fixture
def module(tmp_path):
    file = tmp_path / "mine.py"
    file.write_text(RIGHT)
    return file


def setup_of(module, name="explore", **more):
    explorer = f"{module}:{name}"
    subject = Subject(explorer, frozenset(), source=source_of(explorer))
    return Setup(subject, Limits(answer_timeout=more.pop("answer_timeout", 60)), **more)


def judge():
    return PythonJudge(RunCounter(Scope(Extent(MapClass.MAPS, 1), Rules()), 1), "mine")


def runs(times=1, *, hear=False):
    return judge().worlds_message([Due(0, 0, WORLD)] * times) | {"hear": hear}


def test_a_player_plays_a_batch_in_worlds_and_against_records(module):
    one = PlayerProcess(setup_of(module), 0)
    try:
        logs = [*answered(one, runs(3))]
        (first, *_) = logs
        assert logs == [first] * 3
        assert Log(first).actions == [0]
        judged = judge().judged(Due(0, 0, WORLD), first)
        assert judged.outcome.violation is None
        batch_of_records = judge().percepts_message([judge_record(judged)], [0])
        assert [*answered(one, batch_of_records)] == [first]
    finally:
        one.close()
    with pytest.raises(OSError, match="Bad file descriptor"):
        os.fstat(one._printed)


def test_garbage_is_collected_while_users_code_is_loaded_and_played(module):
    one = PlayerProcess(setup_of(module, "collected"), 0)
    try:
        (log,) = answered(one, runs())
    finally:
        one.close()
    assert Log(log).ending[0] == entries.ANSWERED


@pytest.mark.parametrize("number", [signal.SIGTERM, signal.SIGHUP])
def test_a_signal_for_the_player_of_a_program_is_not_the_programs_fault(number):
    subject = Subject(f"exec:{sys.executable} {PROGRAM} hang", frozenset())
    one = PlayerProcess(Setup(subject, Limits()), 0)
    try:
        one.loaded()
        os.kill(one.pid, number)
        with pytest.raises(Lost, match=f"signal {int(number)}") as lost:
            answered(one, runs())
        assert lost.value.machine
    finally:
        one.close()


def judge_record(judged):
    from allworlds.engines.batch import Recorded

    return Recorded.of(Due(0, 0, WORLD), judged.outcome.episode)


def test_the_walk_of_a_player_that_dies_is_heard(module):
    one = PlayerProcess(setup_of(module, "dies"), 0)
    try:
        with pytest.raises(Lost, match="exit code 3") as lost:
            answered(one, runs(hear=True))
        assert lost.value.law == "crash"
        assert Log(lost_log(bytes(one.part), lost.value)).actions == [0]
    finally:
        one.close()


def test_a_silent_player_is_given_up(module):
    one = PlayerProcess(setup_of(module, "hangs", answer_timeout=0.3), 0)
    try:
        with pytest.raises(Lost, match=r"silent for 0\.3 s") as lost:
            answered(one, runs(hear=True))
        assert (lost.value.law, lost.value.machine) == ("timeout", True)
        assert one.beat[0] == 0
    finally:
        one.close()


def test_prints_are_recorded_where_that_is_asked_for(module):
    for prints, told in ((True, "here\n"), (False, "")):
        one = PlayerProcess(setup_of(module, "prints", prints=prints), 0)
        try:
            answered(one, runs())
        finally:
            one.close()
        assert one.prints.text == told


def test_a_player_that_prints_more_than_a_pipe_holds_answers(module):
    one = PlayerProcess(setup_of(module, "floods", prints=True, answer_timeout=20), 0)
    try:
        answered(one, runs(2))
    finally:
        one.close()
    assert one.prints.text.startswith("xxx")


def test_a_copy_of_a_player_does_not_answer(module):
    one = PlayerProcess(setup_of(module, "forks"), 0)
    try:
        assert len(answered(one, runs(5))) == 5
        assert not one.jobs
    finally:
        one.close()


def test_a_player_that_is_killed_while_it_loads_is_started_once_more(module, tmp_path):
    once = tmp_path / "once"
    text = f"import os, signal\nfrom pathlib import Path\nonce = Path({str(once)!r})\n"
    text += "if not once.exists():\n    once.touch()\n    os.kill(os.getpid(), signal.SIGKILL)\n"
    module.write_text(text + RIGHT)
    one = PlayerProcess(setup_of(module), 0)
    try:
        assert len(answered(one, runs())) == 1
    finally:
        one.close()


def test_a_player_that_always_ends_while_it_loads_is_bad_input(module):
    module.write_text("import os\nos._exit(4)\n")
    one = PlayerProcess(setup_of(module), 0)
    try:
        with pytest.raises(InputError, match=r"exit code 4.* when it imported .*mine.py"):
            one.loaded()
    finally:
        one.close()


@pytest.mark.parametrize(
    "said", [b"X", bytes((player.LOGS,)) + b"12345678", bytes((player.READY,)) + b"\xff", b""]
)
def test_bytes_that_are_no_message_are_a_crash(module, said):
    one = PlayerProcess(setup_of(module), 0)
    try:
        one.loaded()
        one.jobs.append((None, runs()))
        with pytest.raises(Lost, match="none of its messages"):
            one._message(said)
    finally:
        one.close()


def test_what_a_player_started_ends_with_it(module):
    if not linux.HERE:
        pytest.skip("Linux alone ends what has left its group")
    started = "import subprocess\nprocess = subprocess.Popen(['sleep', '1000'], "
    started += "start_new_session=True)\nprint(process.pid, flush=True)\n"
    module.write_text(started + RIGHT)
    one = PlayerProcess(setup_of(module), 0)
    one.loaded()
    (pid,) = {int(word) for word in one._relayed.decode().split()}
    one.close()
    with pytest.raises(ProcessLookupError):
        os.kill(pid, 0)


def test_without_linux_all_but_daemons_and_memory_is_as_ever(module, monkeypatch):
    monkeypatch.setattr(linux, "HERE", False)
    linux.end_with_parent(0)
    linux.adopt()
    linux.limit_memory(1)
    assert linux.descendants(os.getpid()) == []
    one = PlayerProcess(setup_of(module), 0)
    assert len(answered(one, runs())) == 1
    one.close()


# ---------------------------------------------------------------- the player's own part


class Link:
    """A link that a player reads and writes, without a process."""

    def __init__(self, messages):
        self.waiting = b"".join(len(m).to_bytes(4, "little") + m for m in messages)
        self.said = b""

    def read(self, _file, size):
        part, self.waiting = self.waiting[:size], self.waiting[size:]
        return part

    def write(self, _file, data):
        self.said += bytes(data)
        return len(data)

    @property
    def answers(self):
        said, found = self.said, []
        while said:
            size = int.from_bytes(said[:4], "little")
            found.append((said[4], said[5 : 4 + size]))
            said = said[4 + size :]
        return found


@pytest.fixture
def served(monkeypatch):
    """Serve messages by a player in this process; return its answers."""

    def serve(explorer, *batches):
        link = Link([marshal.dumps(batch) for batch in batches])
        monkeypatch.setattr(player.os, "read", link.read)
        monkeypatch.setattr(player.os, "write", link.write)
        server = player._Server(explorer, [0, 0])
        while (batch := player._read()) is not None:
            server.serve(batch)
        monkeypatch.undo()
        return link.answers

    return serve


def test_a_server_plays_what_it_is_given(module, served):
    explorer = load(f"{module}:explore")
    ((letter, content),) = served(explorer, runs(2))
    assert letter == player.LOGS
    logs = players.Logs(content, 2)
    assert {*logs} == {entries.motion(0) + entries.answer((0, 1), (1, 0), 1)}


def test_a_server_sends_each_turn_where_that_is_asked_for(module, served):
    parts = served(load(f"{module}:explore"), runs(hear=True))
    assert [letter for letter, _ in parts] == [player.PART, player.PART, player.LOGS]
    assert [content for _, content in parts[:2]] == [b"", entries.motion(0)]


def test_a_mistake_of_ours_is_told_as_that(module, served):
    ((letter, content),) = served(load(f"{module}:explore"), runs() | {"order": [7]})
    assert letter == player.FAILURE
    assert b"IndexError" in content


class Library:
    """In place of the player of shared libraries: it says what is in its list."""

    made: ClassVar = []

    def __init__(self, native, beat):
        self.made.append(native)

    def play(self, batch):
        if batch["says"] == "fault":
            raise ExplorerFault("crash", "a choice that is none")
        return batch["says"] and player.logs_message(batch["says"])


@pytest.fixture
def library(monkeypatch):
    """A library, as a player has loaded it."""
    Library.made.clear()
    module = "allworlds.engines.kernel.library_player"
    monkeypatch.setitem(sys.modules, module, SimpleNamespace(LibraryPlayer=Library))
    return SimpleNamespace(native="native", player=lambda: None)


@pytest.mark.parametrize(
    ("says", "again", "letter", "logs"),
    [
        ([b"a", b"bc"], False, player.LOGS, [b"a", b"bc"]),
        ([b"a", b"bc"], True, player.LOGS, [b"a", b"bc"]),
        (None, False, player.LOGS, [bytes((entries.BEYOND,))] * 2),
        ("fault", False, player.LOGS, [bytes((entries.BEYOND,))] * 2),
        (None, True, player.NO_ROOM, None),
        ("fault", True, player.NO_ROOM, None),
    ],
)
def test_a_server_of_a_library_tells_its_logs_or_leaves_them_to_python(
    library, served, says, again, letter, logs
):
    asked = {"kind": "native", "runs": 2, "again": again, "says": says}
    one, other = served(library, asked, asked)
    assert one == other
    assert one[0] == letter
    assert logs is None or [*Logs(one[1], 2)] == logs
    assert Library.made == ["native"]


@pytest.fixture
def copied(monkeypatch):
    """This process is a copy, after the first time that it asks for its number."""
    numbers = iter([1])

    class Ended(BaseException):
        """In place of the end of this process."""

    def end(code):
        raise Ended(code)

    monkeypatch.setattr(player.os, "getpid", lambda: next(numbers, 2))
    monkeypatch.setattr(player.os, "_exit", end)
    monkeypatch.setattr(player, "_answer", None)
    return pytest.raises(Ended, match=r"^0$")


def test_a_copy_of_a_player_ends_before_it_answers(module, library, copied, monkeypatch):
    server = player._Server(library, [0, 0])
    with copied:
        server.serve({"kind": "native", "runs": 1, "again": False, "says": [b"a"]})
    monkeypatch.setattr(player, "turns_of", lambda *_: None)
    monkeypatch.setattr(player, "turns_taken", lambda *_: [b""])
    with copied:
        server.serve({"kind": player.TURNS[0]})


def test_a_copy_that_plays_ends(module, copied):
    explorer = load(f"{module}:explore").player()
    with copied:
        player.played(runs(), explorer, [0, 0])


def test_a_link_that_breaks_ends_the_player(module, monkeypatch):
    def broken(*_):
        raise OSError("the owner has gone")

    server = player._Server(load(f"{module}:explore"), [0, 0])
    monkeypatch.setattr(player, "played", broken)
    with pytest.raises(OSError, match="the owner has gone"):
        server.serve(runs())


def test_a_program_stays_between_turns():
    program = SimpleNamespace(stays=False)
    of_program = player.turns_of(SimpleNamespace(program=program, explore=None), None, [0, 0])
    of_function = player.turns_of(SimpleNamespace(program=None, explore=None), None, [0, 0])
    assert program.stays is True
    assert (of_program._most, of_function._most > 1) == (1, True)


def test_what_is_sensed_on_a_walk_is_told_or_why_there_is_none():
    assert b"'bearing'" in player.senses(WORLD, [Move(0)])
    assert b"markers" in player.senses(WORLD, [Drop()])


def test_a_message_to_a_player_that_has_ended_is_dropped():
    one = object.__new__(PlayerProcess)

    def send(_):
        raise BrokenPipeError

    one._link, one._out = SimpleNamespace(send=send), bytearray(b"message")
    one._write()
    assert one._out == b""


def test_an_error_of_ours_in_a_player_is_told_as_that():
    one = object.__new__(PlayerProcess)
    with pytest.raises(HarnessError, match=r"^Traceback: \ufffd$"):
        one._message(bytes((player.FAILURE,)) + b"Traceback: \xff")


def test_a_player_that_is_lost_while_it_loads_is_started_again(monkeypatch):
    one, done = object.__new__(PlayerProcess), []
    one.description = None

    def heard():
        done.append("heard")
        if len(done) == 1:
            raise Lost("crash", "it died", machine=True)
        one.description = "loaded"

    one.heard, one.again = heard, lambda: done.append("again")
    monkeypatch.setattr(players, "wait", lambda *_: None)
    assert one.loaded() == "loaded"
    assert done == ["heard", "again", "heard"]


@pytest.mark.parametrize("lives", [True, False])
def test_a_kept_player_is_used_if_it_lives(lives, monkeypatch):
    setup, closed = SimpleNamespace(message=lambda: "setup"), []
    kept, other = (
        SimpleNamespace(
            owner=os.getpid(), seed=seed, setup=setup, lives=lives, close=lambda: closed.append(1)
        )
        for seed in (3, 4)
    )
    spare = [other, kept]
    monkeypatch.setattr(players, "_spare", spare)
    monkeypatch.setattr(players, "PlayerProcess", lambda *given: given)
    assert players.fresh(setup, 3) == (kept if lives else (setup, 3))
    assert spare == [other]
    assert len(closed) == (not lives)


def test_what_the_system_refuses_is_told_in_one_line(monkeypatch):
    def refused(*_):
        raise OSError(27, "File too large")

    monkeypatch.setattr(players.os, "truncate", refused)
    said = "^no 16 bytes can be shared with an explorer: File too large; legal is 'ulimit -f' of 1"
    with pytest.raises(InputError, match=said):
        players._shared(16)
    with pytest.raises(HarnessError, match=r"^no process could be started: File too large$"):
        players._in_thread(refused)


def test_a_player_here_is_asked_as_one_elsewhere(module):
    here = PlayerHere(load(f"{module}:prints").player(), prints=True)
    elsewhere = PlayerProcess(setup_of(module), 0)
    try:
        assert [*answered(here, runs(2))] == [*answered(elsewhere, runs(2))]
    finally:
        elsewhere.close()
    assert here.prints.text == "here\n" * 2


def test_more_than_a_socket_holds_is_sent_bit_by_bit(module):
    one = PlayerProcess(setup_of(module), 0)
    try:
        assert len([*answered(one, runs() | {"unknown": bytes(1 << 23)})]) == 1
    finally:
        one.close()


def test_it_is_told_whether_one_of_the_others_is_ready():
    there, here = os.pipe()
    try:
        assert not players.wait([], 0, [there])
        os.write(here, b"x")
        assert players.wait([], 0, [there])
    finally:
        os.close(there)
        os.close(here)


def test_it_waits_for_whatever_its_players_may_say(monkeypatch):
    asked = []
    poll = SimpleNamespace(register=lambda *each: asked.append(each), poll=lambda _time: [])
    monkeypatch.setattr(select, "poll", lambda: poll)
    players.wait([SimpleNamespace(files=[7, 8])], 0)
    assert asked == [(7, select.POLLIN), (8, select.POLLIN)]


def test_a_player_is_silent_since_its_latest_run_or_turn(monkeypatch):
    one = object.__new__(players.PlayerProcess)
    one.description, one.jobs, one.beat, one._seen, one._since = ("known",), [1], [3, 0], None, 0.0
    silent = []
    for now, beat in enumerate([[3, 0], [3, 0], [3, 1], [3, 1], [4, 1]]):
        monkeypatch.setattr(players.time, "monotonic", lambda now=now: float(now))
        one.beat = beat
        silent.append(one._silent_for())
    assert silent == [0.0, 1.0, 0.0, 1.0, 0.0]


@pytest.mark.parametrize(("memory", "limited"), [(None, [1_000 + 7]), (50, [50])])
def test_a_library_has_a_limit_of_memory_if_the_user_gives_none(memory, limited, monkeypatch):
    limits = []
    library = SimpleNamespace(print_line_by_line=lambda: None)
    subject = SimpleNamespace(native=SimpleNamespace(library=library))
    monkeypatch.setattr(player, "limit_memory", limits.append)
    monkeypatch.setattr(player, "address_space", lambda: 1_000)
    monkeypatch.setattr("allworlds.explorers.loading.load", lambda *_: subject)
    setup = {"memory": memory, "native_memory": 7, "source": None, "name": "n", "answer_timeout": 1}
    assert player._loaded(setup) is subject
    assert limits == limited


@pytest.mark.parametrize("does", ["played", "turns_taken"])
def test_a_timer_that_an_explorer_has_left_ends_with_its_runs(does, monkeypatch):
    def leaves_timers(*_):
        for timer in player.TIMERS:
            signal.setitimer(timer, 600)
        return [b"log"]

    answers = []
    monkeypatch.setattr(player, does, leaves_timers)
    monkeypatch.setattr(player, "_answer", lambda *words: answers.append(words))
    server = object.__new__(player._Server)
    server._subject = server._player = server._beat = None
    server._turns, server._pid = "turns", os.getpid()
    batch = {"kind": "record", "content": [], "hear": False}
    try:
        (server._play if does == "played" else server._take_turns)(batch)
        assert [signal.getitimer(timer) for timer in player.TIMERS] == [(0.0, 0.0)] * 3
    finally:
        for timer in player.TIMERS:
            signal.setitimer(timer, 0)
    assert len(answers) == 1


def test_a_new_player_is_in_no_run_and_a_loss_has_its_words(module):
    one = PlayerProcess(setup_of(module), 0)
    try:
        assert [*one.beat] == [player.NO_RUN, 0]
    finally:
        one.close()
    assert str(Lost("crash", "it died", machine=True)) == "it died"
