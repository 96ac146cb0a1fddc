"""The commands that open a screen to read, or to decide on."""

from textual.content import Content

from c2s_engine.structure.edits import SetCode
from c2s_tui.part import Part
from c2s_tui.screens.dialogs import Reading


class ScreenCommands(Part):
    """Help, glossary, where a component comes from, conflicts."""

    async def do_help(self, _: str) -> None:
        from c2s_tui.screens.help import help_screen

        focused = self.bench.focused
        name = next((n.HELP_NAME for n in focused.ancestors_with_self if hasattr(n, "HELP_NAME")), "chat") \
            if focused else "chat"  # fmt: skip
        titles = {"chat": "the chat", "sheet": "the structure S", "code": "the code", "picture": "the picture"}
        self.app.push_screen(help_screen(titles.get(name, name), focused, self.app.prefs.keys))

    async def do_glossary(self, argument: str) -> None:
        from c2s_engine.session.glossary import meaning, terms

        if argument:
            entry = meaning(argument)
            unknown = f"The glossary has no word {argument}; /glossary lists all of them."
            await self.chat.note(entry or unknown, "say" if entry else "error")
            return
        words = Content("\n").join(Content.assemble((name, "bold"), f": {text}") for name, text in terms().items())
        self.app.push_screen(Reading("Glossary", words))

    async def do_why(self, argument: str) -> None:
        from c2s_tui.screens.why import why_screen

        cid = argument or (self.bench.sheet.here.cid if self.bench.sheet.here else "") or "E"
        if cid not in self.desk.structure:
            await self.chat.note(f"There is no component {cid}.", "error")
            return
        component = self.desk.structure[cid]
        self.app.push_screen(why_screen(self.desk.structure, component, self.desk.state(component)))

    async def do_conflict(self, argument: str) -> None:
        from c2s_tui.screens.conflict import Conflict

        cid = argument or next((c.id for c in self.desk.structure.components if c.conflict is not None), "")
        if not cid or cid not in self.desk.structure or self.desk.structure[cid].conflict is None:
            await self.chat.note("There is no conflict.", "note")
            return
        component = self.desk.structure[cid]

        async def decided(which: str | None) -> None:
            if which == "mine":
                await self.bench.turns.make_edits((SetCode(component=cid, code=component.code),))
            elif which == "theirs":
                await self.bench.turns.make_edits((SetCode(component=cid, code=None),))

        self.app.push_screen(Conflict(cid, component.code, component.conflict or ""), decided)
