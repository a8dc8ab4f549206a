"""Every way in which a run can end without an answer.

verdict of sys_exit: refuted crash
verdict of os_exit: refuted crash
verdict of interrupt: refuted crash
verdict of no_memory: refuted crash
verdict of recursion: refuted crash
verdict of segfault: refuted crash
verdict of stops: refuted crash
verdict of generator_exit: refuted crash
verdict of unprintable: refuted crash
verdict of closes_its_pipe: refuted crash
verdict of aborts: refuted crash
verdict of deep_in_c: refuted crash or timeout
verdict of silent: refuted timeout
verdict of silent_in_a_loop: refuted timeout
verdict of silent_at_its_close: refuted timeout
verdict of walks_for_ever: refuted budget
verdict of publishes_for_ever: refuted budget
verdict of yields_nothing: refuted illegal-action
verdict of answers_nothing: refuted no-estimate
verdict of answers_without_end: refuted no-estimate
verdict of answers_slowly_without_end: refuted timeout
verdict of answers_too_much: refuted no-estimate
verdict of answers_what_cannot_be_written: refuted no-estimate
verdict of leaves_undecided_what_cannot_be_written: refuted no-estimate
verdict of publishes_without_end: refuted illegal-action
verdict of publishes_what_cannot_be_written: refuted invariant-1
options: --edges 1 --answer-timeout 1
"""

import ctypes
import itertools
import os
import sys
import time

from allworlds import Ambiguous, Checkpoint, CombinatorialMap, Estimate, Move
from allworlds.explorers.builtin.algorithm1 import algorithm1

EDGE = CombinatorialMap((0, 1), (1, 0))
HUGE = 10**5000  # more digits than Python turns into text


def ending(end):
    def explore(first):
        yield Move(0)
        return end()

    return explore


def throwing(error):
    def explore(first):
        yield Move(0)
        raise error

    return explore


class Unprintable(Exception):
    def __str__(self):
        raise self

    __repr__ = __str__


def for_ever():
    while True:
        time.sleep(0.01)
        yield 0


class Slow(CombinatorialMap):
    sigma = property(lambda self: for_ever())


class Endless(CombinatorialMap):
    sigma = property(lambda self: itertools.repeat(0))


class Vast(CombinatorialMap):
    sigma = alpha = (0,) * 10_000_000


def deeper():
    return deeper()


def loop():
    while True:
        pass


sys_exit = throwing(SystemExit(0))
interrupt = throwing(KeyboardInterrupt())
no_memory = throwing(MemoryError())
recursion = ending(deeper)
stops = throwing(StopIteration())
generator_exit = throwing(GeneratorExit())
unprintable = throwing(Unprintable())
os_exit = ending(lambda: os._exit(0))
segfault = ending(lambda: ctypes.string_at(0))
aborts = ending(os.abort)
closes_its_pipe = ending(lambda: os.closerange(3, 64))
silent = ending(lambda: time.sleep(3600))
silent_in_a_loop = ending(loop)
answers_nothing = ending(lambda: None)
answers_without_end = ending(lambda: Estimate(Endless.__new__(Endless), 0))
answers_slowly_without_end = ending(lambda: Estimate(Slow.__new__(Slow), 0))
answers_too_much = ending(lambda: Estimate(Vast.__new__(Vast), 0))
answers_what_cannot_be_written = ending(lambda: Estimate(EDGE, HUGE))
leaves_undecided_what_cannot_be_written = ending(lambda: Ambiguous((0,), (0,), (HUGE,), (0,), 0))


def deep_in_c(first):
    yield Move(0)
    sys.setrecursionlimit(1 << 30)
    deeper()


def silent_at_its_close(first):
    try:
        while True:
            yield Move(0)
    finally:
        time.sleep(3600)


def walks_for_ever(first):
    while True:
        yield Move(0)


def publishes_for_ever(first):
    while True:
        yield Checkpoint((0, 1), (1, 0), 0)


def publishes_without_end(first):
    yield Checkpoint(itertools.repeat(0), (1, 0), 0)


def publishes_what_cannot_be_written(first):
    yield Checkpoint((HUGE, 1), (1, 0), 0)
    return (yield from algorithm1(first))


def yields_nothing(first):
    yield None
