"""What each law asks, in a line, for reports that list the laws."""

from __future__ import annotations

ASKED = {
    "crash": "The explorer must not raise, and its process must not end.",
    "timeout": "The explorer must not be silent for longer than the answer timeout.",
    "illegal-action": "The explorer must yield nothing but motions, markers and checkpoints.",
    "no-estimate": "The explorer must return a map and a dart of it.",
    "budget": "The explorer must come to an end within the step budget.",
    "nondeterministic": "The explorer must do the same again when it senses the same.",
    "map": "The answer must be the same map as the world.",
    "pose": "The dart 'here' of the answer must stand for the robot's place.",
    "ambiguity": "An answer that names no map must be the quotient of all that look alike.",
    "invariant-1": "At every checkpoint, S must be embedded in the world.",
    "invariant-2": "At every checkpoint, U must hold no end of an explored edge.",
    "variant": "From checkpoint to checkpoint, an edge less must be unexplored.",
    "folding": "What was sensed must leave no other world: no answer may be guessed.",
    "bound": "The walk must not cost more than the bound.",
}
"""One sentence a law, in the order of precedence."""
