"""A function for each claim of ledger.toml: it finds a verdict, and reads no expected one."""

import sys
from pathlib import Path

HERE = Path(__file__).parent
sys.path.append(str(HERE.parents[1] / "proofs"))

from allworlds.claims import Found, Means, NotChecked
from decided import certificate, theorem, theorems_in
from logs import entries_of_v0, folding_explores, logs_fold, open_before_the_end, path_lower_bound
from lookalikes import (
    class_sizes,
    counts,
    criterion,
    lookalikes_one_size,
    mass_formula,
    two_sheets,
)
from optima import (
    bouquet_minimax,
    greedy_never_more,
    never_forgetting_in_bound,
    optimum,
    remembering_never_more,
)
from testers import every_explorer_mn_log, order_exact
from twins_and_markers import (
    cycle_needs_information,
    markers_at_one_vertex,
    position_robot,
    smallest_planar_simple_twins,
    smallest_simple_twins,
    smallest_twins,
    trees_need_none,
)
from worst_case import exact_worst

cert_smallest_pairs = certificate
coq_cycles_needed = theorem
coq_folding = theorem
coq_lower_bounds = theorem
coq_checker = theorem
coq_shield = theorem
coq_mass_formula = theorem
coq_certificates = theorem


def _of_this_paper(means: Means, *, names: list[str]) -> Found | NotChecked:
    """Check theorems of the proofs in the folder ``coq`` beside this file."""
    return theorems_in(means, HERE / "coq", names)


coq_bouquets = coq_corridors = _of_this_paper
