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
    the units of a level, and the shards to which they fall;
``effort``
    the limits of a job: workers, time-outs, time, a cluster;
``lanes``, ``here``, ``dask``
    the places of work, transports: lanes here or forked; this thread, threads; a Dask cluster;
``lane``
    a judge with its two players: batches, losses, plays that differ, other hash seeds;
``players``, ``player``
    a player from outside, started and heard, perhaps lost; and the program that it is;
``judge``, ``compiled_judge``
    the judge of every law, and its twin for the laws that the kernel knows: the same bytes;
``scope``, ``examiner``, ``comparison``, ``tally``
    the scope of a check; one judged run; the comparison of two plays; what is counted and found;
``obstacles``, ``compiled_engine``, ``questions``, ``kernel``
    what compiled code cannot do; the engine in it, for built-in explorers; what it is asked; the
    code itself, the only importer of numba;
``run_directory``, ``database``, ``kept_form``
    the finished units of a job, kept on disk; their file, with the identity of the job; as JSON;
``engine_table``
    **the** table of the engines, and the job that they get;
``sweep``, ``progress``, ``swept_report``
    **the** loop over units, and through the levels of a study; its listeners, and its reports;
``single``, ``other_worlds``
    single runs, and findings that are played again, by the same players; and that in other worlds;
``prints``, ``linux``
    prints of explorers, escaped and limited, and a stderr that may be lost; what is Linux's alone.
"""

from typing import TYPE_CHECKING

from allworlds.lazy import open_door

if TYPE_CHECKING:
    from allworlds.engines.comparison import nondeterministic as nondeterministic
    from allworlds.engines.dask import Dask as Dask
    from allworlds.engines.database import (
        Identity as Identity,
        canonical as canonical,
        reading as reading,
    )
    from allworlds.engines.effort import (
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
    from allworlds.engines.engine_table import (
        ENGINES as ENGINES,
        EngineKind as EngineKind,
        EngineName as EngineName,
        Job as Job,
        ReadyEngine as ReadyEngine,
        engine_for as engine_for,
        players_for as players_for,
        why_not_compiled as why_not_compiled,
    )
    from allworlds.engines.examiner import (
        LOST as LOST,
        Examiner as Examiner,
        Outcome as Outcome,
        Referee as Referee,
    )
    from allworlds.engines.here import Threads as Threads, here_or as here_or
    from allworlds.engines.kept_form import from_kept as from_kept
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
    from allworlds.engines.obstacles import COMPILER as COMPILER, WALKED_FROM as WALKED_FROM
    from allworlds.engines.other_worlds import (
        confirmed as confirmed,
        played_elsewhere as played_elsewhere,
    )
    from allworlds.engines.players import Unsettled as Unsettled
    from allworlds.engines.prints import patient_stderr as patient_stderr
    from allworlds.engines.progress import Listener as Listener, Once as Once, Silent as Silent
    from allworlds.engines.run_directory import (
        ENDED as ENDED,
        Gap as Gap,
        Records as Records,
        in_use as in_use,
        merged as merged,
    )
    from allworlds.engines.scope import (
        Given as Given,
        GivenWorlds as GivenWorlds,
        LevelRuns as LevelRuns,
        Placed as Placed,
        Sample as Sample,
        Scope as Scope,
        UnitOfRuns as UnitOfRuns,
    )
    from allworlds.engines.single import (
        SingleRun as SingleRun,
        single_run as single_run,
        subject_of as subject_of,
        unused_choice as unused_choice,
    )
    from allworlds.engines.sweep import Sweep as Sweep, gather as gather
    from allworlds.engines.swept_report import (
        GATE as GATE,
        AskedRows as AskedRows,
        By as By,
        EndedReport as EndedReport,
        RowsReport as RowsReport,
        SweptExit as SweptExit,
        SweptReport as SweptReport,
        ToldGate as ToldGate,
        TriedPlaces as TriedPlaces,
        by_named as by_named,
        told_scope as told_scope,
        tried_places as tried_places,
    )
    from allworlds.engines.tally import (
        AtRun as AtRun,
        EnginesDisagree as EnginesDisagree,
        Row as Row,
        RunCounter as RunCounter,
        Tally as Tally,
        finding_from_record as finding_from_record,
        finding_to_record as finding_to_record,
    )
    from allworlds.engines.units import (
        WHOLE as WHOLE,
        AskedShard as AskedShard,
        LevelUnit as LevelUnit,
        PartialResult as PartialResult,
        Portion as Portion,
        Shard as Shard,
        SweptLevel as SweptLevel,
        Transport as Transport,
        cells_of_level as cells_of_level,
        dealt as dealt,
        drawn_units as drawn_units,
        is_counted as is_counted,
        level_size as level_size,
        shards_of as shards_of,
    )
else:
    open_door(__name__)
