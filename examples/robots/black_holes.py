"""Two robots that look for a black hole in a ring, in ``black-hole``.

``cautious``: robot 0 goes ahead and comes back, robot 1 waits for it for two rounds: right in
fsync; both are lost in central, where nobody can count rounds.
``halves``: each takes what is left from its side; at home stands the list of what is safe, which
is read and written in two activations: right in ssync, but in async one reads it while the other
is about to write, and both are lost; not with ``at_once=true``.
``careless``: each remembers what it has seen itself; both are lost.

An answer is the walk from home to the hole.
"""

from allworlds import Automaton, Do, End, Move, Wait


def walk_to(steps):
    """The walk to the right from home."""
    return [0] + [1] * (steps - 1)


def cautious(first, *, told):
    """Go in pairs."""
    _, robot = told
    turn, steps = 0, 1
    while True:
        if robot == 0:
            yield Move(turn)
            yield Move(0)
            yield Move(0)
        else:
            yield Wait()
            _, _, others, _ = yield Wait()
            if not others:
                return walk_to(steps)
            yield Move(turn)
        turn, steps = 1, steps + 1


def begin(told):
    """The memory: vertices and number, whether it faces right, its target, the turns to come."""
    return (*told, True, 0, ())


def half(memory, percept):
    """Robot 0 takes the next vertex from the right, robot 1 from the left."""
    vertices, robot, right, target, turns = memory
    if not turns:
        safe = percept[3] or []
        if target:
            return (vertices, robot, robot == 0, 0, ()), Do({"write": sorted({*safe, target})})
        left = [vertex for vertex in range(1, vertices) if vertex not in safe]
        if len(left) == 1:
            return memory, End(walk_to(left[0]))
        target = left[0] if robot == 0 else left[-1]
        steps = target if robot == 0 else vertices - target
        out = int(right != (robot == 0))
        turns = (out, *[1] * (steps - 1), 0, *[1] * (steps - 1))
    return (vertices, robot, right, target, turns[1:]), Move(turns[0])


halves = Automaton(begin, half)


def halves_remembered(first, *, told):
    """The same as a generator: what it has forgotten nobody knows."""
    memory, percept = begin(told), first
    while True:
        memory, action = half(memory, percept)
        if isinstance(action, End):
            return action.answer
        percept = yield action


def careless(first, *, told):
    """Look at the next vertex and come back, without a list."""
    vertices, robot = told
    steps, turn = 1, int(robot == 1)
    while steps < vertices - 1:
        for _ in range(steps):
            yield Move(turn)
            turn = 1
        yield Move(0)
        for _ in range(steps - 1):
            yield Move(1)
        steps, turn = steps + 1, 0
    return walk_to(vertices - 1 if robot == 0 else 1)
