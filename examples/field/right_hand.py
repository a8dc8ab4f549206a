"""The right-hand rule: keep to the wall.  The robot goes round one face.

Source: folklore of mazes; É.  Lucas, Récréations mathématiques I (1882), tells where it fails.

Lighthouse: ``told:m``.  Task: every edge walked along in both directions (``judges.py``).
Expected: ``goes_round`` HOLDS in the maps with one face, within 2m motions, and is REFUTED in each
other map, the smallest of which is the loop::

    allworlds check right_hand.py:goes_round --lighthouse told:m --task judges.py:every_dart
        --where judges.py:one_face --bound '2*m'
"""

from allworlds import Move


def goes_round(first, *, told):
    """The explorer: 2m motions, each by the next dart clockwise."""
    for _ in range(2 * told["m"]):
        yield Move(1)
