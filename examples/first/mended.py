"""Map a building whose rooms are numbered."""

from allworlds import CombinatorialMap, Estimate, Move


def explore(first):
    rooms = {}  # by number: what was sensed on entering for the first time
    leads = {}  # from (room, door) to (room, door); door 0 is the first one used

    def enter(percept):
        room = percept.marks
        if room not in rooms:
            rooms[room] = percept
            return room, 0
        # A known room. By which door did the robot come this time?
        return room, (rooms[room].bearing - percept.bearing) % percept.degree

    def search(room, door):
        for k in range(rooms[room].degree):
            if (room, k) not in leads:
                leads[room, k] = None
                known = set(rooms)
                there = enter((yield Move(k - door)))
                leads[room, k], leads[there] = there, (room, k)
                at = there[1] if there[0] in known else (yield from search(*there))
                yield Move(there[1] - at)  # back through the same door
                door = k
        return door

    here = (first.marks, (yield from search(*enter(first))))
    darts = sorted(leads)
    number = {dart: i for i, dart in enumerate(darts)}
    sigma = [number[room, (k + 1) % rooms[room].degree] for room, k in darts]
    alpha = [number[leads[dart]] for dart in darts]
    return Estimate(CombinatorialMap(sigma, alpha), number[here])
