"""What the page of the paper shows can be done as it stands there."""

import re
import shutil
import subprocess
import sys

from paper_claims import PAPER

PAGE = (PAPER / "README.md").read_text(encoding="utf-8")


def test_the_page_is_one_page():
    assert len(PAGE.split()) <= 1200


def test_every_picture_is_shown():
    shown = re.findall(r"!\[.+\]\((figures/.+\.svg)\)", PAGE)
    assert {PAPER / name for name in shown} == {*(PAPER / "figures").glob("*.svg")}


def test_a_claim_of_ones_own_is_as_expected(tmp_path):
    for kind, name in (("python", "claims.py"), ("toml", "ledger.toml")):
        (block,) = re.findall(rf"```{kind}\n(.+?)```", PAGE, re.DOTALL)
        (tmp_path / name).write_text(block, encoding="utf-8")
    shutil.copy(PAPER.parents[1] / "examples" / "robots" / "rendezvous.py", tmp_path)
    command = [sys.executable, "-m", "allworlds", "ledger", str(tmp_path), "-q"]
    run = subprocess.run(command, capture_output=True, text=True, check=False)
    assert run.stdout == "HOLDS: 1 claim: 1 holds\n", run.stdout + run.stderr
