"""The answer of a robot that cannot know its world: the rooted quotient, and no other."""

from __future__ import annotations

from allworlds.judging.laws.case import Case, Violation
from allworlds.maps import Quotient, is_ambiguous, numbering, project
from allworlds.protocol import Ambiguous


def ambiguity_law(case: Case) -> Violation | None:
    """Require that an answer without a map is the rooted quotient of a world that has lookalikes.

    The percepts are one mark at the start's vertex, and the degree; lookalikes are counted
    among all maps, whatever the class that is checked.
    Cost: O(m log m).
    """
    answer = case.estimate
    if not isinstance(answer, Ambiguous):
        return None
    map_, v0 = case.map, case.map.vertex_of[case.start]
    marks = [int(vertex == v0) for vertex in map_.vertex_of]
    quotient, classes = project((map_, marks, case.start))
    # The criterion wants the root at v0; the robot may be elsewhere.
    if not is_ambiguous(quotient):
        return Violation(
            "ambiguity",
            "the map: no other world looks like this one",
            f"Ambiguous, {_words(_canonical(answer))}",
        )
    truth = _of(quotient.rerooted(classes[case.trail[-1]]))
    if _canonical(answer) == truth:
        return None
    return Violation("ambiguity", _words(truth), _words(_canonical(answer)))


def _of(quotient: Quotient) -> Ambiguous:
    marks = tuple([label for label in quotient.labels if isinstance(label, int)])
    return Ambiguous(quotient.sigma, quotient.alpha, quotient.degree, marks, 0)


def _canonical(answer: Ambiguous) -> Ambiguous:
    """The quotient with its darts numbered from ``here``."""
    order = numbering(answer.sigma, answer.alpha, answer.here)
    number = {q: i for i, q in enumerate(order)}
    return Ambiguous(
        tuple(number[answer.sigma[q]] for q in order),
        tuple(number[answer.alpha[q]] for q in order),
        tuple(answer.degree[q] for q in order),
        tuple(answer.marks[q] for q in order),
        0,
    )


def _words(answer: Ambiguous) -> str:
    """The rooted quotient in a sentence."""
    parts = (
        f"{name} {list(values)}"
        for name, values in (
            ("sigma", answer.sigma),
            ("alpha", answer.alpha),
            ("degree", answer.degree),
            ("marks", answer.marks),
        )
    )
    return f"the quotient rooted at 0 with {', '.join(parts)}"
