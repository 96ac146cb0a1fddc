"""The loop of the check server: requests in, processes started, watched, killed, reports out."""

import asyncio
import functools
import json
import os
import socket
from typing import Any

from c2s_engine.check import wire
from c2s_engine.check.pool import Pool
from c2s_engine.check.protocol import CheckRequest, ImportRequest, PlacesRequest
from c2s_engine.check.supervise import check, expect, import_program, places

ENDED = "a process of the check server ended unexpectedly while it worked on this; try it again"
LINE = 64 << 20  # bytes of the longest request


def run(control: socket.socket, out: int, runner: str | None) -> None:
    """Serve requests from stdin until it is closed."""
    asyncio.run(_serve(control, out, runner))


async def _serve(control: socket.socket, out: int, runner: str | None) -> None:
    reader = asyncio.StreamReader(limit=LINE)
    loop = asyncio.get_running_loop()
    await loop.connect_read_pipe(lambda: asyncio.StreamReaderProtocol(reader), os.fdopen(0, "rb"))
    pool = await Pool.start(control)
    running: dict[Any, asyncio.Task] = {}
    lost = asyncio.create_task(pool.lost.wait())
    waiting = asyncio.create_task(_announce(pool, out))
    while True:
        line_task = asyncio.ensure_future(reader.readline())
        await asyncio.wait({line_task, lost}, return_when=asyncio.FIRST_COMPLETED)
        if lost.done():
            _write(out, {"lost": True})
            break
        line = line_task.result()
        if not line:
            break
        message = json.loads(line)
        key = message["id"]
        if message["kind"] == "cancel":
            if key in running:
                running[key].cancel()
            continue
        if message["kind"] == "expect":
            task = asyncio.create_task(expect(pool, message["body"]["map"]))
        else:
            task = asyncio.create_task(_answer(pool, message, out, runner))
        running[key] = task
        task.add_done_callback(functools.partial(_forget, running, key))
    waiting.cancel()
    for task in list(running.values()):
        task.cancel()
    await asyncio.gather(*running.values(), return_exceptions=True)
    pool.close()


def _forget(running: dict[Any, asyncio.Task], key: Any, _: asyncio.Task) -> None:
    running.pop(key, None)


async def _announce(pool: Pool, out: int) -> None:
    await pool.root.warm.wait()
    _write(out, {"ready": True})


async def _answer(pool: Pool, message: dict[str, Any], out: int, runner: str | None) -> None:
    key, kind = message["id"], message["kind"]
    try:
        if kind == "check":
            body = (await check(pool, CheckRequest.model_validate(message["body"]), runner)).model_dump_json()
        elif kind == "places":
            body = (await places(pool, PlacesRequest.model_validate(message["body"]))).model_dump_json()
        elif kind == "import":
            body = (await import_program(pool, ImportRequest.model_validate(message["body"]))).model_dump_json()
        else:
            raise ValueError(f"unknown kind of request {kind!r}")
    except asyncio.CancelledError:
        _write(out, {"id": key, "ok": False, "error": ENDED if pool.lost.is_set() else "cancelled"})
        return
    except wire.Closed:
        _write(out, {"id": key, "ok": False, "error": ENDED})
        return
    except Exception as error:
        said = str(error) if isinstance(error, ValueError) else f"{type(error).__name__}: {error}"
        _write(out, {"id": key, "ok": False, "error": said})
        return
    _raw(out, b'{"id": ' + json.dumps(key).encode() + b', "ok": true, "body": ' + body.encode() + b"}\n")


def _write(out: int, message: dict[str, Any]) -> None:
    _raw(out, json.dumps(message).encode() + b"\n")


def _raw(out: int, data: bytes) -> None:
    view = memoryview(data)
    while view:
        view = view[os.write(out, view) :]
