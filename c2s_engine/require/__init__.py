"""What S requires of a run, and whether a run shows it. Pure: no Scenic, no map, no I/O but its table of bounds.

`require(structure)` derives from S alone, never from what the writer planned; `evaluate` reads facts and tracks.
"""

from c2s_engine.require.conflict import without_reaction
from c2s_engine.require.deriving import require
from c2s_engine.require.judging import evaluate, majority, whole
from c2s_engine.require.scene import shown_by

__all__ = ["evaluate", "majority", "require", "shown_by", "whole", "without_reaction"]
