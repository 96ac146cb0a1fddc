"""A worker process of the benchmark: a task a line on stdin, its outcome a line on stdout."""

import json
import os
import sys
from dataclasses import asdict

from c2s_bench.host import EngineHost
from c2s_bench.tasks import Task

READY = "ready\n"


def main() -> None:
    answers = os.fdopen(os.dup(1), "w", encoding="utf-8")
    os.dup2(2, 1)  # whatever libraries print must not mix with the answers
    host = EngineHost(sys.argv[1])
    answers.write(READY)
    answers.flush()
    for line in sys.stdin:
        outcome = host.run(Task.from_dict(json.loads(line)))
        answers.write(json.dumps(asdict(outcome)) + "\n")
        answers.flush()
    host.close()


if __name__ == "__main__":
    main()
