"""Right explorers that look odd: none of them is refuted, those that give no walk are refused.

verdict of integers: holds
verdict of sequences: holds
verdict of checkpoints: holds
verdict of walks_more: holds
verdict of nested: holds
verdict of busy: holds
verdict of forks: holds
verdict of changes_percepts: holds
verdict of Instance.method: holds
verdict of Instance.of_class: holds
verdict of Instance.of_nobody: holds
verdict of instance: holds
verdict of partial: holds
verdict of decorated: holds
verdict of anonymous: holds
verdict of takes_all: holds
verdict of closes_loudly: holds
verdict of plainly_decorated: holds
verdict of cached: refuted nondeterministic
verdict of asynchronous: refused
verdict of returns_a_generator: holds
verdict of walks_as_an_object: holds
verdict of without_a_signature: holds
verdict of floats: refuted illegal-action
verdict of booleans: refuted illegal-action
verdict of moves_of_its_own: refuted illegal-action
verdict of estimates_of_its_own: refuted no-estimate
verdict of pairs: refuted no-estimate
options: --edges 2 --bound none
"""

import functools
import os
import threading
from array import array
from collections import deque
from itertools import cycle

import numpy as np
from msgspec.structs import force_setattr

from allworlds import Checkpoint, CombinatorialMap, Estimate, Move
from allworlds.explorers.builtin.algorithm1 import algorithm1


class Index:
    def __init__(self, value):
        self.value = value

    def __index__(self):
        return self.value


class OwnMove(Move):
    pass


class OwnEstimate(Estimate):
    pass


class OwnMap(CombinatorialMap):
    pass


def dressed(move=lambda action: action, answer=lambda estimate: estimate, show=lambda shown: shown):
    """Algorithm 1 with other moves and checkpoints, and another answer."""

    def explore(first):
        walk, percept = algorithm1(first), None
        while True:
            try:
                action = walk.send(percept)
            except StopIteration as stop:
                return answer(stop.value)
            percept = yield move(action) if type(action) is Move else show(action)

    return explore


KINDS = cycle([np.int64, np.int8, Index, lambda k: np.array(k), lambda k: k + 10**600 * 5040])


def other_integer(action):
    # Which kind it is says nothing of the walk: all are taken modulo the degree.
    return Move(next(KINDS)(action.k))


def other_sequences(estimate):
    sigma = deque(estimate.map.sigma)
    alpha = array("l", estimate.map.alpha)
    return Estimate(OwnMap(sigma, np.array(alpha)), np.uint8(estimate.here))


def other_checkpoint(shown):
    return Checkpoint(np.array(shown.sigma), (d for d in shown.alpha), Index(shown.here))


integers = dressed(other_integer)
sequences = dressed(answer=other_sequences)
floats = dressed(lambda action: Move(float(action.k)))
booleans = dressed(lambda action: Move(True))
moves_of_its_own = dressed(lambda action: OwnMove(action.k))
estimates_of_its_own = dressed(answer=lambda said: OwnEstimate(said.map, said.here))
pairs = dressed(answer=lambda said: (said.map, said.here))
checkpoints = dressed(show=other_checkpoint)
anonymous = lambda first: (yield from algorithm1(first))


def walks_more(first):
    for k in range(first.degree):
        yield Move(k)
        yield Move(0)
        yield Move(-k)
        yield Move(0)
    return (yield from algorithm1(first))


def nested(first, depth=200):
    if depth:
        return (yield from nested(first, depth - 1))
    return (yield from algorithm1(first))


def busy(first):
    threads = [threading.Thread(target=sum, args=(range(10**4),)) for _ in range(8)]
    for thread in threads:
        thread.start()
    answer = yield from algorithm1(first)
    for thread in threads:
        thread.join()
    return answer


def forks(first):
    child = os.fork()
    answer = yield from algorithm1(first)
    if child:
        os.waitpid(child, 0)
    return answer


def changes_percepts(first):
    walk, percept = algorithm1(first), None
    while True:
        try:
            action = walk.send(percept)
        except StopIteration as stop:
            return stop.value
        said = yield action
        percept = said and type(said)(said.degree, said.marks, said.bearing)
        if said:
            force_setattr(said, "degree", 99)
            force_setattr(said, "bearing", 98)


class Instance:
    def method(first):
        return (yield from algorithm1(first))

    @classmethod
    def of_class(cls, first):
        return (yield from algorithm1(first))

    @staticmethod
    def of_nobody(first):
        return (yield from algorithm1(first))

    def __call__(self, first):
        return (yield from algorithm1(first))


def with_a_word(word, first):
    return (yield from algorithm1(first))


def takes_all(first, *, choices=None, **more):
    return (yield from algorithm1(first))


def closes_loudly(first):
    try:
        return (yield from algorithm1(first))
    finally:
        print("done")


def delegating(explore):
    @functools.wraps(explore)
    def inner(first):
        return (yield from explore(first))

    return inner


def plain(explore):
    @functools.wraps(explore)
    def inner(first):
        return explore(first)

    return inner


instance = Instance()
partial = functools.partial(with_a_word, "word")
decorated = delegating(Instance.method)
plainly_decorated = plain(Instance.method)
cached = functools.lru_cache(Instance.method)


async def asynchronous(first):
    yield


def returns_a_generator(first):
    return algorithm1(first)


class Walker:
    """No generator, but with all of one that a play needs."""

    def __init__(self, first):
        self.send = algorithm1(first).send


walks_as_an_object = Walker


class Compiled:
    """A callable that tells nothing of its parameters, as a compiled one."""

    __signature__ = "none"

    def __call__(self, *given):
        return algorithm1(*given)


without_a_signature = Compiled()
