"""The Python engine: runs are played, judged and added up.

``scope``
    the scope of a check: a class of worlds, all of it or a part, and the rules;
``runs_of_unit``
    the units into which it is cut;
``examiner``
    one run, judged;
``run_counter``
    the runs of a unit, and how they are counted, whoever plays them;
``python_engine``
    all runs of a unit; **the** loop of the exhaustive check;
``play``, ``second_play``, ``comparison``, ``in_process``
    a foreign explorer, which plays everything twice, and the comparison of both plays;
``tally``
    counts that can be added up in any order, and the smallest findings;
``costs``
    the same with the cost of every run.
"""
