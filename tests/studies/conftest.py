import pytest

from studies.whole_explorers import wrong_from


@pytest.fixture(scope="session")
def planted():
    """Algorithm 1, but its pose is wrong from so many edges on if a vertex has that degree."""
    return wrong_from


@pytest.fixture
def planted_file(tmp_path):
    """A function that writes ``planted`` to a file that worker processes can import."""

    def write(edges, degree):
        path = tmp_path / "planted.py"
        path.write_text(
            "from allworlds.explorers.builtin.algorithm1 import algorithm1\n"
            "from allworlds.protocol.actions import Estimate\n"
            "def explore(first, *, choices):\n"
            "    right = yield from algorithm1(first, choices=choices)\n"
            "    map_ = right.map\n"
            f"    if map_.edge_count >= {edges} and max(map_.degrees) >= {degree}:\n"
            "        return Estimate(map_, map_.sigma[right.here])\n"
            "    return right\n"
        )
        return f"{path}:explore"

    return write
