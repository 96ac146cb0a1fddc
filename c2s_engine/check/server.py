"""The check server: JSON lines in and out, one forked process a check. `python -m c2s_engine.check.server`.

Messages in: {"id", "kind": "check" | "places" | "import" | "expect" | "cancel", "body"}; out: {"id", "ok", "body"}
(none for the last two kinds), once {"ready": true}, and {"lost": true} where no more requests are taken because the
process that holds Scenic is gone. That process is forked before anything else is imported here.
"""

import argparse
import os
import socket
import traceback
from pathlib import Path


def main() -> None:
    """Start the warm process, then the loop that serves the front."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--runner", default=None, help="module:function that runs a sampled scene")
    parser.add_argument("--standins", default=None, help="folder with the stand-ins for carla and verifai")
    options = parser.parse_args()
    ours, theirs = socket.socketpair()
    pid = os.fork()
    if pid == 0:
        ours.close()
        try:
            _root(theirs, options.standins, options.runner)
        except Exception:
            traceback.print_exc()
        finally:
            os._exit(1)
    theirs.close()
    out = os.dup(1)
    os.dup2(2, 1)
    from c2s_engine.check import front

    front.run(ours, out, options.runner)


def _root(control: socket.socket, standins: str | None, runner: str | None) -> None:
    """The process that holds Scenic and forks on demand."""
    from c2s_engine import paths
    from c2s_engine.check import execute, library, warm, zygote

    zygote.die_with_parent()
    null = os.open(os.devnull, os.O_RDWR)
    os.dup2(null, 0)
    os.dup2(2, 1)
    warm.warm(Path(standins) if standins else paths.shipped("standins"), runner)

    def begin() -> None:
        zygote.die_with_parent()
        control.close()

    compiling = library.ahead(begin)
    control.sendall(b'{"warm": true}\n')
    zygote.serve(control, execute.handle, children={compiling})


if __name__ == "__main__":
    main()
