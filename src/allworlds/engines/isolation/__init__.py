"""Isolation: foreign code runs in processes that it may kill, and the check goes on.

The owner (a check) hands units to **referees**, which judge; each has two **players** with the
explorer in them, of which the one plays in worlds and the other against what was sensed there.
The **guardian** forks them all, and ends them, and all that they have started.

``jobs``, ``messages``
    what they say to each other, and what a player may say: integers and texts;
``guardian``, ``roles``, ``process``
    starting, hearing and ending processes;
``player``, ``cast``
    the process with the foreign code in it, and its referee's side;
``referee``, ``workers``
    the process that judges units, and its owner's side: the transport;
``shared_logs``, ``scribe``
    many runs of a foreign explorer at a time, in memory that is shared, and who writes their logs
    where the explorer is a generator;
``confirm``
    single runs, and findings once more in fresh processes;
``subject_probe``
    what an explorer takes, looked at once;
``stderr_stream``
    a stderr that may be lost.
"""
