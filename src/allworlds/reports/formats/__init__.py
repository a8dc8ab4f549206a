"""The file formats of reports, a module for each, with a ``FORMAT``.

A new one is a module and a line of the table in ``format_table``.  What takes long to load is
imported where it is used, since the command line needs every module.
"""
