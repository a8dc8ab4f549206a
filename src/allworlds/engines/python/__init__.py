"""The Python engine: runs are played, judged and added up.

``scope``
    the scope of a check: a class of worlds, all of it or a part, and the rules;
``runs_of_unit``
    the units of a scope;
``examiner``
    one run, judged;
``run_counter``
    the runs of a unit, and their counting in all engines;
``python_engine``
    all runs of a unit; **the** loop of the exhaustive check;
``play``, ``world_runner``, ``players``, ``second_play``, ``comparison``, ``in_process``
    a user's explorer, which plays every run twice, and the comparison of plays;
``prints``
    what the explorer prints in one run, escaped and limited;
``tally``
    counts that can be added up in any order, and the smallest findings;
``costs``
    a tally with the cost of every run.
"""
