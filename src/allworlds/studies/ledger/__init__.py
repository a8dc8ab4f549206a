"""The ledger of a paper: its sentences that can be checked, each with the check that decides it.

``claim``
    what a function that decides a claim takes and returns, and the file of the claims, read;
``checked_claims``
    found beside expected: the report;
``skeleton``
    the files that ``init --ledger`` writes.
"""

from typing import TYPE_CHECKING

from allworlds.lazy import open_door

if TYPE_CHECKING:
    from allworlds.studies.ledger.checked_claims import (
        CheckedClaim as CheckedClaim,
        LedgerReport as LedgerReport,
        ledger as ledger,
    )
    from allworlds.studies.ledger.claim import (
        Found as Found,
        Means as Means,
        NotChecked as NotChecked,
        Picture as Picture,
        Unfinished as Unfinished,
        of_check as of_check,
        truth as truth,
    )
else:
    open_door(__name__)
