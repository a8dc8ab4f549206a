"""A marker that is not always seen: how large is a ring, if it can be missed once?

The robot goes on until it has seen the marker twice; the lesser distance is right.

Source: ours; the fault is that of a sensor which misses a landmark.

    $ allworlds team failing_marker.py:twice --model hidden:1+lighthouse:position --robots 1 --family cycle:4
    HOLDS
    $ allworlds team failing_marker.py:once --model hidden:1+lighthouse:position --robots 1 --family cycle:4
    REFUTED
"""

from allworlds import CombinatorialMap, Estimate, Move


def sees(times):
    """The explorer of rings that sees the marker so many times before it answers."""

    def explore(first):
        rounds = []
        for _ in range(times):
            steps = 1
            while not (yield Move(1)).marks:
                steps += 1
            rounds.append(steps)
        ends = range(2 * min(rounds))
        sigma = [end ^ 1 for end in ends]
        alpha = [(end + end % 2 * 2 - 1) % len(ends) for end in ends]
        return Estimate(CombinatorialMap(sigma, alpha), 0)

    return explore


once = sees(1)
twice = sees(2)
