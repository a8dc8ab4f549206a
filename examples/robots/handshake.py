"""Two robots that agree by a whiteboard, in ``shared-whiteboard:goal=agree,labels=true``.

Robot 0 writes, and waits until the other one has answered.  ``polling`` looks again and again: in
async it may look so often as one likes before the other is activated, so it is unfinished at any
budget.  ``watching`` is activated when what it sees has changed, and holds.
"""

from allworlds import Do, Wait, Watch

PING, PONG = "ping", "pong"


def handshake(pause):
    """The program that pauses so while it waits."""

    def explore(first, *, told):
        seen, mine, theirs = first[2], PING, PONG
        if told:
            mine, theirs = PONG, PING
            while seen != theirs:
                seen = (yield pause)[2]
            yield Do({"write": mine})
            return PONG
        seen = (yield Do({"write": mine}))[2]
        while seen != theirs:
            seen = (yield pause)[2]
        return PONG

    return explore


polling = handshake(Wait())
watching = handshake(Watch())
