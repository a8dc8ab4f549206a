"""Isolation: users' code runs in processes that it may kill, and the check goes on.

The owner (a check) hands units to **referees**, which judge; each has two **players** with the
explorer in them, of which the first plays in worlds and the second against recorded percepts.
The **guardian** forks them all, and ends them, and all that they have started.

``jobs``, ``messages``
    messages to players; and those of players: integers and texts alone;
``failures``
    failures for which no explorer is to blame;
``referee_jobs``
    messages to referees, and their answers;
``guardian``, ``guardian_requests``, ``roles``, ``process``, ``process_tree``
    starting, reading and ending processes;
``memory_limit``
    the address space of a process, and a bound on it;
``relay``
    the stderr of processes, on its way to that of the owner;
``player``, ``world_player``, ``one_player``, ``player_pair``
    the process with the user's code in it, its plays in worlds, and the referee's side of one
    player, and of two;
``referee``, ``worker_engine``, ``workers``
    the process that judges units, the engine in it, and its owner's side: the transport;
``shared_logs``, ``library_player``, ``generator_player``
    many runs of a user's explorer at a time, in shared memory; played by a shared library, or by a
    generator;
``log_entries``
    the messages of an explorer in Python, as bytes;
``fresh_process``, ``apart``, ``confirm``
    one job in a process of its own; single runs there, and findings once more;
``subject_probe``
    the keywords that an explorer takes;
``overheard``
    the prints of a player in one run;
``stderr_stream``
    a stderr that may be lost.
"""
