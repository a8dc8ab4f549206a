"""A check as a run directory knows it: what it depends on, its units, its confirmed findings."""

from __future__ import annotations

import hashlib
from collections.abc import Callable
from dataclasses import dataclass, fields, replace
from functools import partial
from typing import Any

from allworlds.engines import (
    ENGINES,
    EngineKind,
    Identity,
    Job,
    KeptUnits,
    Limits,
    Listener,
    ReadyEngine,
    Records,
    Sample,
    Scope,
    Tally,
    ThisThread,
    Whole,
    canonical,
    finding_from_record,
    finding_to_record,
    shelf,
)
from allworlds.explorers import Subject, content_digest, subject_known
from allworlds.judging import Finding, Rules
from allworlds.maps import Extent, MapClass

VERB = "check"


def identity_of(job: Job, engine: str) -> Identity:
    """Everything that the report of a check depends on.

    Raises:
        InputError: if the explorer cannot be told by its content.
    """
    scope, subject = job.scope, job.subject
    rules = {f.name: getattr(scope.rules, f.name) for f in fields(Rules)}
    parameters = {
        "class": scope.extent.map_class.value,
        "edges": scope.extent.edges,
        "vertices": scope.extent.vertices,
        **{
            name: list(value) if name == "laws" and value else value
            for name, value in rules.items()
        },
        "schedules": scope.schedules,
        "engine": engine,
        "max_findings": job.keep,
        "answer_timeout": job.limits.answer_timeout,
        "memory": job.limits.memory,
    }
    explorer = {
        "name": subject.name,
        "keywords": sorted(subject.keywords),
        "digest": content_digest(subject),
    }
    assert not isinstance(scope.coverage, Sample)
    shard = str(scope.coverage)
    return Identity(verb=VERB, parameters=parameters, explorer=explorer, shard=shard)


def job_of(identity: Identity, listener: Listener) -> tuple[Job, EngineKind]:
    """The whole check whose shards have this identity; nothing is left to be done in it.

    The explorer is not looked for: what it has done is known.
    """
    told = dict(identity.parameters)
    rules = {f.name: told[f.name] for f in fields(Rules)}
    if rules["laws"] is not None:
        rules["laws"] = tuple(rules["laws"])
    extent = Extent(MapClass(told["class"]), told["edges"], told["vertices"])
    subject = subject_known(identity.explorer["name"], identity.explorer["keywords"])
    limits = Limits(answer_timeout=told["answer_timeout"], memory=told["memory"])
    scope = Scope(extent, Rules(**rules), told["schedules"], Whole())
    job = Job(scope, subject, limits, told["max_findings"], None, listener.notice)
    return job, NothingLeft(ENGINES[told["engine"]], told["engine"])


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
