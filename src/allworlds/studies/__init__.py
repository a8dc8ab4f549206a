"""Studies: the questions that are asked of all worlds, one file a verb, or a folder.

A study imports no other study but ``check``.
"""
