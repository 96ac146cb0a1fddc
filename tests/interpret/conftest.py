"""One interpreter for all tests of the room (its parser takes two seconds to load)."""

import pytest

from c2s_engine.interpret import EmbeddedInterpreter
from c2s_engine.structure.components import Structure


@pytest.fixture(scope="session")
def read():
    """Text to S."""
    interpreter = EmbeddedInterpreter()

    def interpret(text: str) -> Structure:
        return interpreter.interpret(text).structure

    return interpret
