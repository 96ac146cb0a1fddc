"""Texts with their S by hand: what the learned reader is trained on, and by which reading and motion are measured."""
