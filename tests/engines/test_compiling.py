"""Compiled code is kept, and used again as long as the sources are the same."""

import pickle
import signal
import subprocess
import sys

import numba
import pytest

from allworlds import check
from allworlds.engines import compiled_engine, linux
from allworlds.engines.kernel import compiling
from allworlds.engines.kernel.compiling import is_compiled
from allworlds.engines.kernel.engine import in_another_process
from allworlds.engines.kernel.runs import examine
from processes import PATIENCE

pytestmark = pytest.mark.usefixtures("compiled")


def test_what_other_sources_kept_is_not_read(monkeypatch, tmp_path):
    index = tmp_path / "index"
    index.write_bytes(pickle.dumps(numba.__version__) + b"callworlds.engines.kernel.runs\nGone\n.")
    monkeypatch.setattr(compiling._file_of(examine), "_index_path", str(index))
    assert not is_compiled(examine)


def test_what_cannot_be_kept_is_not_there():
    assert not is_compiled(lambda: None)


@pytest.mark.processes
def test_a_compiler_ends_when_the_user_interrupts_and_another_process_does_not():
    other = subprocess.Popen([sys.executable, "-c", "input()"], stdin=subprocess.PIPE)
    compiler = in_another_process("import time; time.sleep(3600)")
    with pytest.raises(KeyboardInterrupt), linux.compilers_ended():
        raise KeyboardInterrupt
    assert compiler.wait(PATIENCE) == -signal.SIGKILL
    assert other.poll() is None
    other.communicate(b"\n")
    with linux.compilers_ended():
        compiler = in_another_process("input()")
    assert compiler.wait(PATIENCE) == 1  # by itself


@pytest.mark.processes
def test_a_check_that_is_interrupted_ends_its_compiler(monkeypatch):
    begun = []

    def begin(*_):
        begun.append(in_another_process("import time; time.sleep(3600)"))
        raise KeyboardInterrupt

    monkeypatch.setattr("allworlds.engines.sweep.gather", begin)
    assert check(edges=1).interrupted
    assert begun[0].wait(PATIENCE) == -signal.SIGKILL


def test_a_compiler_that_is_not_waited_for_makes_way(monkeypatch):
    asked = []
    monkeypatch.setattr(compiled_engine.kernel, "in_another_process", asked.append)
    compiled_engine.compile_apart()
    assert "os.nice(19);" in asked[0]
