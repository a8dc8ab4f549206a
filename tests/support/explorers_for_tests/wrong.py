"""Explorers that do everything an explorer can do wrong; most of them at a vertex of degree 1.

With one edge there is one world that begins there, so each of them is wrong in it first.
"""

# ruff: noqa: PLC3002, T201
import ctypes
import hashlib
import os
import random
import re
import subprocess
import sys
import threading
import time
from contextlib import suppress
from itertools import count
from pathlib import Path

from allworlds import Choices, CombinatorialMap, Estimate, Move
from allworlds.explorers.builtin.algorithm1 import algorithm1

EDGE = CombinatorialMap((0, 1), (1, 0))
KEPT = []
TURN = count()
MANY = 5000  # choices: more than are kept, with all that the pipe of a worker holds


def right(first):
    return (yield from algorithm1(first))


def everywhere(first):
    return Estimate(EDGE, 0)
    yield


def here_of_another(first):
    """Right but for the pose, where the walk was long."""
    steps = 0
    walk = algorithm1(first)
    percept = None
    try:
        while True:
            action = walk.send(percept)
            steps += type(action) is Move
            percept = yield action
    except StopIteration as stop:
        answer = stop.value
        return Estimate(answer.map, answer.map.sigma[answer.here]) if steps > 6 else answer


def signature(log):
    return hashlib.sha256(repr(log).encode()).hexdigest()


def planted(first):
    """Wrong in the one run whose log has the hash PLANTED."""
    log, reply = [(None, first)], None
    walk = algorithm1(first)
    try:
        while True:
            action = walk.send(reply)
            reply = yield action
            if type(action) is Move:
                log.append((action.k % log[-1][1].degree, reply))
    except StopIteration as stop:
        wrong = signature(log) == os.environ.get("PLANTED")
        return Estimate(EDGE, 0) if wrong else stop.value


def one_schedule(first, *, choices: Choices):
    """Wrong in one of the four schedules of each world."""
    taken = [choices.pick("ab", of="edge"), choices.pick("ab", of="path")]
    answer = yield from algorithm1(first)
    return Estimate(EDGE, 0) if taken == ["b", "a"] and first.degree == 2 else answer


def at_degree_1(misbehave):
    def explore(first):
        if first.degree == 1:
            misbehave()
        return (yield from algorithm1(first))

    return explore


def _module_level(name, misbehave):
    explore = at_degree_1(misbehave)
    explore.__qualname__ = explore.__name__ = name
    globals()[name] = explore


def _hung():
    """Tell the test, where it asks, that this process has nothing more to say."""
    if file := os.environ.get("HUNG"):
        with Path(file).open("a") as pids:
            pids.write(f"{os.getpid()}\n")


def _sleep():
    time.sleep(1000)


def _hang():
    _hung()
    _sleep()


def _segfault():
    ctypes.string_at(0)


def _memory():
    KEPT.append(bytearray(4 << 30))


def _child():
    subprocess.Popen(["sleep", "1000"])


def _orphan_with_our_pipe():
    # It keeps every file of this process open when this process is gone.
    if os.fork() == 0:
        time.sleep(1000)
    os._exit(3)


def _interrupt():
    raise KeyboardInterrupt


def _raise():
    raise ZeroDivisionError("on purpose\nin two lines")


_module_level("hang", _hang)
_module_level("hang_gil", lambda: (_hung(), 10**10**8))
_module_level("hang_regex", lambda: (_hung(), re.match(r"(a+)+$", "a" * 64 + "b")))
_module_level("os_exit", lambda: os._exit(0))
_module_level("segfault", _segfault)
_module_level("memory", _memory)
_module_level("prints", lambda: (print("{}"), os.write(1, b"{}\n")))
_module_level("reads", input)
_module_level("reads_quietly", sys.stdin.read)
_module_level("closes", lambda: os.closerange(3, 256))
_module_level("closes_and_hangs", lambda: (os.closerange(3, 256), time.sleep(1000)))
_module_level("sys_exit", sys.exit)
_module_level("interrupt", _interrupt)
_module_level("raises", _raise)
_module_level("deep", lambda: (lambda f: f(f))(lambda f: f(f)))
_module_level("forks", os.fork)
_module_level("orphan", _orphan_with_our_pipe)
_module_level("child", _child)
_module_level("thread", lambda: threading.Thread(target=_sleep, daemon=True).start())


def hang_in_the_middle(first):
    if first.degree == 1:
        yield Move(0)
        _hung()
        while True:
            pass
    return (yield from algorithm1(first))


def hang_after_choices(first, *, choices):
    if first.degree == 1:
        choices.pick("abc", of="edge")
        yield Move(0)
        choices.pick("abc", of="path")
        _hang()
    return (yield from algorithm1(first))


def chooses_for_ever(first, *, choices):
    if first.degree == 1:
        choices.pick("ab", of="edge")
        yield Move(0)
        for turn in count():
            if turn == MANY:
                _hung()
            choices.pick("ab", of="edge")
    return (yield from algorithm1(first))


def chooses_for_ever_whatever_is_raised(first, *, choices):
    if first.degree == 1:
        choices.pick("ab", of="edge")
        yield Move(0)
        for turn in count():
            if turn == MANY:
                _hung()
            with suppress(BaseException):
                choices.pick("ab", of="edge")
    return (yield from algorithm1(first))


def ends_at_its_close(first):
    """Kills the interpreter when it is closed, after a wrong action."""
    try:
        yield None
    finally:
        os._exit(5)


def _wandering(bits):
    def explore(first):
        if first.degree == 2:
            value = bits()
            for i in range(60):
                yield Move(value >> i & 1)
            return Estimate(EDGE, 0)
        return (yield from algorithm1(first))

    return explore


def by_random(first):
    return (yield from _wandering(lambda: random.getrandbits(60))(first))


def by_time(first):
    return (yield from _wandering(time.perf_counter_ns)(first))


def _object():
    KEPT.append(object())
    return KEPT[-1]


def by_id(first):
    return (yield from _wandering(lambda: id(_object()))(first))


def by_hash(first):
    return (yield from _wandering(lambda: hash(_object()) & (1 << 60) - 1)(first))


def by_state(first):
    return (yield from _wandering(lambda: next(TURN))(first))


def by_answer(first):
    answer = yield from algorithm1(first)
    return Estimate(answer.map, (answer.here + next(TURN)) % len(answer.map.sigma))


def crashes_the_second_time(first):
    if next(TURN) % 2:
        raise ZeroDivisionError
    return (yield from algorithm1(first))
