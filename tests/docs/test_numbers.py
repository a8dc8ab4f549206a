"""Numbers in the prose of the pages, against the program that they are about."""

import re
from pathlib import Path

import pytest

from allworlds.cli import output
from allworlds.corpus.explorers import EQUIVALENT_EXPLORERS, WRONG_EXPLORERS, WRONG_LEARNERS
from allworlds.engines import batch, players
from allworlds.engines.compiled_engine import AGREEMENT_EDGES
from allworlds.engines.kernel import capabilities
from allworlds.explorers import program
from allworlds.explorers.program import SAYINGS
from allworlds.explorers.shared_library import INTERFACE_VERSION
from allworlds.judging.laws.law_table import PRECEDENCE
from allworlds.reports.web import sections as frame
from enumerators import BROKEN_ENUMERATORS
from errands import WEAK_TASK_JUDGES, WRONG_ERRANDS
from judges import WEAK_JUDGES

ROOT = Path(__file__).parents[2]
NUMBERS = {"fifteen": 15}
TABLES = (
    WRONG_EXPLORERS,
    WRONG_LEARNERS,
    WRONG_ERRANDS,
    WEAK_TASK_JUDGES,
    EQUIVALENT_EXPLORERS,
    WEAK_JUDGES,
    BROKEN_ENUMERATORS,
)
"""The mutants that the kill matrix tries."""


def told(page, pattern):
    """The one number of a page that stands where the pattern has its group."""
    text = " ".join((ROOT / "docs" / page).read_text(encoding="utf-8").split())
    (found,) = re.findall(pattern, text)
    return NUMBERS.get(found) or int(found.replace(",", ""))


def test_the_page_of_proofs_says_how_many_mutants_there_are():
    assert told("how-to/certificate.md", r"tries (\d+) wrong explorers") == sum(map(len, TABLES))


@pytest.mark.parametrize(
    ("page", "pattern", "number"),
    [
        ("glossary.md", r"there are \[(\w+)\]\(verdicts.md#laws\)", len(PRECEDENCE)),
        ("verdicts.md", r"every class, up to (\d+) edges", capabilities.MOST_EDGES),
        ("how-to/bound.md", r"The engine has room for (\d+) edges", capabilities.MOST_EDGES),
        ("verdicts.md", r"In worlds with up to (\d+) edges each run", AGREEMENT_EDGES),
        ("verdicts.md", r"step budgets \| up to ([\d,]+)", capabilities.MOST_BUDGET),
        ("verdicts.md", r"one line of at most (\d+) characters", output.LONGEST),
        ("verdicts.md", r"is smaller than (\d+) MB", frame.LARGEST // 1_000_000),
        ("trust.md", r"`PYTHONHASHSEED` 0, the second (\d)", batch.SECOND),
        (
            "how-to/languages.md",
            r"law of the protocol its last (\d) KiB",
            program.STDERR_KEPT >> 10,
        ),
        ("how-to/languages.md", r"a line of more than (\d+) MiB", program.LONGEST_LINE >> 20),
        ("how-to/languages.md", r"more memory than (\d) GB", players.NATIVE_MEMORY >> 10),
        ("how-to/languages.md", r"`ALLWORLDS_VERSION` (\d) \|", INTERFACE_VERSION),
    ],
)
def test_a_limit_in_the_prose_is_that_of_the_program(page, pattern, number):
    assert told(page, pattern) == number


def test_the_page_of_verdicts_names_the_lighthouses_of_the_compiled_engine():
    page = (ROOT / "docs/verdicts.md").read_text(encoding="utf-8")
    (told,) = re.findall(r"^\| lighthouses \| (.*) \|$", page, re.MULTILINE)
    named = re.findall(r"`([^`]+)`", told)
    assert sorted(named) == sorted(capabilities.LIGHTHOUSES - {"cluster-single"})


def test_the_page_of_languages_has_each_line_that_a_program_may_say():
    page = (ROOT / "docs/how-to/languages.md").read_text(encoding="utf-8")
    table = page.partition("### The lines")[2].partition("\n\n- ")[0]
    rows = [row.split("|")[1] for row in table.splitlines() if "| from the program |" in row]
    assert {name for row in rows for name in re.findall(r'`\{"(\w+)"', row)} == {*SAYINGS}
