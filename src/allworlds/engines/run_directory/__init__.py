"""Run directories: the finished units of a job, kept so that they are not done again.

``identity``
    a job's identity: results are merged only if their identities are equal;
``database``
    the file of a run directory, in which every row has a checksum;
``finished_units``
    the finished units of a job: not kept, in a run directory, or in several.

A result is kept as a JSON value.  Data from a directory are never run as code.
"""
