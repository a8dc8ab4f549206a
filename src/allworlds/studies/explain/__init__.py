"""A finding in plain words, with a run that decides between two slips where that is needed."""

from typing import TYPE_CHECKING

from allworlds.lazy import open_door

if TYPE_CHECKING:
    from allworlds.judging import FindingWords as FindingWords
    from allworlds.studies.explain.explaining import (
        AskedExplanation as AskedExplanation,
        ExplainRequest as ExplainRequest,
        explain as explain,
    )
else:
    open_door(__name__)
