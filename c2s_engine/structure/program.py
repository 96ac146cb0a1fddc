"""The assembled program and the map from its lines back to the components."""

from pydantic import BaseModel, ConfigDict

from c2s_engine.structure.components import ComponentId, Structure

BORDER = "## {id}: "
"""Every fragment begins with a comment line `## O1: its one-sentence description`."""


class FragmentSpan(BaseModel):
    """Lines `first`..`last` (1-based, inclusive) of the program belong to `component`."""

    model_config = ConfigDict(frozen=True, extra="forbid")

    component: ComponentId
    first: int
    last: int


class Program(BaseModel):
    """A Scenic program with its source map."""

    model_config = ConfigDict(frozen=True, extra="forbid")

    text: str
    spans: tuple[FragmentSpan, ...] = ()

    def component_at(self, line: int) -> ComponentId | None:
        """The component to which a line (1-based) of the program belongs."""
        for span in self.spans:
            if span.first <= line <= span.last:
                return span.component
        return None

    def span_of(self, cid: ComponentId) -> FragmentSpan | None:
        for span in self.spans:
            if span.component == cid:
                return span
        return None

    def fragment(self, cid: ComponentId) -> str:
        """The text of a component's fragment, as it stands in the program."""
        span = self.span_of(cid)
        lines = self.text.splitlines(keepends=True)
        return "".join(lines[span.first - 1 : span.last]) if span else ""


def assemble(structure: Structure) -> Program:
    """Concatenate the fragments in the order of writing (the paper, Algorithm 1, "S_code").

    Fragments written by the engine are separated by one empty line; imported ones carry their own spacing,
    so that an imported program is assembled again byte for byte.
    """
    pieces: list[str] = []
    spans: list[FragmentSpan] = []
    line = 1
    written = [c for c in structure.components if c.code]
    for i, component in enumerate(written):
        code = (
            component.code if component.code.endswith("\n") or component.origin == "imported" else component.code + "\n"
        )
        if component.origin != "imported" and i < len(written) - 1:
            code = code.rstrip("\n") + "\n\n"
        count = code.count("\n") + (0 if code.endswith("\n") else 1)
        spans.append(FragmentSpan(component=component.id, first=line, last=line + count - 1))
        pieces.append(code)
        line += code.count("\n")
    return Program(text="".join(pieces), spans=tuple(spans))
