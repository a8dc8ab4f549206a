"""Say right or wrong things in odd lines (docs/how-to/languages.md), to be judged from outside.

    python proofs/coq/odd_program.py NAME

In each of the worlds with one edge the program makes one motion and gives the right answer; both
lines, or one of them, are odd.  ``ODD`` has each by its name, with the law that it breaks, if any.
Standard library only.
"""

from __future__ import annotations

import json
import sys
import time
from dataclasses import dataclass

MOVE = '{"move":0}'
ANSWER = '{"estimate":{"sigma":@,"alpha":[1,0],"here":0}}'
"""Where ``@`` stands, sigma is written: it is another one in each of the two maps."""

ILLEGAL, NO_ESTIMATE = "illegal-action", "no-estimate"
LONG = "1" * 4300
CHECKPOINT = '{"checkpoint":{"sigma":[],"alpha":[],"here":0}}\n'


@dataclass(frozen=True)
class Odd:
    """The lines that a program writes, and the law that they break.

    Attributes:
        move, answer: its lines.
        law: which one it breaks; '' if it is right.
        certified: the law that the certified checker names, where that is another.
        silent: how the program ends without a line: ``ends`` or ``waits``; '' if it does not.
    """

    move: str | bytes = MOVE
    answer: str | bytes = ANSWER
    law: str = ""
    certified: str | None = None
    silent: str = ""

    @property
    def laws(self) -> tuple[str, str]:
        """As the package names it, and as the certified checker does."""
        return self.law, self.law if self.certified is None else self.certified


def beside(text: str) -> Odd:
    """A legal motion, with a key beside it that nobody asks for."""
    return Odd(move=f'{{"beside":{text},"move":0}}')


def moved(text: str, law: str = ILLEGAL) -> Odd:
    """A motion by something."""
    return Odd(move=f'{{"move":{text}}}', law=law)


def line(text: str | bytes) -> Odd:
    """No motion, but this line."""
    return Odd(move=text, law=ILLEGAL)


def answered(text: str, law: str = NO_ESTIMATE, certified: str | None = None) -> Odd:
    """Another answer."""
    return Odd(answer=f'{{"estimate":{text}}}', law=law, certified=certified)


ODD = {
    # ---- legal, and odd ----
    "plain": Odd(),
    "spaces": Odd(move='  {\t"move" :\r 0 }  ', answer=ANSWER.replace(",", " , ")),
    "carriage return": Odd(move=MOVE + "\r"),
    "escaped key": Odd(move='{"\\u006d\\u006Fve":0}'),
    "escapes": beside('"\\"\\\\\\/\\b\\f\\n\\r\\t\\u00e9"'),
    "pair of escapes": beside('"\\ud83d\\ude00"'),
    "half a pair": beside('["\\ud83d","\\ud83d\\u0041","\\ude00"]'),
    "characters": Odd(move='{"\u00e9\u20ac\U0001f600":"\x7f\u0080\uffff","move":0}'),
    "numbers beside": beside("[0,-0,1.5,-1.5e+3,1E-2,0e0,1e400]"),
    "words beside": beside("[null,true,false,{},[],[[]]]"),
    "nested beside": beside("[" * 400 + "]" * 400),
    "escape in escape": beside('"\\\\u0031"'),
    "anticlockwise": moved("-1", law=""),
    "minus zero": moved("-0", law=""),
    "large": moved("1" + "0" * 30, law=""),
    "large and negative": moved("-" + "9" * 40, law=""),
    "18 and 19 digits": beside("[999999999999999999,9999999999999999999,-9223372036854775808]"),
    "4300 digits": moved(LONG, law=""),
    "checkpoint first": Odd(move=CHECKPOINT + MOVE),
    "109 checkpoints first": Odd(move=CHECKPOINT * 109 + MOVE),
    "answer with more": Odd(answer=ANSWER.replace('"here"', '"note":[1.5],"here"')),
    "minus zero in the answer": Odd(answer=ANSWER.replace('"here":0', '"here":-0')),
    # ---- no motion ----
    "110 checkpoints first": Odd(move=CHECKPOINT * 110 + MOVE, law="budget"),
    "fraction": moved("1.9"),
    "whole fraction": moved("1.0"),
    "exponent": moved("1e0"),
    "leading zero": moved("01"),
    "negative leading zero": moved("-01"),
    "sign alone": moved("-"),
    "plus": moved("+1"),
    "point first": moved(".5"),
    "point last": moved("1."),
    "exponent without digits": moved("1e"),
    "hexadecimal": moved("0x1"),
    "underscore": moved("1_0"),
    "truth": moved("true"),
    "text": moved('"1"'),
    "null": moved("null"),
    "list": moved("[1]"),
    "4301 digits": moved(LONG + "1"),
    # ---- no JSON ----
    "empty": line(""),
    "comma at the end": line('{"move":0,}'),
    "comma first": line('{,"move":0}'),
    "no colon": line('{"move" 0}'),
    "words after": line(MOVE + " 0"),
    "two objects": line(MOVE + MOVE),
    "single quotes": line("{'move':0}"),
    "no quotes": line("{move:0}"),
    "comment": line(MOVE + " // so"),
    "control character": line(b'{"beside":"\x01","move":0}'),
    "tab in a text": line('{"beside":"\t","move":0}'),
    "bad escape": line('{"beside":"\\x41","move":0}'),
    "short escape": line('{"beside":"\\u00e","move":0}'),
    "escape with a sign": line('{"beside":"\\u+123","move":0}'),
    "no UTF-8": line(b'{"beside":"\xff","move":0}'),
    "UTF-8 too long": line(b'{"beside":"\xc0\xaf","move":0}'),
    "half a character": line(b'{"beside":"\xe2\x82","move":0}'),
    "text without end": line('{"move":0,"beside":"'),
    "object without end": line('{"move":0'),
    "zero byte": line(b'{"move":0}\x00'),
    "zero byte first": line(b'\x00{"move":0}'),
    "form feed": line("\x0c" + MOVE),
    "no-break space": line("\u00a0" + MOVE),
    "word too long": line('{"beside":nullx,"move":0}'),
    "five million brackets": line("[" * 5_000_000),
    "a million objects": line('{"a":' * 1_000_000),
    # ---- no action ----
    "top list": line('["move",0]'),
    "top number": line("0"),
    "no saying": line('{"go":0}'),
    "key with a capital": line('{"Move":0}'),
    "two sayings": line('{"move":0,"drop":true}'),
    "motion and ambiguous": line('{"move":0,"ambiguous":0}'),
    "drop": line('{"drop":true}'),
    "pick": line('{"pick":true}'),
    "checkpoint of nothing": line('{"checkpoint":null}'),
    "checkpoint without here": line('{"checkpoint":{"sigma":[],"alpha":[]}}'),
    "motion after the answer": Odd(answer=f"{ANSWER}\n{MOVE}", law=ILLEGAL),
    # ---- no estimate ----
    "here a fraction": answered('{"sigma":@,"alpha":[1,0],"here":0.5}'),
    "here a whole fraction": answered('{"sigma":@,"alpha":[1,0],"here":0.0}'),
    "here true": answered('{"sigma":@,"alpha":[1,0],"here":true}'),
    "here negative": answered('{"sigma":@,"alpha":[1,0],"here":-1}'),
    "here large": answered('{"sigma":@,"alpha":[1,0],"here":1' + "0" * 30 + "}"),
    "no here": answered('{"sigma":@,"alpha":[1,0]}'),
    "no sigma": answered('{"alpha":[1,0],"here":0}'),
    "answer null": answered("null"),
    "answer a list": answered("[@,[1,0],0]"),
    "fractions in alpha": answered('{"sigma":@,"alpha":[1.0,0.0],"here":0}'),
    "truths in alpha": answered('{"sigma":@,"alpha":[true,false],"here":0}'),
    "text for alpha": answered('{"sigma":@,"alpha":"10","here":0}'),
    "large in alpha": answered('{"sigma":@,"alpha":[1' + "0" * 30 + ',0],"here":0}'),
    "ambiguous": Odd(answer='{"ambiguous":{}}', law=NO_ESTIMATE),
    # ---- no map, which to the certified checker is a wrong one ----
    "here too large": answered('{"sigma":@,"alpha":[1,0],"here":2}', certified="map"),
    "fixed dart": answered('{"sigma":@,"alpha":[0,1],"here":0}', certified="map"),
    "not connected": answered('{"sigma":[0,1,2,3],"alpha":[1,0,3,2],"here":0}', certified="map"),
    "no dart": answered('{"sigma":[],"alpha":[],"here":0}', certified="map"),
    "lists of two lengths": answered('{"sigma":@,"alpha":[1],"here":0}', certified="map"),
    "a million darts": answered(
        '{"sigma":[' + "0," * 1_000_000 + '0],"alpha":[],"here":0}', certified="map"
    ),
    "another map": answered('{"sigma":[1,2,3,0],"alpha":[1,0,3,2],"here":0}', "map"),
    # ---- no line ----
    "ends": Odd(silent="ends", law="crash"),
    "waits": Odd(silent="waits", law="timeout"),
    # ---- what Python's reader takes, and a strict one does not ----
    "key twice": Odd(move='{"move":0,"move":0}', certified=ILLEGAL),
    "key twice, escaped": Odd(move='{"move":1,"mov\\u0065":0}', certified=ILLEGAL),
    "key twice in the answer": Odd(
        answer=ANSWER.replace('"here"', '"here":1,"here"'), certified=ILLEGAL
    ),
    "no number beside": Odd(move='{"beside":NaN,"move":0}', certified=ILLEGAL),
    "infinity beside": Odd(move='{"beside":-Infinity,"move":0}', certified=ILLEGAL),
    "byte order mark": Odd(move=b"\xef\xbb\xbf" + MOVE.encode(), certified=ILLEGAL),
    "half a pair in UTF-8": Odd(move=b'{"beside":"\xed\xa0\xbd","move":0}', certified=ILLEGAL),
    "nested 600 deep beside": Odd(
        move='{"beside":' + "[" * 600 + "]" * 600 + ',"move":0}', certified=ILLEGAL
    ),
}
"""Each odd program by its name."""


def serve(odd: Odd) -> None:
    """Answer each line on stdin until there is none."""
    for text in sys.stdin:
        percept = json.loads(text)
        if odd.silent == "ends":
            return
        if odd.silent == "waits":
            time.sleep(60)
        said = odd.move if "episode" in percept else odd.answer
        sigma = "[1,0]" if percept["percept"]["degree"] == 2 else "[0,1]"
        if isinstance(said, str):
            said = said.replace("@", sigma).encode()
        sys.stdout.buffer.write(said + b"\n")
        sys.stdout.buffer.flush()


if __name__ == "__main__":
    serve(ODD[sys.argv[1]])
