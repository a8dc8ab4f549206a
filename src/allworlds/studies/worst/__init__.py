"""The exact worst and best cost of Algorithm 1 over all worlds and all schedules.

``every_schedule``
    one world, in plain Python; also a sequence of choices that attains the worst cost;
``all_worlds``
    every world of a class: the request, the sweep and its report;
``compiled_engine``
    the compiled engine of that sweep.
"""
