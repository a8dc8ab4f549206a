"""Tellings of each verb's result: a module for each verb, or for verbs with equal tellings.

A module makes the telling of a result (:mod:`allworlds.reports.telling`); the table of the verbs
names its function.  ``finding`` and ``single_run`` make sections that several verbs have.
"""
