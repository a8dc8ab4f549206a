"""A check as a run directory knows it: what it depends on, its units, its confirmed findings."""

from __future__ import annotations

import hashlib
from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import partial
from typing import Any

from allworlds.engines import (
    ENGINES,
    EngineKind,
    Identity,
    Job,
    KeptUnits,
    Listener,
    ReadyEngine,
    Records,
    Sample,
    Scope,
    Tally,
    ThisThread,
    canonical,
    finding_from_record,
    finding_to_record,
    shelf,
)
from allworlds.explorers import Subject, content_digest, subject_known
from allworlds.inputs import meant, remembered, values_of
from allworlds.judging import AskedRules, Finding, Rules
from allworlds.studies.check.requests import CheckRequest

VERB = "check"


def identity_of(request: CheckRequest, job: Job, engine: str) -> Identity:
    """Everything that the report of a check depends on.

    Raises:
        InputError: if the explorer cannot be told by its content.
    """
    scope, subject, rules = job.scope, job.subject, job.scope.rules
    decided = replace(
        request,
        edges=scope.extent.edges,
        lighthouse=rules.lighthouse,
        step_budget=rules.step_budget,
        engine=engine,
    )
    brought = {"promised": rules.promised, "own_bound": rules.own_bound}
    explorer = {
        "name": subject.name,
        "keywords": sorted(subject.keywords),
        "digest": content_digest(subject),
    }
    assert not isinstance(scope.coverage, Sample)
    shard = str(scope.coverage)
    parameters = {**meant(decided), **brought}
    return Identity(verb=VERB, parameters=parameters, explorer=explorer, shard=shard)


def job_of(identity: Identity, listener: Listener) -> tuple[Job, EngineKind]:
    """The whole check whose shards have this identity; nothing is left to be done in it.

    The explorer is not looked for: what it has done is known.
    """
    told = identity.parameters
    request = CheckRequest(**remembered(CheckRequest, told))
    asked = values_of(AskedRules, request)
    rules = Rules(
        told["lighthouse"], promised=told["promised"], own_bound=told["own_bound"], **asked
    )
    subject = subject_known(identity.explorer["name"], identity.explorer["keywords"])
    scope = Scope(request.extent, rules, request.schedules)
    keep, limits = request.max_findings, request.limits
    job = Job(scope, subject, limits, keep, None, listener.notice)
    return job, NothingLeft(ENGINES[request.engine], request.engine)


@dataclass(slots=True)
class NothingLeft:
    """An engine that has nothing left to do.

    Attributes:
        engine: the one that has done it.
        name: of that one.
    """

    engine: EngineKind
    name: str

    def symmetry(self, scope: Scope, subject: Subject) -> str:
        """As of that engine."""
        return self.engine.symmetry(scope, subject)

    def obstacle(self, scope: Scope, subject: Subject) -> str:  # noqa: ARG002  # it is done
        """None."""
        return ""

    def ready(self, job: Job) -> ReadyEngine:  # noqa: ARG002  # it is done
        """A transport by which no unit ever goes."""
        return ReadyEngine(ThisThread(), None)


def shelf_for(records: Records, job: Job) -> KeptUnits:
    """The records of a check as tallies."""
    return shelf(records, partial(Tally.from_json, keep=job.keep, rules=job.scope.rules))


def settled_once(
    found: Finding, rules: Rules, records: Records, settle: Callable[[Finding], Finding | str]
) -> Finding | str:
    """What has become of a finding in fresh processes: itself, confirmed or not, or a remark.

    What is on record is believed, so that a finding is the same whoever reports it.
    """
    plain = replace(found, minimal=False)
    name = "confirmed " + hashlib.sha256(canonical(finding_to_record(plain)).encode()).hexdigest()
    told: Any = records.recall(name)
    if told is None:
        settled = settle(plain)
        if isinstance(settled, str):
            told = {"remark": settled}
        else:
            told = {"finding": finding_to_record(settled)}
        records.note(name, told)
    if "remark" in told:
        return str(told["remark"])
    return replace(finding_from_record(told["finding"], rules), minimal=found.minimal)
