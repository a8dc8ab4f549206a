"""Right, in a directory full of modules with the names of ours and of Python's.

verdict: holds
beside: json re enum types random codecs mmap signal typing numpy typer secrets socket struct pickle
quick: 1
"""

from allworlds.explorers.builtin.algorithm1 import algorithm1


def explore(first):
    return (yield from algorithm1(first))
