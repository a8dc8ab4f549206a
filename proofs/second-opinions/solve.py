"""The answer of one solver to one SMT-LIB file, printed: ``sat``, ``unsat`` or ``unknown``.

    python proofs/second-opinions/solve.py z3|cvc5 FILE [OPTION=VALUE ...]

Run in a process of its own, because neither solver's time limit is to be relied on.
The options are those of cvc5.
"""

import sys
from pathlib import Path


def z3_answer(text: str) -> str:
    """The output of z3 for the script."""
    import z3

    return str(z3.Z3_eval_smtlib2_string(z3.main_ctx().ref(), text)).strip()


def cvc5_answer(text: str, options: list[str]) -> str:
    """The output of cvc5 for the script."""
    import cvc5

    solver = cvc5.Solver(cvc5.TermManager())
    for option in options:
        solver.setOption(*option.split("=", 1))
    parser = cvc5.InputParser(solver)
    parser.setStringInput(cvc5.InputLanguage.SMT_LIB_2_6, text, "script")
    printed = []
    while not (command := parser.nextCommand()).isNull():
        printed.append(str(command.invoke(solver, parser.getSymbolManager())))
    return "".join(printed).strip()


if __name__ == "__main__":
    name, path, *options = sys.argv[1:]
    script = Path(path).read_text(encoding="ascii")
    answer = {"z3": lambda: z3_answer(script), "cvc5": lambda: cvc5_answer(script, options)}[name]
    sys.stdout.write(answer() + "\n")
