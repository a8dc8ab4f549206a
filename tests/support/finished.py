"""Runs that have ended, as the judge is given them."""

from allworlds.explorers.builtin.algorithm1 import algorithm1
from allworlds.judging.laws.law_table import Case
from allworlds.judging.walk import Walk
from allworlds.protocol.actions import Checkpoint


def finished(world):
    """Algorithm 1's run in a world, as a case."""
    generator, walk = algorithm1(world.first), Walk.begin(world)
    reply, checkpoints = None, []
    while True:
        try:
            message = generator.send(reply)
        except StopIteration as stop:
            return Case(walk, tuple(checkpoints), stop.value)
        if isinstance(message, Checkpoint):
            checkpoints.append((len(walk), message))
            reply = None
        else:
            reply = walk.step(message)
