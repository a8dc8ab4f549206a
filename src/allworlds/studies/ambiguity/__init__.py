"""Ambiguity: worlds that no robot can tell apart, their classes, twins and certificates.

Glossary
--------
quotient
    The world with each class of darts that no motion tells apart merged into one dart
    (:mod:`allworlds.maps.quotient`).
ambiguity class
    All worlds with the same rooted quotient; a robot can map a world that is the only member
    of its class.
pose hypothesis
    A member of the ambiguity class, and a dart of this member where the robot can be; darts
    that an automorphism takes to each other count once.
bisimulation
    Classes of darts that prove that no motion tells two worlds apart
    (:mod:`allworlds.world.bisimulation`).
separation
    Motions after which a robot senses different percepts in two worlds.
sensor
    A lighthouse, as far as it decides what a robot senses at each dart.
coarsening
    A sensor made from a given sensor, the finest one: it shows some different letters of the
    finest sensor as one letter.

Modules
-------
``members``
    a bisimulation or a separation of two worlds; the members of a world's ambiguity class,
    which are made from the quotient;
``census_sweep``
    the census, which finds all worlds of a class of maps that look alike under one lighthouse;
``sensed_classes``
    arrays for many worlds of one size, and names that are equal for worlds that look alike;
``side_by_side``
    the comparison of sensors: which of them tells more worlds apart;
``coarsenings``
    the weakest sensors that suffice, among all coarsenings of a finest sensor; a sensor suffices if
    no two worlds with different rooted maps look alike under it;
``question``
    the question of a search: are there two different worlds that no motion tells apart?  The
    question names a class, a lighthouse and the largest sizes, perhaps percepts on a walk;
``twin_search``
    the search for two such worlds, from the smallest worlds on;
``clauses``, ``one_world``, ``formulas``
    the clauses of a propositional formula; the formula whose solutions are worlds; the formula
    whose solutions are pairs of worlds that no motion tells apart;
``solvers``, ``proofs``
    the solvers of formulas, and checkers of proofs that there are no twins; twins
    that were found are checked by :mod:`allworlds.world.bisimulation`.
"""

from typing import TYPE_CHECKING

from allworlds.lazy import open_door

if TYPE_CHECKING:
    from allworlds.studies.ambiguity.census_sweep import (
        AmbiguityCensus as AmbiguityCensus,
        CensusCell as CensusCell,
        CensusRow as CensusRow,
        census as census,
    )
    from allworlds.studies.ambiguity.coarsenings import (
        AmbiguityWeakest as AmbiguityWeakest,
        weakest as weakest,
    )
    from allworlds.studies.ambiguity.members import (
        AmbiguityClass as AmbiguityClass,
        ComparedWorlds as ComparedWorlds,
        class_of as class_of,
        projection_of as projection_of,
        twins as twins,
    )
    from allworlds.studies.ambiguity.question import SearchRequest as SearchRequest
    from allworlds.studies.ambiguity.side_by_side import (
        AmbiguitySensors as AmbiguitySensors,
        sensors as sensors,
    )
    from allworlds.studies.ambiguity.solvers import (
        REQUIREMENTS as REQUIREMENTS,
        has_model_without as has_model_without,
    )
    from allworlds.studies.ambiguity.twin_search import (
        SearchResult as SearchResult,
        search as search,
    )
    from allworlds.world.bisimulation import sensed as sensed
else:
    open_door(__name__)
