"""Run directories: what is finished of a job, kept so that nobody has to do it again.

``identity``
    what a job is: two results can be put together exactly if they are of the same;
``database``
    the file of a run directory, in which every row has a checksum;
``finished_units``
    where the finished units of a job are: nowhere, in a run directory, or in several.

A result is kept as a JSON value.  Nothing that is read from a directory is ever run.
"""
