"""Several robots in worlds that change: every schedule, and every choice of the adversary.

A *model* says how a world changes: where the robots can start, what they sense, and what can follow
their actions.  A model is built in, or a user's Python class.

``request`` has the request, ``team_report`` the report, ``search_sweep`` the search of all worlds;
``finding_reports`` searches the world of a finding again, and explains the run of a finding.
"""
