"""Several robots in worlds that change: every schedule, and every choice of the adversary.

``request`` has the request, ``team_report`` the report, ``search_sweep`` the search of all worlds;
``finding_reports`` searches the world of a finding again, and explains the run of a finding.
"""
