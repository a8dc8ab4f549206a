"""System calls about processes and memory, most of which only Linux has."""

import os
import resource
import signal
import subprocess
import sys

import pytest

from allworlds.engines import linux
from allworlds.inputs.checks import InputError


class Ended(BaseException):
    """In place of the end of this process."""


@pytest.fixture
def controlled(monkeypatch):
    """What the system was asked for; and an end of this process is an exception."""
    asked = []

    def end(code):
        raise Ended(code)

    monkeypatch.setattr(linux, "_control", lambda *what: asked.append(what))
    monkeypatch.setattr(linux.os, "_exit", end)
    return asked


def test_a_process_whose_parent_has_ended_exits_at_once(controlled):
    linux.end_with_parent(os.getppid())
    linux.end_with_parent(os.getppid(), signal.SIGTERM)
    assert controlled == [(1, signal.SIGKILL), (1, signal.SIGTERM)]
    with pytest.raises(Ended, match=r"^1$"):
        linux.end_with_parent(os.getppid() + 1)


@pytest.mark.processes
def test_a_child_with_the_token_is_ended_and_others_are_not():
    def sleeping(token):
        return subprocess.Popen(
            [sys.executable, "-S", "-c", "print(flush=True); input()"],
            env={"TOKEN": token},
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
        )

    ours, other = sleeping("mine-1234"), sleeping("mine-5678")
    for each in (ours, other):
        assert each.stdout.readline()
    linux.end_adopted("mine-1234")
    with pytest.raises(ChildProcessError):
        os.waitpid(ours.pid, 0)
    assert other.poll() is None
    other.communicate(b"\n")
    ours.communicate()


def test_the_address_space_is_0_where_it_is_unknown(monkeypatch, tmp_path):
    assert linux.address_space() > 1
    monkeypatch.setattr(linux, "open", lambda _: (tmp_path / "nowhere").open(), raising=False)
    assert linux.address_space() == 0
    (tmp_path / "nowhere").write_text("what?")
    assert linux.address_space() == 0


def test_a_limit_that_leaves_no_page_is_too_small(monkeypatch):
    set_to = []
    monkeypatch.setattr(resource, "setrlimit", lambda *what: set_to.append(what))
    monkeypatch.setattr(resource, "getrlimit", lambda _: (0, resource.RLIM_INFINITY))
    monkeypatch.setattr(linux, "address_space", lambda: 100)
    linux.limit_memory(100)
    assert set_to == [(resource.RLIMIT_AS, (100 << 20, 100 << 20))]
    said = "MB is probably too small: a process is larger before it begins"
    with pytest.raises(InputError, match=f"^memory 99 {said}$"):
        linux.limit_memory(99)
    assert len(set_to) == 1

    def none_left(*_):
        raise OSError("no memory")

    monkeypatch.setattr(linux.mmap, "mmap", none_left)
    with pytest.raises(InputError, match=f"^memory 100 {said}$"):
        linux.limit_memory(100)


@pytest.mark.processes
def test_the_end_of_a_child_within_some_seconds():
    child = os.posix_spawnp("sleep", ["sleep", "60"], os.environ)
    assert linux.ended_within(0.0, child) is None
    assert linux.ended_within(0.02, child) is None
    os.kill(child, signal.SIGKILL)
    assert linux.ended_within(60.0, child) == -signal.SIGKILL
    child = os.posix_spawnp("sh", ["sh", "-c", "exit 3"], os.environ)
    assert linux.ended_within(60.0, child) == 3
