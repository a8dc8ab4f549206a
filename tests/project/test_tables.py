"""Each table is one: what is said of its entries elsewhere is said of every one of them."""

import inspect
import re
from functools import partial
from importlib import import_module
from operator import attrgetter
from pathlib import Path
from pkgutil import iter_modules, resolve_name
from typing import Any, get_args, get_type_hints

import pytest

import allworlds
from allworlds import reports, strategies
from allworlds.cli import app
from allworlds.cli.app import command_line
from allworlds.documents.document import replace
from allworlds.documents.reading import parse
from allworlds.documents.report import Report
from allworlds.engines.engine_table import ENGINES, engine_for
from allworlds.engines.kernel.capabilities import CHECKED
from allworlds.engines.units import Sample, Scope
from allworlds.explorers import builtin as explorers
from allworlds.explorers.builtin.explorer_table import BUILT_IN
from allworlds.explorers.languages import LANGUAGES
from allworlds.explorers.loading import load
from allworlds.inputs.requests import fields_of
from allworlds.judging.explanations.by_law import TELLERS
from allworlds.judging.laws.bounds import bound_named
from allworlds.judging.laws.law_table import LAWS, PRECEDENCE
from allworlds.judging.rules import RecordedRules, RuleOptions, Rules
from allworlds.judging.tasks import task_named
from allworlds.maps import MapClass
from allworlds.maps.classes import Extent
from allworlds.maps.counting import SOURCES
from allworlds.maps.families import FAMILIES
from allworlds.maps.mixture import MIXES
from allworlds.outcome import Exit, Facts, Verdict
from allworlds.protocol.choices import POLICIES, SEEDED, Schedule
from allworlds.reports import schemas
from allworlds.reports.formats import FORMATS, _maker as maker, formats_of, text
from allworlds.robots.models.table import MODELS, WRAPPERS
from allworlds.studies.ambiguity.question import SEARCHED
from allworlds.studies.check.report import CheckedScope
from allworlds.studies.compare.growth import GROWING
from allworlds.studies.fuzz.sampling import batches
from allworlds.studies.worst.every_schedule import Transit
from allworlds.verbs import BY_NAME, GROUPS, VERBS
from allworlds.world import LIGHTHOUSES, Lighthouse, World, lighthouses
from allworlds.world.lighthouses.kinds import lighthouse_from_json
from allworlds.world.lighthouses.options import place_keys
from bruteforce import rooted_maps_by_permutations as all_rooted_maps
from docsite_modules import load as docsite
from judges import WEAK_JUDGES
from recorded.record import COMMANDS, LEAST

pytestmark = pytest.mark.usefixtures("without_workers")

ROOT = Path(__file__).parents[2]
PACKAGE = Path(allworlds.__file__).parent


def page(name):
    return (ROOT / name).read_text(encoding="utf-8")


def rows(text):
    """The first cells of all rows of tables, and beginnings of lists, where they are names."""
    return re.findall(r"^[|-] `([^`]+)`", text, re.MULTILINE)


def section(text, heading):
    return text.partition(f"\n## {heading}\n")[2].partition("\n## ")[0]


PROTOCOL = page("docs/protocol.md")
ROBOTS = page("docs/robots.md")
VERDICTS = page("docs/verdicts.md")

# ---------------------------------------------------------------- verbs


def function_of(verb):
    return resolve_name(verb.path)


# Documents of verbs that have more than one.
ALSO = {"compare": ["growth"], "init": ["header"]}


def command_of(verb):
    """The verb as click has it."""
    command = command_line()
    for word in verb.name.split():
        command = command.commands[word]
    return command


@pytest.mark.parametrize("name", BY_NAME)
def test_a_verb_is_a_function_of_the_package(name):
    verb = BY_NAME[name]
    _, first, *rest = verb.path.split(".")
    assert first in allworlds.__all__
    assert attrgetter(".".join([first, *rest]))(allworlds) is function_of(verb)
    assert first == name or verb.group
    assert inspect.getdoc(function_of(verb))
    if verb.group:
        assert not verb.panel, "a verb of a group stands under the panel of the group"
        assert verb.group in GROUPS


def test_the_help_has_at_most_sixteen_entries_each_under_a_panel_that_issues_name():
    entries = {verb.group or verb.name for verb in VERBS}
    assert len(entries) <= 16
    panels = dict.fromkeys(verb.panel or GROUPS[verb.group].panel for verb in VERBS)
    assert [*panels] == [
        *("Everyday", "Long runs", "Costs", "Worlds"),
        *("What no robot can tell apart", "Papers"),
    ]


@pytest.mark.parametrize("name", BY_NAME)
def test_a_verb_has_its_command_its_content_and_its_document(name):
    verb = BY_NAME[name]
    function, parts, help_ = app._function_of(verb)
    assert isinstance(function, partial) == bool(verb.help and verb.example)
    assert parts
    assert help_.count("Example: ") == 1
    named = {maker(kind).__name__ for kind in schemas.reports_of(verb) if kind is not Any}
    # The result of merge is that of another verb.
    assert (named, name) == (set(), "merge") or "plain_content" not in named
    if verb.name != "merge":  # whose result hands on that of another verb
        told = get_type_hints(function_of(verb))["return"]
        first, *others = get_args(told) or (told,)
        assert schemas.reports()[verb.document] is first
        assert all(issubclass(one, Report) for one in (first, *others))
        assert {*others} <= {*schemas.reports().values()}


@pytest.mark.parametrize("name", BY_NAME)
def test_the_help_of_a_verb_begins_with_an_example_of_it(name):
    command = command_of(BY_NAME[name])
    assert command.help.startswith(f"Example: allworlds {name}")
    assert command.short_help == BY_NAME[name].summary


def test_what_every_verb_says_is_recorded():
    said = {
        name
        for command in COMMANDS.values()
        for name in BY_NAME
        if (command if isinstance(command, str) else " ".join(command)).startswith(name)
    }
    assert [*LEAST] == [*BY_NAME]
    assert said == {*BY_NAME}


# ---------------------------------------------------------------- options

# What the command line has alone: how a result is printed, and what names worlds and explorers in
# other words.  What a function takes alone: who listens, and values in place of their names.
PRINTED = {"as_json", "quiet", "verbose", "events", "help", "help_all", "files"}
ONLY_CLI = {
    "check": {"estimate", "explorer", "command", "native"},
    "fuzz": {"explorer", "command", "native"},
    "run": {"arguments", "command", "native", "listed", "without_walk", "pdb", "step"},
    "replay": {"explorer", "command", "native", "file", "number"},
    "explain": {"file"},
    "compare": {"command", "native"},
    "team": {"command", "native"},
}
ONLY_PYTHON = {
    "check": {"explore"},
    "fuzz": {"explore"},
    "run": {"explore", "world"},
    "replay": {"explore", "finding"},
    "explain": {"finding", "findings"},
    "play": {"player"},
    "convert": {"output"},
}


def keywords_of(function):
    """The parameters of a function, but for its listener."""
    return {*inspect.signature(function).parameters} - {"listener"}


@pytest.mark.parametrize("name", BY_NAME)
def test_the_command_line_takes_what_the_function_takes(name):
    shown = {param.name for param in command_of(BY_NAME[name]).params} - PRINTED
    taken = keywords_of(function_of(BY_NAME[name]))
    assert shown - taken == ONLY_CLI.get(name, set())
    assert taken - shown == ONLY_PYTHON.get(name, set())


RULES = {field.name for field in fields_of(RuleOptions)}


def test_a_finding_records_every_rule_and_says_how_to_give_it_again():
    # Besides, which text the judge of a task has that is the user's, and among which maps it is
    # minimal.
    more = {"task_digest", "where", "where_digest"}
    assert set(RecordedRules.__annotations__) - more == RULES
    assert set(CheckedScope.__annotations__) > RULES
    others = {"policy": "lifo", "bound": bound_named("n"), "laws": ("map",), "step_budget": 7}
    others["task"] = task_named("cover")
    assert set(others) == RULES
    report = allworlds.check(silent(), edges=1)
    (finding,) = report.findings
    for key, value in others.items():
        judged = replace(finding, under=Rules(**{key: value}))
        assert f" {key}=" in judged.reproduce
        recorded = parse(judged.rules.recorded.to_json(), RecordedRules, "options")
        assert getattr(recorded.rules(finding.world), key) == value


def silent():
    """An explorer that answers nothing; a closure, so that it runs in this process."""

    def stays(_first):
        return None
        yield

    return stays


def option(verb, name):
    (found,) = [param for param in command_of(BY_NAME[verb]).params if param.name == name]
    return found


@pytest.mark.parametrize(
    ("verb", "name", "table"),
    [
        ("check", "engine", ["auto", *ENGINES]),
        ("check", "schedules", get_args(Schedule)),
        ("worst", "transit", get_args(Transit)),
    ],
)
def test_an_option_with_few_values_shows_them_all(verb, name, table):
    assert option(verb, name).metavar == "|".join(table)


@pytest.mark.parametrize(
    ("verb", "name", "table"),
    [
        ("check", "laws", LAWS),
        ("check", "policy", [*POLICIES, SEEDED]),
        ("check", "map_class", MapClass),
        ("ambiguity twins", "lighthouse", LIGHTHOUSES),
        ("ambiguity search", "lighthouse", SEARCHED),
        ("init", "lang", LANGUAGES),
    ],
)
def test_the_help_of_an_option_lists_every_name_of_its_table(verb, name, table):
    words = re.findall(r"[\w:-]+", option(verb, name).help)
    assert {*map(str, table)} <= {*words}


def test_the_help_of_the_families_lists_every_one():
    help_ = option("run", "family").help
    assert FAMILIES
    assert all(kind.form in help_ for kind in FAMILIES)
    assert all(growing.form in option("compare", "family").help for growing in GROWING.values())


@pytest.mark.parametrize("name", FORMATS)
def test_a_format_is_in_the_help_of_every_verb_that_has_what_it_shows_and_told_of(name):
    verbs = [verb for verb in BY_NAME if name in formats_of(verb)]
    assert verbs
    for verb in verbs:
        assert {FORMATS[name].suffix, name} <= {
            "",
            *re.split("[ ,()]+", option(verb, "files").help),
        }
    assert f"`{name}`" in page("docs/how-to/ci.md")


def test_no_report_is_left_out_of_its_table():
    homes = {maker(kind).__module__.split(".")[2] for kind in schemas.reports().values()}
    sources = "".join(path.read_text(encoding="utf-8") for path in PACKAGE.rglob("*.py"))
    for module in iter_modules(reports.__path__):
        used = rf"reports(\.| import (\w+, )*){module.name}\b"
        assert module.name in homes or re.search(used, sources)


# ---------------------------------------------------------------- laws


def test_every_law_is_explained_and_told_in_the_order_of_precedence():
    assert [*TELLERS] == [law for law in PRECEDENCE if law in TELLERS]
    assert tuple(rows(section(VERDICTS, "Laws"))) == PRECEDENCE
    # Two laws of finished runs cannot be left out.
    finished = [law for law in PRECEDENCE if law not in ("ambiguity", "task")][-len(LAWS) :]
    assert finished == [*LAWS]


@pytest.mark.parametrize("law", [*LAWS, "ambiguity"])
def test_every_law_of_finished_runs_has_its_mutants(law):
    assert any(weak.law == law and weak.softer is None for weak in WEAK_JUDGES)


def test_the_compiled_engine_checks_no_law_that_is_none():
    assert set(CHECKED) <= set(LAWS)


def test_a_law_that_the_compiled_engine_does_not_know_is_left_to_the_other(monkeypatch):
    scope = Scope(Extent(MapClass.MAPS, 6), Rules())
    assert engine_for("auto", scope, load("algorithm1")).name == "kernel"
    monkeypatch.setattr("allworlds.engines.kernel.capabilities.CHECKED", CHECKED - {"map"})
    assert "law 'map'" in ENGINES["kernel"].obstacle(scope, load("algorithm1"))
    assert engine_for("auto", scope, load("algorithm1")).name == "python"


# ---------------------------------------------------------------- classes of maps


@pytest.mark.parametrize("map_class", MapClass)
def test_every_class_is_counted_enumerated_drawn_and_told(map_class):
    assert map_class.summary
    assert SOURCES[map_class]
    meant = [map_ for map_ in all_rooted_maps(3) if map_class.includes(map_)]
    assert meant == [*all_rooted_maps(3, map_class)]
    name = f"{map_class.value.replace('-', '_')}_maps" if map_class is not MapClass.MAPS else "maps"
    assert name in strategies.__all__
    assert f"| `{name}(" in page("docs/how-to/pytest.md")
    assert f"| `{map_class}` | {map_class.summary} |" in docsite("documents").page_text()


@pytest.mark.parametrize("map_class", MapClass)
def test_random_worlds_of_every_class_are_drawn(map_class):
    (batch,) = batches(Sample(runs=6))
    drawn = [map_ for map_, _ in batch.placed(Extent(map_class, 4), LIGHTHOUSES["directional"])]
    assert len(drawn) == 6
    assert all(map(map_class.includes, drawn))


def test_a_class_without_a_mixture_of_its_own_is_drawn_all_the_same(monkeypatch):
    monkeypatch.delitem(MIXES, MapClass.SIMPLE)
    test_random_worlds_of_every_class_are_drawn(MapClass.SIMPLE)


@pytest.mark.parametrize("map_class", MapClass)
def test_a_search_stays_in_its_class(map_class, tmp_path):
    found = allworlds.search(
        lighthouse="none", map_class=map_class.value, vertices=4, edges=4, out=tmp_path
    )
    assert all(map_class.includes(world.map) for world in found.pair or ())


# ---------------------------------------------------------------- lighthouses


def members_of(package):
    """Everything that the modules of a package define."""
    for module in iter_modules(package.__path__, f"{package.__name__}."):
        for found in vars(import_module(module.name)).values():
            if getattr(found, "__module__", None) == module.name:
                yield found


def test_no_lighthouse_is_left_out_of_its_table():
    kinds = {
        kind
        for kind in members_of(lighthouses)
        if inspect.isclass(kind)
        and issubclass(kind, Lighthouse)
        and isinstance(vars(kind).get("kind"), str)
    }
    assert kinds == set(LIGHTHOUSES.values())


@pytest.mark.parametrize("model", [*MODELS, "lighthouse:KIND", *(f"{w}:F+MODEL" for w in WRAPPERS)])
def test_every_model_is_told(model):
    assert model in rows(section(ROBOTS, "Models"))


@pytest.mark.parametrize("kind", LIGHTHOUSES)
def test_every_lighthouse_is_told(kind):
    assert kind in rows(section(PROTOCOL, "Lighthouses"))


@pytest.mark.parametrize("kind", LIGHTHOUSES)
def test_every_lighthouse_is_written_and_read_as_its_schema_says(kind):
    lighthouse = LIGHTHOUSES[kind]
    written = {"kind", *place_keys(lighthouse)}
    tried = 0
    for map_ in all_rooted_maps(3):
        for placed in lighthouse.places(map_, 0):
            document = placed.to_json()
            assert written - {"distinct", "single", "start"} <= set(document) <= written
            assert document["kind"] == kind
            assert lighthouse_from_json(document, map_, 0) == placed
            tried += 1
    assert tried > 0


@pytest.mark.parametrize("kind", LIGHTHOUSES)
def test_under_every_lighthouse_a_run_is_checked_told_and_explained(kind):
    found = allworlds.check(silent(), edges=3, lighthouse=kind, max_findings=2).findings
    assert found
    for finding in found:
        assert finding.world.lighthouse.kind == kind
        assert World.from_json(finding.world.to_json()) == finding.world
        assert text(allworlds.explain(finding), 100)
        assert text(allworlds.run(silent(), finding.world), 100)


# ---------------------------------------------------------------- where a new thing goes

NOT_NAMED = ("the function", "the request", "where it acts", "where the result is")
PLACES = [
    [cell.strip() for cell in re.split(r"(?<!\\)\|", row)[1:-1]]
    for row in section(page("docs/ARCHITECTURE.md"), "Where a new thing goes").splitlines()
    if row.startswith("| ") and not row.startswith("| new ")
]


@pytest.mark.parametrize("row", PLACES, ids=lambda row: row[0])
def test_what_is_said_of_a_new_thing_is_so(row):
    new, files, number, _, noticed = row
    places = [place for place in re.findall(r"`([^`]+)`", files) if place != "Report"]
    assert len(places) + sum(map(files.count, NOT_NAMED)) == int(number)
    paths = [(ROOT if place.startswith("tests/") else PACKAGE) / place for place in places]
    assert all(path.exists() for path in paths)
    assert [path.is_dir() for path in paths] == [place.endswith("/") for place in places]
    files = [path / "__init__.py" if path.is_dir() else path for path in paths]
    sources = [file.read_text(encoding="utf-8") for file in files if file.exists()]
    for name in re.findall(r"`(\w+)`", new):
        assert any(re.search(rf"\b{name}\b", source) for source in sources), name
    tests = "".join(
        test.read_text(encoding="utf-8") for test in (ROOT / "tests").rglob("test_*.py")
    )
    for name in re.findall(r"`([^`]+)`", noticed):
        assert f"\ndef {name}(" in tests, name


def test_every_table_says_where_a_new_entry_goes():
    told = {name for new, *_ in PLACES for name in re.findall(r"`(\w+)`", new)}
    assert {"BUILT_IN", "LIGHTHOUSES", "LAWS", "VERBS", "FORMATS", "ENGINES", "POLICIES"} <= told
    assert {"RuleOptions", "Limits", "MapClass", "Transport"} <= told


# ---------------------------------------------------------------- policies, explorers, exit codes


def test_every_policy_is_told():
    assert rows(section(PROTOCOL, "In Python"))[: len(POLICIES) + 1] == [*POLICIES, SEEDED]


def test_no_explorer_is_left_out_of_its_table():
    found = {
        explore
        for explore in members_of(explorers)
        if inspect.isgeneratorfunction(explore)
        and "notice" in inspect.signature(explore).parameters
    }
    assert found == {own.explore for own in BUILT_IN.values()}


def test_every_built_in_explorer_is_told_and_runs_as_it_is_written_for():
    documents = docsite("documents")
    assert documents.EXPLORERS in PROTOCOL
    assert rows(documents.explorers_table()) == [*BUILT_IN]
    for name, own in BUILT_IN.items():
        assert own.about
        assert allworlds.check(name, edges=2, workers=1).scope.lighthouse == own.lighthouse


def test_every_exit_code_and_every_verdict_is_told():
    text = section(VERDICTS, "Verdicts and exit codes")
    assert re.findall(r"^\| (\d+) \|", text, re.MULTILINE) == [str(int(code)) for code in Exit]
    named = dict(re.findall(r"^\| `([a-z-]+)` \| .* \| (\d+) \|$", text, re.MULTILINE))
    facts = [Facts(), *(Facts(**{name: True}) for name in ("refuted", "undecided", "vacuous"))]
    facts.append(Facts(disagrees=True))
    codes = {each.verdict: str(int(each.exit)) for each in facts}
    codes |= {Facts().sample_verdict: str(int(Facts().exit))}
    assert named == codes
    assert {*named} == {*Verdict}
