"""The episode against a model of a few lines, whatever an explorer does in whatever order."""

from copy import copy

import pytest
from hypothesis import Phase, settings
from hypothesis.stateful import (
    RuleBasedStateMachine,
    initialize,
    invariant,
    precondition,
    rule,
    run_state_machine_as_test,
)
from hypothesis.strategies import integers, sampled_from

from allworlds.judging.episode import Answered, play
from allworlds.protocol.actions import Checkpoint, Drop, Estimate, Move, Pick
from allworlds.protocol.choices import Choices
from allworlds.strategies import maps, worlds

STATEFUL = settings(max_examples=120, stateful_step_count=30)
NO_ACTION = (None, 3, "move", Move, Drop, (0,), Move(k=True), Move(0.5), Move("1"), Estimate)
NO_CHECKPOINT = (Checkpoint(0, (), 0), Checkpoint((0.5,), (0,), 0), Checkpoint((0,), (0,), None))


class Crash(Exception):
    """An error that the explorer raises when it is told to."""


class Machine(RuleBasedStateMachine):
    """An explorer that says one thing after the other; the model says what must come of it.

    After each message a fresh episode is played with all messages so far.
    """

    checkpoint_cost = 0

    @initialize(world=worlds(maps(max_edges=4)), budget=integers(0, 8))
    def begin(self, world, budget):
        self.world, self.budget = world, budget
        self.messages = []
        self.dart, self.cost = world.start, 0
        self.steps, self.shown = [], 0
        self.fault, self.last = None, 0

    def say(self, message):
        self.messages.append(message)
        self.last += self.fault is None

    running = precondition(lambda self: self.fault is None)

    @running
    @rule(k=integers(-9, 9))
    def move(self, k):
        self.say(Move(k))
        if self.cost >= self.budget:
            self.fault = "budget"
            return
        map_ = self.world.map
        degree = map_.degree_at[self.dart]
        self.cost += 1
        for _ in range(k % degree):
            self.dart = map_.sigma[self.dart]
        self.dart = map_.alpha[self.dart]
        self.steps.append((Move(k % degree), self.world.percepts[self.dart]))

    @running
    @rule()
    def publish(self):
        self.say(Checkpoint(list(self.world.map.sigma), self.world.map.alpha, 0))
        if self.shown > self.budget:
            self.fault = "budget"
        else:
            self.shown += 1
            self.cost += self.checkpoint_cost

    @running
    @rule(message=sampled_from([*NO_ACTION, *NO_CHECKPOINT, Drop(), Pick()]))
    def say_what_is_illegal(self, message):
        self.say(message)
        too_late = isinstance(message, Checkpoint) and self.shown > self.budget
        self.fault = "budget" if too_late else "illegal-action"

    @running
    @rule()
    def crash(self):
        self.say(Crash())
        self.fault = "crash"

    @rule(k=integers(0, 3))
    def go_on_when_it_is_over(self, k):
        """Send a message after the end of the episode, where it is not heard."""
        if self.fault:
            self.say(Move(k))

    @invariant()
    def the_episode_is_as_the_model_says(self):
        if not hasattr(self, "world"):
            return
        heard = []
        for answer, law in ((Estimate(self.world.map, 0), None), (None, "no-estimate")):
            heard.clear()
            episode = play(self.world, self.player(answer, heard), Choices(), self.budget)
            assert episode.transcript.first == self.world.percepts[self.world.start]
            assert list(episode.transcript.steps) == self.steps
            assert episode.transcript.cost == self.cost <= self.budget
            assert len(episode.checkpoints) == self.shown
            ended = None if isinstance(episode.ending, Answered) else episode.ending.law
            assert ended == (self.fault or law)
            assert len(heard) == self.last

    def player(self, answer, heard):
        replies = [percept for _, percept in self.steps]

        def explore(first, _choices, told):
            assert first == self.world.first
            assert told is None
            expected = iter(replies)
            for message in self.messages:
                heard.append(message)
                if isinstance(message, Crash):
                    raise copy(message)
                reply = yield message
                # A checkpoint is answered with nothing, a motion with what is sensed then.
                if isinstance(message, Checkpoint):
                    assert reply is None
                else:
                    assert reply == next(expected)
            return answer

        return explore


class CheckpointsCost(Machine):
    """A model that is wrong: a checkpoint is counted as a traversal."""

    checkpoint_cost = 1


def test_a_model_in_which_checkpoints_cost_something_is_refuted():
    with pytest.raises(AssertionError):
        run_state_machine_as_test(
            CheckpointsCost,
            settings=settings(STATEFUL, phases=[Phase.generate]),
        )
