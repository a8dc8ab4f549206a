"""Many runs: cut into units, played, judged, added up, and kept.

The way of a run of a user's explorer::

    unit ---> player A, in worlds ---> log ---> judge ---> tally, findings
                                                  |
                                                  v  percepts, in a drawn order
              player B, another process and hash seed ---> the same log?

A *unit* is some maps of a level, with places of the lighthouse; a *run* is one of them.  A *log* is
bytes, and all that a *player* makes: a process with the explorer and without a judge.  A *judge*
walks each log anew in the true map.  A *lane* is a judge with its two players, one for each worker.
Built-in explorers in compiled code need none of this: the kernel plays and judges them, in threads.

The pieces, in the order of the way; ``protocol.playing`` and ``log`` make and read logs:

``units``
    the units of a level, shards of them, limits of the effort, and the one loop over them;
``lanes``, ``transports``
    the places of work: lanes here or forked; threads, a Dask cluster;
``lane``
    a judge with its two players: batches, losses, plays that differ, other hash seeds;
``players``, ``player``
    a player from outside, started and heard, perhaps lost; and the program that it is;
``library_player``
    the batches of a shared library, played in compiled code;
``judge``, ``compiled_judge``
    the judge of every law, and its twin for the laws that the kernel knows: the same bytes;
``python``
    scopes, one judged run, the comparison of two plays, counts, tallies;
``compiled``, ``kernel``
    requests to compiled code, and tallies of its rows; the code itself, the only importer of numba;
``run_directory``
    the finished units of a job, kept on disk;
``job``, ``engine_table``
    the task of an engine, and **the** table of the engines;
``sweep``, ``progress``, ``ended_report``, ``swept_report``
    **the** loop through the levels of a study, its listeners, and its reports;
``single``, ``run_report``
    single runs, findings that are played again, by the same players; the report of one;
``other_worlds``, ``subject_probe``
    the explorer of a finding in other worlds; what a player tells of an explorer;
``prints``, ``stderr_stream``, ``linux``
    prints of explorers, escaped and limited; a stderr that may be lost; what is Linux's alone.
"""

from typing import TYPE_CHECKING

from allworlds.lazy import open_door

if TYPE_CHECKING:
    from allworlds.engines.compiled.sizes import COMPILER as COMPILER, WALKED_FROM as WALKED_FROM
    from allworlds.engines.ended_report import EndedReport as EndedReport, RowsReport as RowsReport
    from allworlds.engines.engine_table import (
        ENGINES as ENGINES,
        EngineKind as EngineKind,
        EngineName as EngineName,
        ReadyEngine as ReadyEngine,
        engine_for as engine_for,
        players_for as players_for,
        why_not_compiled as why_not_compiled,
    )
    from allworlds.engines.job import Job as Job
    from allworlds.engines.kernel.capabilities import COMPILING as COMPILING
    from allworlds.engines.kernel.compiling import is_compiled as is_compiled
    from allworlds.engines.kernel.counting import by_vertices_and_faces as by_vertices_and_faces
    from allworlds.engines.kernel.engine import flag as flag
    from allworlds.engines.kernel.schedules import (
        ScheduleCosts as ScheduleCosts,
        schedule_costs_of_unit as schedule_costs_of_unit,
        search as search,
    )
    from allworlds.engines.lane import GOES_BY_HASHES as GOES_BY_HASHES
    from allworlds.engines.lanes import workers_for as workers_for
    from allworlds.engines.other_worlds import (
        confirmed as confirmed,
        played_elsewhere as played_elsewhere,
    )
    from allworlds.engines.players import Unsettled as Unsettled
    from allworlds.engines.progress import Listener as Listener, Once as Once, Silent as Silent
    from allworlds.engines.python.comparison import nondeterministic as nondeterministic
    from allworlds.engines.python.costs import (
        CostEngine as CostEngine,
        CostTally as CostTally,
        MapKey as MapKey,
        key_of as key_of,
    )
    from allworlds.engines.python.examiner import (
        LOST as LOST,
        Examiner as Examiner,
        Referee as Referee,
    )
    from allworlds.engines.python.run_counter import (
        EnginesDisagree as EnginesDisagree,
        RunCounter as RunCounter,
    )
    from allworlds.engines.python.runs_of_unit import (
        GivenWorlds as GivenWorlds,
        LevelRuns as LevelRuns,
        Placed as Placed,
        UnitOfRuns as UnitOfRuns,
    )
    from allworlds.engines.python.scope import Given as Given, Sample as Sample, Scope as Scope
    from allworlds.engines.python.tally import (
        AtRun as AtRun,
        Row as Row,
        Tally as Tally,
        finding_from_record as finding_from_record,
        finding_to_record as finding_to_record,
    )
    from allworlds.engines.run_directory.database import reading as reading
    from allworlds.engines.run_directory.finished_units import (
        ENDED as ENDED,
        Gap as Gap,
        Records as Records,
        in_use as in_use,
        merged as merged,
    )
    from allworlds.engines.run_directory.identity import (
        Identity as Identity,
        canonical as canonical,
    )
    from allworlds.engines.run_report import SingleRun as SingleRun, unused_choice as unused_choice
    from allworlds.engines.single import single_run as single_run
    from allworlds.engines.stderr_stream import patient_stderr as patient_stderr
    from allworlds.engines.subject_probe import subject_of as subject_of
    from allworlds.engines.sweep import Sweep as Sweep
    from allworlds.engines.swept_report import (
        GATE as GATE,
        SweptExit as SweptExit,
        SweptReport as SweptReport,
        ToldGate as ToldGate,
        TriedPlaces as TriedPlaces,
        told_scope as told_scope,
        tried_places as tried_places,
    )
    from allworlds.engines.transports.dask import Dask as Dask, here_or as here_or
    from allworlds.engines.transports.threads import Threads as Threads
    from allworlds.engines.units.effort import (
        AskedCluster as AskedCluster,
        AskedDirectory as AskedDirectory,
        AskedListener as AskedListener,
        AskedPatience as AskedPatience,
        AskedTime as AskedTime,
        AskedWorkers as AskedWorkers,
        ClusterLost as ClusterLost,
        Limits as Limits,
        TimeIsUp as TimeIsUp,
    )
    from allworlds.engines.units.gather import gather as gather
    from allworlds.engines.units.kept_form import from_kept as from_kept
    from allworlds.engines.units.levels import (
        LevelUnit as LevelUnit,
        SweptLevel as SweptLevel,
        cells_of_level as cells_of_level,
        drawn_units as drawn_units,
        is_counted as is_counted,
        level_size as level_size,
    )
    from allworlds.engines.units.listing import (
        AskedRows as AskedRows,
        By as By,
        by_named as by_named,
    )
    from allworlds.engines.units.shards import (
        WHOLE as WHOLE,
        AskedShard as AskedShard,
        Portion as Portion,
        Shard as Shard,
        dealt as dealt,
        shards_of as shards_of,
    )
    from allworlds.engines.units.unit import PartialResult as PartialResult, Transport as Transport
else:
    open_door(__name__)
