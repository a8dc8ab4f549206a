"""What is written about figures."""

from typing import Annotated

from allworlds.documents.common import ReportDocument
from allworlds.documents.vocabulary import Natural, Some, Text, VerdictName, code
from allworlds.outcome import Exit


class FigureDocument(ReportDocument):
    """Report of 'figure'."""

    verdict: Annotated[VerdictName, "whether what is drawn is so"]
    exit_code: Annotated[
        int,
        code(
            *(Exit.HOLDS, Exit.REFUTED, Exit.INCONCLUSIVE, Exit.VACUOUS, Exit.INTERNAL),
            Exit.INTERRUPTED,
        ),
    ]
    figure: Annotated[Text, "its name"]
    path: Annotated[Text, "the file of the picture"]
    data: Annotated[Text, "the file of its data, CSV"]
    caption: Annotated[list[Text], Some, "what is seen, a few sentences each"]
    columns: Annotated[list[Text], Some, "of the data"]
    rows: Annotated[Natural, "how many there are"]
