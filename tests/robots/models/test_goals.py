"""What robots must reach."""

from types import SimpleNamespace

from allworlds.robots.models.goals import each_everywhere, gathered
from small import EDGE


def test_each_robot_must_be_at_each_vertex():
    state = SimpleNamespace(darts=(0, 1))
    told = {each.name: each.holds(state) for each in each_everywhere(EDGE)}
    assert {name for name, holds in told.items() if not holds} == {
        "robot 0 at vertex 1",
        "robot 1 at vertex 0",
    }
    assert not any(each.forever for each in each_everywhere(EDGE))


def test_robots_are_gathered_at_one_vertex():
    together, apart = (SimpleNamespace(darts=darts) for darts in ((0, 0), (0, 1)))
    condition = gathered(EDGE)
    assert condition.forever
    assert condition.holds(together)
    assert not condition.holds(apart)
