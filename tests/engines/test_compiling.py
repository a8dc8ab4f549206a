"""Compiled code is kept, and used again as long as the sources are the same."""

import gc
import pickle
import signal
import subprocess
import sys
import time

import numba
import pytest

from allworlds import check
from allworlds.engines import compiled_engine, linux
from allworlds.engines.kernel import compiling, library_player
from allworlds.engines.kernel.compiling import is_compiled
from allworlds.engines.kernel.engine import LaidOutRuns, UnitJudge, in_another_process
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


def test_without_a_folder_to_write_to_a_function_is_compiled_all_the_same(monkeypatch):
    def compiler(*, cache=False):
        if cache:
            raise RuntimeError("no locator available")
        return lambda function: ("compiled", function)

    monkeypatch.setattr(compiling, "_njit", compiler)
    assert compiling.entry(len) == ("compiled", len)


def begun(code):
    """Another process that compiles; Linux shows its environment a moment after it has started."""
    compiler = in_another_process(code)
    while not linux._has(compiler.pid, linux.COMPILER):
        time.sleep(0.001)
    return compiler


@pytest.mark.processes
def test_a_compiler_ends_when_the_user_interrupts_and_another_process_does_not():
    other = subprocess.Popen([sys.executable, "-c", "input()"], stdin=subprocess.PIPE)
    compiler = begun("import time; time.sleep(3600)")
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
    compilers = []

    def begin(*_):
        compilers.append(begun("import time; time.sleep(3600)"))
        raise KeyboardInterrupt

    monkeypatch.setattr("allworlds.engines.sweep.gather", begin)
    assert check(edges=1).interrupted
    assert compilers[0].wait(PATIENCE) == -signal.SIGKILL


def test_a_compiler_that_is_not_waited_for_makes_way(monkeypatch):
    asked = []
    monkeypatch.setattr(compiled_engine.kernel, "in_another_process", asked.append)
    compiled_engine.compile_apart()
    assert "os.nice(19);" in asked[0]


@pytest.mark.parametrize("missing", [None, examine, library_player.play])
def test_all_code_that_reads_or_writes_logs_is_kept_or_none_counts_as_kept(missing, monkeypatch):
    monkeypatch.setattr(compiled_engine, "is_compiled", lambda function: function is not missing)
    assert compiled_engine.is_kept() is (missing is None)


def test_code_is_loaded_without_a_run(monkeypatch):
    asked = []

    class Noted(UnitJudge):
        def lay_out(self, most):
            asked.append(super().lay_out(most))
            return asked[-1]

        def judge(self, batch, size):
            asked.append((batch, size))
            return super().judge(batch, size)

    monkeypatch.setattr(compiled_engine.kernel, "UnitJudge", Noted)
    monkeypatch.setattr(library_player, "load_player", lambda: asked.append(gc.isenabled()))
    compiled_engine.load_native()
    nothing = LaidOutRuns(runs=0, first=0, until=0, last=True)
    assert asked == [nothing, (nothing, 0), False]
    assert gc.isenabled()
