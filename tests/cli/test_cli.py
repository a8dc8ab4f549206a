"""The command line from outside: exit codes, what is on stdout, what is on stderr."""

# ruff: noqa: UP031
import json
import os
import shlex
import signal
import subprocess
import sys
from pathlib import Path
from types import SimpleNamespace

import pytest

import processes
from allworlds.cli.app import call, command_line
from allworlds.cli.run import _Stopping, ensure_step
from allworlds.inputs.checks import InputError
from processes import PATIENCE

EXPLORERS = Path(__file__).parents[1] / "support" / "explorers_for_tests"
WRONG = f"{EXPLORERS / 'wrong.py'}"
EDGE = '{"sigma": [0, 1], "alpha": [1, 0]}'


def _heed_signals():
    for number in (signal.SIGINT, signal.SIGHUP):
        signal.signal(number, signal.SIG_DFL)


@pytest.fixture
def start():
    """Start a command in a session of its own; whatever becomes of the test, it ends."""
    started = []

    def run(*arguments, **environment):
        process = subprocess.Popen(
            [sys.executable, "-m", "allworlds", *map(str, arguments)],
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            text=True,
            start_new_session=True,
            # A shell that runs the tests in the background lets them ignore these.
            preexec_fn=_heed_signals,  # noqa: PLW1509
            env={**os.environ, **environment},
        )
        started.append(process)
        return process

    yield run
    for process in started:
        if process.poll() is None:
            for pid in (*processes.children_of(process.pid), process.pid):
                os.kill(pid, signal.SIGKILL)
        process.communicate()


BAD = [
    (["check", "nonsense"], "nonsense"),
    (["check", "no.such.module:explore"], "no.such.module"),
    (["check", "no_such_file.py:explore"], "no_such_file.py"),
    (["check", f"{WRONG}:nobody"], "nobody"),
    (["check", f"{WRONG}:EDGE"], "EDGE"),
    (["check", f"{WRONG}:signature"], "signature"),
    (["check", f"{WRONG}:"], "wrong.py"),
    (["check", ":"], ":"),
    (["check", "json:loads"], "json:loads"),
    (["check", "--exec", ""], "empty"),
    (["check", "--exec", "no-such-program x"], "no-such-program"),
    (["check", "--exec", "'"], "'"),
    (["check", "algorithm1", "--exec", "cat"], "algorithm1"),
    (["check", "--edges", "0"], "0"),
    (["check", "--edges", "-3"], "-3"),
    (["check", "--edges", "x"], "x"),
    (["check", "--edges", "2.5"], "2.5"),
    (["check", "--vertices", "0", "--edges", "2"], "0"),
    (["check", "--vertices", "3"], "3"),
    (["check", "--class", "nonsense"], "nonsense"),
    (["check", "--lighthouse", "nonsense"], "nonsense"),
    (["check", "--policy", "random:x"], "random:x"),
    (["check", "--laws", "map,nonsense"], "nonsense"),
    (["check", "--engine", "nonsense"], "nonsense"),
    (["check", "--schedules", "some"], "some"),
    (["check", "--schedules", "all", f"{WRONG}:right"], "all"),
    (["check", "--bound", "n +"], "n +"),
    (["check", "--bound", "__import__('os')"], "__import__"),
    (["check", "--shard", "2/2"], "2/2"),
    (["check", "--shard", "1"], "1"),
    (["check", "--shard", "9" * 5000 + "/1"], "999"),
    (["check", "--workers", "0"], "0"),
    (["check", "--workers", "many"], "many"),
    (["check", "--workers", "9" * 5000], "999"),
    (["check", "--answer-timeout", "-1"], "-1"),
    (["check", "--answer-timeout", "nan"], "nan"),
    (["check", "--answer-timeout", "inf"], "inf"),
    (["check", "--time-limit", "0"], "0"),
    (["check", "--time-limit", "inf"], "inf"),
    (["check", "--memory", "-5"], "-5"),
    (["check", "--max-findings", "0"], "0"),
    (["check", "--step-budget", "0"], "0"),
    (["check", "--nonsense"], "--nonsense"),
    (["nonsense"], "nonsense"),
    (["count"], "edges"),
    (["count", "--edges", "0"], "0"),
    (["count", "--edges", "2", "--class", "nonsense"], "nonsense"),
    (["run"], "nothing"),
    (["run", "a", "b", "c"], "a b c"),
    (["run", "nonsense"], "nonsense"),
    (["run", "algorithm1", "{"], "JSON"),
    (["run", "algorithm1", '{"sigma": [0, 0], "alpha": [1, 0]}'], "sigma"),
    (["run", "algorithm1", '{"sigma": [true, 0], "alpha": [1, 0]}'], "True"),
    (["run", "algorithm1", "@no-such-file"], "no-such-file"),
    (["run", "algorithm1", "theta", "--choices", "1,x"], "1,x"),
    (["run", "algorithm1", "theta", "--answer-timeout", "nan"], "nan"),
    (["run", "--family", "nonsense:3"], "nonsense:3"),
    (["run", "--family", "cycle:0"], "cycle:0"),
    (["run", "--family", "cycle:5", "--holes", "10%"], "cycle:5"),
    (["run", "--family", "lattice:3x3", "--holes", "100%"], "100%"),
    (["replay", "no-such-file.json"], "no-such-file.json"),
    (["replay", "/"], "/"),
]


@pytest.mark.parametrize(("arguments", "named"), BAD, ids=lambda value: str(value)[:60])
def test_bad_input_is_one_line_that_names_it(refused, arguments, named):
    if arguments[0] == "check" and "--edges" not in arguments and "--vertices" not in arguments:
        arguments = [*arguments, "--edges", "1"]
    assert named in refused(*arguments)


@pytest.mark.parametrize(
    ("text", "named"),
    [
        ("", "JSON"),
        ('{"version": 2, "explorer"', "JSON"),
        ("[" * 100_000, "JSON"),
        ("[1, 2]", "[1, 2]"),
        ('{"version": 99}', "99"),
        ('{"version": 2, "law": "map"}', "explorer"),
        ('{"version": 2, "explorer": "algorithm1", "law": "nonsense"}', "nonsense"),
        ('{"version": 2, "explorer": "algorithm1", "law": []}', "law"),
        ('{"version": 2, "explorer": "algorithm1", "law": "map", "world": 3}', "transcript"),
        (
            '{"version": 2, "explorer": "algorithm1", "law": "map", "world": %s}' % EDGE,
            "transcript",
        ),
        ('{"schema": 2, "verdict": "holds", "findings": []}', "holds"),
    ],
)
def test_a_file_that_is_no_finding_is_bad_input(refused, tmp_path, text, named):
    file = tmp_path / "finding.json"
    file.write_text(text)
    assert named in refused("replay", file)


def test_a_binary_file_is_bad_input(refused, tmp_path):
    file = tmp_path / "finding.json"
    file.write_bytes(bytes(range(256)))
    assert file.name in refused("replay", file)


def test_a_module_that_does_not_import_is_bad_input(refused, tmp_path):
    for i, source in enumerate(["1/0", "import sys; sys.exit(0)", "def", "raise BaseException"]):
        file = tmp_path / f"broken{i}.py"
        file.write_text(source)
        assert file.name in refused("check", f"{file}:explore", "--edges", "1")


@pytest.mark.parametrize(
    "signature", ["first, more", "", "first, *, chosen", "first, choices, /", "*, first"]
)
def test_an_explorer_with_another_signature_is_bad_input(refused, tmp_path, signature):
    file = tmp_path / "explorer.py"
    file.write_text(f"def explore({signature}):\n    yield\n")
    assert "explorer.py" in refused("check", f"{file}:explore", "--edges", "1")


def test_what_an_explorer_prints_is_in_the_document_of_its_run_alone(tmp_path, capfd):
    file = tmp_path / "random.py"  # and it does not take the place of a module of that name
    file.write_text(
        "print('imported')\nfrom allworlds.explorers.builtin.algorithm1 import algorithm1\n"
        "def explore(first):\n    print('explored')\n    return (yield from algorithm1(first))\n"
    )
    for verb in (["check", f"{file}:explore", "--edges", "2"], ["run", f"{file}:explore", "theta"]):
        code = call([*verb, "--json"])
        out, err = capfd.readouterr()
        document = json.loads(out)
        assert (code, document["verdict"]) == (0, "holds"), err
        assert "imported" in err
        # What is printed in a run is told of the one that is shown, and of no other.
        assert document.get("output") == ("explored\n" if verb[0] == "run" else None)
        assert "explored" not in err


@pytest.mark.usefixtures("without_workers")
def test_the_command_of_a_program_shows_the_same_law(cli):
    command = f"{sys.executable} {EXPLORERS / 'program.py'} no-json"
    code, out, _ = cli("check", "--exec", command, "--edges", "1", "--json")
    (finding,) = json.loads(out)["findings"]
    code, out, _ = cli(*shlex.split(finding["reproduce"])[1:], "--json")
    assert (code, json.loads(out)["finding"]["law"]) == (1, "illegal-action")


def test_the_exit_code_is_in_the_document(cli):
    code, out, err = cli("check", "--edges", "1", "--json", "--engine", "python")
    document = json.loads(out)
    assert (code, document["exit_code"], document["schema"], err) == (0, 0, 2, "")
    assert document["scope"]["complete"] is True


def test_counts(cli):
    code, out, _ = cli("count", "--edges", "4", "--json")
    rows = json.loads(out)["rows"]
    # A000698 and the unrooted counts 2, 5, 20, 107.
    assert code == 0
    assert [row["rooted"] for row in rows] == [2, 10, 74, 706]
    assert [row["unrooted"] for row in rows] == [2, 5, 20, 107]


@pytest.mark.parametrize(("number", "explorer", "edges"), [(signal.SIGINT, "hang", "3")])
def test_an_interrupt_leaves_a_report_and_no_worker(start, tmp_path, number, explorer, edges):
    hung = tmp_path / "hung"
    process = start(
        *["check", f"{WRONG}:{explorer}", "--edges", edges, "--json", "--workers", "2"],
        *["--answer-timeout", PATIENCE, "--engine", "python"],
        HUNG=str(hung),
    )
    # Two lanes, each with the players of both plays; where the first hangs, that one.
    workers = 2 * 3 if explorer == "right" else 1
    assert processes.wait(lambda: len(processes.workers_of(process.pid)) >= workers)
    assert explorer == "right" or processes.wait(hung.exists)
    workers = processes.workers_of(process.pid)
    os.killpg(process.pid, number)
    out, err = process.communicate(timeout=PATIENCE)
    document = json.loads(out)
    assert (process.returncode, document["exit_code"]) == (130, 130)
    assert document["scope"]["complete"] is False
    assert document["scope"]["stopped"] == "interrupted"
    assert "Traceback" not in err
    assert processes.end(lambda: set(workers) & {pid for pid, _ in processes.running()})


@pytest.mark.usefixtures("without_workers")
def test_recorded_choices_that_no_longer_fit_are_told_on_stderr(cli, tmp_path):
    _, out, _ = cli(
        "check", f"{WRONG}:one_schedule", "--edges", "1", "--schedules", "all", "--json"
    )
    finding = json.loads(out)["findings"][0]
    file = tmp_path / "finding.json"
    file.write_text(json.dumps({**finding, "choices": [1, 0, 0]}))
    code, out, err = cli("replay", str(file), "--json")
    assert (code, json.loads(out)["outcome"]) == (0, "reproduced")
    assert "recorded choice 2 is 0, but only 2 were asked for" in err
    file.write_text(json.dumps({**finding, "explorer": f"{WRONG}:everywhere"}))
    code, out, err = cli("replay", str(file))
    assert (code, out) == (2, "")
    assert "takes no choices" in err


def test_a_terminal_without_the_characters_is_no_error(start):
    process = start(
        "ambiguity", "twins", "two-loops-plane", "two-loops-torus", PYTHONIOENCODING="ascii"
    )
    out, err = process.communicate(timeout=PATIENCE)
    assert (process.returncode, err) == (0, "")
    assert out.isascii()
    assert r"\u256d" in out  # the corner of an edge


def test_an_internal_error_has_its_own_exit_code(cli, monkeypatch):
    monkeypatch.setattr("allworlds.engines.units.rooted_maps", lambda *_: 1 // 0)
    code, out, err = cli("count", "--edges", "1")
    assert (code, out) == (70, "")
    assert "internal error" in err


def test_a_count_that_its_source_contradicts_is_an_internal_error(cli, monkeypatch):
    monkeypatch.setattr("allworlds.engines.units.rooted_maps", lambda *_: iter(()))
    code, out, _ = cli("count", "--edges", "1")
    assert code == 70
    assert "MISMATCH" in out


def test_the_help_has_the_verbs_in_panels(cli):
    _, out, _ = cli("--help")
    everyday, worlds = (out.index(f"─ {name} ─") for name in ("Everyday", "Worlds"))
    assert everyday < out.index("│ check ") < worlds < out.index("│ count ")


@pytest.mark.parametrize("verb", ["check", "count", "run", "replay"])
def test_help_begins_with_an_example(cli, verb):
    code, out, _ = cli(verb, "--help")
    assert code == 0
    assert f"Example: allworlds {verb}" in out


@pytest.mark.parametrize(
    ("shell", "words", "shown"),
    [
        ("bash", "allworlds check --ed", "plain,--edges"),
        ("bash", "allworlds ambiguity tw", "plain,twins"),
        ("bash", "allworlds check --edges 4 -o fin", "file,fin"),
        ("bash", "allworlds check min", "file,min"),
        ("zsh", "allworlds check --ed", "--edges"),
        ("fish", "allworlds check --ed", "plain,--edges"),
    ],
)
def test_a_shell_is_told_how_a_line_goes_on(shell, words, shown):
    *before, begun = words.split()
    number = begun if shell == "fish" else str(len(before))
    said = told_by_shell(
        _ALLWORLDS_COMPLETE=f"{shell}_complete", COMP_WORDS=words, COMP_CWORD=number
    )
    assert shown in said.split()


def told_by_shell(*words, **env):
    done = subprocess.run(
        [sys.executable, "-m", "allworlds", *words],
        env={**os.environ, **env},
        capture_output=True,
        text=True,
        check=True,
    )
    return done.stdout


@pytest.mark.parametrize(
    ("shell", "begins"),
    [("bash", "_allworlds_completion()"), ("zsh", "#compdef allworlds"), ("fish", "function")],
)
def test_a_shell_gets_what_it_completes_by(shell, begins):
    script = told_by_shell(_ALLWORLDS_COMPLETE=f"{shell}_source")
    assert script.lstrip().startswith(begins)
    assert f"_ALLWORLDS_COMPLETE={shell}_complete" in script


def test_only_the_verb_that_is_meant_gets_its_options():
    commands = command_line("count").commands
    assert len(commands["count"].params) > 3
    assert [param.name for param in commands["check"].params] == ["help"]
    ambiguity = command_line("ambiguity").commands["ambiguity"]
    assert all(len(each.params) > 3 for each in ambiguity.commands.values())


def test_without_a_verb_the_help_is_shown(cli):
    code, out, err = cli()
    assert (code, err) == (0, "")
    assert "Usage: allworlds [OPTIONS] COMMAND" in out


def test_the_debugger_stops_in_the_users_generators_before_a_step(monkeypatch):
    class Debugger:
        def __init__(self, skip):
            stopped.append(skip)

        def reset(self):
            stopped.append("reset")

        def set_next(self, frame):
            stopped.append(frame.f_code.co_name)

        trace_dispatch = "trace"

    def inner():
        yield 1
        yield 2

    def outer():
        yield from inner()
        yield 3

    stopped = []
    monkeypatch.setattr("pdb.Pdb", Debugger)
    monkeypatch.setattr("sys.settrace", stopped.append)
    walk = _Stopping(outer(), 1)
    assert walk.send(None) == 1
    assert stopped == []
    assert [walk.send("percept") for _ in range(2)] == [2, 3]
    assert stopped == [["allworlds", "allworlds.*"], "reset", "outer", "inner", "trace"]


def test_the_debugger_stops_before_a_step_of_the_run():
    transcript = SimpleNamespace(steps=[0, 0, 0])
    run = SimpleNamespace(outcome=SimpleNamespace(episode=SimpleNamespace(transcript=transcript)))
    for step in (1, 3, 4):  # the last one is its answer
        ensure_step(run, step)
    for step in (0, 5, -1):
        with pytest.raises(InputError, match=f"--step {step} is not from 1 to 4, where this run"):
            ensure_step(run, step)
