"""One process behind many episodes; see tests/engines/test_workers.py for what goes wrong."""

import io
import json
import os
import select
import sys
from contextlib import suppress

import pytest

from allworlds import check, run
from allworlds.explorers import program as programs
from allworlds.explorers.program import Program, answering, message_of
from allworlds.inputs.checks import InputError
from allworlds.protocol.actions import Checkpoint, ExplorerFault, Move, Percept
from processes import PATIENCE

SCRIPT = """
import sys, json, os
for line in sys.stdin:
    message = json.loads(line)
    if message["percept"]["degree"] == 9: print("{}", flush=True); continue
    print(json.dumps({"move": message.get("told", message.get("episode", 5))}), flush=True)
    sys.stdin.readline()
    print('{"checkpoint": {"sigma": [0], "alpha": [0], "here": 0}}', flush=True)
    estimate = {"sigma": [0, 1], "alpha": [1, 0], "here": os.getpid()}
    print(json.dumps({"estimate": estimate}), flush=True)
"""


PASS_STDERR_ON = Program._pass_stderr_on  # which a fixture of all tests replaces


@pytest.fixture
def program(tmp_path):
    script = tmp_path / "script.py"
    script.write_text(SCRIPT)
    program = Program(f"{sys.executable} {script}", 5.0)
    yield program
    program.close()
    program.close()


def episode(program, told=None):
    walk = program.explore(Percept(1), told=told)
    said = [next(walk), walk.send(Percept(1))]
    with pytest.raises(StopIteration) as end:
        walk.send(None)
    return said, end.value.value


def test_one_process_plays_many_episodes(program):
    (one, checkpoint), first = episode(program)
    assert checkpoint == Checkpoint([0], [0], 0)
    (other, _), second = episode(program)
    # It moves by the number of the episode, which tells nothing but that it is another one.
    assert one != other
    assert first.here == second.here


def test_it_is_told_what_there_is_to_tell(program):
    assert episode(program, told=4)[0][0] == Move(4)


def test_a_new_process_begins_after_a_fault(program):
    _, first = episode(program)
    with pytest.raises(
        ExplorerFault, match=r"the line \{\}: it has none of the keys move, drop, "
    ) as fault:
        next(program.explore(Percept(9)))
    assert fault.value.law == "illegal-action"
    assert episode(program)[1].here != first.here


SPEAKS = """
import sys, json
if json.loads(sys.stdin.readline())["percept"]["degree"] == 9:
    print("nine", file=sys.stderr, flush=True)
    print("{}", flush=True)
    sys.stdin.readline()
"""


def test_what_a_process_said_is_not_told_of_the_next_one(tmp_path):
    script = tmp_path / "script.py"
    script.write_text(SPEAKS)
    program, details = Program(f"{sys.executable} {script}", 5.0), []
    for degree in (9, 8):
        with pytest.raises(ExplorerFault) as fault:
            next(program.explore(Percept(degree)))
        details.append(fault.value.detail)
    assert ["nine" in detail for detail in details] == [True, False]


WRITES_ON = """
import os, sys, time
sys.stdin.readline()
shown = b'{"checkpoint": {"sigma": [0], "alpha": [0], "here": 0}}\\n'
os.write(1, shown + shown + b'{"mo')
time.sleep(0.1)
os.write(1, b've": 3}\\n')
sys.stdin.readline()
"""


def test_lines_and_a_part_of_one_may_come_together(tmp_path):
    script = tmp_path / "script.py"
    script.write_text(WRITES_ON)
    program = Program(f"{sys.executable} {script}", PATIENCE)
    walk = program.explore(Percept(4))
    shown = Checkpoint([0], [0], 0)
    assert [next(walk), walk.send(None), walk.send(None)] == [shown, shown, Move(3)]
    walk.close()


def test_a_new_process_begins_after_an_episode_that_was_broken_off(program):
    _, first = episode(program)
    walk = program.explore(Percept(1))
    next(walk)
    walk.close()
    assert episode(program)[1].here != first.here
    assert json.dumps(first.map.to_json())


def test_of_a_message_two_hundred_characters_are_shown(tmp_path):
    script = tmp_path / "long.py"
    script.write_text(
        "import json\n"
        "length = json.loads(input())['percept']['degree']\n"
        "print(json.dumps({'estimate': {'x': 'a' * (length - len('{\"x\": \"\"}'))}}))\n"
        "input()\n"
    )
    seen = {}
    for length in (200, 201):
        long = Program(f"{sys.executable} {script}", PATIENCE)
        with pytest.raises(ExplorerFault) as fault:
            next(long.explore(Percept(length)))
        _, _, seen[length] = fault.value.seen.partition(": ")
    assert seen[200] == json.dumps({"x": "a" * 191})
    assert seen[201] == seen[200][:197] + "..."


LINE = '{"move": 0}\\n'
AFTER_ITS_LINE = {
    "silent": (f"raw('{LINE}'); input(); time.sleep(1000)", "timeout", "silent for 0.2 s"),
    "a byte": (
        f"raw('{LINE}x'); time.sleep(1000)",
        "timeout",
        "no whole line in 0.2 s (1 byte of one)",
    ),
    "drops": (f"raw('{LINE}xy')\nwhile True: raw('x')", "timeout", "no whole line in 0.2 s ("),
    "without input": (
        f"os.close(0); raw('{LINE}'); time.sleep(1000)",
        "crash",
        "the end of its input: it reads no more, and goes on",
    ),
    "without output": (
        f"raw('{LINE}'); os.close(1); time.sleep(1000)",
        "crash",
        "the end of its output: it writes no more, and goes on",
    ),
    "gone": (f"raw('{LINE}'); sys.exit(7)", "crash", "the end of its process (exit code 7)"),
}
"""What a program does after its first line, the law that it breaks, and how that is told."""


@pytest.mark.parametrize("kind", AFTER_ITS_LINE)
def test_the_words_for_a_program_without_a_line_are_true_of_it(tmp_path, kind):
    code, law, seen = AFTER_ITS_LINE[kind]
    script = tmp_path / "script.py"
    beginning = "import os, sys, time\nraw = lambda text: os.write(1, text.encode())\n"
    script.write_text(f"{beginning}sys.stdin.readline()\n{code}\n")
    program = Program(f"{sys.executable} {script}", PATIENCE)
    walk = program.explore(Percept(1))
    next(walk)
    if law == "timeout":
        program._timeout = 0.2
    with pytest.raises(ExplorerFault) as fault:
        walk.send(Percept(1))
    assert (fault.value.law, fault.value.seen[: len(seen)]) == (law, seen)
    last = {"a byte": "stdout ended in 'x'", "drops": f"stdout ended in '{'x' * 60}"}
    assert fault.value.detail.startswith(last.get(kind, ""))
    assert ("stdout" in fault.value.detail) == (kind in last)


@pytest.mark.parametrize(
    ("text", "reason"),
    [
        ("\0\1\2", "Exec format error"),
        ("print('no interpreter is named')\n", "Exec format error"),
        ("#!/no/such/interpreter\n", "No such file or directory"),
        ("#!/\n", "Permission denied"),
    ],
)
@pytest.mark.parametrize("name", ["exec:./{}", "shield:exec:./{}"])
@pytest.mark.processes
def test_a_program_that_cannot_be_started_is_bad_input(tmp_path, monkeypatch, text, reason, name):
    monkeypatch.chdir(tmp_path)
    file = tmp_path / "nothing"
    file.write_text(text)
    file.chmod(0o755)
    told = f"--exec './nothing' cannot be started: {reason}; legal is a program"
    with pytest.raises(InputError, match=told):
        check(name.format("nothing"), edges=1)
    with pytest.raises(InputError, match=told):
        run(name.format("nothing"), "loop")


def test_what_cannot_be_run_is_told_apart_from_what_is_not_there(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "folder").mkdir()
    (tmp_path / "plain.py").touch()
    (tmp_path / "loop").symlink_to("loop")
    (tmp_path / "loop.py").symlink_to("loop.py")
    for command, reason in {
        "./folder": "a directory",
        "./plain.py --fast": "not executable",
        "plain.py": "write './plain.py'",
        "./nothing": "there is no program './nothing'",
        "./loop": "'./loop' is a loop of links",
        f"{sys.executable} ./loop.py": "cannot open './loop.py': './loop.py' is a loop of links",
    }.items():
        with pytest.raises(InputError, match=reason):
            Program(command, 1.0)


def test_last_words_that_come_before_the_first_percept_are_kept(monkeypatch):
    start = Program.start

    def start_and_wait(program):
        start(program)
        program._process.wait()

    monkeypatch.setattr(Program, "start", start_and_wait)
    program = Program(f"{sys.executable} -c 'raise SystemExit(\"last words\")'", PATIENCE)
    with pytest.raises(ExplorerFault) as fault:
        next(program.explore(Percept(1)))
    program.close()
    assert "last words" in fault.value.detail


def test_a_program_is_left_to_end_when_its_input_ends(tmp_path):
    script = tmp_path / "script.py"
    script.write_text(f"{SCRIPT}open({str(tmp_path / 'ended')!r}, 'w').close()\n")
    program = Program(f"{sys.executable} {script}", 5.0)
    episode(program)
    program.close()
    assert (tmp_path / "ended").exists()


@pytest.mark.parametrize(
    ("line", "seen"),
    [
        (b"{", "a line that is no JSON: "),
        (b"3", "a line that is no object: '3'"),
        (b"{}", "it has none of the keys move, drop, "),
        (b'{"move": 1, "drop": true}', "it has 2 of the keys move, drop, "),
        (b'{"drop": 1}', "move takes an integer, write one from 0 on, drop and pick take true"),
    ],
)
def test_what_is_no_line_of_the_protocol_is_said(line, seen):
    with pytest.raises(ExplorerFault, match=seen) as fault:
        message_of(line)
    assert fault.value.law == "illegal-action"


def test_what_a_program_says_without_a_newline_is_told_at_once(program, monkeypatch):
    """A stream like stderr, which writes whole lines by itself, and no others."""
    episode(program)
    stream = io.TextIOWrapper(io.BytesIO(), line_buffering=True)
    monkeypatch.setattr(sys, "stderr", stream)
    program._read = lambda _: None
    program._err[:] = b"half a line"
    PASS_STDERR_ON(program)
    assert stream.buffer.getvalue() == b"half a line"


@pytest.mark.parametrize(
    ("percept", "line"),
    [
        (Percept(3, 1, 0), b'{"percept": {"degree": 3, "marks": 1, "bearing": 0}}\n'),
        ([1, {"a": None}], b'{"percept": [1, {"a": null}]}\n'),
        (False, b'{"percept": false}\n'),
    ],
)
def test_the_percept_of_a_model_may_be_any_value(percept, line):
    assert answering(percept) == line


def test_an_estimate_of_no_map_is_told_with_what_was_tried():
    line = b'{"estimate": {"sigma": [0, 1], "alpha": [0, 1], "here": 0}}'
    with pytest.raises(ExplorerFault, match=r"^no map: alpha\[0\] = 0, but alpha must") as fault:
        message_of(line)
    assert fault.value.law == "no-estimate"
    assert fault.value.detail


def test_a_number_with_too_many_digits_for_python_to_print_is_shown():
    least = -(10 ** sys.get_int_max_str_digits())
    with pytest.raises(ExplorerFault, match=r"an object of type dict whose repr fails") as fault:
        programs._values({"here": least}, "an estimate", "no-estimate", "sigma")
    assert fault.value.law == "no-estimate"


def test_a_line_before_the_first_percept_is_illegal(program):
    episode(program)
    program._out += b'{"move": 1}\n'
    with pytest.raises(ExplorerFault) as fault:
        next(program.explore(Percept(1)))
    assert fault.value.law == "illegal-action"
    assert fault.value.seen == "a line before it was asked: '{\"move\": 1}\\n'"


def test_a_line_has_so_many_bytes_at_most(program, monkeypatch):
    monkeypatch.setattr(programs, "LONGEST_LINE", 8)
    program._timeout = 0
    for length, law, seen in (
        (8, "timeout", "no whole line in 0 s (8 bytes of one)"),
        (9, "illegal-action", "a line of over 8 bytes"),
    ):
        program._out[:] = b"x" * length
        with pytest.raises(ExplorerFault) as fault:
            program._line()
        assert (fault.value.law, fault.value.seen) == (law, seen)


def test_a_line_of_the_largest_length_is_read_to_its_end(program, monkeypatch):
    monkeypatch.setattr(programs, "LONGEST_LINE", 10)
    program._timeout = 1000

    def read(_left):
        program._out += b"\nmore"
        return True

    monkeypatch.setattr(program, "_read", read)
    program._out[:] = b"x" * 10
    assert program._line() == b"x" * 10
    assert program._out == b"more"


@pytest.fixture
def full_pipe(program):
    """The end from which nobody has read what fills the pipe to a program."""
    reading, writing = os.pipe()
    os.set_blocking(writing, False)
    with suppress(BlockingIOError):
        while True:
            os.write(writing, bytes(1 << 12))
    program._in_to = writing
    yield reading
    os.close(reading)
    os.close(writing)


def test_a_program_that_reads_no_answers_is_given_up(program, full_pipe):
    program._timeout = 0.01
    with pytest.raises(ExplorerFault) as fault:
        program._send(b"line\n")
    seen = "it writes on, and for 0.01 s it has read nothing of the answers"
    assert (fault.value.law, fault.value.seen) == ("illegal-action", seen)
    assert fault.value.machine


def test_a_line_is_sent_when_earlier_lines_are_read(program, full_pipe, monkeypatch):
    asked = []

    class Poll:
        def register(self, *what):
            asked.append(what)

        def poll(self, milliseconds):
            asked.append(milliseconds)
            os.read(full_pipe, 1 << 20)  # now the program reads
            return asked

    monkeypatch.setattr(programs.select, "poll", Poll)
    program._timeout = 3
    program._send(b"line\n")
    monkeypatch.undo()
    assert asked == [(program._in_to, select.POLLOUT), 3000]
    assert os.read(full_pipe, 100) == b"line\n"


def test_a_process_that_is_started_anew_has_not_said_what_the_one_before_has():
    program = Program(f"{sys.executable} -c 'input()'", 5.0)
    program._out += b"half of a line"
    program._err += b"some words"
    program.start()
    try:
        assert (bytes(program._out), bytes(program._err)) == (b"", b"")
    finally:
        program.close()


def test_a_program_has_all_of_its_time(tmp_path):
    script = tmp_path / "late.py"
    script.write_text("import time\ninput()\ntime.sleep(0.3)\nprint('late', flush=True)\ninput()\n")
    program = Program(f"{sys.executable} {script}", 1.25)
    try:
        program.start()
        program._send(b"{}\n")
        assert program._line() == b"late"
    finally:
        program.close()
