"""Every attack through the command line: the verdict that it must get, one document, nothing left.

``reading.py`` tells how an attack states its verdict.
"""

import json
import os
import re
import shlex
import shutil
import signal
import subprocess
import sys
import sysconfig
from pathlib import Path

import pytest

import processes
from allworlds.explorers import shared_library
from attacks.reading import ATTACKS, KINDS, attack_of, attacks
from small import LONG

EXAMPLES = ATTACKS.parents[1] / "examples" / "c"
CODES = {"holds": 0, "refuted": 1, "refused": 2, "inconclusive": 3, "internal": 70}
PROGRAM = Path(sysconfig.get_path("scripts"), "allworlds")
HIDING = "print('I am not the module you want')\nimport os\nos._exit(0)\n"
MARK = "ATTACKED"


class Scene:
    """A directory in which one check is made, and what is left of it."""

    def __init__(self, directory):
        self.place = directory / "place"
        self.place.mkdir()
        self.temporary = directory / "temporary"
        self.temporary.mkdir()
        self.err = directory / "stderr"

    def start(self, *words):
        environment = {**os.environ, MARK: str(self.place), "TMPDIR": str(self.temporary)}
        with self.err.open("w") as err:
            return subprocess.Popen(
                [PROGRAM, *map(str, words)],
                cwd=self.place,
                env=environment,
                stdin=subprocess.DEVNULL,
                stdout=subprocess.PIPE,
                stderr=err,
            )

    def ended(self, process):
        """The exit code and stdout, after nothing is left of the check."""
        out, _ = process.communicate(timeout=3 * processes.PATIENCE)
        assert processes.end(self.left), self.left()
        assert [*self.temporary.iterdir()] == []
        # A CI service would take such a line for a command of ours.
        assert not re.search(r"^\s*::|##\[", out.decode() + "\n" + self.said(), re.MULTILINE)
        return process.returncode, out.decode()

    def left(self):
        """The processes that still run here, or come from here."""
        mark = f"{MARK}={self.place}".encode()
        return [pid for pid, _ in processes.running() if self._is_ours(pid, mark)]

    def _is_ours(self, pid, mark):
        process = Path("/proc", str(pid))
        try:
            return (process / "cwd").readlink() == self.place or mark in (
                process / "environ"
            ).read_bytes().split(b"\0")
        except OSError:
            return False

    def said(self):
        return self.err.read_text(errors="replace")


@pytest.fixture
def scene(tmp_path):
    return Scene(tmp_path)


def placed(attack, function, scene):
    """The words of the command line for an attack that lies in the scene."""
    if attack.file.suffix == ".c":
        include = [f"-I{EXAMPLES}", f"-I{Path(shared_library.__file__).parent}"]
        made = ["-O1", "-shared", "-fPIC", "-pthread", *include, f"-DATTACK={function}"]
        library = scene.place / f"{function}.so"
        subprocess.run(["cc", "-w", *made, "-o", library, attack.file], check=True)
        return ["--native", f"./{library.name}", *attack.options]
    shutil.copy(attack.file, scene.place)
    for name in attack.beside:
        scene.place.joinpath(f"{name}.py").write_text(HIDING)
    if not function:
        return ["--exec", shlex.join([sys.executable, "-P", attack.file.name]), *attack.options]
    return [f"{attack.file.name}:{function}", *attack.options]


def judged(verdict, code, out, said):
    """Exit code, stdout and stderr are those of the verdict; the report, if there is one."""
    kind, _, laws = verdict.partition(" ")
    assert code == CODES[kind], said
    if kind in ("refused", "internal"):
        assert out == ""
        assert "allworlds: " in said.splitlines()[-1]
        assert kind == "internal" or "Traceback" not in said
        return None
    report = json.loads(out)
    assert (report["verdict"], report["exit_code"]) == (kind, code)
    found = {finding["law"] for finding in report["findings"]}
    assert found <= set(laws.split(" or ")), report["findings"]
    assert bool(found) == (kind == "refuted")
    assert "Traceback" not in said
    return report


def weight(later, workers):
    """The marks of an attack outside the quick run: whether it is a later one, and the workers."""
    return LONG if later or workers == 2 else pytest.mark.slow


def is_for_compiled_code(attack):
    """Whether it is on who plays, or on what is played twice, and the kernel can judge it."""
    kinds = ("state", "reaching", "dying", "libraries")
    # What is left to the Python engine, what names its engine, and what looks for worlds alone.
    others = {"--memory", "--engine", "--where", "--schedules"}
    return attack.file.parent.name in kinds and not attack.signal and not others & {*attack.options}


def tried():
    """Each attack with 1 and with 2 workers; some in the quick run.

    Where both engines can judge, every other file is left to the long run here, and the others in
    :func:`tried_in_compiled_code`.
    """
    for place, attack in enumerate(attacks()):
        elsewhere = is_for_compiled_code(attack) and place % 2 == 0
        for number, function in enumerate(attack.verdicts):
            for workers in (1, 2):
                marks = () if attack.quick == workers else weight(number or elsewhere, workers)
                name = f"{attack.name}-{function or 'exec'}-{workers}"
                yield pytest.param(attack, function, workers, marks=marks, id=name)


@pytest.mark.early
@pytest.mark.parametrize(("attack", "function", "workers"), [*tried()])
def test_an_attack_gets_its_verdict_and_leaves_nothing_behind(attack, function, workers, scene):
    words = placed(attack, function, scene)
    process = scene.start("check", *words, "--workers", workers, "--json")
    verdict = attack.verdicts[function]
    if attack.signal:
        assert processes.wait((scene.place / "ready").exists)
        process.send_signal(signal.Signals[attack.signal])
        code, out = scene.ended(process)
        assert code == int(verdict), scene.said()
        assert not out or json.loads(out)["verdict"] == "inconclusive"
    else:
        code, out = scene.ended(process)
        judged(verdict, code, out, scene.said())
    assert attack.says in scene.said()


def tried_in_compiled_code():
    """Each attack wherever the kernel can judge.

    Libraries alone are tried with two workers, too: only with them does compiled code also play.
    """
    for place, attack in enumerate(attacks()):
        if is_for_compiled_code(attack):
            for number, function in enumerate(attack.verdicts):
                for workers in (1, 2) if attack.file.parent.name == "libraries" else (1,):
                    name = f"{attack.name}-{function or 'exec'}-{workers}"
                    marks = weight(number or place % 2, workers)
                    yield pytest.param(attack, function, workers, marks=marks, id=name)


@pytest.mark.usefixtures("compiled")
@pytest.mark.parametrize(("attack", "function", "workers"), [*tried_in_compiled_code()])
def test_an_attack_gets_the_same_verdict_where_compiled_code_judges(
    attack, function, workers, scene
):
    words = placed(attack, function, scene)
    process = scene.start("check", *words, "--workers", workers, "--json", "--engine", "kernel")
    code, out = scene.ended(process)
    judged(attack.verdicts[function], code, out, scene.said())


def test_every_kind_of_attack_is_told_of():
    told = ATTACKS.parents[1].joinpath("docs", "trust.md").read_text(encoding="utf-8")
    assert [kind.name for kind in KINDS if f"attacks/{kind.name}" not in told] == []


@pytest.mark.parametrize(
    "told", ["verdict: refuted crash\ncolour: red", "verdict: refuted crash\n\nno key", "quick: x"]
)
def test_an_attack_that_is_told_wrongly_is_noticed(told, tmp_path):
    file = tmp_path / "attack.py"
    file.write_text(f'"""An attack.\n\n{told}\n"""\n')
    with pytest.raises((TypeError, AttributeError, ValueError)):
        attack_of(file)


WAITS = """
import os, time
from pathlib import Path
from allworlds.explorers.builtin.algorithm1 import algorithm1

def explore(first):
    if not Path("go").exists():
        Path("waiting").write_text(str(os.getpid()))
        os.rename("waiting", "ready")
        while not Path("go").exists():
            time.sleep(0.01)
    return (yield from algorithm1(first))
"""


@pytest.mark.slow
def test_a_right_explorer_is_not_refuted_by_who_kills_its_player(scene):
    scene.place.joinpath("waits.py").write_text(WAITS)
    words = ["waits.py:explore", "--edges", 2, "--workers", 1, "--answer-timeout", 600, "--json"]
    process = scene.start("check", *words)
    assert processes.wait((scene.place / "ready").exists)
    os.kill(int((scene.place / "ready").read_text()), signal.SIGKILL)
    (scene.place / "go").touch()
    code, out = scene.ended(process)
    report = judged("holds", code, out, scene.said())
    assert (len(report["remarks"]), report["runs"]) == (1, 30)


RIGHT = """
from allworlds.explorers.builtin.algorithm1 import algorithm1

def explore(first):
    return (yield from algorithm1(first))
"""


@pytest.mark.slow
def test_what_was_found_in_another_scope_refutes_nothing_in_this_one(scene):
    scene.place.joinpath("right.py").write_text(RIGHT)

    def check(*options):
        words = ["right.py:explore", *options, "--corpus", "corpus", "--workers", 1, "--json"]
        code, out = scene.ended(scene.start("check", *words))
        return code, json.loads(out)

    code, report = check("--edges", 2, "--bound", 1)
    assert (code, [found["law"] for found in report["findings"]]) == (1, ["bound"])
    code, report = check("--edges", 2)
    assert (code, report["verdict"], report["runs"]) == (0, "holds", 30)
    assert len(report["corpus"]["beyond_scope"]) == 1
