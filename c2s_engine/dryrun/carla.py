"""The same program in CARLA itself, through Scenic's own interface, where package and server are there."""

import importlib.util
import os
import socket
import subprocess
import sys
from importlib.metadata import PackageNotFoundError, version
from pathlib import Path


class CarlaUnavailable(RuntimeError):
    """CARLA cannot be used; the message says what is missing."""


class BadAddress(ValueError):
    """What was given is no address of a server."""


def run_in_carla(text: str, file: str | os.PathLike[str] | None, *, address: str, seed: int, seconds: float,
                 model: str | None = None, scenario: str | None = None) -> int:  # fmt: skip
    """Run the program in CARLA with Scenic's command; returns its exit status. Raises CarlaUnavailable, BadAddress."""
    host, number = server_at(address, "--simulator dry")
    given = Path(file) if file and Path(file).is_file() else None
    script = given or Path.cwd() / ".c2s_run.scenic"
    if given is None:
        script.write_text(text, encoding="utf-8")
    try:
        command = [
            sys.executable,
            "-m",
            "scenic",
            str(script),
            "--simulate",
            "--2d",
            "--count",
            "1",
            "--seed",
            str(seed),
        ]
        command += [
            "--time",
            str(round(seconds / 0.1)),
            "-p",
            "address",
            host,
            "-p",
            "port",
            str(number),
            "-p",
            "render",
            "0",
        ]
        command += ["--model", model] if model else []
        command += ["--scenario", scenario] if scenario else []
        return subprocess.run(command, check=False).returncode
    finally:
        if given is None:
            script.unlink(missing_ok=True)


def server_at(address: str, without: str) -> tuple[str, int]:
    """Host and port of HOST:PORT (port 2000 where none is said), if something listens there and the client package is
    installed; `without`: the option that goes without CARLA. Raises CarlaUnavailable, BadAddress."""
    host, _, port = address.partition(":")
    number = int(port or 2000) if not port or port.isdecimal() else 0
    if not host or not 0 < number < 65536:
        raise BadAddress(f"{address!r} is no address: say HOST:PORT, as in 127.0.0.1:2000.")
    if importlib.util.find_spec("carla") is None or not _installed():
        raise CarlaUnavailable(
            f"CARLA needs its Python package: pip install 'c2s[carla]', or go without CARLA: {without}."
        )
    try:
        socket.create_connection((host, number), timeout=5).close()
    except OSError as error:
        raise CarlaUnavailable(
            f"No CARLA server answers at {host}:{number} ({error}): "
            f"start it, say --address, or go without CARLA: {without}."
        ) from None
    return host, number


def _installed() -> bool:
    try:
        version("carla")
    except PackageNotFoundError:
        return False
    return True
