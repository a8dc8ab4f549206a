"""Explorers: the built-in ones, and the loading of users' explorers.

``builtin``
    the explorers that come with the package;
``loading``
    the names of explorers; finding, loading and playing an explorer by its name;
``sources``
    the part of a request that names an explorer; hints at similar names; the files of an explorer,
    their digest, and the line where the explorer begins;
``program``
    explorers that are programs in any language, which read and write pipes;
``shared_library``
    explorers in shared libraries; the comments in ``allworlds.h`` explain the interface;
``languages``
    the languages of the skeletons: unfinished explorers to start from, in the folder ``skeletons``.

``dir(allworlds.explorers)`` lists the functions of the built-in explorers, for users' programs.
"""

from typing import TYPE_CHECKING

from allworlds.lazy import open_door

if TYPE_CHECKING:
    from allworlds.explorers.builtin.algorithm1 import (
        algorithm1 as algorithm1,
        algorithm1_cluster as algorithm1_cluster,
        algorithm1_natural as algorithm1_natural,
    )
    from allworlds.explorers.builtin.baselines import dfs as dfs, dudek91 as dudek91
    from allworlds.explorers.builtin.folding import (
        folding as folding,
        folding_oldest as folding_oldest,
    )
    from allworlds.explorers.builtin.quotient import quotient as quotient
    from allworlds.explorers.builtin.scanning import (
        algorithm1_door as algorithm1_door,
        algorithm1_word as algorithm1_word,
    )
else:
    open_door(__name__)
