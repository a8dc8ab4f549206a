import json
import lzma
import random
import shutil

import pytest

from proofs import test_claims as quick
from proofs.test_claims import CLAIMS, check, with_right_digests

copied = quick.copied


@pytest.mark.slowest
def test_every_claim_holds_by_the_files_alone_and_without_any_package(copied):
    # -S: no site-packages; so neither a solver nor this project can be imported.
    code, said = check(copied)
    assert code == 0, said
    for claim in CLAIMS:
        assert f"\n{claim:<22}holds" in said


def certificates(proofs_):
    return sorted(json.loads((proofs_ / "manifest.json").read_text()))


@pytest.mark.slowest
@pytest.mark.parametrize("seed", range(8))
def test_a_certificate_with_one_byte_changed_makes_the_check_fail(copied, seed):
    chance = random.Random(seed)
    small = [name for name in certificates(copied) if not name.startswith(("fig", "small"))]
    assert len(small) == 15
    name = chance.choice(small)
    data = bytearray((copied / name).read_bytes())
    data[chance.randrange(len(data))] ^= 1 << chance.randrange(8)
    (copied / name).write_bytes(bytes(data))
    code, said = check(copied, name.split("/")[0])
    assert (code, "FAILS" in said) == (1, True), said


@pytest.mark.slowest
def test_a_harmless_change_of_a_certificate_is_rejected_too(copied):
    path = copied / "no-twins-directional" / "m1.lrat.xz"
    path.write_bytes(lzma.compress(lzma.decompress(path.read_bytes()), preset=0))
    code, said = check(copied, "no-twins-directional")
    assert code == 1
    assert "no-twins-directional/m1.lrat.xz is not the file that was committed" in said


@pytest.mark.parametrize(
    ("claim", "file", "old", "new", "reason"),
    [
        ("cycles", "3-alpha.smt2", "(< x n)", "(< x 0)", "3-alpha.smt2: command 8 is "),
        ("natural-lighthouse", "pair.json", '"start": 0', '"start": -8', "start is -8, but"),
        ("natural-lighthouse", "pair.json", "{", "[" * 100_000, "nested too deeply"),
        ("natural-lighthouse", "pair.json", '"natural"', '"xyz"', "is 'xyz', not 'natural'"),
    ],
)
def test_a_file_that_says_something_else_is_refused_whatever_the_manifest_says(
    copied, claim, file, old, new, reason
):
    path = copied / claim / file
    text = path.read_text()
    assert old in text
    path.write_text(text.replace(old, new))
    with_right_digests(copied)
    code, said = check(copied, claim)
    assert (code, reason in said, len(said.splitlines())) == (1, True, 2), said


@pytest.mark.slowest
def test_a_certificate_that_the_manifest_does_not_name_is_refused(copied):
    shutil.copy(copied / "natural-lighthouse" / "pair.json", copied / "cycles" / "more.json")
    code, said = check(copied, "cycles")
    assert (code, "cycles/more.json is not in the manifest" in said) == (1, True), said
