"""Three robots that explore a ring for ever, never two at one vertex (Blin and others, DISC 2010).

Oblivious, anonymous, without chirality, in ``snapshot:goal=explore,exclusive=true,crossing=false``.
The rules are those that Millet prints (Verification et synthese d'algorithmes de robots, thesis,
UPMC 2015), and of her generator of models; ``old`` has the rule RC5 as it was published, and is
refuted in async; ``new`` has the corrected one.

A robot sees three gaps: x vertices without a robot ahead of it, y between the two others, z behind
it.  Every rule holds as well with ahead and behind exchanged.
"""

from allworlds import Automaton, Do, Wait

AHEAD, BACK, EITHER = "ahead", "back", "either"


def rule_of(x, y, z, *, corrected):
    """The motion for three gaps, or None."""
    if x == 0 and y == 2:
        return BACK  # RL1
    if (x == 1 and z == 2) or (x == 3 and y == 0):
        return AHEAD  # RL2, RL3
    if y == 0 and 3 < x < z:
        return AHEAD  # RC1
    if x == z and y != z and x > 0:
        return EITHER  # RC2
    if 0 < x < z < y or (y == 0 and z == 0):
        return AHEAD  # RC3, RC4
    if corrected:
        return BACK if x == 0 and y == 1 else None  # RC5: the far one of the pair steps away
    return BACK if y == 0 and x == 1 else None  # RC5: the lone one steps away from the pair


def gaps(view):
    """The three gaps, from the view in one direction."""
    robots = view[0]
    one, other = (place for place in range(1, len(robots)) if robots[place])
    return one - 1, other - one - 1, len(robots) - other - 1


def by_rules(*, corrected):
    """The oblivious robot: its memory is None."""

    def step(memory, views):
        for place, view in enumerate(views):
            motion = rule_of(*gaps(view), corrected=corrected)
            if motion == EITHER:
                return memory, Do("either")
            if motion:
                return memory, Do(place if motion == AHEAD else 1 - place)
        return memory, Wait()

    return Automaton(None, step)


old = by_rules(corrected=False)
new = by_rules(corrected=True)
