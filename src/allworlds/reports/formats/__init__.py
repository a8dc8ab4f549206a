"""The file formats of reports: a module for each, named as its option.

A new format is a module of this package with a ``FORMAT``; ``FORMATS`` of ``format_table`` finds
it.  What takes long to load is imported where it is used, since the options need every module.
"""
