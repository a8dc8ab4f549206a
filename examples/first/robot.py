"""Draw a map of the world, starting at its lighthouse."""

from allworlds import CombinatorialMap, Estimate, Move, Percept


def explore(first):
    # For each dart of the map so far: its vertex (named by its first dart), the next dart
    # clockwise, where it leads (None: not known yet), and what one senses on arriving by it.
    vertex, sigma, alpha, sensed = [], [], [], []

    def add_vertex(percepts):
        start, degree = len(sigma), len(percepts)
        vertex.extend([start] * degree)
        sigma.extend(start + (i + 1) % degree for i in range(degree))
        alpha.extend([None] * degree)
        sensed.extend(percepts)
        return start

    def way(start, goal):
        """The darts by which a shortest way leads from one vertex to another."""
        ways, queue = {start: []}, [start]
        for v in queue:
            for dart in range(v, v + sensed[v].degree):
                if alpha[dart] is not None and vertex[alpha[dart]] not in ways:
                    ways[vertex[alpha[dart]]] = [*ways[v], dart]
                    queue.append(vertex[alpha[dart]])
        return ways[goal]

    degree = first.degree
    add_vertex([Percept(degree, 1, (first.bearing - i) % degree) for i in range(degree)])
    here = 0
    while None in alpha:
        dart = alpha.index(None)
        for step in [*way(vertex[here], vertex[dart]), dart]:
            percept = yield Move(step - here)
            here = alpha[step]
        suspects = [d for d, e in enumerate(alpha) if e is None and d != dart]
        suspects = [d for d in suspects if sensed[d] == percept]
        # Have I been here before?
        known, turned = None, 0
        for suspect in suspects:
            at, motions = suspect, []
            for step in way(vertex[suspect], 0):  # if so, this is the way to the lighthouse
                motions.append(step - at)
                arrival = yield Move(step - at - turned)
                at, turned = alpha[step], 0
                if arrival != sensed[at]:
                    break
            else:
                known, here = suspect, at
                break
            back = 0
            for motion in reversed(motions):  # no: go back; the robot then stands
                yield Move(back)
                back = -motion
            turned = motions[0]  # this many darts clockwise of the one where it stood
        # Draw what was found.
        if known is None:
            known = add_vertex([percept] * percept.degree)
            here = known + turned % percept.degree
        alpha[dart], alpha[known] = known, dart
    return Estimate(CombinatorialMap(sigma, alpha), here)
