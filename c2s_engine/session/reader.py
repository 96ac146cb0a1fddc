"""The learned reader in a process of its own, for fronts that draw: a parser that is being loaded holds Python's lock
for seconds, and a key would wait for it. `python -m c2s_engine.session.reader` is the process; frames are a length
(four bytes) and a pickle, between processes of one program only.
"""

import asyncio
import contextlib
import pickle
import struct
import sys
from dataclasses import dataclass
from typing import Any, BinaryIO

from c2s_engine.structure.components import Structure
from c2s_engine.structure.edits import Edit

HEAD = struct.Struct("!I")


class Unreadable(ValueError):
    """A text that is not understood, or that the process ended upon; the message is for the user."""


@dataclass(frozen=True)
class Asked:
    """What a turn asks for: as `interpret.turn.Turn`, without importing it here."""

    kind: str
    edits: tuple[Edit, ...] = ()
    reply: str = ""
    corrects: bool = False


class Reader:
    """Reads texts elsewhere; where the process ended, the next call starts another."""

    def __init__(self) -> None:
        self._process: asyncio.subprocess.Process | None = None
        self._listening: asyncio.Task[None] | None = None
        self._waiting: dict[int, asyncio.Future[Any]] = {}
        self._number = 0
        self._starting = asyncio.Lock()

    async def start(self) -> None:
        """Start the process, which loads the parser while nobody waits."""
        async with self._starting:
            if self._process is None or self._process.returncode is not None:
                self._process = await asyncio.create_subprocess_exec(
                    sys.executable, "-m", "c2s_engine.session.reader",
                    stdin=asyncio.subprocess.PIPE, stdout=asyncio.subprocess.PIPE, start_new_session=True,
                )  # fmt: skip
                self._listening = asyncio.create_task(self._listen(self._process))

    async def ask(self, *call: Any) -> Any:
        """An answer to ("read", text) or ("route", text, structure, last); raises Unreadable."""
        await self.start()
        assert self._process is not None and self._process.stdin is not None
        self._number += 1
        number = self._number
        answer = self._waiting[number] = asyncio.get_running_loop().create_future()
        try:
            with contextlib.suppress(ConnectionError):  # the listener says that it is lost
                self._process.stdin.write(_frame((number, call)))
                await self._process.stdin.drain()
            return await answer
        except asyncio.CancelledError:  # it would read on, and the next text would wait for that
            await self.close()
            raise
        finally:
            self._waiting.pop(number, None)

    async def close(self) -> None:
        """End the process."""
        if self._process is not None:
            with contextlib.suppress(ProcessLookupError):
                self._process.kill()
            await self._process.wait()
        if self._listening is not None:
            self._listening.cancel()
        self._process = None

    async def _listen(self, process: asyncio.subprocess.Process) -> None:
        assert process.stdout is not None
        with contextlib.suppress(asyncio.IncompleteReadError, ConnectionError):
            while True:
                (size,) = HEAD.unpack(await process.stdout.readexactly(HEAD.size))
                number, value, error = pickle.loads(await process.stdout.readexactly(size))
                answer = self._waiting.get(number)
                if answer is not None and not answer.done():
                    answer.set_exception(error) if error is not None else answer.set_result(value)
        await process.wait()
        for answer in self._waiting.values():
            if not answer.done():
                answer.set_exception(Unreadable("The interpreter stopped while reading the text: send it again."))


async def read(text: str, tools: Any) -> Any:
    """What the learned reader reads of a text (interpret.learned.Read), by the process apart where there is one, else
    in a thread; raises Unreadable."""
    return await _asked(tools, "read", text)


async def phrases(text: str, tools: Any) -> list[tuple[int, int]]:
    """The spans of a text's phrases, longer ones first."""
    return await _asked(tools, "phrases", text)


async def route(
    text: str, structure: Structure | None, tools: Any, last: tuple[str, Structure] | None = None
) -> Asked:
    """What a turn asks for, given the S at hand, and what was typed last upon which S."""
    return await _asked(tools, "route", text, structure, last)


async def change(text: str, structure: Structure, tools: Any) -> tuple[Edit, ...]:
    """The edits of S that a text means, which is a change; none where it is not understood. Raises Unreadable."""
    return await _asked(tools, "change", text, structure)


async def _asked(tools: Any, name: str, *arguments: Any) -> Any:
    reader = tools.extra.get("reader")
    return await (reader.ask(name, *arguments) if reader else asyncio.to_thread(_answer, name, arguments))


def _frame(value: Any) -> bytes:
    data = pickle.dumps(value)
    return HEAD.pack(len(data)) + data


def _answer(name: str, arguments: tuple[Any, ...]) -> Any:
    from c2s_engine.interpret import InterpreterFault, InterpretError
    from c2s_engine.interpret.english import NOT_ENGLISH, is_english
    from c2s_engine.interpret.learned import ReaderError, learned, read_change
    from c2s_engine.interpret.phrases import phrases_of

    if name == "phrases":
        return phrases_of(*arguments)
    if name == "route":
        return routed(*arguments)
    try:
        if name == "change":
            if not is_english(arguments[0]):
                raise InterpretError(NOT_ENGLISH)
            found = read_change(*arguments)
            return found.edits if found is not None else ()
        return learned(*arguments)
    except (InterpretError, InterpreterFault, ReaderError) as error:
        raise Unreadable(str(error)) from None


def routed(text: str, structure: Structure | None, last: tuple[str, Structure] | None = None) -> Asked:
    """What `route` answers, in this process."""
    from c2s_engine.interpret import InterpreterFault
    from c2s_engine.interpret.turn import PreviousTurn
    from c2s_engine.interpret.turn import route as route_here

    try:
        asked = route_here(text, structure, PreviousTurn(*last) if last else None)
    except InterpreterFault as fault:
        return Asked("edit", reply=str(fault))
    return Asked(asked.kind, tuple(asked.edits), asked.reply, asked.corrects)


def serve(requests: BinaryIO, answers: BinaryIO) -> None:
    """Answer until the pipe is closed."""
    with contextlib.suppress(Exception):
        _answer("read", ("A car drives ahead of ego.",))  # loads the parser and the model
    while len(head := requests.read(HEAD.size)) == HEAD.size:
        number, (name, *arguments) = pickle.loads(requests.read(*HEAD.unpack(head)))
        try:
            frame = _frame((number, _answer(name, tuple(arguments)), None))
        except Exception as error:
            frame = _frame((number, None, error))
        answers.write(frame)
        answers.flush()


def main() -> None:
    """The process."""
    sink = sys.stdout.buffer
    sys.stdout = sys.stderr  # what libraries print must not get between the frames
    with contextlib.suppress(KeyboardInterrupt, BrokenPipeError):
        serve(sys.stdin.buffer, sink)


if __name__ == "__main__":
    from c2s_engine.session.reader import main as run  # classes are pickled under this name, not __main__'s

    run()
