"""Findings of mutants and of explorers made by hand, and what is told of them."""

from functools import cache

import pytest

from allworlds import Estimate, Move
from allworlds.corpus.explorers import WRONG_EXPLORERS
from allworlds.studies.check.exhaustive import check
from allworlds.studies.explain import explain
from allworlds.studies.run import run
from allworlds.world import Directional, World

MUTANTS = {mutant.name: mutant for mutant in WRONG_EXPLORERS}


@pytest.fixture(scope="session")
def finding_of():
    """The first finding of a mutant."""
    return cache(lambda name: check(MUTANTS[name].explorer(), edges=3).findings[0])


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
