"""The guardian's parts, seen from inside; as a whole it is a process of its own."""

import os
import signal
import socket
import subprocess
import sys
import threading
from contextlib import suppress

import pytest

import processes
from allworlds.engines.isolation.guardian_requests import (
    AskExitCode,
    EndProcesses,
    Spawn,
    receive,
    send,
)
from allworlds.engines.isolation.process_tree import kill_tree

# Two children in sessions of their own, one of them a grandchild; each tells its number.
FAMILY = """
import os, sys, time
def tell(): open(os.path.join(sys.argv[1], str(os.getpid())), "w").close()
for _ in range(2):
    if os.fork():
        break
    os.setsid()
tell()
time.sleep(1000)
"""


@pytest.fixture
def pair():
    ours, theirs = socket.socketpair()
    with ours, theirs:
        yield ours, theirs


@pytest.mark.parametrize(
    "message",
    [
        AskExitCode(5),
        EndProcesses((1, 2)),
        Spawn("player", "/", ["a"] * 30_000, {"A": "b"}),
        None,
        7,
    ],
)
def test_messages_arrive_whole(pair, message):
    ours, theirs = pair
    sender = threading.Thread(target=send, args=(ours, message, []))
    sender.start()
    assert receive(theirs) == (message, [])
    sender.join()


def test_descriptors_arrive_as_ones_of_the_receiver(pair, tmp_path):
    ours, theirs = pair
    with (tmp_path / "file").open("w+") as file:
        send(ours, AskExitCode(1), [file.fileno(), file.fileno()])
        message, descriptors = receive(theirs)
    assert message == AskExitCode(1)
    for descriptor in descriptors:
        os.write(descriptor, b"x")
        os.close(descriptor)
    assert (tmp_path / "file").read_text() == "xx"


@pytest.mark.parametrize("said", [b"", b"\x01", b"\xff\x00\x00\x00abc"])
def test_who_breaks_off_has_gone(pair, said):
    ours, theirs = pair
    ours.sendall(said)
    ours.close()
    with pytest.raises(EOFError):
        receive(theirs)


@pytest.mark.skipif(sys.platform != "linux", reason="there is no /proc to look for descendants in")
@pytest.mark.parametrize("itself", [True, False])
def test_a_tree_is_killed_whatever_sessions_it_is_in(tmp_path, itself):
    process = subprocess.Popen(
        [sys.executable, "-c", FAMILY, str(tmp_path)], start_new_session=True
    )
    assert processes.wait(lambda: len([*tmp_path.iterdir()]) == 3)
    members = {int(path.name) for path in tmp_path.iterdir()}
    assert process.pid in members
    kill_tree(process.pid, itself=itself)
    left = set() if itself else {process.pid}
    assert processes.wait(lambda: members & {pid for pid, _ in processes.running()} == left)
    with suppress(ProcessLookupError):
        os.kill(process.pid, signal.SIGKILL)
    process.wait()


def test_what_is_no_more_can_be_killed_once_more():
    process = subprocess.Popen([sys.executable, "-c", ""])
    process.wait()
    kill_tree(process.pid)
