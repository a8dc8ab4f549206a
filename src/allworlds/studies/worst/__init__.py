"""The exact worst and best cost of Algorithm 1 over all worlds and all schedules.

``every_schedule``
    one world, readably; also a sequence of choices that attains the worst cost;
``worst_request``
    what is asked for;
``worst_report``
    what is reported;
``all_worlds``
    every world of a class, with the compiled engine;
``compiled_engine``
    that engine, and what it brings.
"""
