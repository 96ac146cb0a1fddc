"""What the text left open is chosen so that what S requires is seen: unknowns, moves, and a bounded search over runs.

Pure: what a choice comes to is asked of the caller (`evaluate`), who writes, runs and judges. Only what S leaves open,
or has assumed, is changed; each choice stands in its component's `assumed`, by `planner`. What the text says is
changed only to find out what would resolve a contradiction (`relaxations`), and never kept.
"""

from c2s_engine.solve.relaxing import Relaxation, relaxations
from c2s_engine.solve.search import Outcome, solve
from c2s_engine.solve.unknowns import PLANNER, Unknown, unknowns
from c2s_engine.solve.widening import widened

__all__ = ["PLANNER", "Outcome", "Relaxation", "Unknown", "relaxations", "solve", "unknowns", "widened"]
