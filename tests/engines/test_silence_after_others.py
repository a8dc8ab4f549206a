"""An explorer that is silent only after other runs ends the job with that finding."""

from allworlds.engines import GivenWorlds, Scope
from allworlds.engines.isolation.jobs import Unsettled
from allworlds.engines.python.in_process import InProcessPlayers
from allworlds.engines.python.python_engine import PythonEngine
from allworlds.engines.python.second_play import PlayedTwice
from allworlds.engines.transports.inline import with_last
from allworlds.explorers import algorithm1, in_process_subject
from allworlds.judging import Log, LostRun, Rules, place_of
from allworlds.maps import Extent, MapClass
from allworlds.world import worlds


class Silences(InProcessPlayers):
    """Players in this process, which say that one run was silent."""

    def __init__(self, *, machine):
        def explore(first):
            return (yield from algorithm1(first))

        super().__init__(in_process_subject(explore))
        self.lost = LostRun("timeout", "an action", "silent after others", "", machine)

    def play_runs(self, engine, unit, numbers, script=None):
        for logs in super().play_runs(engine, unit, numbers, script):
            yield [(number, Log((), (), self.lost) if number == 3 else log) for number, log in logs]


def parts(*, machine):
    """The parts of a unit, as a transport hands them over, up to the end or to an exception."""
    scope = Scope(Extent(MapClass.MAPS, 2), Rules())
    unit = GivenWorlds(tuple((world, place_of(world)) for world in worlds(edges=2, places="all")))
    twice = PlayedTwice(PythonEngine(scope, keep=1), "explore", Silences(machine=machine))
    handed_over = []
    try:
        for (_, tally), _ in with_last(twice.parts(unit)):
            handed_over.append(tally)
    except Unsettled as error:
        return handed_over, str(error)
    return handed_over, ""


def test_a_silence_after_others_ends_the_job_and_its_finding_is_handed_over():
    (tally,), reason = parts(machine=False)
    assert reason == "the explorer keeps a state: silent after others"
    assert [found.law for found in tally.findings] == ["timeout"]


def test_a_silence_of_a_world_leaves_the_others_to_be_done():
    tallies, reason = parts(machine=True)
    assert reason == ""
    assert sum(tally.runs for tally in tallies) == 30
    assert [found.law for tally in tallies for found in tally.findings] == ["timeout"]
