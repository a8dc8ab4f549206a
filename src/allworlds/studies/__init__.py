"""Studies: each answers a question about all worlds of a class.

A study is a file, for a verb or two, or a folder; a *verb* is a command such as ``check``.  A study
imports no other study but ``check`` and ``team``.  Six modules are shared: ``options`` has the
parts of requests that name the listener, the Dask cluster and the run directory; ``findings`` has
the part of a request that names a finding; ``scopes`` makes the scope of a report from the options
that took effect; ``reports`` has the base classes of reports that say how a job ended: with all its
work done, or earlier; ``swept`` has the base classes of requests and reports of studies that go
through units, and the document of the count gate; ``user_corpus`` has the user's directory of
earlier findings.

A *sweep* goes through the *levels* of a job: most often a level is all worlds with one number of
edges.  A *unit* is a piece of a level that one worker does, a *tally* the counts and findings of
runs.  An *extent* is a class of maps with its bounds, or the given maps.  A *listener* is told of
the progress of a job.
"""
