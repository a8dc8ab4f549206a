"""The same with SIGHUP.

as: exec
verdict: 130
signal: SIGHUP
"""

import signal
from pathlib import Path

for number in {*signal.Signals} - {signal.SIGKILL, signal.SIGSTOP}:
    signal.signal(number, signal.SIG_IGN)
Path("ready").touch()
while True:
    pass
