"""Tasks and classes of maps for the explorers in this folder.

They stand in a file of their own: judges run where verdicts are made.
"""


def one_face(map_):
    """Whether there is one face alone."""
    return len(map_.faces) == 1


def several_faces(map_):
    """Whether there are two faces or more."""
    return len(map_.faces) > 1


def every_dart(world, transcript, answer):
    """Every edge was walked along in both directions."""
    map_, dart, walked = world.map, world.start, set()
    for action in transcript.actions:
        out = map_.turn(dart, action.k)
        walked.add(out)
        dart = map_.alpha[out]
    missing = len(map_.darts) - len(walked)
    return f"{missing} darts were never left by" if missing else None


def kinds(world, transcript, answer):
    """The answer is the number of kinds of darts: of one kind are those that no motion tells apart.

    They are parted until the parts of the next dart clockwise and of the other end follow from
    the part of a dart, as in the minimisation of automata.
    """
    map_ = world.map
    part = [world.percepts[dart] for dart in map_.darts]
    while True:
        finer = [(part[d], part[map_.sigma[d]], part[map_.alpha[d]]) for d in map_.darts]
        names = {told: i for i, told in enumerate(dict.fromkeys(finer))}
        if len(names) == len({*part}):
            break
        part = [names[told] for told in finer]
    right = len(names)
    return None if answer == right else f"{answer} kinds said, and there are {right}"
