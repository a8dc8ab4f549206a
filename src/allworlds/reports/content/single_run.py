"""Content of the report of one run, and sections and sentences about a finding."""

from __future__ import annotations

import json
from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

from allworlds import words
from allworlds.documents import document as doc
from allworlds.engines.single import SingleRun
from allworlds.explorers.loading import is_program
from allworlds.judging.belief import believed_walk, find_parting
from allworlds.judging.episode import Answered, Over
from allworlds.judging.explanations.endless import stack_of
from allworlds.judging.explanations.story import Belief, Story, Walked
from allworlds.judging.findings.finding import Finding
from allworlds.judging.laws.law_table import embed
from allworlds.judging.rules import Rules
from allworlds.judging.walk import Walk
from allworlds.maps.build import completed
from allworlds.maps.combinatorial import Dart, InvalidMap
from allworlds.protocol.actions import Ambiguous, Estimate
from allworlds.protocol.playing import BUILT, NO_MAP
from allworlds.reports import parts

if TYPE_CHECKING:
    from allworlds.studies.explain import Explanation
    from allworlds.studies.run import Replay, WorldNames


def known(run: SingleRun) -> parts.ShownMap | None:
    """The darts and edges of the world that a run's checkpoints show.

    Each dart and edge has the step of the first checkpoint that shows it.  None if there is no
    checkpoint, or if the part S of a checkpoint does not fit into the world.
    """
    episode, world = run.outcome.episode, run.world
    if not episode.checkpoints:
        return None
    seen = parts.ShownMap({}, {})
    for step, checkpoint in episode.checkpoints:
        embedding = embed(world.map, run.walk.darts[step], checkpoint)
        if isinstance(embedding, str):
            return None
        for dart, other in enumerate(checkpoint.alpha):
            seen.darts.setdefault(embedding[dart], step)
            if other != dart:
                seen.edges.setdefault(embedding[dart], step)
    return seen


def run_content(run: SingleRun | WorldNames) -> parts.ReportContent:
    """The content for one run, with its finding if it breaks a law.

    The verb ``run`` with ``--list`` makes no run, but lists the names that worlds can have; then
    this list is the content.
    """
    if not isinstance(run, SingleRun):
        named = (("maps", run.maps), ("families", run.families), ("corpus", run.corpus))
        section = parts.Section(
            "names", "", [parts.FactList([(kind, ", ".join(of)) for kind, of in named])]
        )
        rows = [[kind, one] for kind, of in named for one in of]
        made = parts.CsvRows({"kind": str, "name": str}, rows)
        return parts.ReportContent(
            "allworlds run", "names", run, None, [section], rows=lambda: made
        )
    headline = parts.Headline(run.verdict.value.upper(), _said(run), run.verdict.value)
    whole = _section(run)
    shown = whole if run.shows_walk or run.finding else doc.replace(whole, blocks=whole.blocks[1:])
    return parts.ReportContent(
        "allworlds run",
        run.explorer,
        run,
        headline,
        [shown],
        rows=lambda: _rows(whole),
        apart=frozenset({"finding"}),
    )


def _rows(section: parts.Section) -> parts.CsvRows:
    """The rows of a CSV file: the steps of the walk that the section shows."""
    return parts.rows_of_walk(
        next(each for each in section.blocks if isinstance(each, parts.ShownWalk))
    )


def _said(run: SingleRun) -> str:
    """The result in a sentence: the broken law, or that no law is broken."""
    if run.finding:
        return f"law {run.finding.law} is broken"
    if not run.checked_laws:
        return f"{nothing_checked(run.rules)}; {cost_words(run)}"
    return f"{cost_words(run)}: no law is broken"


def replay_content(replay: Replay) -> parts.ReportContent:
    """The content for a new run of a finding.

    If the new run breaks no law, a page shows both runs: the new one and the recorded one.
    """
    recorded, run = replay.recorded, replay.again
    again = run.finding
    if again and again.law == recorded.law:
        said = parts.Headline("REPRODUCED", f"law '{again.law}' is broken again", "refuted")
    elif again:
        text = f"law '{again.law}' is broken now, where '{recorded.law}' was recorded"
        said = parts.Headline("REPRODUCED", text, "refuted")
    elif replay.outcome == "not-reproduced":
        text = f"{run.explorer} did the same each time; only a check can show a fault as mended"
        said = parts.Headline("NOT REPRODUCED", text, "inconclusive")
    else:
        text = f"{run.explorer} now keeps every law in the recorded world"
        said = parts.Headline("FIXED", text, "holds")
    section = _section(run)
    return parts.ReportContent(
        "allworlds replay",
        run.explorer,
        replay,
        said,
        [section] if again else [],
        more=lambda: (
            [] if again else [section, finding_section(recorded, title="The recorded finding")]
        ),
        rows=lambda: _rows(section),
        apart=frozenset({"run"}),
    )


def cost_words(run: SingleRun) -> str:
    """The cost of the run in words, with the bound if there is one."""
    bound = "" if run.outcome.bound is None else f" of at most {words.number(run.outcome.bound)}"
    return f"{words.plural(run.outcome.cost, 'traversal')}{bound}"


def _section(run: SingleRun) -> parts.Section:
    """The section of a run.

    If the run breaks a law, the section is that of its finding.  Else the walk of the run is the
    first block.
    """
    if run.finding:
        return finding_section(run.finding, checked=False)
    section = run_section(run, "walk-1")
    laws = parts.fact("laws", ", ".join(run.checked_laws) or nothing_checked(run.rules))
    return doc.replace(section, blocks=[*section.blocks, *printed(run.outcome.output), laws])


def run_section(run: SingleRun, name: str, title: str = "") -> parts.Section:
    """A section for a run that breaks no law: pictures, walk, and the answer if it is no map.

    ``name`` and ``title`` are the name and the title of the section, see :class:`parts.Section`.
    """
    walk, ending = run.walk, run.outcome.episode.ending
    walked = Walked(walk)
    views = [parts.View("world", "The world", parts.walk_in_world(walk), walk.darts)]
    agreement, blocks = None, list[parts.Block]()
    seen = known(run)
    if seen is not None:
        title_of_s = "What the explorer knows (S)"
        views.append(doc.replace(views[0], name="known", title=title_of_s, known=seen))
    match ending:
        case Answered(Estimate() as estimate):
            from allworlds.reports.drawing.layout import named_like

            belief = believed_walk(walk, estimate)
            answer = answer_view(walk, estimate, belief.trail)
            answer = named_like(views[0], answer, belief.agreement)
            views.append(doc.replace(answer, still=seen is not None))
            agreement = belief.agreement
        case Answered(Ambiguous() as quotient):
            blocks += _quotient(quotient)
        case Answered(value):
            blocks.append(parts.fact("answer", json.dumps(value)))
        case Over():
            done = run.rules.task.asks.partition(";")[0]
            blocks.append(parts.fact("ended", f"as the task was done: {done}"))
    shown = parts.ShownWalk(f"The walk of {run.explorer}", walked, views, agreement=agreement)
    return parts.Section(name, title, [shown, *blocks])


def _quotient(answer: Ambiguous) -> list[parts.Block]:
    """The blocks for an answer without a map: the quotient that all possible worlds share."""
    header = ["dart", "sigma", "alpha", "degree", "marks", ""]
    columns = (range(len(answer.sigma)), answer.sigma, answer.alpha, answer.degree, answer.marks)
    rows = [[*row, "here" if row[0] == answer.here else ""] for row in zip(*columns, strict=True)]
    said = "The answer: several worlds look alike, and this is their quotient."
    return [parts.Paragraph(said), parts.Table(header, rows)]


LONGEST_LIST = 60
"""The largest number of choices that are shown; of a longer list the first choices are shown."""


def headline_of(finding: Finding) -> str:
    """A finding in one line: the explorer, the broken law and the world's name and size."""
    return f"{finding.explorer} breaks the law '{finding.law}' in {finding.world.in_words}"


def finding_section(
    finding: Finding, number: int = 1, origin: str = "", *, title: str = "", checked: bool = True
) -> parts.Section:
    """Everything about a finding, as one section.

    Args:
        finding: the finding.
        number: the finding's number among the findings that are shown.
        origin: the finding's origin, in words; empty if the check itself has found it.
        title: the title; if empty, the number, the explorer, the law and the world make the title.
        checked: whether the finding comes from a check, which confirms findings; else the section
            does not say whether the finding is confirmed.
    """
    from allworlds.studies.explain import explained  # which a check that holds does not need

    story, explanation = Story(finding), explained(finding)
    title = title or f"Finding {number}: {headline_of(finding)}"
    said = "Copy the finding as JSON, for replay and explain"
    blocks = [
        _law(finding, explanation.step),
        _walk(story, explanation, f"The walk of finding {number}"),
        *_belief(story),
        parts.FactList([*_remarks(finding, origin, checked=checked)]),
        parts.Quote("command", "reproduce", finding.reproduce, command=True),
        *_detail(finding),
        *printed(finding.output, finding.detail),
        parts.DataRecord(said, finding.to_json()),
    ]
    return parts.Section(f"finding-{number}", title, blocks)


def _detail(finding: Finding) -> list[parts.Block]:
    """The detail of the finding under a title, such as ``traceback``; no block without a detail."""
    detail = finding.detail
    if finding.law == "no-estimate":
        # The explanation names the line of the call.
        detail = "" if detail.startswith(BUILT) else detail.partition(f"\n\n{BUILT}")[0]
        title = "the permutations that were tried"
    elif finding.law == "nondeterministic":
        title = "the two plays, from their first difference on"
    else:
        title = "output on stderr" if is_program(finding.explorer) else "traceback"
    return [parts.Quote("detail", title, detail)] if detail else []


def printed(output: str, shown: str = "") -> list[parts.Block]:
    """The block of the explorer's output; no block without output.

    ``shown`` is a text that the section shows elsewhere: if it contains the output, there is no
    block.
    """
    if not output or output.rstrip() in shown:
        return []
    return [parts.Quote("output", "printed by the explorer", output, prefix="| ")]


def nothing_checked(rules: Rules) -> str:
    """The sentence for a report in which no law was checked, because no run shows a checkpoint.

    The sentence lists the laws of ``rules``, all of which need checkpoints.  The caller knows that
    none of them was checked.
    """
    laws = words.listed(rules.judged)
    return f"nothing was checked: the explorer shows no checkpoints, which are needed for {laws}"


MOST_LINES = 3
"""The largest number of lines of code that are named as run in the finding alone; further lines are
counted."""


def wrong_line(finding: Finding, step: int | None) -> str:
    """The line of the user's code that a finding is about; empty if the line is unknown.

    The first of these cases that applies decides.  First: the explorer was silent for too long, and
    its stack is known; the line is the innermost one in the stack.  Second: a checkpoint is wrong;
    the line yields this checkpoint.  Third: the walk in the answer and the walk in the world
    diverge at a step; the line yields the action of this step.  Fourth: the broken law is not
    ``bound``; the line is the last one that is known, where the explorer ended.

    Args:
        finding: the finding.
        step: the first step at which the walk in the answer and the walk in the world diverge; None
            if they do not.
    """
    code, shown = finding.code, finding.believed
    for where, _ in stack_of(finding):
        return where
    if code is None or not code.steps:
        return ""
    if finding.step is not None and shown and shown.number < len(code.checkpoints):
        return code.checkpoints[shown.number]
    if step is not None and step <= len(code.steps):
        return code.steps[max(step - 1, 0)]
    return "" if finding.law == "bound" else code.steps[-1]


def _lines(finding: Finding, step: int | None) -> Iterator[tuple[str, str]]:
    """Facts about lines of code; none if the finding has no lines.

    The facts name the first wrong line, the lines that only the finding's run reaches, and the
    lines that ran most.  ``step`` is the first step at which the walk in the answer and the walk in
    the world diverge; None if they do not.
    """
    code = finding.code
    if code is None:
        return
    if where := wrong_line(finding, step):
        yield "line", code.source(where)
    if code.alone:
        lines = [code.source(where) for where in code.alone[:MOST_LINES]]
        if (more := len(code.alone) - MOST_LINES) > 0:
            lines.append(f"{words.plural(more, 'other line')}: --json lists them")
        runs = words.plural(code.right, "run")
        yield "only here", f"{'; '.join(lines)} (not run in {runs} that broke no law)"
    if code.busy:
        yield "ran often", "; ".join(code.source(where) for where in code.busy[:2])


def _law(finding: Finding, step: int | None) -> parts.FactList:
    """Facts about a finding: the law, the expected and the found result, and lines of code.

    The expected and the found result are left out in two cases, because the fact about the law then
    says what is wrong: the answer is an estimate with a wrong map or a wrong pose; or the
    explorer's sigma and alpha are no map.  ``step`` is the first step at which the walk in the
    answer and the walk in the world diverge; None if they do not.
    """
    lines = [*_lines(finding, step)]
    wrong = {
        "map": "the answer is not the same map as the world",
        "pose": "the answer is the same map, but 'here' is not the robot's dart",
    }.get(finding.law, "")
    if wrong and isinstance(finding.seen, Estimate):
        return parts.FactList([("law", f"{finding.law}: {wrong}"), *lines])
    if str(finding.seen).startswith(NO_MAP):
        no_map = f"{finding.law}: the explorer's sigma and alpha are no map"
        return parts.FactList([("law", no_map), *lines])
    expected, seen = (
        words.plural(value, "traversal") if isinstance(value, int) else str(value)
        for value in (finding.expected, finding.seen)
    )
    if isinstance(finding.expected, int):
        expected = f"at most {expected}"
    return parts.FactList([("law", finding.law), ("expected", expected), ("seen", seen), *lines])


def _walk(story: Story, explanation: Explanation, title: str) -> parts.ShownWalk:
    walk = story.walk
    views = [parts.View("world", "The world", parts.walk_in_world(walk), walk.darts)]
    elsewhere, agreement = None, None
    if explanation.answer:
        belief = Belief(story)
        views.append(answer_view(walk, belief.answer, belief.walk.trail))
        elsewhere = parts.Elsewhere("expected by the answer", belief.walk.expected)
        agreement = belief.walk.agreement
    elif other := explanation.other:
        there = Walk.of(other, walk.actions)
        trail, scene = there.darts, parts.walk_in_world(there)
        views.append(parts.View("answer", "Another world, with the same percepts", scene, trail))
        # The steps in which both worlds look alike to an observer who sees everything.
        parting = find_parting(story.map, walk.darts, other.map, trail, [True] * len(trail))
        agreement = parting.step if parting else len(trail)
    from allworlds.reports.drawing.layout import named_like

    views[1:] = [named_like(views[0], view, agreement or 0) for view in views[1:]]
    code = story.finding.code
    return parts.ShownWalk(
        title,
        story,
        views,
        explanation.sentences,
        elsewhere,
        agreement,
        explanation.step,
        lines=code.steps[: len(walk)] if code else (),
    )


def _belief(story: Story) -> list[parts.Block]:
    """Two pictures: the wrong checkpoint, and the world at the same step.

    There is no block if the wrong result is an answer, which is shown elsewhere.
    """
    finding, shown = story.finding, story.finding.believed
    if shown is None or (finding.step is None and isinstance(finding.seen, Estimate)):
        return []
    until = Walk.of(story.world, story.walk.actions[: shown.step])
    here = f"after step {shown.step}"
    try:
        map_ = completed(shown.sigma, shown.alpha)
    except InvalidMap:
        map_ = None
    if map_ is None or shown.here not in map_.darts:
        lists = f"sigma {[*shown.sigma]}, alpha {[*shown.alpha]}, here {shown.here}"
        wrong = "This is no map" if map_ is None else "This map has no such dart 'here'"
        return [parts.fact("S", f"{here}, in the explorer's numbers: {lists}. {wrong}")]
    known = len(shown.sigma)
    names = ["?" if min(darts) >= known else f"s{i}" for i, darts in enumerate(map_.vertices)]
    scene = parts.Scene(map_, None, shown.here, vertices=names)
    title = f"The S {here}, in the explorer's numbers (darts at '?' lead to unknown vertices)"
    beside = (f"The world {here}", parts.walk_in_world(until))
    return [parts.MapPictures([beside, (title, scene)])]


def answer_view(walk: Walk, answer: Estimate, trail: Sequence[Dart]) -> parts.View:
    """The picture of an answer, in which the walk can be followed.

    Args:
        walk: the walk of the run in the world.
        answer: the explorer's answer.
        trail: the same walk in the map of the answer: the robot's dart at the start and after each
            step.
    """
    scene = parts.walk_in_answer(walk, answer)
    note = "R: where the robot stands according to the answer"
    return parts.View("answer", "The answer", scene, trail, note)


def _remarks(finding: Finding, origin: str, *, checked: bool) -> Iterator[tuple[str, str]]:
    if finding.choices:
        shown, more = finding.choices[:LONGEST_LIST], len(finding.choices) - LONGEST_LIST
        rest = f", and {words.number(more)} more" if more > 0 else ""
        yield "choices", ", ".join(map(str, shown)) + rest
    if checked:
        confirmed = "no: no new process has repeated the run"
        if finding.confirmed:
            confirmed = "yes: a new process got the same percepts, and no world, and did the same"
        smaller = "a smaller world may refute the explorer, too"
        if finding.minimal:
            among = finding.rules.among
            scope = f"the scope (--where {among.name})" if among else "the scope"
            smaller = f"no smaller world of {scope} refutes the explorer"
        yield "confirmed", f"{confirmed}; {smaller}"
    for world in finding.earlier:
        text = json.dumps(world.to_json(), separators=(",", ":"))
        yield "ran before", f"in {world.in_words}: {text}"
    yield "origin", origin


def explain_content(explanation: Explanation) -> parts.ReportContent:
    """The content for an explanation: the broken law, the story, the walk in world and answer."""
    finding = explanation.finding
    title = headline_of(finding)
    if explanation.findings > 1:
        which = f"finding {explanation.number} of {explanation.findings}"
        title = f"{title} ({which}; --finding K explains another)"
    section = finding_section(finding, explanation.number, title=title)
    return parts.ReportContent(
        "allworlds explain", explanation.explorer, explanation, None, [section]
    )
