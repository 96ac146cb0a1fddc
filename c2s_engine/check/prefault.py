"""A forked process copies each page on which it first writes: this does so ahead, for the pages that a check writes on.

Most of the time of a short check goes into such faults. A scout, forked once from a snapshot, rehearses a check and
tells which pages it had to copy; a child that waits for its job copies the same ones meanwhile. Linux only: elsewhere
nothing is learnt and nothing done.
"""

import array
import contextlib
import ctypes
import mmap
import os
import sys
from collections.abc import Callable
from typing import Any

Ranges = list[tuple[int, int]]
_POPULATE_WRITE = 23  # of madvise, since Linux 5.14
_EXCLUSIVE = 1 << 63 | 1 << 56  # of a page's entry in pagemap: present, and mapped by this process alone
_PAGE = mmap.PAGESIZE
pages: Ranges = []
"""What a forked process writes on while it does what was rehearsed."""
later: Ranges = []
"""What of this it writes on in the second half alone."""
Rehearsal = Callable[[Callable[[], None]], None]
"""Is given what is to be called halfway."""


def learn(rehearse: Rehearsal) -> None:
    """Find out which pages these are; none where that cannot be known."""
    pages[:], later[:] = _scouted(rehearse) if sys.platform.startswith("linux") else ((), ())


def _scouted(rehearse: Rehearsal) -> tuple[Ranges, Ranges]:
    """The pages (address, length in bytes) that a forked process copies while it rehearses, and in the second half."""
    ours, theirs = os.pipe()
    pid = os.fork()
    if pid == 0:
        try:
            os.close(ours)
            _scout(theirs, rehearse)
        finally:
            os._exit(0)
    os.close(theirs)
    with open(ours, "rb") as pipe:
        data = pipe.read()
    with contextlib.suppress(ChildProcessError):
        os.waitpid(pid, 0)
    numbers = array.array("Q")
    numbers.frombytes(data[: len(data) // 8 * 8])
    first = numbers[0] if numbers else 0
    return _ranges(numbers[1 : 1 + first]), _ranges(numbers[1 + first :])


def _scout(pipe: int, rehearse: Rehearsal) -> None:
    with open("/proc/self/maps", encoding="utf-8") as maps, open("/proc/self/pagemap", "rb", buffering=0) as pagemap:
        areas = [_area(line) for line in maps if _writable(line)]
        halves: list[array.array[int]] = []
        rehearse(lambda: halves.append(_copied(areas, pagemap)))
        halves.append(_copied(areas, pagemap))
    before = set(halves[0])
    later = array.array("Q", (page for page in halves[-1] if page not in before))
    with open(pipe, "wb") as out:
        out.write(array.array("Q", [len(halves[-1])]).tobytes() + halves[-1].tobytes() + later.tobytes())


def _copied(areas: list[tuple[int, int]], pagemap: Any) -> "array.array[int]":
    """The addresses of the pages that this process alone has."""
    found = array.array("Q")
    for start, end in areas:
        pagemap.seek(start // _PAGE * 8)
        flags = array.array("Q")
        flags.frombytes(pagemap.read((end - start) // _PAGE * 8))
        found.extend(start + i * _PAGE for i, flag in enumerate(flags) if flag & _EXCLUSIVE == _EXCLUSIVE)
    return found


def _ranges(addresses: "array.array[int]") -> Ranges:
    found: Ranges = []
    for address in addresses:
        if found and sum(found[-1]) == address:
            found[-1] = (found[-1][0], found[-1][1] + _PAGE)
        else:
            found.append((address, _PAGE))
    return found


def _writable(line: str) -> bool:
    rights = line.split(None, 2)[1]
    return rights.startswith("rw") and rights.endswith("p") and "[stack]" not in line


def _area(line: str) -> tuple[int, int]:
    start, _, end = line.split(None, 1)[0].partition("-")
    return int(start, 16), int(end, 16)


def populate(ranges: Ranges) -> None:
    """Copy these pages now; where the kernel cannot, they are copied when they are written on, as ever."""
    if not ranges:
        return
    with contextlib.suppress(OSError, AttributeError):
        madvise = ctypes.CDLL(None).madvise
        madvise.argtypes = (ctypes.c_void_p, ctypes.c_size_t, ctypes.c_int)
        for address, length in ranges:
            madvise(address, length, _POPULATE_WRITE)
