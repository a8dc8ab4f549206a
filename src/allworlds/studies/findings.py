"""The part of a request that is a finding.

In Python the part is the finding itself (:class:`FindingOptions`); the command line has a file and
a number in its place (:class:`FindingWords`).
"""

from typing import Annotated, NamedTuple

from allworlds.inputs.checks import InputError, in_file, integer_of, parse_json, read_text
from allworlds.inputs.requests import SCOPE, Argument, Option, OptionGroup, Request
from allworlds.judging.findings.finding import Finding, findings_of
from allworlds.robots.team_finding import TeamFinding, is_of_team


class ChosenFinding(NamedTuple):
    """A finding, its number in a report (from 1 on), and the number of findings in the report."""

    finding: Finding | TeamFinding
    number: int = 1
    findings: int = 1


class FindingWords(Request):
    """The argument and the option of the command line that name a finding: a file and a number."""

    file: Annotated[str, Argument("", "FILE", "A finding, or a check's report; - for stdin.")]
    number: Annotated[
        int,
        Option(
            SCOPE, "K", "Which finding of a report: 1 is the smallest.", "finding", parse=integer_of
        ),
    ] = 1

    def chosen(self) -> ChosenFinding:
        """The finding with the number ``number`` in the file, and how many findings there are.

        Raises:
            InputError: naming the file, the offending value in it, or the number.
        """
        document = parse_json(read_text(self.file), file=self.file)
        with in_file(self.file):
            found = findings_of(document)
        if not 1 <= self.number <= len(found):
            holds = f"findings 1 to {len(found)}" if len(found) > 1 else "1 finding"
            raise InputError(f"finding = {self.number} is not there: the file holds {holds}")
        with in_file(self.file):
            chosen = found[self.number - 1]
            kind = TeamFinding if is_of_team(chosen) else Finding
            finding = kind.from_json(chosen)
        return ChosenFinding(finding, self.number, len(found))

    def value(self) -> Finding | TeamFinding:
        """The chosen finding alone, without its number."""
        return self.chosen().finding


class FindingOptions(Request, kw_only=False):
    """The part of a request that is a finding.

    On the command line the arguments of :class:`FindingWords`, a file and a number, name it.
    """

    finding: Annotated[Finding | TeamFinding, OptionGroup(FindingWords, "the finding")]
