"""The statements of ``second-opinions``, written by the checker: the files must say the same.

A statement is some hypotheses and a conclusion about the symbols that it declares.  They are put
together here from the laws of the paper: I-1 and I-2 are written once, and stand before and after
a pass with other names for what the pass changes; an induction is one claim, and its step has the
claim as hypothesis and the claim one motion, turn or pass later as conclusion.  So a step cannot
claim another thing than it assumes, and 'I-1 after' is I-1.

Attributes:
    STATEMENTS: each statement by the name of its file.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping
from dataclasses import dataclass

Laws = tuple[str, ...]
"""Formulas of SMT-LIB, to be asserted one by one."""


@dataclass(frozen=True)
class Statement:
    """A conclusion that follows from hypotheses, or, without one, hypotheses that can be met.

    Attributes:
        title: the first line of the file.
        logic: of the script.
        sorts: those that are declared, in their order.
        symbols: their names and sorts, a line for those with the same: ``sigma: Dart -> Dart``.
        hypotheses: what is assumed.
        conclusion: what follows; '' if the statement is that the hypotheses can be met.
        defined: functions with their definitions, as commands.
    """

    title: str
    logic: str
    sorts: str
    symbols: str
    hypotheses: Laws
    conclusion: str
    defined: str = ""

    @property
    def expected(self) -> str:
        """The answer of a solver that proves it."""
        return "unsat" if self.conclusion else "sat"

    @property
    def script(self) -> str:
        """The commands of its file: hypotheses, and the conclusion denied."""
        sorts = "".join(f"(declare-sort {sort} 0)" for sort in self.sorts.split())
        denied = (f"(not {self.conclusion})",) if self.conclusion else ()
        asserted = "".join(f"(assert {law})" for law in (*self.hypotheses, *denied))
        symbols = "".join(declared(line) for line in self.symbols.strip().splitlines())
        return f"(set-logic {self.logic}){sorts}{symbols}{self.defined}{asserted}(check-sat)"


def declared(line: str) -> str:
    """The declarations that a line ``names: sorts -> sort`` stands for."""
    names, _, sorts = line.partition(":")
    *arguments, sort = (part.strip() for part in sorts.split("->"))
    if arguments:
        return "".join(f"(declare-fun {n} ({arguments[0]}) {sort})" for n in names.split())
    return "".join(f"(declare-const {name} {sort})" for name in names.split())


def renamed(law: str, names: Mapping[str, str]) -> str:
    """A law with other names."""
    return re.sub(r"[A-Za-z_]\w*", lambda word: names.get(word[0], word[0]), law)


def at(time: str, changing: str, laws: Laws) -> Laws:
    """Laws before (0) or after (1) a pass, where the pass changes some symbols."""
    names = {name: name + time for name in changing.split()}
    return tuple(renamed(law, names) for law in laws)


def every(variables: str, law: str) -> str:
    """A law for all values: ``every("d Dart, x MapDart", ...)``."""
    bound = " ".join(f"({variable.strip()})" for variable in variables.split(","))
    return f"(forall ({bound}) {law})"


def both(laws: Iterable[str]) -> str:
    """All of the laws, as one formula; a single one stays as it is."""
    several = list(laws)
    return several[0] if len(several) == 1 else f"(and {' '.join(several)})"


def follows(conditions: Laws, law: str) -> str:
    """A law under conditions, if there are any."""
    return f"(=> {both(conditions)} {law})" if conditions else law


@dataclass(frozen=True)
class Claim:
    """A claim that is proved by induction.

    Attributes:
        variables: what it is about, as in ``every``.
        conditions: under which it holds.
        laws: what holds; several are assumed one by one.
        later: the names of the same things one step later, and of what it may fail for.
    """

    variables: str
    conditions: Laws
    laws: Laws
    later: Mapping[str, str]

    @property
    def assumed(self) -> Laws:
        """The induction hypothesis."""
        return tuple(every(self.variables, follows(self.conditions, law)) for law in self.laws)

    @property
    def given(self) -> Laws:
        """The conditions, one step later."""
        return tuple(renamed(law, self.later) for law in self.conditions)

    @property
    def next(self) -> str:
        """The claim, one step later, for what it may fail for."""
        return both(renamed(law, self.later) for law in self.laws)


# ---- The world, and turning ----

TWO_ENDS = (every("d Dart", "(= (alpha (alpha d)) d)"),)
TWO_DARTS = (every("d Dart", "(not (= (alpha d) d))"),)
SAME_VERTEX = (every("d Dart", "(= (vertex (sigma d)) (vertex d))"),)
PERCEPT_OF_VERTEX = tuple(
    every("c Dart, d Dart", f"(=> (= (vertex c) (vertex d)) (= ({sensed} c) ({sensed} d)))")
    for sensed in ("degree", "marked")
)
TURN_BACK = (every("d Dart", "(= (back (turn d)) d)"),)
TURNS_BACK = (every("b Turn, d Dart", "(= (unturn b (turn b d)) d)"),)


def of_x(laws: Laws) -> Laws:
    """Laws of darts d, as laws of darts x."""
    return tuple(renamed(law, {"d": "x"}) for law in laws)


# ---- The invariants ----

SUBGRAPH = (
    every("d Dart, c Dart", "(=> (and (seen d) (= (vertex c) (vertex d))) (seen c))"),
    every("d Dart", "(=> (walked d) (and (seen d) (walked (alpha d))))"),
)
ONE_TO_ONE = (
    every("x MapDart", "(=> (known x) (and (seen (phi x)) (= (name (phi x)) x)))"),
    every("d Dart", "(=> (seen d) (and (known (name d)) (= (phi (name d)) d)))"),
)
EDGE_INDEX = (
    every("x MapDart", "(=> (known x) (and (known (next x)) (= (phi (next x)) (sigma (phi x)))))"),
)
SAME_EDGES = (
    every("x MapDart", "(=> (explored x) (and (known x) (walked (phi x))))"),
    every("x MapDart", "(=> (and (known x) (walked (phi x))) (explored x))"),
    every(
        "x MapDart",
        """(=> (explored x) (and (explored (partner x)) (= (partner (partner x)) x)
                                 (= (phi (partner x)) (alpha (phi x)))))""",
    ),
)
RECORDED = (
    every(
        "x MapDart",
        "(=> (known x) (and (= (degree_map x) (degree (phi x))) (= (home x) (marked (phi x)))))",
    ),
)
I1 = (*SUBGRAPH, *ONE_TO_ONE, *EDGE_INDEX, *SAME_EDGES, *RECORDED)

OPEN_IS_UNEXPLORED = every("x MapDart", "(=> (open x) (and (known x) (not (walked (phi x)))))")
UNEXPLORED_IS_OPEN = every("d Dart", "(=> (and (seen d) (not (walked d))) (open (name d)))")
I2 = (OPEN_IS_UNEXPLORED, UNEXPLORED_IS_OPEN)
OPEN_IS_KNOWN = (every("x MapDart", "(=> (open x) (known x))"),)
NOTHING_OPEN = (every("x MapDart", "(not (open x))"),)

# ---- One pass ----

BY_LOOP = "walked explored open partner"
BY_VERTEX = "seen walked known explored open phi name next partner degree_map home"

LOOP_FOUND = ("(open0 e)", "(open0 h)", "(= (alpha (phi e)) (phi h))")
VERTEX_FOUND = ("(open0 e)", "(not (seen0 (alpha (phi0 e))))")
AT_NEW_VERTEX = "(= (vertex d) (vertex (alpha (phi0 e))))"


def edge_walked(phi: str) -> Laws:
    """The edge of e has been walked in the pass."""
    return (
        every(
            "d Dart", f"(= (walked1 d) (or (walked0 d) (= d ({phi} e)) (= d (alpha ({phi} e)))))"
        ),
    )


def edge_added(other: str) -> Laws:
    """The edge of e and another dart has been added to S in the pass."""
    return (
        every("x MapDart", f"(= (explored1 x) (or (explored0 x) (= x e) (= x {other})))"),
        every(
            "x MapDart",
            f"(= (partner1 x) (ite (= x e) {other} (ite (= x {other}) e (partner0 x))))",
        ),
    )


VERTEX_SEEN = (every("d Dart", f"(= (seen1 d) (or (seen0 d) {AT_NEW_VERTEX}))"),)
NEW_DARTS = (
    every("x MapDart", f"(= (new x) (exists ((d Dart)) (and {AT_NEW_VERTEX} (= x (fresh d)))))"),
    every("d Dart", f"(=> {AT_NEW_VERTEX} (= (phi1 (fresh d)) d))"),
    "(= entry (fresh (alpha (phi0 e))))",
    every("x MapDart", "(= (known1 x) (or (known0 x) (new x)))"),
    every("x MapDart", "(=> (known0 x) (= (phi1 x) (phi0 x)))"),
    every("d Dart", "(= (name1 d) (ite (seen0 d) (name0 d) (fresh d)))"),
)
NEW_ORDER = (
    every("x MapDart", "(=> (known0 x) (= (next1 x) (next0 x)))"),
    every("d Dart", f"(=> {AT_NEW_VERTEX} (= (next1 (fresh d)) (fresh (sigma d))))"),
)
NEW_RECORD = tuple(
    every("x MapDart", f"(= ({kept}1 x) (ite (new x) ({sensed} (alpha (phi0 e))) ({kept}0 x)))")
    for kept, sensed in (("degree_map", "degree"), ("home", "marked"))
)

# ---- Tests ----

TURNED_IN_MAP = (
    every(
        "e MapDart",
        "(=> (known e) (and (known (turn_map e)) (= (phi (turn_map e)) (turn (phi e)))))",
    ),
)
TURNED_BY_IN_MAP = (
    every("b Turn, e MapDart", "(=> (known e) (= (phi (turn_map b e)) (turn b (phi e))))"),
)
CROSSED_IN_MAP = (
    every(
        "e MapDart",
        "(=> (explored e) (and (known (partner e)) (= (phi (partner e)) (alpha (phi e)))))",
    ),
)
SAME_POINTED = ("(= (phi pointed_map) pointed)",)
MATCH = (
    every(
        "e MapDart, d Dart",
        """(= (match_kw e d)
              (and (= (degree_map e) (degree d)) (= (home e) (marked d)) (explored (turn_map e))
                   (match_w (partner (turn_map e)) (alpha (turn d)))))""",
    ),
)
MATCH_PROVES = Claim(
    "e MapDart, d Dart",
    ("(known e)", "(match_w e d)"),
    ("(= d (phi e))",),
    {"match_w": "match_kw", "e": "h", "d": "x"},
)
TRUTH_MATCHES = Claim(
    "e MapDart",
    ("(known e)", "(leads_w e)"),
    ("(match_w e (phi e))",),
    {"leads_w": "leads_kw", "match_w": "match_kw", "e": "h"},
)
ONE_HYPOTHESIS = Claim(
    "p Dart, q Dart", ("(agree_w p q)",), ("(= p q)",), {"agree_w": "agree_kw", "p": "x", "q": "y"}
)

# ---- Motions ----

TURNED_AND_BACK = Claim(
    "x Dart",
    (),
    ("(= (back_k (turn_k x)) x)", "(= (turn_k (back_k x)) x)"),
    {"turn_k": "turn_k1", "back_k": "back_k1", "x": "d"},
)
RUN_UNDONE = Claim(
    "x Dart",
    (),
    ("(= (undo_w (run_w x)) x)",),
    {"undo_w": "undo_kw", "run_w": "run_kw", "x": "d"},
)
TURNED_ALIKE = Claim(
    "x MapDart",
    ("(known x)",),
    ("(and (known (turn_map_k x)) (= (phi (turn_map_k x)) (turn_k (phi x))))",),
    {"turn_map_k": "turn_map_k1", "turn_k": "turn_k1", "x": "e"},
)

# ---- Folding ----

MERGES_FORCED = Claim(
    "x LogDart, y LogDart",
    ("(merged0 x y)",),
    ("(= (place x) (place y))",),
    {"merged0": "merged1", "x": "f", "y": "g"},
)
LINKS_FORCED = Claim(
    "x LogDart, y LogDart",
    ("(linked0 x y)",),
    ("(= (place y) (alpha (place x)))",),
    {"linked0": "linked1", "x": "f", "y": "g"},
)

# ---- The bound ----

PASS_BOUND = """(define-fun pass_bound ((s Real) (p Real)) Real
  (+ s (* 2.0 (- s 1.0) (- (* 2.0 m) (* 2.0 p)))))"""
LEAST = "(define-fun least ((x Real) (y Real)) Real (ite (<= x y) x y))"
SIX_SUM_1 = """(define-fun six_sum_1 ((q Real)) Real
  (+ (* 3.0 q (+ q 1.0)) (* 12.0 m q (- q 1.0)) (* (- 4.0) (- q 1.0) q (- (* 2.0 q) 1.0))))"""
SUM_2 = """(define-fun sum_2 ((j Real)) Real
  (+ (* j n) (* 2.0 (- n 1.0) (- (* 2.0 m) (* 2.0 (- n 1.0))) j)
     (* (- 2.0) (- n 1.0) j (- j 1.0))))"""
TERMS = """(define-fun term_1 ((s Real)) Real
  (+ s (* 2.0 (- s 1.0) (- (* 2.0 m) (* 2.0 (- s 1.0))))))
(define-fun term_2 ((i Real)) Real
  (+ n (* 2.0 (- n 1.0) (- (- (* 2.0 m) (* 2.0 (- n 1.0))) (* 2.0 (- i 1.0))))))"""
ALL_TESTS = "(<= cost_tests (* 2.0 (- s 1.0) tests))"
"""The bound of the tests of a pass; while they go on their cost is ``cost``."""
TESTS_SO_FAR = renamed(ALL_TESTS, {"cost_tests": "cost"})
SUM_SO_FAR = {
    "run": "(<= cost sum)",
    "sum-1": "(= (* 6.0 sum) (six_sum_1 q))",
    "sum-2": "(= sum (sum_2 j))",
}


def one_more(law: str, number: str) -> str:
    """The law of a sum so far after one step more; ``number`` counts the steps."""
    after = renamed(law, {"cost": "cost_after", "sum": "sum_after", number: "@"})
    return after.replace("@", f"(+ {number} 1.0)")


def for_no_term(law: str, function: str) -> str:
    """The law after one step more, and that the closed form is 0 for no term."""
    return f"(and {law} (= ({function} 0.0) 0.0))"


# ---- The statements ----

WORLD_AND_MAP = """
sigma alpha: Dart -> Dart
vertex: Dart -> Vertex
degree: Dart -> Degree
marked: Dart -> Bool
"""

STATE = """seen walked: Dart -> Bool
known explored open: MapDart -> Bool
phi: MapDart -> Dart
name: Dart -> MapDart
next partner: MapDart -> MapDart
degree_map: MapDart -> Degree
home: MapDart -> Bool"""
"""What of the map and of the walk a pass may change."""

STATEMENTS = {
    "turns-reversible": Statement(
        "Turning is reversible: induction step over the number of places turned",
        "UF",
        "Dart",
        """
sigma sigma_inv turn_k back_k turn_k1 back_k1: Dart -> Dart
d: Dart""",
        (
            every("x Dart", "(= (sigma_inv (sigma x)) x)"),
            every("x Dart", "(= (sigma (sigma_inv x)) x)"),
            every("x Dart", "(= (turn_k1 x) (sigma (turn_k x)))"),
            every("x Dart", "(= (back_k1 x) (back_k (sigma_inv x)))"),
            *TURNED_AND_BACK.assumed,
        ),
        TURNED_AND_BACK.next,
    ),
    "motion-reversible": Statement(
        "One motion is reversible",
        "UF",
        "Dart",
        """
alpha turn back move: Dart -> Dart
d: Dart""",
        (*of_x(TWO_ENDS + TURN_BACK), every("x Dart", "(= (move x) (alpha (turn x)))")),
        "(and (= (alpha (move d)) (turn d)) (= (back (alpha (move d))) d))",
    ),
    "run-reversible": Statement(
        "A run of motions is reversible: induction step over its length",
        "UF",
        "Dart",
        """
alpha turn back run_w undo_w run_kw undo_kw: Dart -> Dart
d: Dart""",
        (
            *of_x(TWO_ENDS + TURN_BACK),
            every("x Dart", "(= (run_kw x) (run_w (alpha (turn x))))"),
            every("y Dart", "(= (undo_kw y) (back (alpha (undo_w y))))"),
            *RUN_UNDONE.assumed,
        ),
        RUN_UNDONE.next,
    ),
    "key-lemma-base": Statement(
        "Uniqueness of the embedded path, base: at v0 the direction of the marker tells all",
        "UF",
        "Dart Turn",
        """
turn unturn: Turn Dart -> Dart
home: Dart -> Bool
bearing: Dart -> Turn
pointed x y: Dart""",
        (
            *TURNS_BACK,
            every("d Dart", "(=> (home d) (= (turn (bearing d) d) pointed))"),
            "(home x)",
            "(home y)",
            "(= (bearing x) (bearing y))",
        ),
        "(= x y)",
    ),
    "key-lemma-step": Statement(
        "Uniqueness of the embedded path (key lemma): induction step over the motions",
        "UF",
        "Dart Degree",
        """
turn back: Dart -> Dart
explored: Dart -> Bool
partner: Dart -> Dart
degree: Dart -> Degree
home: Dart -> Bool
agree_w agree_kw: Dart Dart -> Bool
x y: Dart""",
        (
            *TURN_BACK,
            every("d Dart", "(=> (explored d) (= (partner (partner d)) d))"),
            every(
                "p Dart, q Dart",
                """(= (agree_kw p q) (and (= (degree p) (degree q)) (= (home p) (home q))
                     (explored (turn p)) (explored (turn q))
                     (agree_w (partner (turn p)) (partner (turn q)))))""",
            ),
            *ONE_HYPOTHESIS.assumed,
            *ONE_HYPOTHESIS.given,
        ),
        ONE_HYPOTHESIS.next,
    ),
    "direction-needed": Statement(
        "Without the direction of the marker the key lemma is false",
        "UF",
        "Dart Degree",
        """
sigma alpha: Dart -> Dart
degree: Dart -> Degree
home explored: Dart -> Bool
pointed x y a0 a1 b0 b1 c0 c1: Dart""",
        (
            every("d Dart", "(or (= d a0) (= d a1) (= d b0) (= d b1) (= d c0) (= d c1))"),
            *(
                every("d Dart", f"(and (= ({turn} ({turn} d)) d) (not (= ({turn} d) d)))")
                for turn in ("sigma", "alpha")
            ),
            every(
                "d Dart", "(and (= (degree (sigma d)) (degree d)) (= (home (sigma d)) (home d)))"
            ),
            "(home pointed)",
            every("d Dart", "(=> (home d) (or (= d pointed) (= d (sigma pointed))))"),
            every("d Dart", "(=> (explored d) (explored (alpha d)))"),
            *(f"(not (explored {dart}))" for dart in "xy"),
            *(f"(explored (sigma {dart}))" for dart in "xy"),
            "(and (= (degree x) (degree y)) (not (home x)) (not (home y)))",
            "(and (home (alpha (sigma x))) (home (alpha (sigma y))))",
            "(not (= x y))",
            "(and (= (alpha (sigma x)) pointed) (not (= (alpha (sigma y)) pointed)))",
        ),
        "",
    ),
    "turns-carried-over": Statement(
        "Turning in S is turning in G: induction step over the number of places turned",
        "UF",
        "Dart MapDart",
        """
phi: MapDart -> Dart
known: MapDart -> Bool
sigma: Dart -> Dart
next: MapDart -> MapDart
turn_k turn_k1: Dart -> Dart
turn_map_k turn_map_k1: MapDart -> MapDart
e: MapDart""",
        (
            *EDGE_INDEX,
            every("d Dart", "(= (turn_k1 d) (sigma (turn_k d)))"),
            every("x MapDart", "(= (turn_map_k1 x) (next (turn_map_k x)))"),
            *TURNED_ALIKE.assumed,
            *TURNED_ALIKE.given,
        ),
        TURNED_ALIKE.next,
    ),
    "match-proves-base": Statement(
        "A test that matches to the end proves its hypothesis, base: no motions left",
        "UF",
        "Dart MapDart Turn",
        """
turn unturn: Turn Dart -> Dart
turn_map: Turn MapDart -> MapDart
phi: MapDart -> Dart
known: MapDart -> Bool
marked: Dart -> Bool
home: MapDart -> Bool
bearing: Dart -> Turn
expected: MapDart -> Turn
pointed: Dart
pointed_map h: MapDart
x: Dart""",
        (
            *TURNS_BACK,
            every("d Dart", "(=> (marked d) (= (turn (bearing d) d) pointed))"),
            every(
                "e MapDart",
                "(=> (and (known e) (home e)) (= (turn_map (expected e) e) pointed_map))",
            ),
            *TURNED_BY_IN_MAP,
            *SAME_POINTED,
            "(known h)",
            "(home h)",
            "(marked x)",
            "(= (bearing x) (expected h))",
        ),
        "(= x (phi h))",
    ),
    "match-proves-step": Statement(
        "A test that matches to the end proves its hypothesis: induction step",
        "UF",
        "Dart MapDart Degree",
        """
alpha turn back: Dart -> Dart
marked: Dart -> Bool
degree: Dart -> Degree
phi: MapDart -> Dart
known explored: MapDart -> Bool
partner turn_map: MapDart -> MapDart
home: MapDart -> Bool
degree_map: MapDart -> Degree
match_w match_kw: MapDart Dart -> Bool
h: MapDart
x: Dart""",
        (
            *TWO_ENDS,
            *TURN_BACK,
            *TURNED_IN_MAP,
            *CROSSED_IN_MAP,
            *MATCH,
            *MATCH_PROVES.assumed,
            *MATCH_PROVES.given,
        ),
        MATCH_PROVES.next,
    ),
    "truth-matches-base": Statement(
        "A true hypothesis always matches, base: no motions left",
        "UF",
        "Dart MapDart Turn Degree",
        """
below: Turn Degree -> Bool
turn: Turn Dart -> Dart
turn_map: Turn MapDart -> MapDart
degree: Dart -> Degree
degree_map: MapDart -> Degree
marked: Dart -> Bool
home: MapDart -> Bool
bearing: Dart -> Turn
expected: MapDart -> Turn
phi: MapDart -> Dart
known: MapDart -> Bool
pointed: Dart
pointed_map h: MapDart""",
        (
            every(
                "b Turn, c Turn, d Dart",
                """(=> (and (below b (degree d)) (below c (degree d)) (= (turn b d) (turn c d)))
                       (= b c))""",
            ),
            every(
                "d Dart",
                """(=> (marked d)
                       (and (below (bearing d) (degree d)) (= (turn (bearing d) d) pointed)))""",
            ),
            every(
                "e MapDart",
                """(=> (and (known e) (home e)) (and (below (expected e) (degree_map e))
                       (= (turn_map (expected e) e) pointed_map)))""",
            ),
            every("e MapDart", "(=> (known e) (= (degree_map e) (degree (phi e))))"),
            every("e MapDart", "(=> (known e) (= (home e) (marked (phi e))))"),
            *TURNED_BY_IN_MAP,
            *SAME_POINTED,
            "(known h)",
        ),
        """(and (= (degree_map h) (degree (phi h))) (= (home h) (marked (phi h)))
                (=> (home h) (= (expected h) (bearing (phi h)))))""",
    ),
    "truth-matches-step": Statement(
        "A true hypothesis always matches: induction step",
        "UF",
        "Dart MapDart Degree",
        """
alpha turn: Dart -> Dart
marked: Dart -> Bool
degree: Dart -> Degree
phi: MapDart -> Dart
known explored: MapDart -> Bool
partner turn_map: MapDart -> MapDart
home: MapDart -> Bool
degree_map: MapDart -> Degree
leads_w leads_kw: MapDart -> Bool
match_w match_kw: MapDart Dart -> Bool
h: MapDart""",
        (
            *TURNED_IN_MAP,
            *CROSSED_IN_MAP,
            *(renamed(law, {"x": "e"}) for law in RECORDED),
            every(
                "e MapDart",
                "(= (leads_kw e) (and (explored (turn_map e)) (leads_w (partner (turn_map e)))))",
            ),
            *MATCH,
            *TRUTH_MATCHES.assumed,
            *TRUTH_MATCHES.given,
        ),
        TRUTH_MATCHES.next,
    ),
    "rejected-means-new": Statement(
        "If e leads to a known vertex, a true hypothesis is in U",
        "UF",
        "Dart MapDart Degree",
        """
alpha: Dart -> Dart
degree: Dart -> Degree
marked seen walked: Dart -> Bool
known open: MapDart -> Bool
phi: MapDart -> Dart
name: Dart -> MapDart
degree_map: MapDart -> Degree
home: MapDart -> Bool
e: MapDart""",
        (
            *TWO_ENDS,
            *TWO_DARTS,
            SUBGRAPH[1],
            ONE_TO_ONE[1],
            *RECORDED,
            *I2,
            "(open e)",
            "(seen (alpha (phi e)))",
        ),
        """(exists ((h MapDart)) (and (open h) (not (= h e)) (= (phi h) (alpha (phi e)))
             (= (degree_map h) (degree (alpha (phi e)))) (= (home h) (marked (alpha (phi e))))))""",
    ),
    "start-has-I": Statement(
        "I-1 and I-2 are true before the loop is entered",
        "UF",
        "Dart MapDart Vertex Degree",
        f"""{WORLD_AND_MAP.strip()}
{STATE}
fresh: Dart -> MapDart
start: Dart""",
        (
            *SAME_VERTEX,
            *PERCEPT_OF_VERTEX,
            every("d Dart", "(= (seen d) (= (vertex d) (vertex start)))"),
            every("d Dart", "(not (walked d))"),
            every(
                "x MapDart",
                """(= (known x)
                      (exists ((d Dart)) (and (= (vertex d) (vertex start)) (= x (fresh d)))))""",
            ),
            every(
                "d Dart",
                """(=> (= (vertex d) (vertex start))
                       (and (= (phi (fresh d)) d) (= (next (fresh d)) (fresh (sigma d)))))""",
            ),
            every("d Dart", "(= (name d) (fresh d))"),
            every("x MapDart", "(not (explored x))"),
            every("x MapDart", "(= (degree_map x) (degree start))"),
            every("x MapDart", "(= (home x) (marked start))"),
            every("x MapDart", "(= (open x) (known x))"),
        ),
        both(I1 + I2),
    ),
    "loop-keeps-I1": Statement(
        "Loop augmentation maintains I-1",
        "UF",
        "Dart MapDart Vertex Degree",
        f"""{WORLD_AND_MAP.strip()}
seen: Dart -> Bool
known: MapDart -> Bool
phi: MapDart -> Dart
name: Dart -> MapDart
next: MapDart -> MapDart
degree_map: MapDart -> Degree
home: MapDart -> Bool
walked0: Dart -> Bool
explored0 open0: MapDart -> Bool
partner0: MapDart -> MapDart
walked1: Dart -> Bool
explored1: MapDart -> Bool
partner1: MapDart -> MapDart
e h: MapDart""",
        (
            *TWO_ENDS,
            *at("0", BY_LOOP, I1 + OPEN_IS_KNOWN),
            *LOOP_FOUND,
            *edge_walked("phi"),
            *edge_added("h"),
        ),
        both(at("1", BY_LOOP, I1)),
    ),
    "loop-keeps-I2": Statement(
        "Loop augmentation maintains I-2",
        "UF",
        "Dart MapDart",
        """
alpha: Dart -> Dart
seen: Dart -> Bool
known: MapDart -> Bool
phi: MapDart -> Dart
name: Dart -> MapDart
walked0: Dart -> Bool
open0: MapDart -> Bool
walked1: Dart -> Bool
open1: MapDart -> Bool
e h: MapDart""",
        (
            *at("0", BY_LOOP, ONE_TO_ONE + I2),
            *LOOP_FOUND,
            *edge_walked("phi"),
            every("x MapDart", "(= (open1 x) (and (open0 x) (not (= x e)) (not (= x h))))"),
        ),
        both(at("1", BY_LOOP, I2)),
    ),
    "vertex-keeps-I1": Statement(
        "Non-loop augmentation maintains I-1",
        "UF",
        "Dart MapDart Vertex Degree",
        f"""{WORLD_AND_MAP.strip()}
{at("0", BY_VERTEX, (STATE,))[0]}
seen1 walked1: Dart -> Bool
known1 explored1: MapDart -> Bool
phi1: MapDart -> Dart
name1: Dart -> MapDart
next1 partner1: MapDart -> MapDart
degree_map1: MapDart -> Degree
home1 new: MapDart -> Bool
fresh: Dart -> MapDart
e entry: MapDart""",
        (
            *TWO_ENDS,
            *SAME_VERTEX,
            *PERCEPT_OF_VERTEX,
            *at("0", BY_VERTEX, I1 + OPEN_IS_KNOWN),
            *VERTEX_FOUND,
            *VERTEX_SEEN,
            *edge_walked("phi0"),
            *NEW_DARTS,
            *NEW_ORDER,
            *edge_added("entry"),
            *NEW_RECORD,
        ),
        both(at("1", BY_VERTEX, I1)),
    ),
    "vertex-keeps-I2": Statement(
        "Non-loop augmentation maintains I-2",
        "UF",
        "Dart MapDart Vertex",
        """
alpha: Dart -> Dart
vertex: Dart -> Vertex
seen0 walked0: Dart -> Bool
known0 open0: MapDart -> Bool
phi0: MapDart -> Dart
name0: Dart -> MapDart
seen1 walked1: Dart -> Bool
known1 open1: MapDart -> Bool
phi1: MapDart -> Dart
name1: Dart -> MapDart
new: MapDart -> Bool
fresh: Dart -> MapDart
e entry: MapDart""",
        (
            *at("0", BY_VERTEX, SUBGRAPH + ONE_TO_ONE + I2),
            *VERTEX_FOUND,
            *VERTEX_SEEN,
            *edge_walked("phi0"),
            *NEW_DARTS,
            every(
                "x MapDart",
                """(= (open1 x) (or (and (open0 x) (not (= x e)))
                                    (and (new x) (not (= x entry)))))""",
            ),
        ),
        both(at("1", BY_VERTEX, I2)),
    ),
    "variant-falls": Statement(
        "Each pass explores exactly one edge more: t falls",
        "UF",
        "Dart MapDart",
        """
alpha: Dart -> Dart
phi: MapDart -> Dart
walked0: Dart -> Bool
open0: MapDart -> Bool
walked1: Dart -> Bool
e: MapDart""",
        (
            *TWO_ENDS,
            *TWO_DARTS,
            every("d Dart", "(=> (walked0 d) (walked0 (alpha d)))"),
            every("x MapDart", "(=> (open0 x) (not (walked0 (phi x))))"),
            "(open0 e)",
            *edge_walked("phi"),
        ),
        both(
            (
                "(not (= (phi e) (alpha (phi e))))",
                "(not (walked0 (phi e)))",
                "(not (walked0 (alpha (phi e))))",
                "(walked1 (phi e))",
                "(walked1 (alpha (phi e)))",
                every("d Dart", "(=> (walked0 d) (walked1 d))"),
                every(
                    "d Dart",
                    "(=> (walked1 d) (or (walked0 d) (= d (phi e)) (= d (alpha (phi e)))))",
                ),
            )
        ),
    ),
    "variant-bounds-passes": Statement(
        "The bound function t is never negative and falls: arithmetic",
        "QF_LIA",
        "",
        "edges_world edges_map edges_map_after t t_after: Int",
        (
            "(= t (- edges_world edges_map))",
            "(= t_after (- edges_world edges_map_after))",
            "(= edges_map_after (+ edges_map 1))",
            "(<= edges_map_after edges_world)",
        ),
        "(and (<= 0 t_after) (< t_after t))",
    ),
    "exit-closed": Statement(
        "When U is empty, G_s is closed: step along a path from the start",
        "UF",
        "Dart MapDart Vertex",
        """
sigma alpha: Dart -> Dart
vertex: Dart -> Vertex
seen walked: Dart -> Bool
open: MapDart -> Bool
name: Dart -> MapDart
d: Dart""",
        (*SAME_VERTEX, *SUBGRAPH, UNEXPLORED_IS_OPEN, *NOTHING_OPEN, "(seen d)"),
        "(and (seen (sigma d)) (seen (alpha d)) (walked d))",
    ),
    "exit-map-is-world": Statement(
        "Termination and the invariant imply that S is G",
        "UF",
        "Dart MapDart",
        """
sigma alpha: Dart -> Dart
seen walked: Dart -> Bool
known explored open: MapDart -> Bool
phi: MapDart -> Dart
name: Dart -> MapDart
next partner: MapDart -> MapDart
start: Dart
root: MapDart""",
        (
            follows(
                (
                    "(seen start)",
                    every("d Dart", "(=> (seen d) (and (seen (sigma d)) (seen (alpha d))))"),
                ),
                every("d Dart", "(seen d)"),
            ),
            *ONE_TO_ONE,
            *EDGE_INDEX,
            *SAME_EDGES,
            "(known root)",
            "(= (phi root) start)",
            UNEXPLORED_IS_OPEN,
            *NOTHING_OPEN,
        ),
        both(
            (
                every("x MapDart", "(=> (known x) (= (name (phi x)) x))"),
                every("d Dart", "(and (known (name d)) (= (phi (name d)) d))"),
                every("x MapDart", "(=> (known x) (= (phi (next x)) (sigma (phi x))))"),
                every(
                    "x MapDart",
                    "(=> (known x) (and (explored x) (= (phi (partner x)) (alpha (phi x)))))",
                ),
                "(= (name start) root)",
            )
        ),
    ),
    "folding-merges-forced": Statement(
        "Folding: every merge is forced, one step",
        "UF",
        "Dart LogDart Turn",
        """
sigma alpha: Dart -> Dart
turn unturn: Turn Dart -> Dart
pointed: Dart
place: LogDart -> Dart
next: LogDart -> LogDart
walked: LogDart -> Bool
target: LogDart -> LogDart
home: LogDart -> Bool
bearing: LogDart -> Turn
merged0 merged1: LogDart LogDart -> Bool
f g: LogDart""",
        (
            *TURNS_BACK,
            every("x LogDart", "(= (place (next x)) (sigma (place x)))"),
            every("x LogDart", "(=> (walked x) (= (place (target x)) (alpha (place x))))"),
            every("x LogDart", "(=> (home x) (= (turn (bearing x) (place x)) pointed))"),
            every(
                "x LogDart, y LogDart",
                """(= (merged1 x y)
                      (or (merged0 x y) (merged0 y x)
                          (exists ((z LogDart)) (and (merged0 x z) (merged0 z y)))
                          (and (home x) (home y) (= (bearing x) (bearing y)))
                          (exists ((u LogDart) (v LogDart))
                            (and (merged0 u v)
                              (or (and (= x (next u)) (= y (next v)))
                                  (and (walked u) (walked v)
                                       (= x (target u)) (= y (target v))))))))""",
            ),
            *MERGES_FORCED.assumed,
            *MERGES_FORCED.given,
        ),
        MERGES_FORCED.next,
    ),
    "folding-links-forced": Statement(
        "Folding: every link is forced, one step",
        "UF",
        "Dart LogDart",
        """
alpha: Dart -> Dart
place: LogDart -> Dart
merged linked0 linked1: LogDart LogDart -> Bool
f g: LogDart""",
        (
            *TWO_ENDS,
            *(renamed(law, {"merged0": "merged"}) for law in MERGES_FORCED.assumed),
            every(
                "x LogDart, y LogDart",
                """(= (linked1 x y) (or (linked0 x y) (linked0 y x)
                      (exists ((z LogDart)) (and (merged z x) (linked0 z y)))))""",
            ),
            *LINKS_FORCED.assumed,
            *LINKS_FORCED.given,
        ),
        LINKS_FORCED.next,
    ),
    "bound-tests-step": Statement(
        "The tests of one pass: induction step over the hypotheses tested",
        "QF_NRA",
        "",
        "s tests cost steps cost_after: Real",
        (
            "(<= steps (- s 1.0))",
            "(= cost_after (+ cost (* 2.0 steps)))",
            TESTS_SO_FAR,
        ),
        one_more(TESTS_SO_FAR, "tests"),
    ),
    "bound-one-pass": Statement(
        "The bound of one pass",
        "QF_NRA",
        "",
        "m p s tests way cost_tests cost: Real",
        (
            "(<= 1.0 s)",
            "(<= way s)",
            "(<= tests (- (* 2.0 m) (* 2.0 p)))",
            ALL_TESTS,
            "(= cost (+ way cost_tests))",
        ),
        "(<= cost (pass_bound s p))",
        PASS_BOUND,
    ),
    "bound-pass-grows": Statement(
        "The bound of a pass grows with the number of vertices known",
        "QF_NRA",
        "",
        "m p s t: Real",
        ("(<= s t)", "(<= p m)"),
        "(<= (pass_bound s p) (pass_bound t p))",
        PASS_BOUND,
    ),
    "bound-run-step": Statement(
        "The run: induction step over the passes",
        "QF_NRA",
        "",
        "m n p s cost cost_pass cost_after sum sum_after: Real",
        (
            "(< p m)",
            "(<= s (+ p 1.0))",
            "(<= s n)",
            "(<= cost_pass (pass_bound s p))",
            "(= cost_after (+ cost cost_pass))",
            "(= sum_after (+ sum (pass_bound (least (+ p 1.0) n) p)))",
            SUM_SO_FAR["run"],
        ),
        one_more(SUM_SO_FAR["run"], "p"),
        PASS_BOUND + LEAST,
    ),
    "bound-terms": Statement(
        "The sum of the bounds is (1) + (2), term by term",
        "QF_NRA",
        "",
        "m n p s i: Real",
        ("(= s (least (+ p 1.0) n))", "(= i (+ (- p (- n 1.0)) 1.0))"),
        """(and (=> (< p (- n 1.0)) (= (pass_bound s p) (term_1 (+ p 1.0))))
                (=> (<= (- n 1.0) p) (= (pass_bound s p) (term_2 i))))""",
        PASS_BOUND + LEAST + TERMS,
    ),
    "bound-sum-1-step": Statement(
        "Sum (1) in closed form: induction step over its terms",
        "QF_NRA",
        "",
        "m q sum sum_after: Real",
        (
            SUM_SO_FAR["sum-1"],
            "(= sum_after (+ sum (+ q 1.0) (* 2.0 q (- (* 2.0 m) (* 2.0 q)))))",
        ),
        for_no_term(one_more(SUM_SO_FAR["sum-1"], "q"), "six_sum_1"),
        SIX_SUM_1,
    ),
    "bound-sum-2-step": Statement(
        "Sum (2) in closed form: induction step over its terms",
        "QF_NRA",
        "",
        "m n j sum sum_after: Real",
        (
            SUM_SO_FAR["sum-2"],
            """(= sum_after (+ sum n (* 2.0 (- n 1.0)
                  (- (- (* 2.0 m) (* 2.0 (- n 1.0))) (* 2.0 j)))))""",
        ),
        for_no_term(one_more(SUM_SO_FAR["sum-2"], "j"), "sum_2"),
        SUM_2,
    ),
    "bound-polynomial": Statement(
        "(1) + (2) is the polynomial, exactly",
        "QF_NRA",
        "",
        "m n sum_1 sum_2_all: Real",
        (
            "(= (* 6.0 sum_1) (six_sum_1 (- n 1.0)))",
            "(= sum_2_all (sum_2 (+ (- m n) 1.0)))",
        ),
        """(= (* 6.0 (+ sum_1 sum_2_all))
              (+ (* 12.0 m m n) (* (- 12.0) m n n) (* 4.0 n n n) (* (- 12.0) m m) (* 30.0 m n)
                 (* (- 15.0) n n) (* (- 12.0) m) (* 11.0 n)))""",
        SIX_SUM_1 + SUM_2,
    ),
}
