"""Three oblivious robots that gather on a ring from all starts but three equal gaps; ``snapshot``.

``three`` is right in async.  ``naive`` makes one step to the nearest vertex with a robot, and stays
if two are equally near: in central and in fsync it fails from different starts.
"""

from allworlds import Automaton, Do, Wait


def others_in(views):
    """The distances of the vertices with other robots, in the direction of the first view."""
    robots = views[0][0]
    return [place for place in range(1, len(robots)) if robots[place]]


def towards(ahead, behind):
    """The step to the nearer side; the first view is ahead."""
    if ahead == behind:
        return Do("either")
    return Do("first" if ahead < behind else "second")


def gather(memory, views):
    """Widen the largest gap: whoever is beside it goes away from it, towards the third robot.

    Of two largest gaps the robot between them makes one larger, while the others stay.  At last two
    are at one vertex, and the third goes there.
    """
    ring, others = len(views[0][0]), others_in(views)
    if views[0][0][0] > 1 or not others:
        return memory, Wait()
    if len(others) == 1:
        return memory, towards(others[0], ring - others[0])
    ahead, between, behind = others[0], others[1] - others[0], ring - others[1]
    beside_largest = max(ahead, behind) > between
    return memory, towards(ahead, behind) if beside_largest else Wait()


def step_to_nearest(memory, views):
    """Go to the nearest."""
    ring, others = len(views[0][0]), others_in(views)
    if not others or others[0] == ring - others[-1]:
        return memory, Wait()
    return memory, towards(others[0], ring - others[-1])


three = Automaton(None, gather)
naive = Automaton(None, step_to_nearest)
