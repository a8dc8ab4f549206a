"""The Python part of shim.c: a generator behind the functions of allworlds.h."""

import ctypes

from allworlds.explorers.loading import load
from allworlds.explorers.shared_library import CAction, CPercept
from allworlds.protocol.actions import Checkpoint, Drop, Estimate, Move, Percept
from allworlds.protocol.choices import Choices

MOVE, DROP, CHECKPOINT, ANSWER = 1, 2, 4, 5


class Shim:
    """One explorer, found by its name as the command line finds it."""

    def __init__(self, name):
        self.player = load(name).player()

    def start(self, percept, told, action):
        """A new generator."""
        self.going = self.player(percept_at(percept), Choices(), None if told < 0 else told)
        return self.go_on(None, action)

    def step(self, percept, action):
        """Send the generator the percept, or None after a checkpoint."""
        return self.go_on(None if self.shown else percept_at(percept), action)

    def go_on(self, reply, action):
        """Its next action; what it raises is a crash."""
        said = CAction.from_address(action)
        self.shown = None
        try:
            message = self.going.send(reply)
        except StopIteration as end:
            self.shown, said.kind = end.value, ANSWER
            return 0
        if isinstance(message, Move):
            said.kind, said.motion = MOVE, message.k
        elif isinstance(message, Drop):
            said.kind = DROP
        elif isinstance(message, Checkpoint):
            self.shown, said.kind = message, CHECKPOINT
        return 0

    def answer(self, capacity, sigma, alpha, here):
        """Write the map shown or returned; return the number of its darts, 0 if it is no map."""
        shown = self.shown
        if isinstance(shown, Estimate):
            shown = Checkpoint(shown.map.sigma, shown.map.alpha, shown.here)
        if not isinstance(shown, Checkpoint):
            return 0
        for address, values in ((sigma, shown.sigma), (alpha, shown.alpha)):
            (ctypes.c_int32 * capacity).from_address(address)[: len(values)] = [*values]
        ctypes.c_int32.from_address(here).value = shown.here
        return len(shown.sigma)


def percept_at(address):
    """A percept in C's memory."""
    seen = CPercept.from_address(address)
    return Percept(seen.degree, seen.marks, None if seen.bearing < 0 else seen.bearing)
