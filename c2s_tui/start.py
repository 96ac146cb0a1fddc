"""The first run, the example and the gallery."""

from typing import TYPE_CHECKING

from c2s_engine.structure.specs import SettingsSpec
from c2s_tui import desk as desks
from c2s_tui.part import Part, background, sentence
from c2s_tui.screens.dialogs import Choosable, Chooser
from c2s_tui.sessions import fresh_name

if TYPE_CHECKING:
    from c2s_tui.workbench import Workbench

EXAMPLE = "example"


class Start(Part):
    """What happens before the first turn."""

    def __init__(self, bench: "Workbench", wanted: str | None):
        super().__init__(bench)
        self.wanted = wanted  # the session that was asked for
        self.ready = False  # programs can be checked

    @background("begin", exclusive=False)
    async def begin(self) -> None:
        """Make the engine, open the session that is asked for (else the last, else the example), start the checks."""
        try:
            await self.backend.load()
        except Exception as error:
            await self.chat.note(sentence(error), "error")
            await self.bench.turns.say_early(opened=False)
            return
        prefs = self.app.prefs
        if prefs.trouble:
            await self.chat.note(prefs.trouble, "warning")
        if prefs.model:
            await self.backend.set_model(prefs.model)
        known = {s.name for s in await self.backend.all_sessions()}
        if self.wanted is None and not prefs.welcomed:
            await self.welcome()
        else:
            last = prefs.session if prefs.session in known else None
            await self.bench.sessions.enter(self.wanted or last or fresh_name(known))
        await self.bench.turns.say_early(opened=self.bench.session is not None)
        try:
            await self.backend.start()
            stands = self.desk.structure.settings.spec
            likely = self.bench.choices.choice.map or (stands.map if isinstance(stands, SettingsSpec) else "")
            if likely:
                await self.backend.warm(likely)
        except Exception as error:
            await self.chat.note(f"Programs cannot be checked: {sentence(error)}. /doctor says more.", "error")
        self.ready = True
        if self.bench.files.file is not None and self.bench.session is not None:
            await self.bench.files.import_file(self.bench.files.file)
        if self.bench.turns.then and not self.bench.turns.busy:
            then, self.bench.turns.then = self.bench.turns.then, ""
            await self.bench.run_command(then)

    async def welcome(self) -> None:
        """The first run: the example session, explained in six lines; no model, no network."""
        from c2s_tui.example import install, lines, state

        try:
            if self.bench.session is None:
                left = state()
                self.desk = desks.restored(desks.opened(left.structure, left.program), left)
                self.bench.show()
            name = await self.backend.thread.do(lambda: install(self.backend.sessions, EXAMPLE))
        except (OSError, ValueError, RuntimeError) as error:
            await self.chat.note(f"The example could not be opened: {sentence(error)}", "warning")
            name = "session-1"
        await self.bench.sessions.enter(name)
        for line in lines():
            await self.chat.note(line, "say")
        self.app.remember(welcomed=True)

    async def do_example(self, _: str) -> None:
        if await self.bench.turns.may_begin():
            await self.welcome()

    async def do_gallery(self, argument: str) -> None:
        """The examples; the one that is chosen is put where one types, to be changed or sent."""
        from c2s_engine.session.gallery import gallery

        def chosen(name: str | None) -> None:
            if name:
                self.bench.room.go_to("chat")
                self.chat.entry.put(gallery()[name].text)

        if argument and argument not in gallery():
            names = ", ".join(gallery())
            await self.chat.note(f"There is no example {argument}; there are {names}.", "error")
        elif argument:
            chosen(argument)
        else:
            entries = [Choosable(name, name, example.about) for name, example in gallery().items()]
            foot = "Enter copies its text into the chat line; a second Enter sends it"
            self.app.push_screen(Chooser("Examples", entries, foot=foot, wide=True), chosen)
