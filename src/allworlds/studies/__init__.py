"""Studies: questions about all worlds, each in a file for a verb or two, or in a folder.

A study imports no other study but ``check``.  Five modules are shared: ``options`` has parts of
requests: the listener, the Dask cluster and the run directory; ``findings`` has the part that
names a finding; ``scopes`` makes the scope of a report from the options that took effect;
``reports`` has the base of reports of jobs that ended, with or without rows; ``swept`` has the
requests and reports of studies that go through units, and their count gate.

A *sweep* goes through the *levels* of a job: most often a level is all worlds with one number of
edges.  A *unit* is a piece of a level that one worker does, a *tally* the counts and findings of
runs.
"""
