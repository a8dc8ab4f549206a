"""The scripts of the page of play, asked line by line."""

import json
import shutil
import subprocess
from pathlib import Path

import pytest

import allworlds

SCRIPTS = Path(allworlds.__file__).parent / "reports" / "web"
ANSWERS = Path(__file__).with_name("answers.js")


@pytest.fixture(scope="module")
def ask():
    """A function from a question to what the scripts of the page answer."""
    node = shutil.which("node")
    if node is None:
        pytest.skip("node is not installed")
    with subprocess.Popen(
        [node, str(ANSWERS), str(SCRIPTS)], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True
    ) as process:

        def answer(**question):
            process.stdin.write(json.dumps(question) + "\n")
            process.stdin.flush()
            return json.loads(process.stdout.readline())

        yield answer
        process.stdin.close()
        assert process.wait(timeout=60) == 0
