"""Many runs: cut into units, played, judged, added up, and kept.

The way of a run of a user's explorer::

    unit ---> player A, in worlds ---> log ---> judge ---> tally, findings
                                                  |
                                                  v  percepts, in a drawn order
              player B, another process and hash seed ---> the same log?

A *unit* is some maps of a level, with places of the lighthouse; a *run* is one of them.  A *log* is
bytes, and all that a *player* makes: a process with the explorer and without a judge.  A *judge*
walks each log anew in the true map.  A *lane* is a judge with its two players, one for each worker.
A run is, on its way: ``NumberedRun`` (of a unit), ``Due`` (in a batch), ``Log`` (of a play),
``Episode`` (followed), ``Outcome`` (judged), and counted, or a ``Finding``.
Built-in explorers in compiled code need none of this: the kernel plays and judges them, in threads.

The pieces, in the order of the way; ``protocol.playing`` and ``log`` make and read logs:

``units``
    the scope of a check; the units of a level, and the shards to which they fall;
``limits``
    the limits of a job: workers, time-outs, time, memory;
``listeners``
    listeners to the progress of a job;
``lanes``, ``dask``
    the places of work, transports: lanes here or forked; a Dask cluster;
``lane``
    the loop: a judge with its two players;
``batch``
    some runs on their way, with their logs; the protocol of judges;
``plays``
    two players and what they are given, and fresh ones for runs that are played anew;
``losses``, ``hash_seeds``
    the meanings of the loss of a player, and of plays under other hash seeds: tables;
``settling``, ``more_seeds``
    the faults of a batch; runs that are played again under six further seeds;
``across``
    all runs of small levels in both orders, and which earlier run makes a later one another;
``players``, ``player``
    a player from outside, started and heard, perhaps lost; and the program that it is;
``judge``, ``compiled_judge``, ``judges``
    the judge of every law, and its twin for the laws that the kernel knows: the same bytes; the
    choice between them;
``tally``
    what is counted and found;
``compiled_engine``, ``kernel``
    the engine in compiled code, for built-in explorers, and what it is asked; the code itself, the
    only importer of numba;
``kept_units``, ``run_directory``
    the identity of a job, and its results as JSON; its finished units, kept on disk;
``engine_table``
    **the** table of the engines, what the compiled one cannot do, and the job that they get; two
    transports more: this thread, threads;
``sweep``
    **the** loop over units, and through the levels of a study;
``asked_again``
    predicates and lighthouses of the user's, asked again in fresh processes;
``single``
    single runs, and findings that are played again, by the same players;
``hints``
    a finding with what more plays show: options that help, and lines of the user's code;
``prints``, ``linux``
    prints of explorers, escaped and limited, and a stderr that may be lost; what is Linux's alone.
"""
