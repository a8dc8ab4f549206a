"""The verb ``team``: counts, findings, refusals, and the same report however it is made."""

import json
from copy import deepcopy
from pathlib import Path
from types import SimpleNamespace

import pytest

import allworlds
from allworlds.documents.document import replace
from allworlds.engines.limits import Limits, TimeoutOptions
from allworlds.engines.listeners import Listener
from allworlds.engines.single import subject_of
from allworlds.engines.units import SweptLevel
from allworlds.inputs.checks import InputError
from allworlds.outcome import Verdict
from allworlds.reports.content.team import diagram
from allworlds.robots import team as team_module
from allworlds.robots.models.meeting import Meeting
from allworlds.robots.search_lane import SearchLane
from allworlds.robots.team import Team
from allworlds.studies.team.finding_reports import replayed, sentences_of
from allworlds.studies.team.request import TeamRequest
from allworlds.studies.team.search_sweep import TeamSweep
from allworlds.testing import assert_team

PROGRAMS = Path(__file__).parents[1] / "support" / "teams.py"
ANYWHERE = "meeting:apart=false"


def team(*names, edges=3, model=ANYWHERE, **options):
    """A search of programs of that file."""
    programs = [f"{PROGRAMS}:{name}" for name in names]
    return allworlds.team(*programs, edges=edges, model=model, **options)


# ---------------------------------------------------------------- what holds


@pytest.mark.parametrize(
    ("scheduler", "configurations"),
    # Of the prototype with one robot at a time; the numbers of async are the same with sets.
    [("fsync", 969), ("ssync", 1629), ("central", 1629), ("async", 2591)],
)
def test_who_waits_is_found_by_who_searches_from_every_start(scheduler, configurations):
    report = team("waits", "searches", scheduler=scheduler)
    assert report.verdict is Verdict.HOLDS
    total = report.total
    # 86 rooted maps with up to 3 edges, each with 2m darts for the other robot.
    assert (total.maps, total.worlds) == (86, 488)
    assert total.configurations == configurations
    assert total.longest == 20


def test_robots_are_told_apart_by_what_they_are_told():
    labelled = team("by_label", model="meeting:labels=true,apart=false", edges=2)
    assert labelled.verdict is Verdict.HOLDS
    assert len(labelled.asked.team.subjects) == 1


def test_a_unit_is_small_beside_its_level():
    sweep = TeamSweep(TeamRequest(explorers=(f"{PROGRAMS}:waits",), edges=5), Team((), ()))
    (*_, largest) = sweep.levels()
    weights = [unit.weight(sweep.extent) for unit in largest.units]
    assert sum(weights) == largest.worlds == 8162
    # With ten units one alone, of the maps that begin with a new vertex, is half of the work.
    assert max(weights) < largest.worlds / 60


def test_the_gate_counts_the_maps():
    report = team("waits", "searches", edges=2)
    assert report.explorer == report.explorers[0] != report.explorers[1]
    assert [(cell.enumerated, cell.counted) for cell in report.cells] == [
        (1, 1),
        (1, 1),
        (3, 3),
        (5, 5),
        (2, 2),
    ]


def test_a_map_that_is_left_out_is_noticed(monkeypatch):
    from allworlds.robots.team import TeamScope

    searches = TeamScope.searches

    def fewer(scope, unit, minds):
        every = list(searches(scope, unit, minds))
        return every[:-1] if unit.edges == 1 else every

    monkeypatch.setattr(TeamScope, "searches", fewer)
    report = team("waits", "waits", edges=1, model="meeting")
    assert report.exit_code == 70


# ---------------------------------------------------------------- what is found


@pytest.mark.parametrize(
    ("program", "law", "events"),
    [
        ("raises", "crash", 1),
        ("says_a_number", "illegal-action", 1),
        ("no_pair", "illegal-action", 1),
        ("does", "illegal-action", 1),
        ("other_end", "progress", 2),
    ],
)
def test_a_slip_is_a_finding_with_a_shortest_run_in_the_smallest_world(program, law, events):
    report = team(program, model="meeting")
    (found,) = report.findings
    assert (report.exit_code, found.law, found.minimal) == (1, law, True)
    assert len(found.events) == events


def test_an_error_is_told_with_its_line():
    (found,) = team("raises", model="meeting").findings
    assert 'raise ValueError("three")' in found.detail
    assert "turns.py" not in found.detail


def test_a_run_that_the_budget_cuts_off_refutes_nothing_unless_it_is_a_bound():
    report = team("waits", "polls", edges=2, budget=4)
    assert (report.verdict, report.exit_code) == (Verdict.INCONCLUSIVE, 3)
    assert report.unfinished is not None
    assert not report.findings
    bounded = team("waits", "polls", edges=2, within=4)
    assert [found.law for found in bounded.findings] == ["budget"]


def test_a_bound_on_activations_is_refused_where_none_are_counted():
    with pytest.raises(InputError, match="within = 4 has no effect on automata"):
        team("other_end", edges=2, within=4)


def test_too_many_configurations_leave_the_verdict_open():
    report = team("waits", "searches", edges=2, configurations=3)
    assert (report.verdict, report.total.full > 0) == (Verdict.INCONCLUSIVE, True)


def test_no_start_is_vacuous():
    report = team("waits", edges=1, robots=3, model="meeting")
    assert (report.verdict, report.exit_code) == (Verdict.VACUOUS, 4)


# ---------------------------------------------------------------- findings again


def finding():
    (found,) = team("other_end", model="meeting", scheduler="async").findings
    return found


def test_a_stale_move_is_told():
    told = allworlds.explain(finding())
    assert "repeat for ever" in " ".join(told.sentences)


def test_one_schedule_is_played_and_told():
    found = finding()
    asked = {"world": json.dumps({"sigma": found.sigma, "alpha": found.alpha})}
    asked |= {"starts": found.starts, "scheduler": "async", "model": "meeting", "edges": None}
    report = team("other_end", schedule=found.schedule, **asked)
    assert report.verdict is Verdict.INCONCLUSIVE
    assert report.unfinished.schedule == found.schedule
    assert report.unfinished.events == found.events


def test_a_team_is_asserted():
    programs = [f"{PROGRAMS}:{name}" for name in ("waits", "searches")]
    assert_team(*programs, edges=2, model=ANYWHERE, scheduler="async")
    with pytest.raises(AssertionError, match="the run goes on for ever without the goal"):
        assert_team(f"{PROGRAMS}:other_end")


# ---------------------------------------------------------------- however it is made


@pytest.mark.processes
@pytest.mark.parametrize("how", ["two workers", "a run directory", "shards"])
def test_the_report_is_the_same_however_it_is_made(how, tmp_path):
    asked = {"scheduler": "async", "edges": 3}
    plain = team("waits", "searches", **asked)
    if how == "two workers":
        made = team("waits", "searches", workers=2, **asked)
    elif how == "a run directory":
        team("waits", "searches", run=tmp_path / "run", **asked)
        made = team("waits", "searches", run=tmp_path / "run", **asked)
    else:
        runs = [tmp_path / str(k) for k in range(2)]
        for k, run in enumerate(runs):
            team("waits", "searches", run=run, shard=(k, 2), **asked)
        made = allworlds.merge(*runs)
    assert made.to_json() == plain.to_json()


@pytest.mark.processes
def test_findings_are_the_same_however_they_are_made(tmp_path):
    asked = {"model": "meeting", "scheduler": "async", "max_findings": 5}
    plain = team("other_end", **asked)
    runs = [tmp_path / str(k) for k in range(3)]
    for k, run in enumerate(runs):
        team("other_end", run=run, shard=(k, 3), **asked)
    assert allworlds.merge(*runs).to_json()["findings"] == plain.to_json()["findings"]


def test_a_model_that_is_made_in_python_is_searched():
    report = allworlds.team(f"{PROGRAMS}:other_end", model=Meeting(), edges=1, scheduler="central")
    assert report.verdict is Verdict.HOLDS


# ---------------------------------------------------------------- refusals

WRONG = {
    "no program": ((), "team takes one program"),
    "too many": (("waits", "polls", "walks", "--robots", "2"), "3 programs for 2 robots"),
    "a scheduler": (("waits", "--scheduler", "all"), "'all'"),
    "a lead": (("waits", "--lead", "2"), "lead = 2 has no effect in fsync"),
    "a delay": (("waits", "--scheduler", "async", "--start-delay", "1"), "has no rounds"),
    "a model": (("waits", "--model", "meting"), "did you mean 'meeting'?"),
    "an option": (("waits", "--model", "meeting:lables=true"), "did you mean 'labels'?"),
    "starts": (("waits", "--starts", "0,1"), "no effect without world"),
    "a dart": (("waits", "--world", "k4", "--starts", "0,99"), "99 is no dart"),
    "two worlds": (("waits", "--world", "k4", "--family", "cycle:4"), "not both"),
    "a budget": (("waits", "--budget", "0"), "budget = 0 is less than 1"),
}


@pytest.mark.parametrize("case", WRONG)
def test_what_cannot_be_meant_is_refused_in_one_line(case, refused):
    (arguments, said) = WRONG[case]
    named = [f"{PROGRAMS}:{word}" if word.isidentifier() else word for word in arguments]
    values = {"async", "all", "meting", "cycle", "k4"}
    words = [
        plain if plain in values else word for plain, word in zip(arguments, named, strict=True)
    ]
    assert said in refused("team", *words)


# ---------------------------------------------------------------- a corpus of findings


def past(report):
    """What a search says of its corpus, without the directory and without what is empty."""
    said = report.corpus.to_json()
    return {kind: len(names) for kind, names in said.items() if kind != "directory" and names}


def test_findings_of_earlier_searches_are_tried_first(tmp_path):
    options = {"edges": 2, "model": "meeting", "scheduler": "fsync", "corpus": tmp_path}
    assert past(team("waits", **options)) == {"written": 1}
    again = team("waits", **options)
    assert (past(again), again.levels, again.exit_code) == ({"reproduced": 1}, (), 1)
    given = team("waits", **{**options, "edges": None, "family": "lattice:1x2"})
    assert (past(given), given.levels) == ({"reproduced": 1}, ())


@pytest.mark.parametrize(
    ("names", "options", "kind"),
    [
        (["waits"], {"scheduler": "async"}, "beyond_scope"),
        (["waits"], {"budget": 7}, "beyond_scope"),
        (["waits"], {"model": "meeting:labels=true"}, "beyond_scope"),
        (["waits"], {"robots": 3}, "beyond_scope"),
        (["waits"], {"edges": None, "family": "lattice:1x3"}, "beyond_scope"),
        (["waits", "searches"], {}, "fixed"),
        (["waits", "waits", "searches"], {}, "stale"),
        (["waits", "polls"], {"configurations": 2}, "undecided"),
    ],
)
def test_a_finding_of_another_scope_or_team_is_told_as_what_it_is(names, options, kind, tmp_path):
    asked = {"edges": 2, "model": "meeting", "scheduler": "fsync", "corpus": tmp_path}
    team("waits", **asked)
    assert past(team(*names, **{**asked, **options}))[kind] == 1


MINE = """
from dataclasses import dataclass
from allworlds.robots.models.meeting import Meeting
from allworlds.robots.team import Team

@dataclass(frozen=True)
class Mine(Meeting):
    pass
"""


def test_a_finding_whose_model_has_another_text_is_stale(tmp_path):
    model = tmp_path / "model.py"
    corpus = tmp_path / "corpus"
    asked = {"edges": 1, "model": f"{model}:Mine", "corpus": corpus}
    model.write_text(MINE)
    assert past(team("waits", **asked)) == {"written": 1}
    model.write_text(f"{MINE}# changed\n")
    assert past(team("waits", **asked)) == {"stale": 1, "written": 1}


def interrupted_in_one_world(monkeypatch):
    """Have the user interrupt as soon as the programs search a given world."""
    through = TeamSweep._through

    def asked(sweep, ready):
        if sweep.request.world:
            raise KeyboardInterrupt
        return through(sweep, ready)

    monkeypatch.setattr(TeamSweep, "_through", asked)


def test_an_interrupt_while_a_finding_is_tried_again_ends_the_search(tmp_path, monkeypatch):
    asked = {"edges": 1, "model": "meeting", "corpus": tmp_path}
    team("waits", **asked)
    interrupted_in_one_world(monkeypatch)
    assert team("waits", **asked).exit_code == 130


def test_an_interrupt_of_a_replay_is_one(monkeypatch):
    found = finding()
    interrupted_in_one_world(monkeypatch)
    with pytest.raises(KeyboardInterrupt):
        allworlds.replay(found)


def test_the_limits_hold_for_each_search_of_a_past_finding(tmp_path, monkeypatch):
    through, seen = TeamSweep._through, []

    def kept(sweep, ready):
        seen.append(sweep.request)
        return through(sweep, ready)

    asked = {"edges": 1, "model": "meeting", "corpus": tmp_path}
    team("waits", **asked)
    monkeypatch.setattr(TeamSweep, "_through", kept)
    team("waits", **asked, time_limit=77, memory=4321)
    (again,) = seen
    assert again.world
    assert (again.time_limit, again.memory) == (77, 4321)


@pytest.mark.processes
def test_who_senses_what_is_answered_in_two_ways_is_blamed():
    found = team("changes_at_ends", model="meeting", budget=6, max_findings=99).findings
    blamed = [each for each in found if each.law == "nondeterministic"]
    assert len(blamed) > 5
    for each in blamed:
        assert each.map.degree_at[each.events[-2].darts[each.robot]] == 1


def test_the_searches_of_a_unit_are_counted_once_however_many_are_made_at_once(monkeypatch):
    whole, turn = team("waits", "searches", edges=2), SearchLane.turn
    monkeypatch.setattr("allworlds.robots.search_lane.AT_ONCE", 1)
    monkeypatch.setattr(SearchLane, "turn", lambda *lane: deepcopy(turn(*lane)))  # as if sent
    assert team("waits", "searches", edges=2).total == whole.total


def test_robots_with_tokens_walk():
    assert team("waits", "other_end", edges=1, model="tokens").verdict is Verdict.HOLDS


def test_a_move_that_comes_late_is_told_with_both_events():
    phases = [("look", 0), ("move", 1), ("look", 1), ("move", 0), ("move", 1)]
    turns = [SimpleNamespace(phase=phase, robot=robot) for phase, robot in phases]
    events = [SimpleNamespace(robots=[turn], world="") for turn in turns]
    late = SimpleNamespace(law="deadlock", seen="they wait", loop=0, events=events)
    *_, told = sentences_of(late)
    assert told == (
        "A move follows from what was sensed earlier: robot 0 looks in event 1 and moves in event "
        "4; robot 1 looks in event 3 and moves in event 5."
    )


def test_of_a_long_run_the_first_and_the_last_events_are_drawn(monkeypatch):
    monkeypatch.setattr("allworlds.reports.content.team.SHOWN_EVENTS", 2)
    (found,) = team("waits", "polls", edges=1, within=5).findings
    assert [line[0] for line in diagram(found)] == [" ", "1", "2", "3", "4", "5"]
    (found,) = team("waits", "polls", edges=1, within=6).findings
    lines = diagram(found)
    assert [line[0] for line in lines] == [" ", "1", "2", ".", "5", "6"]
    assert lines[3] == "... 2 more events: --json has all of them"


def test_a_program_of_this_process_is_not_sent_to_others():
    def waits_here(first):
        yield from ()

    here = Team((subject_of(waits_here, Limits()),), (0, 0))
    with pytest.raises(InputError, match="lives in this process alone and cannot be sent to"):
        assert here.with_content
    sent = Team((subject_of(f"{PROGRAMS}:waits", Limits()),), (0, 0)).with_content
    assert sent.program_of == (0, 0)
    assert "def waits" in str(sent.subjects[0])


def test_the_first_program_that_is_another_one_elsewhere_is_told(monkeypatch):
    told = {"a": "", "b": "b differs", "c": "c differs"}
    monkeypatch.setattr(team_module, "not_alike", lambda subject, *_: told[subject])
    assert Team(("a", "b", "c"), (0, 1, 2)).not_alike(("",) * 3, 1.0) == "b differs"
    assert Team(("a",), (0,)).not_alike(("",), 1.0) == ""


def test_a_replay_tells_the_law_of_then_and_of_now():
    (found,) = team("raises", model="meeting").findings
    again = replayed(found, None, TimeoutOptions())
    assert (again.law, again.law_now, again.outcome) == ("crash", "crash", "reproduced")
    (gone,) = team("other_end", model="meeting").findings
    mended = replayed(replace(gone, law="deadlock"), None, TimeoutOptions())
    assert (mended.law, mended.law_now, mended.outcome) == ("deadlock", "progress", "reproduced")


def test_a_schedule_needs_a_world_and_its_starts():
    with pytest.raises(InputError, match="needs a world and its starts"):
        team("waits", "polls", schedule="0+1")


def test_what_is_no_model_is_refused():
    with pytest.raises(InputError, match="model = 5 is neither a name nor a model"):
        team("waits", "polls", model=5)


def test_a_team_has_the_digest_of_each_program_and_is_sent_if_all_can_be(tmp_path):
    def waits_here(first):
        yield from ()

    file = tmp_path / "mine.py"
    file.write_text("def mine(first):\n    yield\n")
    mine, here = (subject_of(each, Limits()) for each in (f"{file}:mine", waits_here))
    built_in = subject_of("algorithm1", Limits())
    digest, other = Team((mine, built_in), (0, 1)).digests
    assert digest != other
    file.write_text("def mine(first):\n    yield 1\n")
    assert Team((subject_of(f"{file}:mine", Limits()),), (0,)).digests[0] != digest
    assert Team((mine, built_in), (0, 1)).importable
    assert not Team((mine, here), (0, 1)).importable


def test_a_corpus_that_cannot_be_written_is_a_remark_and_a_notice(tmp_path):
    (tmp_path / "file").touch()
    heard = []

    class Hears(Listener):
        def notice(self, text):
            heard.append(text)

    directory = tmp_path / "file" / "directory"
    report = team("waits", edges=1, model="meeting", corpus=directory, listener=Hears())
    (found,) = report.findings
    lost = f"the corpus could not take {found.file_name}: Not a directory"
    assert (report.remarks, heard) == ((lost,), [lost])


def test_a_finding_of_an_unfinished_level_is_kept_and_not_the_smallest():
    request = TeamRequest(explorers=[f"{PROGRAMS}:waits"], edges=1, model="meeting")
    sweep = TeamSweep(request, request.team())
    tally = sweep.empty()
    tally.find(finding())
    sweep.leave(SweptLevel(1, 2, ()), tally)
    (kept,) = sweep._tally.findings
    assert kept == replace(finding(), minimal=False)
    assert sweep._tally.rows == {}


def test_a_library_is_not_asked_turn_by_turn(monkeypatch):
    compiled = SimpleNamespace(compiled=True, name="mine.so")
    monkeypatch.setattr("allworlds.engines.single.subject_of", lambda *_: compiled)
    told = "'mine.so' is a shared library, which cannot be asked turn by turn; legal are functions"
    with pytest.raises(InputError, match=told):
        TeamRequest(explorers=["mine.so"], model="meeting").team()


def test_a_worker_of_a_cluster_has_one_lane_without_a_time_limit(monkeypatch):
    made = SimpleNamespace()

    def transport(address, workers, deadline, *, inside, probe):
        made.__dict__.update(address=address, workers=workers, inside=inside, probe=probe)
        return made

    monkeypatch.setattr("allworlds.engines.dask.Dask", transport)
    request = TeamRequest(
        explorers=[f"{PROGRAMS}:waits"], edges=1, dask="there:1", workers=3, time_limit=7
    )
    ready = TeamSweep(request, request.team()).ready()
    assert ready.transport is made
    assert (made.address, made.workers) == ("there:1", 3)
    sent, alone = made.inside.args
    assert "def waits" in str(sent.subjects[0])
    assert (alone.workers, alone.time_limit) == (1, None)
    assert made.probe() == ""


LEAST = {
    "robots": 1,
    "budget": 1,
    "within": 1,
    "lead": 1,
    "start_delay": 0,
    "configurations": 1,
    "max_findings": 1,
}


@pytest.mark.parametrize(("name", "least"), LEAST.items())
def test_numbers_of_a_team_have_a_least_value(name, least):
    asked = {"explorers": ("a", "b"), "edges": 1, "model": "meeting"}
    assert getattr(TeamRequest(**asked, **{name: least}), name) == least
    told = f"{name.replace('_', '-')} = {least - 1} is less than {least}, the least one"
    if name == "max_findings":
        told = "max-findings 0 is not positive and finite"
    with pytest.raises(InputError, match=told):
        TeamRequest(**asked, **{name: least - 1})
