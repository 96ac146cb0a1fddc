"""Searching documents and snippets, reading and using what is found (a mixin of the workbench)."""

from typing import Any

from textual import work
from textual.content import Content

from c2s_engine.retrieve.provenance import whose
from c2s_engine.structure.edits import SetCode
from c2s_tui.screens.dialogs import Reading


class Search:
    """Commands that concern the documents and snippets."""

    async def do_search(self: Any, argument: str) -> None:
        if not argument:
            self.chat.entry.put("/search ")
            return
        await self.chat.user(f"/search {argument}")
        self.look_up(argument)

    @work(group="search", exclusive=True, exit_on_error=False)
    async def look_up(self: Any, query: str) -> None:
        """Search the documents and show what was found, numbered."""
        self.working = self.working or "searching"
        self.show_status()
        try:
            found = await self.backend.ask("search", query, kind="doc", limit=5)
        except Exception as error:
            await self.chat.note(f"The search failed: {self._sentence(error)}", "error")
            return
        finally:
            self.working = "" if self.working == "searching" else self.working
            self.show_status()
        if found:
            await self.chat.found([as_passage(f) for f in found])
            await self.chat.note("/read N opens one in full, /use N takes its scenario (or its code) into S.", "note")
        else:
            await self.chat.note("Nothing was found.", "note")

    @work(group="snippets", exclusive=True, exit_on_error=False)
    async def offer_snippets(self: Any, structure: Any) -> None:
        """When a turn is over, say which snippets are near to what no field could say; once for the same words."""
        if not self.backend.can("snippets"):
            return
        from c2s_engine.retrieve.errors import RetrievalError

        try:
            found = await self.backend.ask("snippets", structure)
        except (RetrievalError, OSError):
            return  # /search says why nothing can be searched
        new = [entry for entry in found if entry[:2] not in self.offered]
        if not new or self.busy or structure != self.desk.structure:
            return
        self.offered |= {entry[:2] for entry in new}
        for cid, words, _ in new:
            await self.chat.note(f"{cid or 'S'} has no field for “{words}”. Similar code:", "note")
        await self.chat.found([passage for *_, passages in new for passage in passages])

    def _result(self: Any, number: str) -> Any:
        """The result that a number means; None where there is none."""
        passages = self.chat.passages
        return passages[int(number) - 1] if number.isdigit() and 1 <= int(number) <= len(passages) else None

    async def _no_result(self: Any, command: str) -> None:
        count = len(self.chat.passages)
        which = f"Give a number: /{command} 1 to /{command} {count}."
        said = which if count else "There are no results: use /search first."
        await self.chat.note(said, "error")

    async def do_read(self: Any, argument: str) -> None:
        """A result in full."""
        chosen = self._result(argument)
        if chosen is None:
            await self._no_result("read")
            return
        notes = f"{whose(chosen)}\n" if whose(chosen) else ""
        head = f"{chosen.source}{f', {chosen.clause}' if chosen.clause else ''}\n{notes}\n"
        use = f"/use {argument}" if chosen.kind == "doc" else f"/use {argument} ID"
        foot = f"Esc goes back, c copies; {use} in the chat uses it"
        self.app.push_screen(Reading(chosen.title, Content.styled(head, "$muted") + chosen.text, foot))

    async def do_use(self: Any, argument: str) -> None:
        from c2s_engine.session.citing import description_of

        number, _, cid = argument.partition(" ")
        chosen = self._result(number)
        if chosen is None:
            await self._no_result("use")
        elif chosen.kind == "snippet":
            await self._use_code(chosen, cid.strip(), number)
        else:
            siblings = await self.backend.ask("search", chosen.title, kind="doc", limit=10)
            self.chat.entry.put(description_of(chosen, siblings))
            self.go_to("chat")

    async def _use_code(self: Any, chosen: Any, cid: str, number: str) -> None:
        """Give a snippet's code to a component, as code by hand; undo takes it back."""
        fitting = [c.id for c in self.desk.structure.components if c.kind == chosen.component[:1]]
        if cid not in self.desk.structure:
            which = " or ".join(f"/use {number} {c}" for c in fitting) or "add an object first"
            await self.chat.note(f"Code for a component: name the component ({which}).", "error")
        else:
            await self.make_edits((SetCode(component=cid, code=chosen.text.rstrip("\n") + "\n"),))


def as_passage(found: Any) -> Any:
    """A search result as the event that the chat shows."""
    from c2s_engine.structure.progress import Passage

    if isinstance(found, Passage):
        return found
    data = (
        found if isinstance(found, dict) else {n: getattr(found, n) for n in Passage.model_fields if hasattr(found, n)}
    )
    return Passage.model_validate({"kind": "doc", "title": "", "text": "", "score": 0.0, **data, "type": "passage"})
