"""Never comes to the end of its import; whoever waits for it may interrupt.

verdict: 130
signal: SIGINT
"""

from pathlib import Path

Path("ready").touch()
while True:
    pass
