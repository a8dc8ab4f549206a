"""The records of the demand-driven check, and of the search over schedules."""

from __future__ import annotations

from numpy import dtype, int64, uint8

from allworlds.engines.kernel.records import DARTS, DEPTHS, GLUING, WORLD

WALKED = 80
"""Room for more than the darts of a world, so that a robot that errs stays in its buffers."""

NOW = dtype(
    [
        # Where the walk stands, and the dart that it is about to cross.
        ("stage", uint8),
        ("y", uint8),
        # The world W: its open darts, and how many darts and vertices there are.
        ("open", int64),
        ("darts", uint8),
        ("vertices", uint8),
        # The robot's S: how many darts and vertices; its U; which vertices of W are in it; for
        # each vertex its distance to v0 and the first dart that leads nearer, packed.
        ("s_darts", uint8),
        ("s_vertices", uint8),
        ("unexplored", int64),
        ("in_s", int64),
        ("level", int64),
        ("parent", int64),
        ("position", uint8),
        ("passes", uint8),
        # The pass: the dart e, what it led to, the hypotheses left, the one tested, the steps
        # of the test, and the dart in which the next one should end.
        ("e", uint8),
        ("x", uint8),
        ("hypotheses", int64),
        ("candidate", uint8),
        ("steps", uint8),
        ("t", uint8),
        # The cost and the counters of the walk, packed.
        ("total", int64),
    ],
    align=True,
)
"""The state to which a walk goes back to decide a dart in another way."""

CHOICE = dtype([("untried", int64), ("degree", int64), ("now", NOW)], align=True)
"""A dart that must be decided: partners and degrees to be tried, and the walk up to there."""

WALK = dtype(
    [
        ("now", NOW),
        ("edges", int64),
        ("limit", int64),
        ("policy", int64),
        ("fuel", int64),
        ("back_weight", int64),
        ("bound", int64, DARTS),
        ("viable", uint8, (DARTS, 2 * DARTS)),
        ("sensed", uint8, DARTS),
        # What has been met: worlds, and by vertices what they have shown.
        ("worlds", int64),
        ("counts", int64, (DARTS, DEPTHS)),
        # W, by darts: the partner, the vertex, the degree there as it is and as it is sensed,
        # and the dart behind the last one of the vertex.  The degrees of the vertices.
        ("partner", uint8, WALKED),
        ("owner", uint8, WALKED),
        ("degree", uint8, WALKED),
        ("felt", uint8, WALKED),
        ("end", uint8, WALKED),
        ("degrees", uint8, WALKED),
        # S, by darts: the partner, the vertex, the degree that is expected there, the image in
        # W.  By vertices: the darts, and the vertices joined to each.  By degrees: the darts.
        ("s_partner", uint8, WALKED),
        ("s_owner", uint8, WALKED),
        ("s_degree", uint8, WALKED),
        ("image", uint8, WALKED),
        ("own", int64, WALKED),
        ("of_degree", int64, WALKED),
        ("adjacent", int64, WALKED),
        # The two ends of the edge that each pass has added to S.
        ("one_end", uint8, WALKED),
        ("other_end", uint8, WALKED),
        # The decisions that can still be taken otherwise.
        ("depth", int64),
        ("choices", CHOICE, WALKED),
        # Room for a world that is to be blamed.
        ("world", WORLD),
    ],
    align=True,
)
"""Algorithm 1 on its way through all worlds at once."""


SCHEDULES = dtype(
    [
        ("gluing", GLUING),
        ("world", WORLD),
        ("transit", int64),
        # By darts: the number of the edge; the most expensive and the cheapest way to go on.
        ("edge_of", int64, DARTS),
        ("most", int64, DARTS),
        ("least", int64, DARTS),
        # By vertices: those joined in S, and lengths of paths.
        ("adjacent", int64, DARTS),
        ("near", int64, DARTS),
        ("far", int64, DARTS),
        # A path on its way, and its ends: steps until a mismatch.
        ("at", int64, DARTS),
        ("robot", int64, DARTS),
        ("turned", int64, DARTS),
        ("visited", int64, DARTS),
        ("shortest", int64),
        ("longest", int64),
        # Different tests, and those of a false hypothesis that matched.
        ("tests", int64),
        ("wrong", int64),
    ],
    align=True,
)
"""All schedules in one world after the other."""
