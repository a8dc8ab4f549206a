"""Search by solvers for worlds that no motion tells apart; the only importer of z3 and pysat.

What comes out are plain values: maps, numbers and the paths of files.
"""

from allworlds.smt.twin_search import Searched, SearchResult, search
from allworlds.smt.witness import MarkedMap

__all__ = ["MarkedMap", "SearchResult", "Searched", "search"]
