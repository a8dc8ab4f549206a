"""A function for each claim of ledger.toml: it finds a verdict, and reads no expected one."""

import sys
from pathlib import Path

sys.path.append(str(Path(__file__).parents[2] / "proofs"))

from algorithm import (
    direction_needed,
    every_schedule,
    lighthouse_suffices,
    marker_on_the_way,
    no_twins_smt,
    no_twins_with_direction,
    not_both,
    tests_decide,
    three_cases,
)
from beyond import (
    directional_not_minimal,
    door_minimal,
    door_suffices,
    powers_have_twins,
    primitive_words,
    weakest_sensors,
)
from complexity import (
    bound,
    bound_order,
    bound_polynomial,
    dfs_2m,
    every_edge_walked,
    lower_bound_2m,
    order_reached,
    pass_cost,
    pass_cost_all_schedules,
    pass_hypotheses,
    pass_kinds,
    pass_tests,
    pass_walk,
    printed_3,
    printed_limit_of_2,
    terms_left_out,
    vertices_first,
)
from correctness import (
    augmentations,
    edge_index,
    empty_U,
    invariant_at_start,
    invariant_kept,
    variant_falls,
)
from decided import certificate, theorem
from measured import (
    below_bound,
    gap_parts,
    means_above_2m,
)
from position import (
    cycles,
    elsewhere,
    fig1,
    fig1_caption,
    fig1_different,
    movable_marker,
    movable_marker_multigraphs,
    orientation_alone,
    position_not_enough,
    position_tells_cycles,
    two_door_rooms,
)
from readings import signature_readings
from two_vertices import (
    cluster,
    cluster_multigraphs,
    natural,
    natural_multigraphs,
    two_vertices_order,
)
from worlds_and_motions import (
    marker_tells_entry,
    motions_undone,
    orders_are_shifts,
)

cert_fig1 = certificate
cert_cycles = certificate
cert_no_twins_directional = certificate
cert_natural_lighthouse = certificate
coq_algorithm1 = theorem
coq_invariant = theorem
coq_tests = theorem
coq_bound = theorem
coq_no_information = theorem
coq_position = theorem
coq_laying = theorem
coq_cluster = theorem
coq_natural = theorem
coq_2m = theorem
