"""The Python engine: runs, played, judged and added up.

``scope``
    what is to be checked: a class of worlds, all of it or a part, and the rules;
``runs_of_unit``
    the pieces of work into which it is cut;
``examiner``
    one run, judged, and what differs between two plays of it;
``python_engine``
    all runs of a unit; **the** loop of the exhaustive check;
``play``, ``second_play``, ``in_process``
    a foreign explorer, which plays everything twice;
``tally``
    counts that can be added up in any order, and the smallest findings;
``costs``
    the same with the cost of every run.
"""
