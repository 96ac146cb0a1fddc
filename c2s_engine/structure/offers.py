"""What would do where the numbers of a text contradict one another: data that fronts show."""

from collections.abc import Sequence

from pydantic import BaseModel, ConfigDict

from c2s_engine.structure.components import ComponentId, field_words


class Offer(BaseModel):
    """A number of the text, and the value with which alone all that is required was shown in one run.

    `said`, `value`: in the user's units; `amount`: the value in SI units, as `SetField` takes it."""

    model_config = ConfigDict(frozen=True)

    component: ComponentId
    field: str
    said: str
    value: str
    amount: float

    def __str__(self) -> str:
        return f"{self.component}: {field_words(self.field)} {self.value} instead of {self.said}"


def verdict(found: Sequence[Offer]) -> str:
    """What the offers say of S, in a sentence or two."""
    if not found:
        return "No change of a single number in the text was found that meets all requirements."
    if len(found) == 1:
        return f"All requirements are met with one number changed: {found[0]}."
    names = ", ".join(f"{o.component} {field_words(o.field)} {o.said}" for o in found)
    lines = "\n".join(f"- {o}" for o in found)
    return f"These numbers contradict one another: {names}. Any one of these changes resolves it:\n{lines}"
