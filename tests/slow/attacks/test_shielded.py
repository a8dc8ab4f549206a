"""The attacks with a shield: every one is made right, but for what no answer of theirs can mend."""

import pytest

from attacks.reading import attacks
from attacks.test_attacks import Scene, judged, placed

NOT_MENDED = {"crash", "timeout", "nondeterministic"}
"""What a process does, and not an explorer."""


@pytest.fixture
def scene(tmp_path):
    return Scene(tmp_path)


DEAR = {"state", "reaching", "libraries"}
"""Kinds of attacks that take some seconds with a shield."""


def tried():
    """Each attack under the directional lighthouse.

    All are slowest but the first one of each kind that is not dear.
    """
    kinds = {*DEAR}
    for attack in attacks():
        if attack.signal or "--lighthouse" in attack.options:
            continue
        for function in attack.verdicts:
            kind = attack.name.partition("/")[0]
            marks = [pytest.mark.slowest] if kind in kinds else []
            kinds.add(kind)
            name = f"{attack.name}-{function or 'exec'}"
            yield pytest.param(attack, function, id=name, marks=marks)


@pytest.mark.early
@pytest.mark.parametrize(("attack", "function"), [*tried()])
def test_an_attack_is_made_right_as_far_as_its_process_lives(attack, function, scene):
    words = placed(attack, function, scene)
    if not function:  # a program takes long to make its many plays with a shield
        at = words.index("--edges") if "--edges" in words else len(words)
        words = [*words[:at], "--edges", "2", *words[at + 2 :]]
    kinds = {"--exec": "exec:", "--native": "native:"}
    first = [f"shield:{kinds[words[0]]}{words[1]}"] if words[0] in kinds else [f"shield:{words[0]}"]
    words = [*first, *words[2 if words[0] in kinds else 1 :]]
    code, out = scene.ended(scene.start("check", *words, "--json"))
    stated, _, laws = attack.verdicts[function].partition(" ")
    left = NOT_MENDED & set(laws.split(" or "))
    if stated == "refuted" and code == 0:
        judged("holds", code, out, scene.said())
    elif stated == "refuted":
        judged(f"refuted {' or '.join(left)}", code, out, scene.said())
    else:
        judged(attack.verdicts[function], code, out, scene.said())
