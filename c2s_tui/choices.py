"""Choosing what a turn uses: method, model, map, theme (a mixin of the workbench)."""

from typing import Any

from textual import work

from c2s_tui.screens.dialogs import Choosable, Chooser, Reading

METHODS = [
    Choosable("embedded", "embedded", "no language model: nothing to install, fastest"),
    Choosable("typed", "typed", "a language model fills in S; the code is written from its fields"),
    Choosable("mixed", "mixed", "like typed; what no field can express, the model writes as code"),
    *(Choosable(f"chat2scenic:C{i}", f"C{i}", f"configuration {i} of Chat2Scenic: a language model writes the code")
      for i in range(1, 13)),
]  # fmt: skip


class Choices:
    """Commands that open a list, or take the name that follows them."""

    async def do_method(self: Any, argument: str) -> None:
        names = {m.value: m.value for m in METHODS} | {m.label: m.value for m in METHODS}
        if argument in names:
            self.choose(method=names[argument])
            return
        if argument:
            await self.chat.note(
                f"There is no method {argument}; there are {', '.join(m.label for m in METHODS)}.", "error"
            )
            return
        self.app.push_screen(
            Chooser("How programs are written", METHODS, self.choice.method),
            lambda value: self.choose(method=value) if value else None,
        )

    async def do_vim(self: Any, _: str) -> None:
        """Vim's keys in the code, on or off."""
        on = not self.app.prefs.vim
        self.app.remember(vim=on)
        self.code.area.use_vim(on)
        state = "on: Esc leaves insert mode, i enters it" if on else "off"
        self.app.notify(f"Vim keys in the code are {state}.", markup=False)

    async def do_mouse(self: Any, _: str) -> None:
        """Leave the mouse to the terminal, so that text is selected and copied as anywhere else in it, or take it."""
        driver, self.mouse_free = self.app._driver, not self.mouse_free
        switch = getattr(driver, f"_{'disable' if self.mouse_free else 'enable'}_mouse_support", None)
        if switch is not None:
            switch()
        free = "The mouse is the terminal's: select and copy as usual; /mouse takes it back."
        self.app.notify(free if self.mouse_free else "The mouse works here again.", markup=False)

    async def do_theme(self: Any, argument: str) -> None:
        from c2s_tui.look.themes import names

        if argument and argument not in names():
            await self.chat.note(f"There is no theme {argument}; there are {', '.join(names())}.", "error")
            return
        if argument:
            self.take_theme(argument)
            return
        entries = [Choosable(n, n, _THEMES.get(n, "")) for n in names()]
        self.app.push_screen(
            Chooser("Theme", entries, self.app.theme), lambda value: self.take_theme(value) if value else None
        )

    def take_theme(self: Any, name: str) -> None:
        self.app.theme = name
        self.app.remember(theme=name)
        self.show()

    async def do_map(self: Any, argument: str) -> None:
        self.offer_maps(argument)

    @work(group="choices", exclusive=True, exit_on_error=False)
    async def offer_maps(self: Any, argument: str) -> None:
        """The maps that are installed; `auto` leaves it to the text."""
        maps = list(await self.backend.ask("maps"))
        entries = [Choosable("auto", "auto", "the one that the text names, else the default")]
        entries += [Choosable(m.name, m.name, str(getattr(m, "path", ""))) for m in maps]
        if argument:
            if argument not in {e.value for e in entries}:
                names = ", ".join(e.value for e in entries)
                await self.chat.note(f"There is no map {argument}; there are {names}.", "error")
                return
            chosen: str | None = argument
        else:
            chosen = await self.app.push_screen_wait(Chooser("Map", entries, self.choice.map or "auto"))
        if chosen:
            self.choose(map="" if chosen == "auto" else chosen)

    async def do_model(self: Any, argument: str) -> None:
        if argument:
            await self.take_model(argument)
        else:
            self.offer_models()

    async def take_model(self: Any, name: str) -> None:
        """Use a model from now on."""
        await self.backend.set_model(name)
        self.choose(model=name)

    @work(group="choices", exclusive=True, exit_on_error=False)
    async def offer_models(self: Any) -> None:
        """The models that Ollama has, with sizes; a typed name is pulled."""
        try:
            models = await self.backend.models()
        except Exception as error:
            self.app.push_screen(
                Reading("No models", f"{self._sentence(error)}\n\nThe method `embedded` needs none: /method embedded")
            )
            return
        entries = [Choosable(m["name"], m["name"], m.get("note", "")) for m in models]
        chosen = await self.app.push_screen_wait(
            Chooser("Language model", entries, self.choice.model, free="type to filter, or the name of a model to pull")
        )
        if not chosen:
            return
        if chosen not in {e.value for e in entries} and not await self._pull(chosen):
            return
        await self.take_model(chosen)

    async def _pull(self: Any, name: str) -> bool:
        """Pull a model, its progress in the status line; whether that went well."""
        try:
            async for status, done, total in self.backend.pull(name):
                share = f" {100 * done // total} %" if total else ""
                self.working = f"pulling {name}: {status}{share}"
                self.show_status()
        except Exception as error:
            await self.chat.note(f"{name} could not be pulled: {self._sentence(error)}", "error")
            return False
        finally:
            self.working = ""
            self.show_status()
        return True

    async def do_gallery(self: Any, argument: str) -> None:
        """The examples; the one that is chosen is put where one types, to be changed or sent."""
        from c2s_engine.session.gallery import gallery

        def chosen(name: str | None) -> None:
            if name:
                self.go_to("chat")
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

    async def do_settings(self: Any, _: str) -> None:
        self.settings_dialog()

    @work(group="choices", exclusive=True, exit_on_error=False)
    async def settings_dialog(self: Any) -> None:
        """Everything that can be chosen, with what stands."""
        from c2s_tui.prefs import prefs_file

        prefs = self.app.prefs
        entries = [
            Choosable("method", "method", self.choice.method),
            Choosable("model", "model", self.choice.model or "none (only the method embedded works without one)"),
            Choosable("map", "map", self.choice.map or "auto"),
            Choosable("theme", "theme", self.app.theme),
            Choosable("animation", "animation", "on" if prefs.animation else "off (for slow connections)"),
            Choosable("doctor", "doctor", "check the installation"),
        ]
        foot = f'Keys are remapped under [keys] in {prefs_file().name}, beside config.toml: "app.run" = "f6"'
        chosen = await self.app.push_screen_wait(Chooser("Settings", entries, foot=foot))
        if chosen == "animation":
            self.app.remember(animation=not prefs.animation)
            self.app.animation_level = "full" if prefs.animation else "none"
            self.settings_dialog()
        elif chosen:
            await self.run_command(chosen)

    async def do_doctor(self: Any, _: str) -> None:
        self.look_over()

    @work(group="choices", exclusive=True, exit_on_error=False)
    async def look_over(self: Any) -> None:
        """Show what the doctor finds."""
        from c2s_tui.findings import findings

        self.working = self.working or "checking the installation"
        self.show_status()
        try:
            lines = await findings(self.backend)
        finally:
            self.working = ""
            self.show_status()
        self.app.push_screen(Reading("Doctor", "\n".join(lines)))


_THEMES = {
    "c2s-dark": "dark", "c2s-light": "light", "c2s-ansi": "the terminal's own 16 colours", "c2s-mono": "without colour",
}  # fmt: skip
