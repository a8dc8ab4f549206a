"""Three oblivious robots that gather on a ring from all starts but three equal gaps; ``snapshot``.

``odd`` is Odd-Gathering of Klasing, Markou and Pelc (TCS 390, 2008), for three robots: one moves at
a time.  ``three`` has the rules that Millet and others synthesized for rounds (SSS 2014), where two
may move.  Both are right in async.  ``naive`` makes one step to the nearest vertex with a robot,
and stays if two are equally near: in central and in fsync it fails from different starts.
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


def beside_the_largest(ahead, between, behind):
    """Whether to leave a largest gap, or the one between two of them."""
    return max(ahead, behind) > between


def nearer_or_axial(ahead, between, behind):
    """The same, of two robots beside one largest gap the nearer one alone; of equals the third."""
    nearer = min(ahead, behind) < between < max(ahead, behind)
    return nearer or ahead == behind != between


def by_gaps(moves):
    """The robot that goes away from the larger gap beside it, if ``moves`` says so of the three.

    At last two are at one vertex, and the third goes there.
    """

    def gather(memory, views):
        ring, others = len(views[0][0]), others_in(views)
        if views[0][0][0] > 1 or not others:
            return memory, Wait()
        if len(others) == 1:
            return memory, towards(others[0], ring - others[0])
        ahead, between, behind = others[0], others[1] - others[0], ring - others[1]
        going = moves(ahead, between, behind)
        return memory, towards(ahead, behind) if going else Wait()

    return Automaton(None, gather)


def step_to_nearest(memory, views):
    """Go to the nearest."""
    ring, others = len(views[0][0]), others_in(views)
    if not others or others[0] == ring - others[-1]:
        return memory, Wait()
    return memory, towards(others[0], ring - others[-1])


odd = by_gaps(nearer_or_axial)
three = by_gaps(beside_the_largest)
naive = Automaton(None, step_to_nearest)
