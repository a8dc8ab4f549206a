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
from attacks.reading import ATTACKS, attack_of, attacks

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


def tried():
    """Each attack of the quick run."""
    for attack in attacks():
        for function in attack.verdicts if attack.quick else ():
            name = f"{attack.name}-{function or 'exec'}-{attack.quick}"
            yield pytest.param(attack, function, attack.quick, id=name)


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


@pytest.mark.parametrize(
    "told", ["verdict: refuted crash\ncolour: red", "verdict: refuted crash\n\nno key", "quick: x"]
)
def test_an_attack_that_is_told_wrongly_is_noticed(told, tmp_path):
    file = tmp_path / "attack.py"
    file.write_text(f'"""An attack.\n\n{told}\n"""\n')
    with pytest.raises((TypeError, AttributeError, ValueError)):
        attack_of(file)
