"""The ledger: the sentences of the paper that can be checked, and our own, each with its check.

``claims.toml``, ``manifest``
    what is claimed, in words, and which verdict and which numbers must come out;
``found``
    what these functions take and hand back;
``model``, ``position``, ``algorithm``, ``correctness``, ``complexity``, ``measured``,
``lighthouses``
    what decides the sentences of Sections II to VIII, one small function a claim;
``passes``
    Algorithm 1 taken apart, pass by pass;
``folds``, ``ambiguous``, ``limits``
    what decides our own;
``machine``
    certificates and proofs in Coq, where they are at hand;
``table``
    ``CHECKS``: all these functions by the ids of the claims;
``entries``
    found beside expected: the report.
"""

from allworlds.ledger.entries import ClaimsReport, Entry, claims, entered
from allworlds.ledger.found import Budget, Found, Means, NotChecked, Picture
from allworlds.ledger.manifest import SECTIONS, Claim, Scope, manifest

__all__ = [
    "SECTIONS",
    "Budget",
    "Claim",
    "ClaimsReport",
    "Entry",
    "Found",
    "Means",
    "NotChecked",
    "Picture",
    "Scope",
    "claims",
    "entered",
    "manifest",
]
