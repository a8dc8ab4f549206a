"""A right explorer: fold the log, go home through what is known, explore the nearest open dart.

Every arrival at a vertex is a fresh copy of it until an arrival at the marker says where one
is.  Then darts become equal, and with them all that follows from them.
"""

from allworlds import CombinatorialMap, Estimate, Move


class Folded:
    def __init__(self):
        self.parent, self.sigma, self.alpha = [], [], {}

    def vertex(self, degree):
        start = len(self.parent)
        self.parent += range(start, start + degree)
        self.sigma += [start + (i + 1) % degree for i in range(degree)]
        return start

    def find(self, dart):
        while self.parent[dart] != dart:
            dart = self.parent[dart]
        return dart

    def turned(self, dart, k):
        for _ in range(k):
            dart = self.find(self.sigma[dart])
        return self.find(dart)

    def offset(self, start, end):
        k, dart = 0, self.find(start)
        while dart != self.find(end):
            k, dart = k + 1, self.turned(dart, 1)
        return k

    def merge(self, *pair):
        pairs = [pair]
        while pairs:
            a, b = map(self.find, pairs.pop())
            if a == b:
                continue
            partners = [self.alpha[d] for d in (a, b) if d in self.alpha]
            pairs += [tuple(partners)] if len(partners) == 2 else []
            pairs.append((self.sigma[a], self.sigma[b]))
            self.parent[b] = a
            if partners:
                self.alpha[a] = partners[0]

    def around(self, dart):
        first = dart = self.find(dart)
        while True:
            yield dart
            dart = self.turned(dart, 1)
            if dart == first:
                return

    def way(self, start, is_goal):
        """The darts by which a shortest walk leaves, up to the first dart that is a goal."""
        seen, queue = {self.find(start)}, [(start, ())]
        for at, way in queue:
            for dart in self.around(at):
                if is_goal(dart):
                    return [*way, dart]
                if dart in self.alpha:
                    other = min(self.around(self.alpha[dart]))
                    if other not in seen:
                        seen.add(other)
                        queue.append((self.alpha[dart], (*way, dart)))
        return None


def explore(first):
    log = Folded()
    here = start = log.vertex(first.degree)
    pointed = log.turned(start, first.bearing)
    while (way := log.way(start, lambda dart: dart not in log.alpha)) is not None:
        home = log.way(here, lambda dart: dart == log.find(pointed))
        for dart in [*home[:-1], *way]:
            percept = yield Move(log.offset(here, dart))
            if log.find(dart) in log.alpha:
                here = log.find(log.alpha[log.find(dart)])
                continue
            here = log.vertex(percept.degree)
            log.alpha[log.find(dart)], log.alpha[here] = here, log.find(dart)
            if percept.marks:
                log.merge(pointed, log.turned(here, percept.bearing))
    darts = sorted({log.find(dart) for dart in range(len(log.parent))})
    number = {dart: i for i, dart in enumerate(darts)}
    sigma = [number[log.turned(dart, 1)] for dart in darts]
    alpha = [number[log.find(log.alpha[dart])] for dart in darts]
    return Estimate(CombinatorialMap(sigma, alpha), number[log.find(here)])
