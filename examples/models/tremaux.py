"""Trémaux: marks at the passages, and back where a new passage leads to an old room.

The board of a room holds a bit for each used door, and by which door the robot first came.

Source: É. Lucas, Récréations mathématiques I (1882), after C. P. Trémaux.

    $ allworlds check tremaux.py --lighthouse compass+whiteboard:states=65536 --task home --bound '2*m' --edges 3
    HOLDS
    $ allworlds check tremaux.py --lighthouse compass+whiteboard:states=65536 --task home --bound '2*m-1' --edges 3
    REFUTED
"""

from allworlds import Move, Write


def tremaux(first):
    """Walk along every passage twice, and end at home."""
    percept, came = first, False
    while True:
        north, doors = percept.bearing, range(percept.degree)
        here = -north % percept.degree
        used, way_back = divmod(percept.marks, 16)  # 0: a new room, 1: home, else a door + 2
        new = way_back == 0
        if new:
            way_back = here + 2 if came else 1
        fresh = came and not used >> here & 1
        used |= came << here
        left = [door for door in doors if not used >> door & 1]
        if fresh and not new:
            door = here  # an old room by a new passage: turn back
        elif left:
            door = left[0]
        elif way_back == 1:
            return
        else:
            door = way_back - 2
        yield Write((used | 1 << door) * 16 + way_back)
        came, percept = True, (yield Move(north + door))
