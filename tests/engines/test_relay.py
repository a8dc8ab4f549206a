"""The relay, which takes the text of explorers to stderr."""

import os

import pytest

from allworlds.cli.output import printable
from allworlds.engines.isolation.relay import Relay
from allworlds.words import escaped


@pytest.fixture
def said():
    """Say texts through a relay, one after the other; what has come out."""
    out, into = os.pipe()

    def say(*texts):
        relay = Relay()
        end = relay.leading_to(into)
        for text in texts:
            os.write(end, text if isinstance(text, bytes) else text.encode())
            relay.pass_on()
        os.close(end)
        return os.read(out, 1 << 16).decode()

    yield say
    os.close(out)


@pytest.mark.parametrize(
    ("text", "shown"),
    [
        ("plain\n", "plain\n"),
        ("a::b\n::\n", "a::b\n\\x3a:\n"),
        ("::error::x\n \t::y", "\\x3a:error::x\n \t\\x3a:y"),
        ("\u202eturned\x9b\n", "\\u202eturned\\x9b\n"),
        (":\n: :\n", ":\n: :\n"),
        (b"\xff::\n", "\\xff::\n"),
        ("10%\r::error::x\r\n::y\n", "10%\r\\x3a:error::x\r\n\\x3a:y\n"),
        ("\x0b::x\n\u2003::y\n\n::z", "\x0b\\x3a:x\n\u2003\\x3a:y\n\n\\x3a:z"),
    ],
)
def test_no_line_is_a_command_and_no_control_is_obeyed(said, text, shown):
    assert said(text) == shown


def test_the_rest_of_a_line_is_no_beginning(said):
    assert said("begun, ", "::not a command\n", "::one\n") == "begun, ::not a command\n\\x3a:one\n"


@pytest.mark.parametrize(
    ("texts", "shown"),
    [
        ((":", ":x\n"), "\\x3a:x\n"),
        (("a\n:", ":x\n"), "a\n\\x3a:x\n"),
        ((" ", "::x\n"), " \\x3a:x\n"),
        (("a\r", "::x\n"), "a\r\\x3a:x\n"),
        (("a", ":", ":x\n"), "a::x\n"),
        (("a ", "b\n"), "a b\n"),
    ],
)
def test_what_is_written_bit_by_bit_is_no_command(said, texts, shown):
    assert said(*texts) == shown


def test_nobody_who_reads_holds_nobody_up():
    out, into = os.pipe()
    relay = Relay()
    end = relay.leading_to(into)
    os.close(out)
    os.write(end, b"lost\n")
    relay.pass_on()
    os.close(end)


def test_texts_of_ours_show_what_explorers_have_put_there():
    assert printable("\x1b[0m\n::error::\u202e\n ::x") == "\\x1b[0m\n\\x3a:error::\\u202e\n \\x3a:x"
    assert escaped("\u2066a\u2069 \x85é漢\n") == "\\u2066a\\u2069 \\x85é漢\n"
