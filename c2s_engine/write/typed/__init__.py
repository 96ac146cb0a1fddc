"""The typed writer: spec to Scenic, closed under compilation."""

from c2s_engine.write.typed.contradictions import ResolveError
from c2s_engine.write.typed.plan import Plan
from c2s_engine.write.typed.planning import make_plan
from c2s_engine.write.typed.spread import contradiction
from c2s_engine.write.typed.writer import TypedWriter

__all__ = ["Plan", "ResolveError", "TypedWriter", "contradiction", "make_plan"]
