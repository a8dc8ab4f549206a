"""Writes motions without end, and reads none of the answers.

as: exec
verdict: refuted illegal-action
options: --edges 1 --answer-timeout 2 --step-budget 1000000
"""

import sys

LINES = '{"move": 0}\n' * 1000
while True:
    sys.stdout.write(LINES)
