"""Findings of mutants and of explorers made by hand, and what is told of them."""

import pytest

from allworlds import Estimate, Move
from allworlds.studies.explain import explain
from allworlds.studies.run import run
from allworlds.world import Directional, World
from mutant_findings import finding_of as first_finding_of


@pytest.fixture(scope="session")
def finding_of():
    """The first finding of a mutant."""
    return first_finding_of


@pytest.fixture
def told(finding_of):
    """Law, step and text of a mutant's finding."""

    def law_step_and_text(name):
        explanation = explain(finding_of(name))
        return explanation.law, explanation.step, " ".join(explanation.sentences)

    return law_step_and_text


@pytest.fixture
def answering():
    """An explorer that walks and answers whatever it senses."""

    def explorer(map_, here, *motions):
        def explore(first):
            for k in motions:
                yield Move(k)
            return Estimate(map_, here)

        return explore

    return explorer


@pytest.fixture
def explained():
    """A function that explains an explorer's finding in a map with the lighthouse at dart 0."""
    return lambda map_, explore: explain(run(explore, World(map_, Directional(0))).finding)
