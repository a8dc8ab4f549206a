"""A program that runs for ever and ignores signals; the process that checks it gets SIGHUP.

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
