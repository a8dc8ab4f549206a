"""The schemas against real documents, and against the same documents spoilt."""

import copy
import functools
import json
import tempfile
from pathlib import Path

import pytest
from jsonschema import Draft202012Validator

from allworlds import Move
from allworlds.corpus.explorers import WRONG_EXPLORERS
from allworlds.documents.document import replace
from allworlds.maps import named_map
from allworlds.outcome import Interrupted
from allworlds.studies.ambiguity import census, class_of, search, sensors, twins, weakest
from allworlds.studies.check.exhaustive import check
from allworlds.studies.compare.comparison import compare
from allworlds.studies.convert import convert
from allworlds.studies.count import count
from allworlds.studies.explain import explain
from allworlds.studies.fuzz.sample_sweep import fuzz
from allworlds.studies.init import init
from allworlds.studies.ledger import ledger
from allworlds.studies.merge import merge, status
from allworlds.studies.run import play, replay, run
from allworlds.studies.team.search_sweep import team
from allworlds.studies.worst.all_worlds import worst
from allworlds.verbs import VERBS
from allworlds.world import LIGHTHOUSES, Directional, Position, World, worlds
from allworlds.world.named import own_corpus
from mutant_findings import finding_of
from recorded.record import least
from schemas.rules import RULES, broken
from schemas.validating import SCHEMAS, complaints

pytestmark = pytest.mark.usefixtures("compiled")

WRONG = {mutant.name: mutant for mutant in WRONG_EXPLORERS if mutant.name != "confirmed-too-early"}
PLANTRI = Path(__file__).parents[1] / "support" / "data" / "plantri"
RECORDED = Path(__file__).parents[1] / "recorded"
PAPER = Path(__file__).parents[2] / "papers" / "minimal_information"
THETA = named_map("theta")


def whole(name):
    """The reference to a schema, or to a part of one as NAME#PART."""
    file, hash_, part = name.partition("#")
    return f"{file}.schema.json{hash_}{part}"


FINDING, WORLD = "check#/$defs/Finding", "explain#/$defs/WorldDocument"
"""What is written; the schemas ``finding`` and ``world`` are of what is read."""


def interrupted():
    report = check(edges=3)
    return replace(report, ending=Interrupted()).to_json()


def placed(kind):
    """A world with a lighthouse of that kind: the smallest that has a place for it."""
    return next(worlds(edges=4, lighthouse=kind))


def marked(name):
    return World(named_map(name), Position(0))


def searched(**bounds):
    """A search for two worlds alike; a test that is asked for it needs z3."""
    pytest.importorskip("z3")
    return search(lighthouse="position", **bounds).to_json()


@functools.cache
def manifest():
    return json.loads((own_corpus().directory / "manifest.json").read_text(encoding="utf-8"))


def kept(verb):
    """The document that a verb makes of a run directory."""
    with tempfile.TemporaryDirectory() as directory:
        check(edges=2, run=directory)
        return verb(directory).to_json()


def skeleton():
    with tempfile.TemporaryDirectory() as directory:
        return init(directory).to_json()


def begun_ledger():
    with tempfile.TemporaryDirectory() as directory:
        return init(f"{directory}/paper", ledger=True).to_json()


def back_and_forth():
    """A player of two motions."""
    actions = iter([Move(1), Move(0), None])
    return lambda percept, refused: next(actions)


DOCUMENTS = {
    "check holds": (whole("check"), lambda: check(edges=2).to_json()),
    "check of a class": (whole("check"), lambda: check(vertices=3, map_class="simple").to_json()),
    "check of a shard": (whole("check"), lambda: check(edges=2, shard=(0, 2)).to_json()),
    "check without a bound": (whole("check"), lambda: check(edges=2, bound="none").to_json()),
    "check interrupted": (whole("check"), interrupted),
    **{
        f"{name} interrupted": (
            whole(name),
            lambda ask=ask: replace(ask(), ending=Interrupted()).to_json(),
        )
        for name, ask in {
            "count": lambda: count(edges=2),
            "worst": lambda: worst(edges=2),
            "ambiguity-census": lambda: census(edges=2),
        }.items()
    },
    "check refuted": (
        whole("check"),
        lambda: check(WRONG["mirror-image"].explorer(), edges=3, max_findings=3).to_json(),
    ),
    "compare": (whole("compare"), lambda: compare("algorithm1", "folding", edges=2).to_json()),
    "growth": (whole("growth"), lambda: compare("algorithm1", family="strip", to=30).to_json()),
    "compare in a family": (
        whole("compare"),
        lambda: compare("algorithm1", "folding", family="cycle:4").to_json(),
    ),
    "compare refuted": (
        whole("compare"),
        lambda: compare("folding", WRONG["mirror-image"].explorer(), edges=3).to_json(),
    ),
    "fuzz": (whole("check"), lambda: fuzz(edges=6, runs=3).to_json()),
    "fuzz refuted": (
        whole("check"),
        lambda: fuzz(WRONG["pose-lost"].explorer(), edges=6, runs=3).to_json(),
    ),
    "count": (whole("count"), lambda: count(edges=3).to_json()),
    "convert": (whole("convert"), lambda: convert(PLANTRI / "tri6.pl").to_json()),
    "init": (whole("init"), skeleton),
    "init of a ledger": (whole("ledgerskeleton"), begun_ledger),
    "play": (whole("play"), lambda: play("theta", player=back_and_forth()).to_json()),
    "header": (whole("header"), lambda: init(header=True).to_json()),
    "count simple": (whole("count"), lambda: count(vertices=4, map_class="simple").to_json()),
    "run": (whole("run"), lambda: run("algorithm1", World(THETA, Directional(0))).to_json()),
    "run refuted": (
        whole("run"),
        lambda: run(WRONG["mirror-image"].explorer(), finding_of("mirror-image").world).to_json(),
    ),
    "run without an answer": (
        whole("run"),
        lambda: run(WRONG["no-answer"].explorer(), World(THETA, Directional(0))).to_json(),
    ),
    "replay fixed": (
        whole("replay"),
        lambda: replay(finding_of("mirror-image"), "algorithm1").to_json(),
    ),
    "replay reproduced": (
        whole("replay"),
        lambda: replay(finding_of("mirror-image"), WRONG["mirror-image"].explorer()).to_json(),
    ),
    "ledger": (
        whole("ledger"),
        lambda: ledger(PAPER, only=["fig1", "printed-3", "bound-polynomial", "coq-2m"]).to_json(),
    ),
    "manifest": (whole("manifest"), manifest),
    "worst": (whole("worst"), lambda: worst(edges=2).to_json()),
    "every schedule": (
        whole("check"),
        lambda: check(edges=2, schedules="all").to_json(),
    ),
    "team": (whole("team"), lambda: met("central").to_json()),
    "team refuted": (whole("team"), lambda: met("fsync").to_json()),
    "team cut off": (whole("team"), lambda: met("fsync", "walks_for_ever", budget=3).to_json()),
    "replay of a team": (
        whole("teamreplay"),
        lambda: replay(met("async").findings[0]).to_json(),
    ),
    "explain a team": (
        whole("teamexplanation"),
        lambda: explain(met("async").findings[0]).to_json(),
    ),
    "worst of a shard": (whole("worst"), lambda: worst(edges=2, shard=(0, 2)).to_json()),
    "census of a shard": (
        whole("ambiguity-census"),
        lambda: census(edges=2, shard=(0, 2)).to_json(),
    ),
    "merge": (whole("merge"), lambda: kept(merge)),
    "status": (whole("status"), lambda: kept(status)),
    "worst of a class": (
        whole("worst"),
        lambda: worst(edges=2, map_class="simple", transit="shortest").to_json(),
    ),
    "twins told apart": (
        whole("twins"),
        lambda: twins(marked("cycle-3"), marked("cycle-4")).to_json(),
    ),
    "twins of other degrees": (
        whole("twins"),
        lambda: twins(marked("k4"), marked("wheel-4")).to_json(),
    ),
    "twins alike": (
        whole("twins"),
        lambda: twins(*class_of(marked("k4"), map_class="simple").worlds).to_json(),
    ),
    "twins that are one": (whole("twins"), lambda: twins(marked("k4"), marked("k4")).to_json()),
    "ambiguity class": (whole("ambiguity-class"), lambda: class_of(marked("k4")).to_json()),
    "ambiguity class cut short": (
        whole("ambiguity-class"),
        lambda: class_of(marked("k4"), limit=1).to_json(),
    ),
    "ambiguity class of one": (
        whole("ambiguity-class"),
        lambda: class_of(marked("cycle-3")).to_json(),
    ),
    "ambiguity census": (whole("ambiguity-census"), lambda: census(edges=3).to_json()),
    "ambiguity sensors": (
        whole("ambiguity-sensors"),
        lambda: sensors("position", "door", "word:12", edges=3).to_json(),
    ),
    "ambiguity weakest": (
        whole("ambiguity-weakest"),
        lambda: weakest(f"{RECORDED}/features.py:Ends", edges=3).to_json(),
    ),
    "search sat": (whole("search"), lambda: searched(vertices=2, edges=2)),
    "search unsat": (whole("search"), lambda: searched(vertices=2, edges=1)),
    "search vacuous": (
        whole("search"),
        lambda: searched(vertices=1, edges=1, map_class="simple"),
    ),
    **{
        f"finding {name}": (
            whole(FINDING),
            functools.partial(lambda name: finding_of(name).to_json(), name),
        )
        for name in WRONG
    },
    **{
        f"explain {name}": (
            whole("explain"),
            functools.partial(lambda name: explain(finding_of(name)).to_json(), name),
        )
        for name in ("mirror-image", "no-retracing", "crashes-at-leaves")
    },
    **{
        f"world {kind}": (
            whole(WORLD),
            functools.partial(lambda kind: placed(kind).to_json(), kind),
        )
        for kind in LIGHTHOUSES
    },
    "transcript": (
        whole("transcript"),
        lambda: [*finding_of("mirror-image").transcript.to_json()],
    ),
}


def met(scheduler, program="other_end", **options):
    """Two robots on small maps."""
    return team(f"{RECORDED}/explorers.py:{program}", scheduler=scheduler, edges=1, **options)


@functools.cache
def document(name):
    reference, make = DOCUMENTS[name]
    return reference, make()


@pytest.mark.parametrize("name", SCHEMAS)
def test_every_schema_is_one(name):
    schema = SCHEMAS[name]
    Draft202012Validator.check_schema(schema)
    assert schema["$schema"] == "https://json-schema.org/draft/2020-12/schema"
    assert schema["$id"] == f"{name}.schema.json"


@pytest.mark.parametrize("name", DOCUMENTS)
def test_what_is_written_is_what_the_schema_says(name):
    reference, found = document(name)
    assert wrongs(reference, found) == []


def wrongs(reference, document):
    """The faults of a document by its schema, or, if there are none, by the rules between keys."""
    name = reference.replace(".schema.json", "").removesuffix("#")
    return complaints(reference, document) or broken(name, document)


# A document, what is changed in it, and the rule that it breaks then; "" for the schema itself.
WRONG_VALUES = [
    ("check holds", {"schema": 1}, ""),
    ("check holds", {"verdict": "verified"}, ""),
    ("check holds", {"exit_code": 6}, ""),
    ("check holds", {"worlds": -1}, ""),
    ("check holds", {"witnesses": {"loop": "many"}}, ""),
    ("check holds", {"verdict": "refuted", "exit_code": 1}, "refuted is what has a finding"),
    ("check holds", {"verdict": "inconclusive"}, "the exit code is the verdict's, unless it was"),
    ("check holds", {"verdict": "not-refuted"}, "not-refuted is a sample, and so not complete"),
    ("check refuted", {"verdict": "holds", "exit_code": 0}, "what has a finding is refuted, or an"),
    ("run", {"verdict": "refuted", "exit_code": 1}, "refuted is what has a finding"),
    ("run refuted", {"finding": None}, "refuted is what has a finding"),
    ("run", {"exit_code": 1}, "the exit code is the verdict's"),
    ("replay fixed", {"exit_code": 0}, "the exit code is the outcome's"),
    ("replay reproduced", {"law_now": None}, "reproduced is what breaks a law now"),
    ("finding mirror-image", {"law": "maps"}, ""),
    ("finding mirror-image", {"version": 1}, ""),
    ("finding mirror-image", {"seen": "a mirror image"}, "map and pose speak of rooted maps"),
    ("finding walks-too-much", {"expected": "one"}, "the bound speaks of integers"),
    ("finding no-answer", {"seen": 3}, "every other law speaks in sentences"),
    ("count", {"class": "trees"}, ""),
    ("explain mirror-image", {"sentences": []}, ""),
    ("worst", {"transit": "longest"}, ""),
    ("worst", {"exit_code": 4}, "4 is no row"),
    ("worst", {"gate": {"source": "a table", "agrees": False}}, "70 is a disagreement"),
    ("worst", {"rows": []}, "4 is no row"),
    ("worst", {"rows": "one not replayed"}, "0 is no wrong test, and every row replayed"),
    ("twins told apart", {"distinguishable": False}, "motions tell apart what is distinguishable"),
    ("twins told apart", {"twins": True}, "twins are different and not distinguishable"),
    ("twins told apart", {"relation": "same"}, "one world is not told from itself"),
    ("twins told apart", {"bisimulation": [[0, 0], [0, 0]]}, "a bisimulation proves that nothing"),
    ("twins alike", {"distinguishable": True}, "motions tell apart what is distinguishable"),
    ("twins alike", {"twins": False}, "twins are different and not distinguishable"),
    (
        "twins that are one",
        {"twins": True},
        "twins are different and not distinguishable",
    ),
    ("ambiguity class", {"size": 1}, "ambiguous is a class of two"),
    ("ambiguity class", {"ambiguous": False}, "ambiguous is a class of two"),
    ("ambiguity class", {"sheets": 1}, "a class of two has two sheets"),
    ("ambiguity class of one", {"ambiguous": True}, "ambiguous is a class of two"),
    ("ambiguity class of one", {"notice": "one is left out"}, "of a class of one nothing is left"),
    ("ambiguity census", {"lighthouse": 3}, ""),
    ("search sat", {"pair": None}, "sat is a pair with its bisimulation"),
    ("search sat", {"exit_code": 3}, "3 is unknown"),
    ("search sat", {"status": "unsat"}, "sat is a pair with its bisimulation"),
    ("search sat", {"certificate": None}, "sat has a certificate, unknown and vacuous have none"),
    ("search unsat", {"status": "unknown"}, "3 is unknown"),
    ("search vacuous", {"vacuous": False}, "4 is vacuous"),
    ("search sat", {"vacuous": True, "exit_code": 4}, "vacuous is unsat"),
    ("world directional", {"lighthouse": {"kind": "directional", "darts": [0]}}, ""),
    ("world directional", {"lighthouse": {"kind": "lamp", "dart": 0}}, ""),
]


@pytest.mark.parametrize(("name", "change", "rule"), WRONG_VALUES)
def test_a_value_that_cannot_be_is_refused(name, change, rule):
    reference, found = document(name)
    assert wrongs(reference, found) == []
    wrong = {**found, **change}
    if wrong.get("rows") == "one not replayed":
        wrong["rows"] = [*found["rows"][:-1], {**found["rows"][-1], "replayed": None}]
    assert complaints(reference, wrong) == [] if rule else complaints(reference, wrong)
    assert not rule or any(words.startswith(rule) for words in wrongs(reference, wrong))


def test_every_rule_is_seen_to_be_broken():
    for name, rules in RULES.items():
        told = [rule for document, _, rule in WRONG_VALUES if DOCUMENTS[document][0] == whole(name)]
        for words in rules:
            assert any(rule and words.startswith(rule) for rule in told), f"{name}: {words}"


# ---------------------------------------------------------------- what is read


def test_a_world_may_not_hold_more_than_is_known():
    world = World(THETA, Directional(0)).to_json()
    assert complaints(whole("world"), world) == []
    light = {**world["lighthouse"], "drat": 0}
    for more in ({**world, "strat": 1}, {**world, "lighthouse": light}):
        assert complaints(whole("world"), more)
        with pytest.raises(ValueError, match="is no key of a"):
            World.from_json(more)


def test_a_finding_may_hold_more_than_is_known():
    finding = {**finding_of("pose-lost").to_json(), "remark": "found on a rainy day"}
    finding["transcript"][0]["time"] = 0.1
    assert complaints(whole("finding"), finding) == []
    assert complaints(whole(FINDING), finding)


def test_what_may_be_left_out_may_be_left_out():
    assert complaints(whole("world"), THETA.to_json()) == []
    finding = finding_of("pose-lost").to_json()
    least = {key: finding[key] for key in ("version", "explorer", "law", "world", "transcript")}
    assert complaints(whole("finding"), least) == []
    for key in least:
        assert complaints(whole("finding"), {k: v for k, v in least.items() if k != key})
    for key in ("sigma", "alpha"):
        assert complaints(whole("world"), {k: v for k, v in THETA.to_json().items() if k != key})


def test_a_transcript_that_is_read_needs_its_actions_and_percepts():
    reference = whole("transcript")
    rows = finding_of("pose-lost").transcript.to_json()
    assert complaints(reference, rows) == []
    for key in ("move", "percept"):
        wrong = copy.deepcopy(rows)
        del wrong[1][key]
        assert complaints(reference, wrong)
    assert complaints(reference, [])


# ---------------------------------------------------------------- completeness


@pytest.mark.usefixtures("without_workers")
@pytest.mark.parametrize("verb", VERBS, ids=lambda verb: verb.name)
def test_what_the_command_line_prints_keeps_its_schema(verb, cli, tmp_path):
    code, out, _ = cli(*least(verb.name, str(tmp_path)), "--json")
    assert code == 0
    document = json.loads(out)
    assert wrongs(whole(verb.document), document) == []
    assert complaints(whole("made-by"), document["made_by"]) == []
    assert complaints(whole(verb.document), {**document, "made_by": {}})


def test_a_document_of_every_verb_and_of_every_kind_is_looked_at():
    told = {reference for reference, _ in DOCUMENTS.values()}
    assert {whole(verb.document) for verb in VERBS} <= told
    assert {whole(FINDING), whole(WORLD)} < told
    assert {whole("transcript"), whole("manifest")} < told
