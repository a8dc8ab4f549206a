"""A program that says nothing, and does not listen.

as: exec
verdict: refuted timeout
options: --edges 1 --answer-timeout 1
"""

import time

time.sleep(3600)
