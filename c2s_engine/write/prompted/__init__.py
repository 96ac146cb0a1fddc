"""The prompted writer: the paper's component-wise generation, with the twelve configurations and with repair."""

from c2s_engine.write.prompted.method import PromptedMethod

__all__ = ["PromptedMethod"]
