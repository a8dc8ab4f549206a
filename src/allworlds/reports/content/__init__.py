"""The content of the report of each verb.

The table ``MAKERS`` of ``reports.formats`` names the functions that make contents.
"""
