"""All rule sets of oblivious robots on a ring, in ``snapshot``: a rule is chosen when it is needed.

So a few hundred beginnings decide what millions of whole rule sets would.
"""

from allworlds import Automaton, Do, Wait
from gathering import seen


class Unruled(Exception):
    """Raised for a view without a rule."""


def lazily(rules, asked):
    """The robot of these rules; a view without one is put into the list, and is a fault."""

    def step(memory, views):
        view = tuple(seen(each[0]) for each in views)
        if view not in rules:
            asked.append(view)
            raise Unruled(str(view))
        rule = rules[view]
        return memory, Do(rule - 1) if rule else Wait()

    return Automaton(None, step)


def some_rules(attempt):
    """The number of rule sets that were begun, and whether one of them is right.

    ``attempt`` says whether a program is right; it raises Unruled where a rule that is needed is
    missing.
    """
    tried, left = 0, [{}]
    while left:
        rules, asked = left.pop(), []
        tried += 1
        try:
            if attempt(lazily(rules, asked)):
                return tried, True
        except Unruled:
            one, other = view = asked[0]
            left += [{**rules, view: rule} for rule in range(2 if one == other else 3)]
    return tried, False
