"""Runs that have ended, as the judge is given them."""

from allworlds.explorers.builtin.algorithm1 import algorithm1
from allworlds.judging.laws.law_table import Case
from allworlds.protocol.actions import Checkpoint, Transcript
from small import stepped


def finished(world):
    """Algorithm 1's run in a world, as a case."""
    generator = algorithm1(world.first)
    dart, reply, steps, checkpoints = world.start, None, [], []
    while True:
        try:
            message = generator.send(reply)
        except StopIteration as stop:
            transcript = Transcript(world.first, tuple(steps))
            return Case(world.map, world.start, transcript, tuple(checkpoints), stop.value)
        if isinstance(message, Checkpoint):
            checkpoints.append((len(steps), message))
            reply = None
        else:
            dart, reply = stepped(world, dart, message)
            steps.append((message, reply))
