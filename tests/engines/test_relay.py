"""The relay, which takes the text of explorers to stderr."""

import os

import pytest

from allworlds.engines.isolation.relay import Relay


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
        ("a::b\n::\n", "a::b\n:\\x3a\n"),
        ("::error::x\n \t::y", ":\\x3aerror::x\n \t:\\x3ay"),
        ("\u202eturned\x9b\n", "\\u202eturned\\x9b\n"),
        ("\x1b[31mred\a\v\f\x7f\n", "\\x1b[31mred\\x07\\x0b\\x0c\\x7f\n"),
        (":\n: :\n", ":\n: :\n"),
        (b"\xff::\n", "\\xff::\n"),
        ("10%\r::error::x\r\n::y\n", "10%\r:\\x3aerror::x\r\n:\\x3ay\n"),
        ("\x0b::x\n\u2003::y\n\n::z", "\\x0b::x\n\u2003:\\x3ay\n\n:\\x3az"),
        ("##[error]x\na ##vso[b]\n#[c]\n", "##\\x5berror]x\na ##vso\\x5bb]\n#[c]\n"),
    ],
)
def test_no_line_is_a_command_and_no_control_is_obeyed(said, text, shown):
    assert said(text) == shown


def test_the_rest_of_a_line_is_no_beginning(said):
    assert said("begun, ", "::not a command\n", "::one\n") == "begun, ::not a command\n:\\x3aone\n"


@pytest.mark.parametrize(
    ("texts", "shown"),
    [
        ((":", ":x\n"), ":\\x3ax\n"),
        (("a\n:", ":x\n"), "a\n:\\x3ax\n"),
        ((" ", "::x\n"), " :\\x3ax\n"),
        (("a\r", "::x\n"), "a\r:\\x3ax\n"),
        (("a", ":", ":x\n"), "a::x\n"),
        ((": ", ":x\n"), ": :x\n"),
        (("a #", "#", "[b]\n"), "a ##\\x5bb]\n"),
        (("##v", "s", "o[b]\n"), "##vso\\x5bb]\n"),
        (("##", "\n[b]\n"), "##\n[b]\n"),
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
