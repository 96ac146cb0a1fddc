"""Eighth stage: what became of each clause of the text, so that nothing of it is dropped without a word."""

from c2s_engine.interpret.accounting.account import accounted, accounted_for_given_structure

__all__ = ["accounted", "accounted_for_given_structure"]
