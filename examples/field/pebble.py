"""A map drawn with one pebble where darts have numbers: port-labelled graphs.

At the end of an unknown dart the robot drops the pebble, goes back, and looks for it at every
known vertex, by shortest ways.  Where it lies, the dart is known by its number; if it lies nowhere,
the end is a new vertex.  Either way the robot fetches the pebble.

Source: G. Dudek, M. Jenkin, E. Milios, D. Wilkes, Robotic exploration as graph construction
(1991), and with numbered darts M. Bender, A. Fernández, D. Ron, A. Sahai, S. Vadhan, The power of a
pebble (2002).

Lighthouse: ``compass+movable``.  Task: ``map``.  Expected: ``draws`` HOLDS in all maps within 4mn
motions.  ``blind`` takes the other end for the first open dart of its vertex: this is REFUTED by
the law ``pose``, in the smallest case in two loops at one vertex::

    allworlds check pebble.py:draws --lighthouse compass+movable --bound '4*m*n'
"""

from allworlds import CombinatorialMap, Drop, Estimate, Move, Pick


def by_pebble(*, ports):
    """The explorer that reads the numbers of darts, or does not.

    Dart k of a vertex is the one that is k further clockwise than its reference dart.
    """

    def explore(first):
        ends = [[None] * first.degree]  # for each known vertex the other ends of its darts
        at, dart, percept = 0, -first.bearing % first.degree, first

        def walk(way):
            nonlocal at, dart, percept
            for out in way:
                percept = yield Move(out - dart)
                at, dart = ends[at][out] or (None, -percept.bearing % percept.degree)

        def seen(vertex):
            yield from walk(shortest(ends, at, vertex))
            return percept.marks > 0

        while (unknown := first_open(ends)) is not None:
            vertex, out = unknown
            yield from walk([*shortest(ends, at, vertex), out])
            degree, number = percept.degree, dart
            yield Drop()
            percept = yield Move(0)
            at, dart = vertex, out
            other = None
            for known in range(len(ends)):
                if len(ends[known]) == degree and (yield from seen(known)):
                    other = known
                    break
            if other is None:
                other = len(ends)
                ends.append([None] * degree)
            elif not ports:
                free = [k for k, end in enumerate(ends[other]) if not end and (other, k) != unknown]
                number = min(free, default=number)
            ends[vertex][out], ends[other][number] = (other, number), unknown
            yield from walk(shortest(ends, at, other))
            yield Pick()
        return answer(ends, at, dart)

    return explore


def first_open(ends):
    """The first dart without a known other end; None if there is none."""
    every = ((v, k) for v, darts in enumerate(ends) for k in range(len(darts)))
    return next(((v, k) for v, k in every if not ends[v][k]), None)


def shortest(ends, start, goal):
    """The darts of a shortest known way between two vertices."""
    ways, queue = {start: []}, [start]
    for vertex in queue:
        for out, end in enumerate(ends[vertex]):
            if end and end[0] not in ways:
                ways[end[0]] = [*ways[vertex], out]
                queue.append(end[0])
    return ways[goal]


def answer(ends, at, dart):
    """The finished map, and the dart by which the robot has come."""
    every = [(v, k) for v, darts in enumerate(ends) for k in range(len(darts))]
    numbers = {place: number for number, place in enumerate(every)}
    sigma = [numbers[v, (k + 1) % len(ends[v])] for v, k in numbers]
    alpha = [numbers[ends[v][k]] for v, k in numbers]
    return Estimate(CombinatorialMap(sigma, alpha), numbers[at, dart])


draws = by_pebble(ports=True)
blind = by_pebble(ports=False)
