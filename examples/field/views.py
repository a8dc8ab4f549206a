"""Views, cut off at a depth: how far must a robot look to tell places apart?

The view of depth 0 from a dart is the degree of its vertex.  The view of depth d + 1 is that and,
for each dart clockwise from this one, the view of depth d from its other end.  The explorer looks
at the view of depth d from every dart, and says how many kinds of darts there are.  It is told how
many vertices there are, so that it knows how far the last one can be.

Source: M. Yamashita, T. Kameda, Computing on anonymous networks (1996); N. Norris, Universal covers
of graphs: isomorphism to depth n-1 implies isomorphism to all depths (1995).

Lighthouse: ``told:n``.  Task: ``judges.py:kinds``, the number of kinds of darts that motions tell
apart.  Expected: ``to_n``, which looks to depth n, HOLDS as far as it was tried (4 edges).  Less is
REFUTED: depth n - 1 (``norris``: the theorem is about vertices whose darts have numbers) in the
smallest case with 3 edges, depths 0, 1 and 2 with 2, 3 and 4 edges. Counted are kinds of darts;
kinds of vertices are fewer, and need 3 edges to refute depth 0::

    allworlds check 'views.py:looks?depth=1' --lighthouse told:n --task judges.py:kinds
        --step-budget 100000 --edges 3
"""

from allworlds import Move


def looks(depth):
    """The explorer that looks to this depth."""
    return by_views(lambda _n: depth)


def by_views(depth_of):
    """The explorer that looks to a depth that depends on the number of vertices."""

    def explore(first, *, told):
        depth, far = depth_of(told["n"]), told["n"] - 1
        view, _ = yield from walked(first, far + depth)
        found = set()
        for degree, beyond in within(view, far):
            cut_off = tuple(cut(other, depth - 1) for other in beyond) if depth else ()
            found |= {(degree, cut_off[k:] + cut_off[:k]) for k in range(degree)}
        return len(found)

    return explore


def walked(percept, depth):
    """The view of that depth from here, and the offset of the dart by which the robot had come.

    The robot walks all of the view, and is back then.
    """
    beyond = []
    for turn in range(percept.degree if depth else 0):
        there = yield Move(min(turn, 1))  # after the first dart each is the next one clockwise
        view, way_back = yield from walked(there, depth - 1)
        yield Move(way_back)
        beyond.append(view)
    return (percept.degree, tuple(beyond)), 1 if beyond else 0


def within(view, far):
    """The views from one dart or more of each vertex that is at most that far."""
    yield view
    for beyond in view[1] if far else ():
        yield from within(beyond, far - 1)


def cut(view, depth):
    """The view as far as that depth."""
    return view[0], tuple(cut(beyond, depth - 1) for beyond in view[1]) if depth else ()


to_n = by_views(lambda n: n)
norris = by_views(lambda n: n - 1)
