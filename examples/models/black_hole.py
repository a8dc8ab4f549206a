"""A black hole in a ring: one robot goes ahead and comes back, the other one counts the rounds.

It is right if all act in rounds; else nobody can tell a slow robot from a lost one.

Source: J. Czyzowicz, D. Kowalski, E. Markou, A. Pelc, Complexity of searching for a black hole,
Fundamenta Informaticae 71(2-3), 229-242 (2006).

    $ allworlds team black_hole.py --model black-hole --family cycle:4 --scheduler fsync
    HOLDS
    $ allworlds team black_hole.py --model black-hole --family cycle:4 --scheduler ssync
    REFUTED
"""

from allworlds import Move, Wait


def search(first, *, told):
    """Robot 1 tries the next room; robot 0 answers when it does not come back."""
    _, ahead = told
    walk = []
    while True:
        walk.append(1 if walk else 0)  # go on round the ring
        if ahead:
            yield Move(walk[-1])
            yield Move(0)
            yield Move(0)
        else:
            yield Wait()
            _, _, others, _ = yield Wait()
            if not others:
                return walk
            yield Move(walk[-1])
