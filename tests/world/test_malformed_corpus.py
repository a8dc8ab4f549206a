"""A corpus that is none is refused in one line, whatever is wrong with it."""

import hashlib
import json

import pytest

from allworlds.inputs.checks import InputError
from allworlds.world.corpus import MANIFEST, load_corpus

ENTRY = {
    "name": "a",
    "kind": "world",
    "file": "a.json",
    "sha256": "0" * 64,
    "provenance": "made",
    "expected": {},
}


def entries(rows):
    return json.dumps({"schema": 1, "entries": rows}).encode()


@pytest.mark.parametrize(
    ("manifest", "said"),
    [
        (b"\xff\xfe", "is no text"),
        (b"", "not JSON"),
        (b"[" * 100_000, "not JSON"),
        (b"[]", "manifest.json: expected object, got array"),
        (b'{"schema": 2}', "schema = 2 is not one of 1"),
        (b'{"schema": 1}', "manifest.json: object missing required field entries"),
        (b'{"schema": 1, "schema": 1}', "stands twice"),
        (entries(True), "entries = True: expected array, got bool"),  # noqa: FBT003
        (entries(None), "entries = None: expected array, got null"),
        (entries({"a": ENTRY}), "expected array, got object"),
        (entries([3]), "entries[0] = 3: expected object, got int"),
        (entries([{**ENTRY, "kind": []}]), "entries[0].kind = []: expected str, got array"),
        (entries([{**ENTRY, "name": None}]), "entries[0].name = None: expected str, got null"),
        (entries([{**ENTRY, "a\nb": 1}]), r"object contains unknown field a\nb"),
        (entries([{**ENTRY, "a` - at `$[b": 1}]), "unknown field a - at $[b"),
        (entries([{**ENTRY, "\ud800": 1}]), "a key or a word in it is no text"),
        (entries([ENTRY, ENTRY]), "corpus entry 'a' occurs twice"),
    ],
)
def test_a_manifest_that_is_none_is_refused(tmp_path, manifest, said):
    (tmp_path / MANIFEST).write_bytes(manifest)
    with pytest.raises(InputError) as refusal:
        load_corpus(tmp_path)
    assert said in str(refusal.value)
    assert "\n" not in str(refusal.value)


@pytest.mark.parametrize(
    ("file", "content", "said"),
    [
        ("b.json", b"{}", "No such file"),
        (".", b"{}", "Is a directory"),
        ("a\0b", b"{}", "No such file"),
        ("\ud800", b"{}", "No such file"),
        ("x" * 5000, b"{}", "File name too long"),
        ("a.json", b"\xff", "'a.json' is no text"),
        ("a.json", b"[" * 100_000, "not JSON"),
        ("a.json", None, "has the digest"),
    ],
)
def test_a_file_that_is_none_is_refused(tmp_path, file, content, said):
    digest = hashlib.sha256(content or b"").hexdigest()
    (tmp_path / MANIFEST).write_bytes(entries([{**ENTRY, "file": file, "sha256": digest}]))
    (tmp_path / "a.json").write_bytes(content or b"changed")
    corpus = load_corpus(tmp_path)
    with pytest.raises(InputError, match=said) as refusal:
        corpus.document(corpus.entries[0])
    assert "\n" not in str(refusal.value)
