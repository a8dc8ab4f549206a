"""Whatever text an element is given, it is text and no markup."""

import json
from html.parser import HTMLParser

import pytest

from allworlds.reports.drawing.svg import document, legal, raw, record, tag


def test_characters_that_html_does_not_allow_are_replaced_and_others_kept():
    forbidden = "\0\x08\x0b\x1f\x7f\x85\ud800\udfff\ufdd0\ufdef\ufffe\uffff\U0001ffff\U0010fffe"
    assert legal(forbidden) == "\N{REPLACEMENT CHARACTER}" * len(forbidden)
    kept = "\t\n az~\xa0é\u202e漢\ufdcf\ufdf0\ufffd\U0001f600\U0010fffd"
    assert legal(kept) == kept


def test_a_script_that_would_end_itself_is_no_element():
    with pytest.raises(ValueError, match="would end it"):
        raw("script", "'</script>'")
    block = record({"x": "</script><!--&"}, id="x")
    assert json.loads(block.text) == {"x": "</script><!--&"}


class Read(HTMLParser):
    """The events of a text as a browser reads it."""

    def __init__(self, text):
        super().__init__(convert_charrefs=True)
        self.told = []
        self.feed(text)
        self.close()

    def handle_starttag(self, tag, attrs):
        self.told.append((tag, dict(attrs)))

    def handle_data(self, data):
        self.told.append(data)


def test_text_and_attributes_are_escaped():
    text = document(tag("p", "<i>", tag("b", "&"), "</p>", title="\"'<>"))
    assert Read(text).told == [
        "\n",
        ("p", {"title": "\"'<>"}),
        "<i>",
        ("b", {}),
        "&",
        "</p>",
        "\n\n",
    ]
