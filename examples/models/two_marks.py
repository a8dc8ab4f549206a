"""Two kinds of marks in place of a direction: one pebble at home, two behind the first door.

Then the robot maps the world as if they had been there, by the built-in algorithm for such marks.

Source: G. Dudek, M. Jenkin, E. Milios, D. Wilkes, Robotic exploration as graph construction, IEEE
Transactions on Robotics and Automation 7(6), 859-865 (1991), for one mark; two are
ours.

    $ allworlds check two_marks.py:leaves --lighthouse movable:markers=3,pick=false --class simple --edges 3
    HOLDS
    $ allworlds check two_marks.py:keeps --lighthouse movable:markers=3,pick=false --class simple --edges 3
    REFUTED
"""

from allworlds import Drop, Move
from allworlds.explorers import algorithm1_cluster


def leaves(first, *, choices):
    """Leave the marks, and draw the map."""
    yield Drop()
    yield Move(0)
    yield Drop()
    yield Drop()
    home = yield Move(0)
    return (yield from algorithm1_cluster(home, choices=choices))


def keeps(first, *, choices):
    """Leave one mark alone."""
    home = yield Drop()
    return (yield from algorithm1_cluster(home, choices=choices))
