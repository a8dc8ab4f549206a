"""The first finding of each wrong explorer, which many tests speak of: it is looked for once."""

from functools import cache

from allworlds.corpus.explorers import WRONG_EXPLORERS
from allworlds.studies.check.exhaustive import check

MUTANTS = {mutant.name: mutant for mutant in WRONG_EXPLORERS}


@cache
def finding_of(name):
    return check(MUTANTS[name].explorer(), edges=3).findings[0]
