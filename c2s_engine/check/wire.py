"""Frames between the server and its processes: a JSON header and an opaque blob. Only trusted senders send blobs."""

import asyncio
import json
import socket
import struct
from typing import Any

_HEAD = struct.Struct(">II")
MAXIMUM = 64 << 20  # bytes of one frame


class Closed(Exception):
    """The other side is gone."""


def encode(header: dict[str, Any], blob: bytes = b"") -> bytes:
    data = json.dumps(header).encode()
    return _HEAD.pack(len(data), len(blob)) + data + blob


def send(sock: socket.socket, header: dict[str, Any], blob: bytes = b"") -> None:
    """Send a frame over a blocking socket."""
    sock.sendall(encode(header, blob))


def receive(sock: socket.socket) -> tuple[dict[str, Any], bytes]:
    """Read a frame from a blocking socket; raises Closed at the end."""
    size, extra = _HEAD.unpack(_exactly(sock, _HEAD.size))
    return json.loads(_exactly(sock, size)), _exactly(sock, extra)


def _exactly(sock: socket.socket, count: int) -> bytes:
    parts = bytearray()
    while len(parts) < count:
        piece = sock.recv(min(count - len(parts), 1 << 20))
        if not piece:
            raise Closed
        parts += piece
    return bytes(parts)


async def read(reader: asyncio.StreamReader) -> tuple[dict[str, Any], bytes]:
    """Read a frame in the server; raises Closed at the end or where the frame makes no sense."""
    try:
        size, extra = _HEAD.unpack(await reader.readexactly(_HEAD.size))
        if size > MAXIMUM or extra > MAXIMUM:
            raise Closed
        header = json.loads(await reader.readexactly(size))
        blob = await reader.readexactly(extra)
    except (asyncio.IncompleteReadError, ConnectionError, ValueError):
        raise Closed from None
    if not isinstance(header, dict):
        raise Closed
    return header, blob
