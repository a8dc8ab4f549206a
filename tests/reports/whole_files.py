"""Reports in every form of file, whole: pages, Markdown, tables, documents for CI services.

``RENEW=1 pytest tests/reports/test_whole_files.py`` writes the texts anew; what then differs is to
be meant, and told in the commit.
"""

import json
import re
from html import unescape
from pathlib import Path

import allworlds
from allworlds import Drop, Move
from allworlds.documents.document import replace
from allworlds.engines.tally import Tally
from allworlds.outcome import Completed, Disagreed, Interrupted, Stopped
from allworlds.reports import notebook
from allworlds.reports.formats import file_of
from allworlds.reports.web.sections import world_data
from allworlds.studies.check.exhaustive import check
from allworlds.studies.explain import explain
from allworlds.studies.ledger import LedgerReport
from allworlds.studies.run import play, replay, run
from allworlds.studies.team.finding_reports import TeamExplanation
from allworlds.world import (
    Compass,
    Directional,
    Doormarks,
    Labelling,
    Movable,
    Whiteboard,
    World,
    world_named,
)
from recorded_texts import Texts
from reports.whole import EDGE, LASSO, PATH, claims_found, found, mine, moves, team

FILES = Texts(Path(__file__).parent / "whole_files")
case = FILES.case


def forms(result, *names):
    """The result as files of these formats."""
    Path(".git").mkdir(exist_ok=True)  # so that this is a repository, wherever it is
    shorter = {"html": page, "sarif": without_rules}
    for name in names:
        text = file_of(name, result)
        yield f"## {name}\n{shorter.get(name, str)(text)}"


def without_rules(text):
    """A log of SARIF with the first of its rules."""
    log = json.loads(text)
    del log["runs"][0]["tool"]["driver"]["rules"][1:]
    return json.dumps(log, indent=1)


def page(text):
    """A page without what is the same in all pages, and without its document."""
    text = re.sub(r"<style>.*?</style>|<script>.*?</script>", "", text, flags=re.DOTALL)
    text = re.sub(r'<script[^>]* id="report-json">.*?</script>', "", text, flags=re.DOTALL)
    text = re.sub(r'<div class="controls".*?</div>', "", text, flags=re.DOTALL)
    return re.sub(r"'sha256-[^']*'", "'sha256-'", text)


def in_notebook(value):
    """The frame of a page in a notebook, and the page."""
    begin, _, rest = notebook.shown(value).partition('srcdoc="')
    inside, _, end = rest.partition('"')
    return f"{begin}{end}\n{page(unescape(inside))}"


SERVICES = ("junit", "sarif", "annotations")
LABELLED = World(PATH, Directional(0), labels=Labelling("", ("hall", "a kitchen", "x"), ()))


@case
def walks():
    yield from forms(run("algorithm1", World(LASSO, Directional(0))), "html", "markdown", "svg")
    yield from forms(run(mine.walking(*moves(0, 0)), LABELLED), "html", "latex")
    yield from forms(run("algorithm1", world_named("theta-torus", "directional")), "markdown")
    marking = World(PATH, Movable(), 0)
    yield from forms(run(mine.walking(Drop(), *moves(0, 1)), marking), "html", "csv")


@case
def findings():
    finding = found(mine.first_edge, PATH)
    yield from forms(run(mine.first_edge, World(PATH, Directional(0))), "html")
    yield from forms(explain(finding), "html", "markdown")
    yield from forms(replay(finding, mine.first_edge), "markdown", "csv")
    yield in_notebook(finding)
    yield in_notebook(run(mine.first_edge, World(EDGE, Directional(0))))
    yield notebook.short_text_of(finding)
    yield notebook.shown(finding.transcript)
    yield notebook.text_of(finding.transcript)


@case
def checks():
    held = check("algorithm1", edges=2, engine="python")
    held = replace(held, seconds=(0.25, 1.5))
    yield from forms(held, "html", "markdown", "latex", *SERVICES)
    yield notebook.short_text_of(held)
    refuted = check(mine.first_edge, edges=2, max_findings=2)
    refuted = replace(refuted, seconds=(0.25,))
    yield from forms(refuted, "markdown", *SERVICES)
    for ending in (Stopped("the time is over"), Interrupted(), Disagreed("two numbers")):
        ended = replace(held, ending=ending, levels=(1,), cells=held.cells[:2])
        yield from forms(ended, *SERVICES)
    vacuous = check("algorithm1", edges=1, where="cubic", engine="python")
    yield from forms(replace(vacuous, seconds=()), "markdown", *SERVICES)


@case
def checks_of_files():
    """The place of an explorer is a line of its file, from the folder of the repository."""
    Path("inner").mkdir()
    Path("inner/mine.py").write_text(Path("mine.py").read_text(encoding="utf-8"))
    refuted = check("inner/mine.py:first_edge", edges=1, engine="python")
    yield from forms(replace(refuted, seconds=(2.0,)), *SERVICES)
    elsewhere = [replace(each, code=None) for each in refuted.findings]
    tally = Tally(refuted.tally.keep, findings=elsewhere)
    beyond = replace(refuted, seconds=(), explorer="elsewhere.py:explore", tally=tally)
    yield from forms(beyond, *SERVICES)
    flow = Path(".github/workflows/check.yml")
    flow.parent.mkdir(parents=True)
    for text in ("on: push\njobs:\n  - run: allworlds check\n", "on: push\n"):
        flow.write_text(text)
        yield from forms(beyond, "sarif")
    Path("pyproject.toml").write_text("[tool.allworlds]\n")
    yield from forms(beyond, "sarif")


@case
def claims():
    made = LedgerReport(
        budget="quick",
        required=(),
        claims=tuple(claims_found()),
        directory="here",
        ending=Completed(),
    )
    yield from forms(made, "html", "markdown", "csv", "latex", "junit")
    yield str(made.seconds_by_part)


@case
def comparisons():
    compared = allworlds.compare("algorithm1", "folding", edges=2)
    yield from forms(compared, "html", "markdown", "latex", "csv", "svg", "json")
    yield from forms(allworlds.count(edges=2), "html", "markdown", "csv", "json")


@case
def alike_worlds():
    pair = [world_named(name, "none") for name in ("cycle-2", "cycle-3")]
    yield from forms(allworlds.twins(*pair), "html", "markdown", "json")
    pair = [world_named(name, "directional") for name in ("theta", "theta-torus")]
    yield from forms(allworlds.twins(*pair), "html", "csv")
    yield from forms(allworlds.ambiguity.class_of(world_named("edge", "position")), "html", "json")


@case
def teams():
    refuted = team("other_end", model="meeting", edges=1)
    yield from forms(refuted, "html", "markdown", "plantuml", *SERVICES)
    found_ = refuted.findings[0]
    yield from forms(TeamExplanation(finding=found_, number=1, findings=2), "html", "markdown")


@case
def games():
    for lighthouse in (Directional(0), Compass((0, 1)), Movable()):
        game = play(World(EDGE, lighthouse, 0))
        yield from forms(replace(game, path="game.html"), "html")
    done = iter([Move(0), Drop(), Move(0), None])
    yield from forms(play(LABELLED, player=lambda *_: next(done)), "html", "markdown", "json")
    for lighthouse in (
        Whiteboard(),
        Doormarks(),
        Movable(),
        Movable(2, distinct=True),
        Movable(1, pick=False),
        Directional(2),
    ):
        yield str(world_data(World(LASSO, lighthouse, 0)))
