"""Numbers and lists in words."""

import json
import unicodedata

import pytest

from allworlds.words import (
    about,
    duration,
    escaped,
    harmless,
    harmless_json,
    listed,
    number,
    plural,
    size,
)


def test_a_size_is_told_in_edges_and_vertices():
    assert size(1, 2) == "1 edge and 2 vertices"
    assert size(2, 1) == "2 edges and 1 vertex"


def test_only_one_is_singular():
    assert [plural(n, "edge") for n in range(3)] == ["0 edges", "1 edge", "2 edges"]
    assert [plural(n, "class", "classes") for n in (1, 2)] == ["1 class", "2 classes"]


def test_thousands_are_separated():
    assert number(999) == "999"
    assert plural(1_234_567, "run") == "1,234,567 runs"


@pytest.mark.parametrize(
    ("names", "words"),
    [("1", "1"), ("13", "1 and 3"), ("135", "1, 3 and 5")],
)
def test_the_last_of_several_follows_an_and(names, words):
    assert listed(names) == words


@pytest.mark.parametrize(
    ("seconds", "words"),
    [
        (12, "12 s"),
        (300, "5 min"),
        (12_000, "3 h 20 min"),
        (4 * 86_400 + 3 * 3600, "4 days 3 h"),
        (70_499 * 365 * 86_400.0, "70,000 years"),
        (3 * 365 * 86_400, "3 years"),
        (1e300, "more than 1,000,000,000,000 years"),
    ],
)
def test_a_duration_is_rounded_to_what_one_can_imagine(seconds, words):
    assert duration(seconds) == words


def test_a_number_of_many_digits_is_told_by_the_first_two():
    assert about(123_456_789_012_345) == "123,456,789,012,345"
    assert about(637 * 10**74) == "6.3 x 10^76"


UNSEEN = [chr(code) for code in (0xAD, 0x200B, 0x202E, 0x2069, 0xFEFF, 0xE0041, 0x7F, 0x9B)]


def test_what_controls_a_text_or_is_not_seen_is_shown_as_its_number():
    for letter in [*map(chr, range(32)), *UNSEEN]:
        kept = letter in "\t\n\r"
        assert escaped(f"a{letter}b") == (f"a{letter}b" if kept else f"a{ascii(letter)[1:-1]}b")


def test_what_is_seen_stays():
    seen = [
        letter
        for letter in map(chr, range(0x3000))
        if unicodedata.category(letter)[0] != "C" and letter not in "\u2028\u2029"
    ]
    assert escaped("".join(seen)) == "".join(seen)


@pytest.mark.parametrize(
    ("text", "shown"),
    [
        ("::error::x", ":\\x3aerror::x"),
        ("a\n \t::x\r::y", "a\n \t:\\x3ax\r:\\x3ay"),
        ("a::b : :", "a::b : :"),
        ("##[error]x ##vso[y] # #[z]", "##\\x5berror]x ##vso\\x5by] # #[z]"),
        ("\x1b[0m\n::error::\u202e", "\\x1b[0m\n:\\x3aerror::\\u202e"),
    ],
)
def test_no_line_is_a_command_for_a_runner(text, shown):
    assert harmless(text) == shown
    assert harmless(shown) == shown


def test_no_line_of_json_is_a_command_and_the_document_is_the_same():
    document = {"##[a]": ["b ##vso[c]", "#[", "::"]}
    text = harmless_json(json.dumps(document, indent=1))
    assert json.loads(text) == document
    assert "##[" not in text
    assert "##vso[" not in text


@pytest.mark.parametrize(
    ("seconds", "words"),
    [
        (0.99, "0 s"),
        (59.99, "59 s"),
        (60, "1 min"),
        (3599, "59 min"),
        (3600, "1 h 0 min"),
        (86_399, "23 h 59 min"),
        (86_400, "1 day 0 h"),
        (730 * 86_400 - 1, "729 days 23 h"),
        (730 * 86_400, "2 years"),
        (99 * 365 * 86_400, "99 years"),
        (119 * 365 * 86_400, "110 years"),
        ((10**12 - 1) * 365 * 86_400, "990,000,000,000 years"),
        (10**12 * 365 * 86_400, "more than 1,000,000,000,000 years"),
    ],
)
def test_a_unit_begins_where_the_one_before_is_full(seconds, words):
    assert duration(seconds) == words


def test_numbers_of_up_to_15_digits_are_told_whole():
    assert about(10**15 - 1) == "999,999,999,999,999"
    assert about(10**15) == "1.0 x 10^15"
