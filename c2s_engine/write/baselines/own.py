"""Code by hand and a program that a model wrote anew as a whole: each keeps its place, or the turn is refused."""

import re

from c2s_engine.structure.components import Component, Structure
from c2s_engine.structure.program import assemble
from c2s_engine.structure.regenerate import interface
from c2s_engine.write import by_hand
from c2s_engine.write.prompted.checking import Check, first_error

_MODEL = re.compile(r"^model\s", re.M)


async def with_own(before: Structure, written: Structure, check: Check | None) -> Structure:
    """The program written anew with the code by hand of before in it, and what the model wrote there offered beside it.

    An object by hand takes the place of the one that defines a name of its own, else of that of its number; where the
    new program has neither, it is added, if a scene can still be found. Raises ValueError where there is no place.
    """
    own = [c for c in before.components if c.origin in by_hand.OWN and c.code]
    if not own:
        return written
    if before.ego in own and _MODEL.search(before.ego.code):  # the whole program is by hand
        return by_hand.with_offer(before, "E", assemble(written).text)
    if not written.settings.code:
        which = ", ".join(c.id for c in own)
        raise ValueError(f"The model's program has no components, so that what is by hand ({which}) has no place in it")
    added: list[Component] = []
    taken: set[str] = set()
    for component in own:
        place = _place(component, written, taken)
        if place is None:
            added.append(component)
            continue
        taken.add(place)
        offer = written[place].code
        kept = component.model_copy(update={"id": place, "code": _renumbered(component, place)})
        written = by_hand.with_offer(written.with_component(kept), place, offer)
    for component in added:
        written = await _added(component, written, check)
    return written


def _place(component: Component, written: Structure, taken: set[str]) -> str | None:
    """Where a component by hand belongs in the new program."""
    if not component.id.startswith("O"):
        return component.id
    names = set(interface(component))
    free = [o for o in written.objects if o.id not in taken]
    namesake = next((o.id for o in free if names & set(interface(o))), None)
    return namesake or next((o.id for o in free if o.id == component.id), None)


async def _added(component: Component, written: Structure, check: Check | None) -> Structure:
    cid = component.id if component.id not in written else written.next_object_id()
    more = component.model_copy(update={"id": cid, "code": _renumbered(component, cid)})
    whole = by_hand.with_marks(written.model_copy(update={"objects": (*written.objects, more)}))
    if check is not None and (problem := await _problem(whole, check)) and not await _problem(written, check):
        raise ValueError(f"{component.id} is by hand and does not fit what the model wrote now ({problem})")
    return whole


async def _problem(structure: Structure, check: Check) -> str:
    program = assemble(structure)
    found = first_error(await check(program.text, program.spans, "sample"))
    return found.message if found else ""


def _renumbered(component: Component, cid: str) -> str:
    """Its code, with the border line of its new number where it has one."""
    return re.sub(rf"\A## {component.id}\b", f"## {cid}", component.code)
