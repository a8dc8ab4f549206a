import inspect
import pickle
import subprocess
import sys
import time
import warnings
from fractions import Fraction

import pytest

from allworlds.inputs.checks import InputError
from allworlds.judging.laws.bounds import Bound, bound_named, default_step_budget, paper_bound
from allworlds.judging.rules import Rules
from allworlds.maps import named_map
from small import LOLLIPOP


def printed(m, n):
    """Expression (3) of Section VI, without its unstated lower order terms."""
    return (
        2 * m * m * n - 2 * m * n * n + Fraction(2, 3) * n**3 - 2 * m * m - Fraction(5, 2) * n * n
    )


def expanded(m, n):
    """(1) + (2) expanded by hand; the terms (3) leaves out are 5mn - 2m + 11n/6."""
    return printed(m, n) + 5 * m * n - 2 * m + Fraction(11, 6) * n


def pass_by_pass(m, n):
    """At most s steps to the new vertex, then 2(s - 1) for each hypothesis."""
    total = 0
    for explored in range(m):
        s = min(explored + 1, n)
        total += s + 2 * (s - 1) * (2 * m - 2 * explored)
    return total


SIZES = [(m, n) for m in range(1, 13) for n in range(1, m + 2)]


def test_the_bound_is_the_expanded_polynomial():
    for m, n in SIZES:
        assert paper_bound(n, m) == expanded(m, n), (m, n)


def test_the_bound_is_the_sum_over_the_passes():
    for m, n in SIZES:
        assert paper_bound(n, m) == pass_by_pass(m, n), (m, n)


def test_a_single_edge_costs_one():
    assert paper_bound(2, 1) == 1


def test_at_one_vertex_each_edge_is_walked_once():
    assert [paper_bound(1, m) for m in range(1, 6)] == [1, 2, 3, 4, 5]


def test_what_is_printed_lies_below_and_is_negative_for_a_single_edge():
    assert printed(1, 2) < 0
    for m, n in SIZES:
        assert printed(m, n) < paper_bound(n, m), (m, n)


def test_without_the_term_5mn_the_polynomial_is_wrong():
    assert all(expanded(m, n) - 5 * m * n != paper_bound(n, m) for m, n in SIZES)


def test_the_named_bounds():
    assert bound_named("paper").of(LOLLIPOP, 0) == paper_bound(2, 2)
    assert bound_named("none").of(LOLLIPOP, 0) is None
    assert bound_named("paper").name == "paper"
    assert bound_named("n + 1").name == "n + 1"
    assert isinstance(bound_named("n"), Bound)


def test_a_bound_survives_pickling():
    for text in ("paper", "none", "n*m + d0"):
        copy = pickle.loads(pickle.dumps(bound_named(text)))
        assert copy.name == text
        assert copy.of(LOLLIPOP, 1) == bound_named(text).of(LOLLIPOP, 1)


def test_the_six_variables():
    assert [bound_named(v).of(LOLLIPOP, 0) for v in ("n", "m", "d0", "D")] == [2, 2, 1, 3]
    assert [bound_named(v).of(LOLLIPOP, 0) for v in ("d", "g", "d+g")] == [1, 0, 1]
    torus, path = named_map("two-loops-torus"), named_map("path-4")
    assert [bound_named(v).of(torus, 0) for v in ("d", "g", "d+g")] == [0, 1, 1]
    assert [bound_named(v).of(path, 0) for v in ("d", "g", "d+g")] == [3, 0, 3]
    assert [bound_named("d0").of(LOLLIPOP, d) for d in LOLLIPOP.darts] == [1, 3, 3, 3]


N, M, D0, D, DIAMETER, GENUS = 5, 7, 2, 4, 3, 1


@pytest.mark.parametrize(
    ("text", "value"),
    [
        ("0", 0),
        ("7", 7),
        ("n+m*d0", N + M * D0),
        ("(n+m)*d0", (N + M) * D0),
        ("n-m-D", N - M - D),
        ("n-(m-D)", N - (M - D)),
        ("-n", -N),
        ("--n", N),
        ("-n**2", -(N**2)),
        ("(-n)**2", N**2),
        ("2**3**2", 512),
        ("(2**3)**2", 64),
        ("2**0", 1),
        ("0**0", 1),
        ("2**64", 2**64),
        ("m//d0", 3),
        ("-m//d0", -4),
        ("m//-d0", -4),
        ("m**20", 7**20),
        ("12345678901234567890*n", 61728394506172839450),
        ("min(n, m)", N),
        ("max(n, m, 100)", 100),
        ("min(max(n, m), D*d0)", M),
        ("2*m*(n-1) + max(0, m-n+1)", 59),
        ("n  *\tm", 35),
        ("9*paper", 9 * paper_bound(N, M)),
        ("max(paper, n) - paper", 0),
        ("10*d + g", 10 * DIAMETER + GENUS),
    ],
)
def test_expressions_are_evaluated_exactly(text, value):
    found = bound_named(text).value(N, M, D0, D, DIAMETER, GENUS)
    assert found == value
    assert type(found) is int


def refused(text):
    """The message of the refusal, wherever it comes; it is one line."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        with pytest.raises(InputError) as caught:
            bound_named(text).of(LOLLIPOP, 0)
    message = str(caught.value)
    assert len(message.splitlines()) == 1
    return message


@pytest.mark.parametrize(
    ("text", "part"),
    [
        ("x", "'x'"),
        ("n + edges", "'edges'"),
        ("N", "'N'"),
        ("Paper", "'Paper'"),
        ("two - vertices", "'two'"),
        ("none", None),
        ("1.5", "'1.5'"),
        ("n*1e3", "'1e3'"),
        ("1j", "'1j'"),
        ("n/2", "/"),
        ("n % 2", "%"),
        ("n @ m", "'n @ m'"),
        ("n << 1", "'n << 1'"),
        ("n ^ m", "'n ^ m'"),
        ("2 m", "did you mean '2*m'"),
        ("+n", "'+n'"),
        ("~n", "'~n'"),
        ("not n", "'not n'"),
        ("n.real", "'n.real'"),
        ("n[0]", "'n[0]'"),
        ("abs(n)", "'abs(n)'"),
        ("min", "'min'"),
        ("min()", "'min()'"),
        ("min(n)", "'min(n)'"),
        ("min(*n)", "'min(*n)'"),
        ("max(*n, 1)", "'*n'"),
        ("min(n, m, key=abs)", "'min(n, m, key=abs)'"),
        ("min(n, m, **n)", "'min(n, m, **n)'"),
        ("n.min(1, 2)", "'n.min(1, 2)'"),
        ("(lambda: 1)()", "'(lambda: 1)()'"),
        ("lambda: 1", "'lambda: 1'"),
        ("'n'", "\"'n'\""),
        ("b'n'", "\"b'n'\""),
        ("f'{n}'", "f'{n}'"),
        ("True", "'True'"),
        ("None", "'None'"),
        ("...", "'...'"),
        ("n + False", "'False'"),
        ("n < m", "'n < m'"),
        ("n and m", "'n and m'"),
        ("n if m else 1", "'n if m else 1'"),
        ("(n := 3)", "'n := 3'"),
        ("[n]", "'[n]'"),
        ("n, m", "'n, m'"),
        ("()", "'()'"),
        ("[i for i in n]", "'[i for i in n]'"),
        ("__import__('os')", "__import__"),
        ("é", "é"),
        ("n + ü", "ü"),
        ("", "''"),
        ("   ", "'   '"),
        ("n +", "'n +'"),
        ("(n", "'(n'"),
        ("n)", "'n)'"),
        ("n m", "'n m'"),
        ("n = 1", "'n = 1'"),
        ("import os", "'import os'"),
        ("yield n", "yield n"),
        ("n\n+ m", r"'n\n+ m'"),
        ("n\0", r"'n\x00'"),
        ("\ud800", r"'\ud800'"),
        ("01", "'01'"),
        ("1//0", "divides by zero at n=2 m=2 d0=1 D=3"),
        ("m//(n-2)", "divides by zero at n=2"),
        ("min(1, 1//(d0-1))", "divides by zero"),
        ("2**-1", "power -1"),
        ("2**65", "power 65"),
        ("0**-n", "power -2"),
        ("9**9**9", "power 387420489"),
    ],
)
def test_anything_else_is_refused_in_one_line_that_names_it(text, part):
    if part is None:
        assert bound_named(text).of(LOLLIPOP, 0) is None
        return
    assert part in refused(text)


def test_an_expression_may_have_a_value_in_some_worlds_only():
    bound = bound_named("m//(n-2)")
    assert bound.value(3, 5, 1, 1, 1, 0) == 5
    with pytest.raises(InputError, match=r"n=2 m=5 d0=1 D=1$"):
        bound.value(2, 5, 1, 1, 1, 0)
    with pytest.raises(InputError, match=r"n=2 m=5 d0=1 D=1 g=0$"):
        bound_named("m//g").value(2, 5, 1, 1, 1, 0)


@pytest.mark.parametrize(
    "text",
    [
        "(" * 150 + "n" + ")" * 150,
        "(" * 5_000 + "n" + ")" * 5_000,
        "-" * 500 + "n",
        "-" * 20_000 + "n",
        "min(" * 50 + "n" + ", 9)" * 50,
        "min(" * 5_000 + "n" + ", 9)" * 5_000,
        "+".join("n" * 500),
        "+".join("n" * 1_500),
        "+".join("n" * 5_000),
        "+".join("n" * 50_000),
        "**".join("n" * 500),
        "[" * 90 + "]" * 90,
        "n" * 100_000,
        "1" * 5_000,
        "n if " * 1_000,
    ],
    ids=lambda text: f"{text[:4]}x{len(text)}",
)
def test_long_expressions_have_a_value_or_are_refused_and_end_soon(text):
    start = time.monotonic()
    try:
        outcome = str(bound_named(text).of(LOLLIPOP, 0))
    except InputError as error:
        outcome = str(error)
    assert len(outcome.splitlines()) == 1
    assert time.monotonic() - start < 5


def test_what_can_be_read_can_be_evaluated_at_any_depth_of_the_stack():
    def deep(levels, bound):
        return deep(levels - 1, bound) if levels else bound.of(LOLLIPOP, 0)

    for k in (100, 300, 500, 700, 800, 850, 900, 950, 1000):
        try:
            bound = bound_named("+".join("n" * k))
        except InputError:
            continue
        for levels in (0, 50, 100, 150):
            try:
                value = deep(levels, bound)
            except InputError:
                continue
            assert value == 2 * k


def test_powers_of_powers_do_not_run_away():
    text = "((((9**64)**64)**64)**64)**64"
    code = (
        "from allworlds.inputs.checks import InputError\n"
        "from allworlds.judging.laws.bounds import bound_named\n"
        "try:\n"
        f"    bound_named({text!r}).value(2, 2, 1, 3, 1, 0)\n"
        "except InputError as error:\n"
        "    print(len(str(error).splitlines()))\n"
    )
    path = [p for p in sys.path if p]
    done = subprocess.run(
        [sys.executable, "-c", f"import sys; sys.path[:0] = {path!r}\n{code}"],
        capture_output=True,
        text=True,
        timeout=10,
        check=True,
    )
    assert done.stdout.strip() == "1"


@pytest.mark.parametrize(
    "text",
    ["2**(((9**64)**64)**2)", "2**-(((9**64)**64)**2)", "2**0x" + "F" * 5_000],
    ids=["positive", "negative", "hexadecimal"],
)
def test_an_exponent_of_thousands_of_digits_is_refused(text):
    refused(text)


@pytest.mark.parametrize(
    "text", ["\N{FULLWIDTH LATIN SMALL LETTER N}", "\N{MATHEMATICAL BOLD SMALL M}*2"]
)
def test_letters_that_python_takes_for_n_and_m_are_refused(text):
    refused(text)


def test_digits_are_not_parted():
    with pytest.raises(InputError, match="'1_0'"):
        bound_named("1_0")


# ---------------------------------------------------------------- two vertices


def test_the_bound_of_two_vertices_adds_two_for_each_test_and_the_search():
    bound = bound_named("two-vertices")
    for n, m in SIZES:
        tests = sum(2 * m - 2 * p - 1 for p in range(m))
        assert tests == m**2
        for degree in (1, m):
            assert bound.value(n, m, degree, m, 1, 0) == paper_bound(n, m) + 2 * tests + 2 * degree


def test_the_bound_of_two_vertices_has_a_name():
    # n = m = 2, (1)+(2) = 7, two traversals for each of 3 + 1 tests, and v0 of degree 1 or 3.
    assert [bound_named("two-vertices").of(LOLLIPOP, d) for d in (0, 1)] == [17, 21]
    assert pickle.loads(pickle.dumps(bound_named("two-vertices"))).name == "two-vertices"
    with pytest.raises(InputError, match="not one of paper, two-vertices, none or an expression"):
        bound_named("two vertices")


@pytest.mark.parametrize(
    ("text", "variables"),
    [
        ("none", set()),
        ("paper", {"n", "m"}),
        ("two-vertices", {"n", "m", "d0"}),
        ("7", set()),
        ("2*m", {"m"}),
        ("9*paper", {"n", "m"}),
        ("paper + d0", {"n", "m", "d0"}),
        ("min(n, 3) + D**2 - -d0", {"n", "D", "d0"}),
        ("d + 2*g", {"d", "g"}),
    ],
)
def test_a_bound_knows_what_it_depends_on(text, variables):
    bound = bound_named(text)
    assert bound.variables == variables
    base = {"n": 5, "m": 9, "d0": 2, "D": 3, "d": 4, "g": 2}
    moved = {
        name
        for name in base
        if bound.value(*{**base, name: 1}.values()) != bound.value(*base.values())
    }
    assert moved == variables


@pytest.mark.parametrize("text", ["1if n else 2", "65or(65)", "0and 1", "n is 1", "1(n)", "'\\d'"])
def test_what_python_thinks_of_a_text_besides_is_not_told(text):
    # Warnings are errors in tests, and would be another one than this.
    with pytest.raises(InputError, match="bound"):
        bound_named(text)


def test_the_default_step_budget():
    assert default_step_budget(1) == 108
    assert default_step_budget(100) == 900


@pytest.mark.parametrize(
    ("options", "budget"),
    [
        ({}, 8 * paper_bound(20, 40) + 100),
        ({"bound": "paper"}, 8 * paper_bound(20, 40) + 100),
        ({"bound": "2*m"}, 100 * 80 + 100),
        ({"bound": "0"}, 100),
        ({"bound": "-m"}, 100),
        ({"bound": "2*m", "step_budget": 7}, 7),
        ({"bound": "2*m", "laws": ("map",)}, None),
        ({"bound": "10**9"}, 8 * paper_bound(20, 40) + 100),
        ({"bound": "d0"}, 8 * paper_bound(20, 40) + 100),
        ({"bound": "m//0"}, 8 * paper_bound(20, 40) + 100),
        ({"own_bound": "2*m"}, 100 * 80 + 100),
        ({"own_bound": "10**9"}, 10**9),
        ({"own_bound": "2*m", "bound": "none"}, 8 * paper_bound(20, 40) + 100),
        ({"own_bound": "10**9", "bound": "m"}, 100 * 40 + 100),
    ],
)
def test_no_run_goes_on_far_beyond_the_bound_that_is_checked(options, budget):
    if budget is None:
        with pytest.raises(InputError, match="no effect"):
            Rules(**options)
    else:
        assert Rules(**options).budget_by_size(20, 40) == budget


@pytest.mark.parametrize(
    ("text", "legal"),
    [("2**63**1 * m", True), ("(2**63)**64 * 2**63", True), ("(2**63)**64 * 2**64", False)],
)
def test_a_bound_has_4096_bits_at_most(text, legal):
    bound = bound_named(text)
    assert bound is not None
    if legal:
        assert bound.value(2, 1, 1, 1, 1, 0).bit_length() in (64, 4096)
    else:
        with pytest.raises(InputError, match="has a value of over 4096 bits"):
            bound.value(2, 1, 1, 1, 1, 0)


def test_a_bound_that_is_nested_too_deeply_for_what_is_left_of_the_stack_is_refused():
    bound = bound_named("+".join("n" * 100))

    def value(frames):
        return value(frames - 1) if frames else bound.value(2, 2, 1, 3, 1, 0)

    assert value(0) == 200
    left = sys.getrecursionlimit() - len(inspect.stack())
    with pytest.raises(InputError, match=r"^bound of 199 characters is nested too deeply$"):
        value(left - 50)


@pytest.mark.parametrize(
    ("text", "value"),
    [
        ("1**64", 1),
        ("m**0", 1),
        ("2**64", 2**64),
        ("(2**63)**64", 2 ** (63 * 64)),
        ("1**65", "raises to the power 65; legal are 0..64"),
        ("m**(0 - 1)", "raises to the power -1; legal are 0..64"),
        ("(2**64)**64", "has a value of over 4096 bits"),
    ],
)
def test_a_power_is_from_0_to_64(text, value):
    bound = bound_named(text)
    if isinstance(value, int):
        assert bound.value(1, 1, 1, 1, 1, 0) == value
    else:
        with pytest.raises(InputError, match=value):
            bound.value(1, 1, 1, 1, 1, 0)
