"""Rules between the keys of a document; a schema tells the legal values of each key alone.

Each rule is a sentence and a condition that a document must satisfy; ``broken`` lists the rules
that a document, or one inside it, breaks.
"""

ROOTED = {"sigma", "alpha", "here"}


def rooted(value):
    return isinstance(value, dict) and set(value) == ROOTED


def integer(value):
    return type(value) is int


WRITTEN = "check#/$defs/Finding"

FINDING = {
    "map and pose speak of rooted maps": lambda d: (
        d["law"] not in ("map", "pose") or (rooted(d["expected"]) and rooted(d["seen"]))
    ),
    "the bound speaks of integers": lambda d: (
        d["law"] != "bound" or (integer(d["expected"]) and integer(d["seen"]))
    ),
    "every other law speaks in sentences": lambda d: (
        d["law"] in ("map", "pose", "bound")
        or (isinstance(d["expected"], str) and isinstance(d["seen"], str))
    ),
}
RULES = {
    "check": {
        "refuted is what has a finding": lambda d: d["verdict"] != "refuted" or d["findings"],
        "what has a finding is refuted, or an error": lambda d: (
            not d["findings"] or d["verdict"] in ("refuted", "error")
        ),
        "not-refuted is a sample, and so not complete": lambda d: (
            d["verdict"] != "not-refuted"
            or (d["scope"]["sample"] is not None and not d["scope"]["complete"])
        ),
        "the exit code is the verdict's, unless it was interrupted": lambda d: (
            d["exit_code"]
            in {
                "holds": (0, 130),
                "not-refuted": (0, 130),
                "refuted": (1, 130),
                "inconclusive": (3, 130),
                "vacuous": (4, 130),
                "error": (70,),
            }[d["verdict"]]
        ),
    },
    WRITTEN: FINDING,
    "run": {
        "refuted is what has a finding": lambda d: (
            (d["verdict"] == "refuted") == (d["finding"] is not None)
        ),
        "the exit code is the verdict's": lambda d: (
            d["exit_code"] == {"holds": 0, "refuted": 1}[d["verdict"]]
        ),
    },
    "replay": {
        "reproduced is what breaks a law now": lambda d: (
            (d["outcome"] == "reproduced") == (d["law_now"] is not None)
        ),
        "the exit code is the outcome's": lambda d: (
            d["exit_code"] == {"fixed": 5, "reproduced": 0, "not-reproduced": 3}[d["outcome"]]
        ),
    },
    "worst": {
        "70 is a disagreement": lambda d: (d["exit_code"] == 70) == (not d["gate"]["agrees"]),
        "4 is no row": lambda d: d["exit_code"] == 70 or (d["exit_code"] == 4) == (not d["rows"]),
        "0 is no wrong test, and every row replayed": lambda d: (
            d["exit_code"] != 0
            or all(
                row["wrong_tests"] in (0, None) and integer(row["replayed"]) for row in d["rows"]
            )
        ),
    },
    "twins": {
        "motions tell apart what is distinguishable": lambda d: (
            d["distinguishable"] == ("motions" in d) == ("percepts" in d)
        ),
        "a bisimulation proves that nothing does": lambda d: (
            d["distinguishable"] != ("bisimulation" in d)
        ),
        "one world is not told from itself": lambda d: (
            not d["distinguishable"] or d["relation"] != "same"
        ),
        "twins are different and not distinguishable": lambda d: (
            d["twins"] == (d["relation"] == "different" and not d["distinguishable"])
        ),
    },
    "ambiguity-class": {
        "ambiguous is a class of two": lambda d: d["ambiguous"] == (d["size"] > 1),
        "a class of two has two sheets": lambda d: not d["ambiguous"] or d["sheets"] > 1,
        "of a class of one nothing is left out": lambda d: d["ambiguous"] or d["notice"] is None,
    },
    "search": {
        "sat is a pair with its bisimulation": lambda d: (
            (d["status"] == "sat") == (d["pair"] is not None) == (d["bisimulation"] is not None)
        ),
        "sat has a certificate, unknown and vacuous have none": lambda d: (
            (d["status"] != "sat" or d["certificate"] is not None)
            and (d["certificate"] is None or (d["status"] != "unknown" and not d["vacuous"]))
        ),
        "3 is unknown": lambda d: (d["exit_code"] == 3) == (d["status"] == "unknown"),
        "4 is vacuous": lambda d: (d["exit_code"] == 4) == d["vacuous"],
        "vacuous is unsat": lambda d: not d["vacuous"] or d["status"] == "unsat",
    },
}


def inside(name, document):
    """The documents that this one holds."""
    match name:
        case "check":
            yield from ((WRITTEN, finding) for finding in document["findings"])
        case "run" if document["finding"] is not None:
            yield WRITTEN, document["finding"]
        case "replay":
            yield "run", document["run"]


def broken(name, document):
    """The rules that a document of a schema breaks; the schema itself must be kept."""
    rules = RULES.get(name, {})
    found = [words for words, holds in rules.items() if not holds(document)]
    return found + [words for inner in inside(name, document) for words in broken(*inner)]
