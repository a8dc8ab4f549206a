"""Several robots in worlds that change: every schedule, and every choice of the adversary.

``request`` the request, ``team_report`` the report, ``search_sweep`` the search of all worlds,
``finding_reports`` findings whose worlds are searched again, or whose runs are explained.
"""
