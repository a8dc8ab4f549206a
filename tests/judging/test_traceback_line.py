"""The line of a traceback that tells, in the languages that explorers are written in."""

import pytest

from allworlds.judging.explanations.by_law import telling_line

CASES = {
    "python": (
        (
            'Traceback (most recent call last):\n  File "mine.py", line 3, in explore\n'
            "    Error: it is\nallworlds.Stop: no more"
        ),
        "allworlds.Stop: no more",
    ),
    "node": (
        (
            "/tmp/mine.js:3\n  undefinedfn();\n  ^\n\n"
            "ReferenceError: undefinedfn is not defined\n    at explore (/tmp/mine.js:3:1)\n"
            "    at Module._compile (node:internal/modules/cjs/loader:1554:14)\n\nNode.js v20.20.2"
        ),
        "ReferenceError: undefinedfn is not defined",
    ),
    "java": (
        (
            'Exception in thread "main" java.lang.IllegalStateException: no dart\n'
            "\tat Mine.explore(Mine.java:12)\n\tat Mine.main(Mine.java:3)"
        ),
        'Exception in thread "main" java.lang.IllegalStateException: no dart',
    ),
    "java with a cause": (
        (
            "java.lang.RuntimeException: outer\n\tat Mine.main(Mine.java:3)\n"
            "Caused by: java.io.IOException: pipe\n\tat Mine.read(Mine.java:9)\n\t... 1 more"
        ),
        "Caused by: java.io.IOException: pipe",
    ),
    "rust": (
        (
            "thread 'main' panicked at src/main.rs:4:5:\nindex out of bounds: the len is 0\n"
            "note: run with `RUST_BACKTRACE=1` environment variable to display a backtrace"
        ),
        "thread 'main' panicked at src/main.rs:4:5: index out of bounds: the len is 0",
    ),
    "go": (
        (
            "panic: runtime error: index out of range [3]\n\ngoroutine 1 [running]:\nmain.main()\n"
            "\t/tmp/mine.go:8 +0x1d\nexit status 2"
        ),
        "panic: runtime error: index out of range [3]",
    ),
    "c++": (
        (
            "terminate called after throwing an instance of 'std::out_of_range'\n"
            "  what():  vector::_M_range_check\n"
        ),
        "what():  vector::_M_range_check",
    ),
    "c": (
        "mine: mine.c:9: main: Assertion `k < degree' failed.",
        "mine: mine.c:9: main: Assertion `k < degree' failed.",
    ),
    "nothing that one knows": ("one\ntwo\n\n", "two"),
    "nothing": ("\n  \n", ""),
}


@pytest.mark.parametrize("name", CASES)
def test_the_line_that_tells_is_found(name):
    text, line = CASES[name]
    assert telling_line(text) == line
