"""The app on the scripted engine, with real sessions in a folder of the test's own."""

import asyncio
from collections.abc import AsyncIterator, Awaitable, Callable, Iterator
from contextlib import asynccontextmanager
from pathlib import Path
from typing import Any

import pytest
from pytest_textual_snapshot import SVGImageExtension
from scripted_engine import CUT_IN, ScriptedEngine, describing
from textual.widgets import Input, TextArea

from c2s_engine.structure.edits import SetField
from c2s_tui.app import C2SApp
from c2s_tui.backend import Backend
from c2s_tui.prefs import Prefs

QUICK = {
    "test_describe_to_program", "test_describe_to_program_80x24", "test_escape_cancels_and_keeps_what_is_typed",
    "test_edit_an_object_shows_its_reach_and_rewrites_only_that", "test_hand_edit_and_conflict",
    "test_compile_error_and_fix", "test_undo_and_redo", "test_first_run_opens_and_explains_the_example",
    "test_the_picture_after_steps", "test_what_was_typed_comes_back", "test_the_results_of_a_run",
}  # fmt: skip
"""The flows of `make test`; the others are part of `make test-full`."""

SNAPSHOTS = Path(__file__).parents[2] / "snapshots"


@pytest.hookimpl(tryfirst=True)
def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    for item in items:
        ours = item.path.parent == Path(__file__).parent and "stage" in getattr(item, "fixturenames", ())
        if ours and item.name not in QUICK:
            item.add_marker(pytest.mark.full)


@pytest.fixture(autouse=True, scope="session")
def _pictures_in_the_top_folder() -> None:
    SVGImageExtension.dirname = classmethod(
        lambda cls, *, test_location: str(SNAPSHOTS / Path(test_location.filepath).stem)
    )


@pytest.fixture(autouse=True)
def _homes(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    for name in ("CACHE", "DATA", "CONFIG"):
        monkeypatch.setenv(f"XDG_{name}_HOME", str(tmp_path / name.lower()))
    for name in ("NO_COLOR", "TMUX", "C2S_ASCII"):
        monkeypatch.delenv(name, raising=False)
    monkeypatch.setenv("TERM", "xterm-256color")


class Stage:
    """One app with its engine; `flow` steps wait for what they wait for, never for time."""

    def __init__(self, folder: Path):
        self.engine = ScriptedEngine(scripts=describing())
        self.folder = folder
        self.backends: list[Backend] = []
        self.app: Any = None

    def make(self, session: str | None = "demo", prefs: Prefs | None = None, file: Path | None = None) -> C2SApp:
        """An app on the engine as it is set up now."""
        backend = Backend(lambda: self.engine, self.folder)
        self.backends.append(backend)
        self.app = C2SApp(backend=backend, session=session, file=file, prefs=prefs or Prefs(welcomed=True))
        return self.app

    @property
    def bench(self) -> Any:
        return self.app.workbench

    @property
    def busy(self) -> bool:
        """Whether a turn, a run or a search is under way."""
        return self.bench.turns.busy

    @property
    def said(self) -> list[str]:
        """The lines of the conversation."""
        return [line.plain for line in self.bench.query("Line")]

    async def until(self, pilot: Any, holds: Callable[[], Any]) -> None:
        """Let the app work until something holds."""
        for _ in range(3000):
            if holds():
                await pilot.pause()
                return
            await asyncio.sleep(0.01)
        raise AssertionError(f"this never came to hold; the chat says {self.said[-3:]}")

    async def ready(self, pilot: Any) -> None:
        await self.until(pilot, lambda: self.bench is not None and self.bench.start.ready)

    async def idle(self, pilot: Any) -> None:
        await self.until(pilot, lambda: not self.busy)
        await pilot.pause()

    async def say(self, pilot: Any, text: str, wait: bool = True) -> None:
        """Type a line into the chat and send it; wait for the turn's end."""
        before = len(self.said)
        self.bench.chat.entry.put(text)
        self.bench.chat.entry.focus()
        await pilot.press("enter")
        if wait:
            await self.until(pilot, lambda: len(self.said) > before and not self.busy)
            await pilot.pause()

    @asynccontextmanager
    async def described(self, size: tuple[int, int] = (140, 45)) -> AsyncIterator[Any]:
        """A pilot of an app in which CUT_IN has been described."""
        async with self.make().run_test(size=size) as pilot:
            await self.ready(pilot)
            await self.say(pilot, CUT_IN)
            yield pilot

    def write(self, old: str, new: str) -> None:
        """Write something else in the code pane; it is not applied yet."""
        self.bench.code.area.text = self.bench.code.area.text.replace(old, new)

    async def misspell(self, pilot: Any) -> None:
        """Write a name that is not defined, and wait until that is found while it is typed; F8 goes there."""
        await pilot.press("f4")
        await self.until(pilot, lambda: self.bench.code.area.has_focus)
        self.write("with behavior VanBehavior", "with behavior VanBehaviour")
        await self.until(pilot, lambda: self.bench.code.area.problems)
        await pilot.press("f8")
        await self.until(pilot, lambda: self.bench.code.finding is not None)
        assert self.bench.code.finding.component == "O1"

    async def conflict(self, pilot: Any, gap: float = 25.0) -> None:
        """Change a field of O1, which is written by hand."""
        await self.bench.turns.make_edits((SetField(component="O1", path="placement.gap", value=gap),))
        await self.until(pilot, lambda: self.bench.desk.structure["O1"].conflict and not self.busy)

    async def editing(self, pilot: Any, key: str) -> None:
        """Open a row of the structure pane for editing."""
        await self.to_row(pilot, key)
        await pilot.press("enter")
        await self.until(pilot, lambda: self.bench.sheet.editor and self.bench.sheet.editor.query("Input"))

    async def to_row(self, pilot: Any, key: str) -> None:
        """Put the cursor of the structure pane on a row."""
        self.bench.room.go_to("sheet")
        await self.until(pilot, lambda: self.bench.sheet.has_focus)
        self.bench.sheet._go([row.key for row in self.bench.sheet.rows].index(key))
        await pilot.pause()

    async def type_over(self, pilot: Any, text: str) -> None:
        """Replace what stands in the focused line and press Enter."""
        await self.until(pilot, lambda: isinstance(self.app.focused, Input))
        self.app.focused.value = text
        await pilot.press("enter")
        await self.idle(pilot)

    async def still(self, pilot: Any) -> None:
        """Stop what blinks, and let the last drawing be done."""
        await self.until(pilot, lambda: self.bench.drawing.due is None)
        for screen in self.app.screen_stack:
            for area in [*screen.query(TextArea), *screen.query(Input)]:
                area.cursor_blink = False
                area.notify_style_update()  # a line that was drawn while the cursor was off may be kept
                area.refresh()
        self.app.clear_notifications()
        await pilot.pause()
        await pilot.pause()


@pytest.fixture
def stage(tmp_path: Path) -> Iterator[Stage]:
    found = Stage(tmp_path / "sessions")
    yield found
    assert found.app is None or found.bench is None or not found.bench.faults, "errors of the app's own"
    for backend in found.backends:
        asyncio.run(backend.close())


@pytest.fixture
def compare(snap_compare: Any, stage: Stage) -> Callable[..., bool]:
    """Run a flow on a fresh app and compare the picture; the flow asserts the state first."""

    def run(flow: Callable[[Any], Awaitable[None]], size: tuple[int, int] = (140, 45), **options: Any) -> bool:
        app = stage.make(**options)

        async def before(pilot: Any) -> None:
            await stage.ready(pilot)
            await flow(pilot)
            await stage.still(pilot)

        return snap_compare(app, terminal_size=size, run_before=before)

    return run
