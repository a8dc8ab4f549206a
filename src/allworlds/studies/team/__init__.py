"""Several robots in worlds that change: every schedule, and every choice of the adversary.

``request`` what is asked, ``team_report`` what is seen, ``search_sweep`` how all worlds are
searched, ``retold`` findings that are searched again, and told.
"""
