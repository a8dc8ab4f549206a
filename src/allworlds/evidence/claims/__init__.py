"""The ledger: checkable sentences of the paper, and of this project, each with its check.

``claims.toml``, ``manifest``
    what is claimed, in words, and which verdict and which numbers must come out;
``claim_types``
    what these functions take and hand back;
``model``, ``position``, ``algorithm``, ``correctness``, ``complexity``, ``measured``,
``lighthouses``
    what decides the sentences of Sections II to VIII, one small function a claim;
``passes``
    Algorithm 1 taken apart, pass by pass;
``folds``, ``ambiguous``, ``limits``, ``corridors``
    what decides our own;
``machine``
    certificates and proofs in Coq, where they are at hand;
``claim_table``
    ``CHECKS``: all these functions by the ids of the claims;
``ledger``
    found beside expected: the report;
``claims_telling``
    what the report says.
"""

from typing import TYPE_CHECKING

from allworlds.lazy import open_door

if TYPE_CHECKING:
    from allworlds.evidence.claims.ledger import claims as claims
else:
    open_door(__name__)
