"""The exact worst and best cost of Algorithm 1 over all worlds and all schedules.

``every_schedule``
    the costs in one world, in plain Python, and a sequence of choices that attains the worst cost;
``all_worlds``
    the costs in every world of a class: the request, the sweep and its report;
``compiled_engine``
    the compiled engine of this sweep.
"""
