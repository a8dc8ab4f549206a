"""Many runs: cut into units, played, judged, added up, and kept.

The way of a run of a user's explorer::

    unit ---> player A, in worlds ---> log ---> judge ---> tally, findings
                                                  |
                                                  v  percepts, runs in random order
              player B, another process and hash seed ---> the same log?

A *job* is one call of a verb with many runs, such as a check.  A *level* of a job is all worlds
with one number of edges.  A *unit* is some maps of a level, with places of the lighthouse; a *run*
is one map and one place.  A *player* is a process with the explorer and without a judge; it makes
*logs*, which are bytes.  A player is *lost* if its process ends too early, or if it is silent for
too long.  A *judge* walks each log anew in the true map.  A *lane* is a judge with its two players;
each worker has one lane.  A run has these forms in turn: ``NumberedRun`` (in a unit), ``Due`` (in a
batch), ``Log`` (played), ``Episode`` (the log, followed in the world), ``Outcome`` (judged); then
it is counted, and becomes a ``Finding`` if it breaks a law.  For compiled built-in explorers there
are no players and no logs: the kernel plays and judges their runs in threads.

The modules of this package (logs are made and read outside of it, by ``protocol.playing`` and
``log``):

``units``
    the scope of a check; the units of a level, and the shards to which the units are dealt;
``limits``
    the limits of a job: workers, time-outs, time, memory;
``listeners``
    listeners to the progress of a job;
``lanes``, ``dask``
    transports, which bring units to lanes: in this process, in forked processes, or on a cluster;
``lane``
    the loop over the batches of some units, for a judge and its two players;
``batch``
    some runs of a unit, with their logs; the protocol of judges;
``plays``
    the two players of a lane and their messages; fresh players for runs that are played anew;
``losses``, ``hash_seeds``
    two tables: what the loss of a player means; what it means if the two plays of a run differ,
    which may be due to the different hash seeds of their processes;
``settling``, ``more_seeds``
    the search for runs of a batch that break a law; runs of the largest worlds, which are played
    again under six further hash seeds;
``across``
    all runs in small worlds, played once more in two opposite orders, to find runs that change a
    later run;
``players``, ``player``
    the code by which the owner of a player starts the player, hears it and notices its loss; the
    program that a player process executes;
``judge``, ``compiled_judge``, ``judges``
    the judge in Python, which knows every law; the judge in compiled code, which judges the same
    logs by the laws that the kernel knows; the choice between these two judges;
``tally``
    the counts and the findings;
``compiled_engine``, ``kernel``
    the compiled engine for built-in explorers; the compiled code that this engine calls, the only
    code that imports numba;
``kept_units``, ``run_directory``
    the identity of a job, and the results of its units as JSON; the directory that keeps finished
    units;
``engine_table``
    **the** table of the engines, the kinds of checks that the compiled engine cannot do, and the
    job that an engine gets; two further transports: to this thread, and to several threads;
``sweep``
    **the** loop over units, and through the levels of a study;
``user_code_checks``
    checks that the user's conditions and lighthouses give the same answers in fresh processes;
``single``
    single runs, and findings that fresh players play again;
``prints``, ``linux``
    the prints of explorers, and a stderr whose reader may be gone; system calls of Linux.
"""
