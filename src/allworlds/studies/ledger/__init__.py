"""The ledger of a paper: its sentences that can be checked, each with the check that decides it.

``claim``
    what a function that decides a claim takes and returns, and the file of the claims, read;
``checked_claims``
    found beside expected: the report;
``skeleton``
    the files that ``init --ledger`` writes.
"""
