"""Whom a noun or "one" means by where it is: "the one on the left", "the vehicle behind", "the parked one"."""

from __future__ import annotations

from c2s_engine.interpret.who.parts import Parts

PARTS = {"ahead": "lead", "behind": "following", "oncoming": "oncoming"}
"""The part in the scene of who is at a place."""


class ByPlace(Parts):
    """The part of Cast that knows road users by where they are."""
