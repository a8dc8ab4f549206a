import pytest

from allworlds.judging.findings.finding import Finding
from allworlds.studies.run import replay
from small import slowest
from world import test_corpus as quick
from world.test_corpus import CORPUS, entries


@pytest.mark.parametrize("most", [slowest(6)])
@entries("counts")
def test_the_enumeration_gives_the_known_numbers(entry, most):
    quick.test_the_enumeration_gives_the_known_numbers(entry, most)


@pytest.mark.usefixtures("without_workers")
@entries("finding")
def test_a_finding_is_reproduced_by_its_mutant_to_the_letter(entry):
    finding = Finding.from_json(CORPUS.document(entry))
    replayed = replay(finding)
    assert replayed.outcome == entry.expected["outcome"]
    again = replayed.again.finding
    assert again.law == finding.law == entry.expected["law"]
    assert again.world == finding.world
    if finding.law != "nondeterministic":
        # What such an explorer does depends on what it did before.
        assert again.transcript == finding.transcript
        assert (again.expected, again.seen) == (finding.expected, finding.seen)
