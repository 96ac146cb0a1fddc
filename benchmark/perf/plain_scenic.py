"""Compile and sample programs with Scenic as it is installed: a JSON line for each. Nothing of c2s is imported.

`PYTHON plain_scenic.py SEED ITERATIONS FILE...`. Each program has a process of its own, forked once Scenic is imported.
"""

import json
import os
import random
import resource
import sys
import warnings

import numpy
from scenic.syntax.translator import scenarioFromFile

SECONDS = 120  # of CPU time, a program
warnings.simplefilter("ignore")


def verdict(file: str, seed: int, iterations: int) -> dict:
    """What becomes of a program: the stage that failed and why, or its scene."""
    stage = "compile"
    try:
        random.seed(seed)
        numpy.random.seed(seed)
        scenario = scenarioFromFile(file, mode2D=True)
        stage = "sample"
        random.seed(seed)
        numpy.random.seed(seed)
        scene, tries = scenario.generate(maxIterations=iterations)
    except Exception as error:
        return {"stage": stage, "error": f"{type(error).__name__}: {error}"[:300]}
    places = [(float(o.position.x), float(o.position.y), float(o.heading)) for o in scene.objects]
    return {"stage": "", "iterations": tries, "scene": places}


def main() -> None:
    """Fork for each file, and say what became of it."""
    seed, iterations, files = int(sys.argv[1]), int(sys.argv[2]), sys.argv[3:]
    for file in files:
        sys.stdout.flush()
        pid = os.fork()
        if pid == 0:
            resource.setrlimit(resource.RLIMIT_CPU, (SECONDS, SECONDS))
            out = os.dup(1)
            os.dup2(os.open(os.devnull, os.O_WRONLY), 1)
            answer = {"file": file, **verdict(file, seed, iterations)}
            os.write(out, json.dumps(answer).encode() + b"\n")
            os._exit(0)
        _, status = os.waitpid(pid, 0)
        if status:
            print(json.dumps({"file": file, "stage": "compile", "error": f"ended with status {status}"}))


if __name__ == "__main__":
    main()
