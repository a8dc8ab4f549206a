"""Explorers and rules as parts of a run directory's identity."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import fields
from typing import Any

from allworlds.explorers import Subject, content_digest, subject_known
from allworlds.inputs import as_json, meant
from allworlds.judging import Among, AskedRules, Rules


def parameters_of(request: object, rules: Rules) -> dict[str, Any]:
    """The request for the record, with the rules that follow from it and the explorer."""
    return {**meant(request), **rules_record(rules)}


def rules_record(rules: Rules) -> dict[str, Any]:
    """Record of those rules that may come from the explorer."""
    names = ("lighthouse", "step_budget", "promised", "own_bound", "shared_file")
    return {name: as_json(getattr(rules, name)) for name in names}


def rules_known(request: object, told: Mapping[str, Any]) -> Rules:
    """The rules of a request with this record."""
    names = [field.name for field in fields(AskedRules)]
    asked = {name: getattr(request, name) for name in names if hasattr(request, name)}
    asked["step_budget"] = told["step_budget"]
    kept = {name: told[name] for name in ("promised", "own_bound", "shared_file")}
    among = Among.of(getattr(request, "where", None))
    return Rules(told["lighthouse"], among=among, **kept, **asked)


def record_of(subject: Subject) -> dict[str, Any]:
    """Record of an explorer, identified by its content.

    Raises:
        InputError: if it cannot be.
    """
    return {
        "name": subject.name,
        "keywords": sorted(subject.keywords),
        "digest": content_digest(subject),
    }


def subject_of_record(told: Mapping[str, Any]) -> Subject:
    """The explorer of such a record. Its code is not loaded, because its results are known."""
    return subject_known(told["name"], told["keywords"])
