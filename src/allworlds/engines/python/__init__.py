"""Runs in Python: judged, compared, counted and added up.

``scope``
    the scope of a check: a class of worlds, all of it or a part, and the rules;
``runs_of_unit``
    the units of a scope;
``examiner``
    one run, judged;
``run_counter``
    the runs of a unit, and their counting in all engines;
``comparison``
    two plays of one run, and what their difference means;
``tally``
    counts that can be added up in any order, and the smallest findings;
``costs``
    a tally with the cost of every run.
"""
