"""A directory of findings: what is stale, and what cannot be written."""

from types import SimpleNamespace

import pytest

from allworlds.inputs.checks import InputError
from allworlds.protocol.user_code import OtherText
from allworlds.studies.user_corpus import UserCorpus


def test_a_finding_of_another_text_is_stale_and_the_others_are_tried(tmp_path):
    def read(text):
        if text == "other":
            raise OtherText("the lighthouse has another text now")
        return SimpleNamespace(key=int(text))

    for name, text in (("a", "2"), ("b", "other"), ("c", "1")):
        (tmp_path / f"{name}.json").write_text(text)
    corpus, tried = UserCorpus(tmp_path, read), []
    assert corpus.retry(lambda each: tried.append(each.key), lambda _: True) == []
    assert tried == [1, 2]
    report = corpus.report
    assert (report.stale, report.fixed) == (("b.json",), ("c.json", "a.json"))


def test_what_is_no_file_or_no_text_is_refused(tmp_path):
    (tmp_path / "a.json").write_bytes(b"\xff")
    with pytest.raises(InputError, match=r"^corpus file 'a.json' cannot be read: it is no text$"):
        UserCorpus(tmp_path, str).retry(lambda each: each, lambda _: True)
    (tmp_path / "a.json").unlink()
    (tmp_path / "b.json").mkdir()
    with pytest.raises(InputError, match=r"corpus file 'b.json' is no regular file; legal are"):
        UserCorpus(tmp_path, str).retry(lambda each: each, lambda _: True)
