"""Searching documents and snippets, reading and using what is found."""

from typing import TYPE_CHECKING, Any

from textual.content import Content

from c2s_engine.retrieve.provenance import attribution
from c2s_engine.structure.components import Structure
from c2s_engine.structure.edits import SetCode
from c2s_engine.structure.progress import Passage
from c2s_tui.part import Part, background, sentence
from c2s_tui.screens.dialogs import Reading

if TYPE_CHECKING:
    from c2s_tui.workbench import Workbench


class Search(Part):
    """Commands that concern the documents and snippets."""

    def __init__(self, bench: "Workbench"):
        super().__init__(bench)
        self.offered: set[tuple[str, str]] = set()  # (component, words) whose snippets were shown

    async def do_search(self, argument: str) -> None:
        if not argument:
            self.chat.entry.put("/search ")
            return
        await self.chat.user(f"/search {argument}")
        self.look_up(argument)

    @background("search")
    async def look_up(self, query: str) -> None:
        """Search the documents and show what was found, numbered."""
        self.bench.turns.working = self.bench.turns.working or "searching"
        self.bench.show_status()
        try:
            found = await self.backend.ask(lambda engine: engine.search(query, kind="doc", limit=5))
        except Exception as error:
            await self.chat.note(f"The search failed: {sentence(error)}", "error")
            return
        finally:
            self.bench.turns.working = "" if self.bench.turns.working == "searching" else self.bench.turns.working
            self.bench.show_status()
        if found:
            await self.chat.found([as_passage(f) for f in found])
            await self.chat.note("/read N opens one in full, /use N takes its scenario (or its code) into S.", "note")
        else:
            await self.chat.note("Nothing was found.", "note")

    @background("snippets")
    async def offer_snippets(self, structure: Structure) -> None:
        """When a turn is over, say which snippets are near to what no field could say; once for the same words."""
        from c2s_engine.retrieve.errors import RetrievalError

        try:
            found = await self.backend.ask(lambda engine: engine.snippets(structure))
        except (RetrievalError, OSError):
            return  # /search says why nothing can be searched
        new = [entry for entry in found if entry[:2] not in self.offered]
        if not new or self.bench.turns.busy or structure != self.desk.structure:
            return
        self.offered |= {entry[:2] for entry in new}
        for cid, words, _ in new:
            await self.chat.note(f"{cid or 'S'} has no field for “{words}”. Similar code:", "note")
        await self.chat.found([passage for *_, passages in new for passage in passages])

    def _result(self, number: str) -> Passage | None:
        """The result that a number means; None where there is none."""
        passages = self.chat.passages
        return passages[int(number) - 1] if number.isdigit() and 1 <= int(number) <= len(passages) else None

    async def _no_result(self, command: str) -> None:
        count = len(self.chat.passages)
        which = f"Give a number: /{command} 1 to /{command} {count}."
        said = which if count else "There are no results: use /search first."
        await self.chat.note(said, "error")

    async def do_read(self, argument: str) -> None:
        """A result in full."""
        chosen = self._result(argument)
        if chosen is None:
            await self._no_result("read")
            return
        notes = f"{attribution(chosen)}\n" if attribution(chosen) else ""
        head = f"{chosen.source}{f', {chosen.clause}' if chosen.clause else ''}\n{notes}\n"
        use = f"/use {argument}" if chosen.kind == "doc" else f"/use {argument} ID"
        foot = f"Esc goes back, c copies; {use} in the chat uses it"
        self.app.push_screen(Reading(chosen.title, Content.styled(head, "$muted") + chosen.text, foot))

    async def do_use(self, argument: str) -> None:
        from c2s_engine.session.citing import description_of

        number, _, cid = argument.partition(" ")
        chosen = self._result(number)
        if chosen is None:
            await self._no_result("use")
        elif chosen.kind == "snippet":
            await self._use_code(chosen, cid.strip(), number)
        else:
            siblings = await self.backend.ask(lambda engine: engine.search(chosen.title, kind="doc", limit=10))
            self.chat.entry.put(description_of(chosen, siblings))
            self.bench.room.go_to("chat")

    async def _use_code(self, chosen: Passage, cid: str, number: str) -> None:
        """Give a snippet's code to a component, as code by hand; undo takes it back."""
        fitting = [c.id for c in self.desk.structure.components if c.kind == chosen.component[:1]]
        if cid not in self.desk.structure:
            which = " or ".join(f"/use {number} {c}" for c in fitting) or "add an object first"
            await self.chat.note(f"Code for a component: name the component ({which}).", "error")
        else:
            await self.bench.turns.make_edits((SetCode(component=cid, code=chosen.text.rstrip("\n") + "\n"),))


def as_passage(found: Any) -> Passage:
    """A search result as the event that the chat shows."""
    if isinstance(found, Passage):
        return found
    data = (
        found if isinstance(found, dict) else {n: getattr(found, n) for n in Passage.model_fields if hasattr(found, n)}
    )
    return Passage.model_validate({"kind": "doc", "title": "", "text": "", "score": 0.0, **data, "type": "passage"})
