"""Players as their owner sees them, and a player's own part in this process."""

import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest

from allworlds.engines import linux
from engines import test_players as quick
from engines.test_players import RIGHT

module = quick.module

pytestmark = pytest.mark.processes


def test_players_end_with_the_process_that_has_started_them(module, tmp_path):
    if not linux.HERE:
        pytest.skip("elsewhere they end when their link is closed")
    pids = tmp_path / "pids"
    text = "import os\nfrom pathlib import Path\n"
    text += f"with Path({str(pids)!r}).open('a') as file:\n    file.write(f'{{os.getpid()}} ')\n"
    module.write_text(text + RIGHT)
    command = [sys.executable, "-m", "allworlds", "check", f"{module}:hangs", "--edges", "1"]
    command += ["--answer-timeout", "1"]
    process = subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    while not pids.exists() or len(pids.read_text().split()) < 3:
        time.sleep(0.01)
    process.send_signal(signal.SIGKILL)
    process.wait()
    for pid in pids.read_text().split():
        for _ in range(500):
            if not Path(f"/proc/{pid}").exists() or b"Z" in _state(pid):
                break
            time.sleep(0.01)
        else:
            raise AssertionError(f"the player {pid} goes on")


def _state(pid):
    try:
        return Path(f"/proc/{pid}/stat").read_bytes().rpartition(b")")[2].split()[0]
    except OSError:
        return b"Z"
