"""Interrupted commands: the finished part, one line on stderr, and exit code 130."""

import builtins
import json
import signal
import sys
import threading
from importlib import import_module
from types import SimpleNamespace

import pytest

from allworlds.cli import _interrupt_again, app, main
from allworlds.engines.engine_table import Threads
from allworlds.inputs.checks import at_interrupts
from allworlds.outcome import Completed, Interrupted, until_interrupted
from allworlds.studies.ambiguity.twin_search import _TwinsSearch

# A verb; what it goes through once for each of its rows; its words; where its rows stand.
ROWS = {
    "count": ("allworlds.engines.sweep.gather", "--edges 4", "rows"),
    "ambiguity census": ("allworlds.engines.sweep.gather", "--edges 4", "rows"),
    "worst": ("allworlds.engines.sweep.gather", "--edges 4", "rows"),
}


class InterruptedAt:
    """A function that the user interrupts when it has been called so often."""

    def __init__(self, function, times):
        self.function, self.times = function, times

    def __call__(self, *arguments):
        self.times -= 1
        if self.times < 0:
            raise KeyboardInterrupt
        return self.function(*arguments)


@pytest.fixture
def interrupt(monkeypatch):
    """Interrupt what has that path when it is called for the n-th time, counted from 0."""

    def at(path, times):
        home, _, name = path.rpartition(".")
        module = import_module(home)  # a function of the package may have its name, too
        monkeypatch.setattr(module, name, InterruptedAt(getattr(module, name), times))

    return at


@pytest.mark.usefixtures("compiled")
@pytest.mark.parametrize("verb", ROWS)
def test_the_rows_before_an_interrupt_are_told(cli, interrupt, verb):
    path, words, rows = ROWS[verb]
    interrupt(path, 2)
    code, out, err = cli(*verb.split(), *words.split(), "--json")
    document = json.loads(out)
    assert (code, err) == (130, "allworlds: interrupted; the report tells what was finished\n")
    assert document["complete"] is False
    assert len(document[rows]) == (5 if verb == "worst" else 2)  # of 1 edge 2 sizes, of 2 edges 3


@pytest.mark.usefixtures("compiled")
@pytest.mark.parametrize("verb", ROWS)
def test_the_text_of_what_was_interrupted_says_so(cli, interrupt, verb):
    path, words, _ = ROWS[verb]
    interrupt(path, 1)
    code, out, _ = cli(*verb.split(), *words.split())
    assert code == 130
    head = " ".join(out.partition("\n\n")[0].split())
    assert head.startswith("INCONCLUSIVE interrupted; before that: ")


SEARCH = "ambiguity search --lighthouse position --class simple --vertices 4 --edges 6 --json --out"


def test_a_search_that_is_interrupted_is_undecided(cli, interrupt, tmp_path):
    interrupt("allworlds.studies.ambiguity.formulas.pair_formula", 1)
    code, out, err = cli(*SEARCH.split(), tmp_path)
    document = json.loads(out)
    assert (code, document["exit_code"], document["status"]) == (130, 130, "unknown")
    assert len(document["levels"]) == 1
    assert document["notices"][-1].startswith("interrupted; no answer follows from the sizes")
    assert all(line.startswith("allworlds: interrupted") for line in err.splitlines())


def test_twins_that_were_found_before_an_interrupt_are_told(cli, monkeypatch, tmp_path):
    def interrupted(*_):
        raise KeyboardInterrupt

    monkeypatch.setattr(_TwinsSearch, "_fewer_vertices", interrupted)
    code, out, _ = cli(*SEARCH.split(), tmp_path)
    document = json.loads(out)
    assert (code, document["status"], len(document["pair"])) == (130, "sat", 2)
    assert document["notices"][-1] == "interrupted before fewer vertices were tried"
    assert (tmp_path / "pair.json").exists()


def test_an_interrupt_at_once_is_told_in_a_line(capsys, monkeypatch):
    loads = builtins.__import__

    def interrupted(name, globals_=None, locals_=None, fromlist=(), level=0):
        if "app" in (fromlist or ()):
            raise KeyboardInterrupt
        return loads(name, globals_, locals_, fromlist, level)

    monkeypatch.setattr(builtins, "__import__", interrupted)
    monkeypatch.setattr(signal, "signal", lambda *_: None)
    monkeypatch.setattr(sys, "unraisablehook", sys.unraisablehook)
    with pytest.raises(SystemExit) as end:
        main()
    assert end.value.code == 130
    assert capsys.readouterr() == ("", "allworlds: interrupted\n")


def test_an_interrupt_that_falls_into_a_finalizer_comes_again(capsys):
    def dropped():
        _interrupt_again(SimpleNamespace(exc_type=KeyboardInterrupt))
        while True:
            signal.pause()

    before = signal.getsignal(signal.SIGALRM)
    try:
        with pytest.raises(KeyboardInterrupt):
            dropped()
    finally:
        signal.signal(signal.SIGALRM, before)
    assert capsys.readouterr() == ("", "")


@pytest.mark.parametrize("words", ["ambiguity twins k4 k4", "ambiguity class k4"])
def test_what_has_one_answer_has_none(cli, monkeypatch, words):
    def interrupted(*_):
        raise KeyboardInterrupt

    monkeypatch.setattr("allworlds.world.named._world_of_text", interrupted)
    assert cli(*words.split()) == (130, "", "allworlds: interrupted\n")


def test_rows_until_an_interrupt():
    def rows():
        yield 1
        yield 2
        raise KeyboardInterrupt

    assert until_interrupted(rows()) == ((1, 2), Interrupted())
    assert until_interrupted([3]) == ((3,), Completed())
    assert until_interrupted([]) == ((), Completed())


def test_a_thread_that_cannot_be_given_up_is_not_waited_for():
    busy, on = threading.Event(), threading.Event()

    class Stubborn:
        def halt(self):
            pass

        def parts(self, unit):
            busy.set()
            assert on.wait(60)
            yield unit

    def use():
        with Threads(1) as threads:
            parts = threads.map(Stubborn(), [1])
            consumer = threading.Thread(target=lambda: [*parts], daemon=True)
            consumer.start()
            assert busy.wait(60)
            raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        use()
    assert not on.is_set()
    on.set()


def test_threads_that_are_not_interrupted_finish():
    class Doubling:
        def halt(self):
            pass

        def parts(self, unit):
            yield 2 * unit

    with Threads(2) as threads:
        assert sorted(part.result for part in threads.map(Doubling(), [1, 2, 3])) == [2, 4, 6]


def test_to_be_left_is_to_be_interrupted_unless_it_is_to_be_ignored(monkeypatch):
    handled = {}
    before = {signal.SIGHUP: signal.SIG_IGN}
    monkeypatch.setattr(signal, "getsignal", lambda number: before.get(number, signal.SIG_DFL))
    monkeypatch.setattr(signal, "signal", handled.__setitem__)
    at_interrupts(signal.default_int_handler)
    assert handled == dict.fromkeys([signal.SIGINT, signal.SIGTERM], signal.default_int_handler)


def test_a_thread_that_goes_on_is_not_waited_for(monkeypatch):
    class Left(BaseException):
        pass

    def leave(code):
        raise Left(code)

    monkeypatch.setattr(signal, "signal", lambda *_: None)
    monkeypatch.setattr(app, "prepare_streams", lambda: None)
    monkeypatch.setattr(app, "call", lambda _: 5)
    monkeypatch.setattr(threading, "active_count", lambda: 2)
    monkeypatch.setattr(app.os, "_exit", leave)
    with pytest.raises(Left, match="5"):
        app.main()


def test_windows_is_refused(monkeypatch, capsys):
    monkeypatch.setattr(app, "os", SimpleNamespace(name="nt"))
    monkeypatch.setattr(app, "prepare_streams", lambda: None)
    with pytest.raises(SystemExit, match="2"):
        app.main()
    said = capsys.readouterr().err
    assert said.count("\n") == 1
    assert "is not supported, but Linux is (macOS was not tried)" in said


def test_a_broken_pipe_is_no_verdict(cli, monkeypatch):
    def broken(*_, **__):
        raise BrokenPipeError(32, "Broken pipe")

    monkeypatch.setattr("allworlds.check", broken)
    code, out, err = cli("check", "--edges", 1)
    assert (code, out, err) == (70, "", "allworlds: Broken pipe\n")
