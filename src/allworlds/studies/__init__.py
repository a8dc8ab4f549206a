"""Studies: the questions that are asked of all worlds, a file for a verb or two, or a folder.

A study imports no other study but ``check``.  Five modules are for all of them: ``options`` has
parts of requests, such as the listener, the cluster and the run directory, and ``findings`` the
part that names a finding; ``scopes`` makes the scope of a report, as it took effect; ``reports``
has the base of reports of jobs that ended, with or without rows; ``swept`` has requests and reports
of studies that go through units, and the gate of their counts.
"""
