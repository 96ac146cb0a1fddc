"""Why a component is as it is: the words of the text, the clauses, snippets and chunks it rests on."""

from textual.content import Content

from c2s_engine.structure.components import Component, Structure
from c2s_tui.look.kinds import colour, mark, state_word
from c2s_tui.screens.dialogs import Reading

KINDS = {"text": "your words", "rule": "rule", "clause": "clause", "snippet": "snippet", "chunk": "documentation"}


def why_screen(structure: Structure, component: Component, state: str) -> Reading:
    """The sources of one component, with the user's text in which its words are marked."""
    return Reading(f"Why is {component.id} here?", _body(structure, component, state))


def _body(structure: Structure, component: Component, state: str) -> Content:
    origin = {"rendered": "written from its fields", "generated": "written by a model", "by_hand": "written by hand",
              "imported": "imported"}[component.origin]  # fmt: skip
    parts: list = [(f"{component.description or 'no sentence'}\n", f"bold {colour(component.id)}")]
    parts.append((f"{origin}; {state_word(state)}\n\n", "$muted"))
    if structure.text:
        text = Content(structure.text)
        for link in component.links:
            if link.span:
                text = text.stylize(f"bold {colour(component.id)}", *link.span)
        parts += [text, "\n\n"]
    for link in component.links:
        parts += [(f"{KINDS[link.kind]:<14}", "$muted"), f"{link.label}\n"]
    if not component.links:
        parts.append(("no words or sources are recorded for it\n", "$muted"))
    for assumption in component.assumed:
        parts += [(f"{mark('assumed')} assumed       ", "$muted"), f"{assumption.field} = {assumption.value}: ",
                  f"{assumption.reason}\n"]  # fmt: skip
    for unmet in component.unmet:
        parts += [(f"{mark('unmet')} not said      ", "$text-warning"), f"{unmet.text}: {unmet.reason}\n"]
    return Content.assemble(*parts)
