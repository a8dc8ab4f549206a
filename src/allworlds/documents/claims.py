"""What is written about claims: the ledger."""

from typing import Annotated, Literal, TypeAlias, TypedDict

from allworlds.documents.common import InRows
from allworlds.documents.vocabulary import Positive, Text, code
from allworlds.documents.worlds import WorldDocument
from allworlds.outcome import Exit

Shown: TypeAlias = int | float | str | list[int] | list[float] | list[str]


class ClaimEntry(TypedDict):
    """A sentence that can be checked, what is expected of it, and what was found."""

    id: Annotated[Text, "its name, for `--only` and `--require`"]
    section: Annotated[Text, "of the paper; `ours`: the sentence is not the paper's"]
    statement: Annotated[Text, "the sentence in short"]
    method: Annotated[Text, "how it is decided"]
    scope: Annotated[Text, "on what it was decided under this budget"]
    source: Annotated[Text, "where the sentence stands, and where the expected numbers come from"]
    expected: Annotated[
        Literal["holds", "refuted"], "the verdict that it must get; `refuted`: an erratum"
    ]
    verdict: Annotated[
        Literal["holds", "refuted", "vacuous", "not-checked"],
        "what was found; `vacuous`: a witness was never met",
    ]
    standing: Annotated[
        Literal["as-expected", "unexpected", "vacuous", "not-checked"],
        "whether verdict, witnesses and figures are those that are expected",
    ]
    witnesses: Annotated[dict[str, int], "how often each thing was met that the sentence is about"]
    expected_witnesses: Annotated[dict[str, Positive], "how often it must be met"]
    figures: Annotated[dict[str, Shown], "the numbers that the sentence names, as found"]
    expected_figures: Annotated[dict[str, Shown], "and as expected"]
    differences: Annotated[list[str], "what is not as expected, in words"]
    told: Annotated[str, "what refutes it, what is to be seen, or why it was not checked"]
    worlds: Annotated[list[WorldDocument], "worlds that show it"]


class ClaimsDocument(InRows):
    """Report of 'claims'."""

    exit_code: Annotated[
        int, code(Exit.HOLDS, Exit.REFUTED, Exit.INCONCLUSIVE, Exit.VACUOUS, Exit.INTERRUPTED)
    ]
    budget: Annotated[Literal["quick", "full"], "how much was done"]
    required: Annotated[list[str], "the claims that had to be checked"]
    claims: Annotated[list[ClaimEntry], "in the order of the sections; then ours"]
