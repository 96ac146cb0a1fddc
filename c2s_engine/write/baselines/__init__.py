"""Methods to compare with, built from their published descriptions on this project's own data."""

from c2s_engine.write.baselines.chatscene import ChatScene
from c2s_engine.write.baselines.nl2scenic import NL2Scenic

__all__ = ["ChatScene", "NL2Scenic"]
