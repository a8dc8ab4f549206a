"""A map by two robots without a marker: one of them is the marker of the other.

In ``face-to-face``, with the team ``leader, follower``.  The leader is the explorer dudek91, which
is not changed: where it would carry its marker along, the leader tells the follower which way it
goes, waits until that has gone, and goes after it.

Both are automata.  The follower has no memory.  The leader remembers what it told dudek91, and
nothing else: as a generator it would remember each time whether it looked before the follower went
or after it, and there would be a thousand times as many configurations.
"""

from allworlds import Automaton, Checkpoint, Do, Drop, End, Move, Percept, Pick, Watch
from allworlds.explorers import dudek91


def next_action(replies):
    """What dudek91 does after these percepts: an action, or its end."""
    game = dudek91(Percept(*replies[0]))
    action, left = None, [None, *(Percept(*each) for each in replies[1:])]
    try:
        for reply in left:
            action = game.send(reply)
            while isinstance(action, Checkpoint):
                action = game.send(None)
    except StopIteration as stop:
        return End(stop.value)
    return action


def lead(memory, percept):
    """Step; the memory: the replies to dudek91, whether the marker is carried, the way to go."""
    replies, carried, way = memory
    degree, others = percept
    if way is not None:
        return (memory, Watch()) if others else ((replies, carried, None), Move(way))
    while True:
        replies = (*replies, (degree, 0 if carried else len(others)))
        action = next_action(replies)
        if not isinstance(action, Drop | Pick):
            break
        carried = isinstance(action, Pick)
    if carried and isinstance(action, Move):
        return (replies, carried, action.k), Do(action.k)
    return (replies, carried, None), action


def follow(memory, percept):
    """Come along when told so."""
    _, others = percept
    turn, word = others[0] if others else (0, None)
    return memory, Watch() if word is None else Move(turn + word)


leader = Automaton(((), True, None), lead)
follower = Automaton(None, follow)
