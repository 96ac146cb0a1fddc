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


def run_in_carla(text: str, file: str | os.PathLike[str] | None, *, address: str, seed: int, seconds: float,
                 model: str | None = None, scenario: str | None = None) -> int:  # fmt: skip
    """Run the program in CARLA with Scenic's command; returns its exit status. Raises CarlaUnavailable."""
    host, _, port = address.partition(":")
    if importlib.util.find_spec("carla") is None or not _installed():
        raise CarlaUnavailable(
            "CARLA needs its Python package: pip install 'c2s[carla]', or run without --simulator carla."
        )
    number = int(port) if port.isdigit() else 2000
    try:
        socket.create_connection((host, number), timeout=5).close()
    except OSError as error:
        raise CarlaUnavailable(
            f"No CARLA server answers at {host}:{number} ({error}): start it, or say --address."
        ) from None
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


def _installed() -> bool:
    try:
        version("carla")
    except PackageNotFoundError:
        return False
    return True
