"""The question of a search, made in one line."""

from allworlds.studies.ambiguity import SearchRequest
from allworlds.studies.ambiguity.question import question_of


def question(lighthouse, map_class, vertices, edges, **more):
    """The question of these names and numbers."""
    bounds = {"map_class": map_class, "vertices": vertices, "edges": edges}
    return question_of(SearchRequest(lighthouse=lighthouse, **bounds, **more))
