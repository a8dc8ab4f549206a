"""A program that runs for ever and hears nothing, and who checks it gets SIGKILL.

as: exec
verdict: -9
signal: SIGKILL
"""

import signal
from pathlib import Path

for number in {*signal.Signals} - {signal.SIGKILL, signal.SIGSTOP}:
    signal.signal(number, signal.SIG_IGN)
Path("ready").touch()
while True:
    pass
