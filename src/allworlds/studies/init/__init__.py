"""Files to begin with, ``beginning``: a skeleton of an explorer or ledger, or the C header."""

from typing import TYPE_CHECKING

from allworlds.lazy import open_door

if TYPE_CHECKING:
    from allworlds.studies.init.beginning import (
        Header as Header,
        LedgerSkeleton as LedgerSkeleton,
        Skeleton as Skeleton,
        init as init,
    )
else:
    open_door(__name__)
