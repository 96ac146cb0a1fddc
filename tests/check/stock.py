"""Compile and sample programs with Scenic as it is: prints a JSON line for each (run in a process of its own)."""

import hashlib
import json
import random
import sys
from pathlib import Path

sys.path.insert(0, sys.argv[1])

import ast  # noqa: E402

import numpy  # noqa: E402
from scenic.syntax.compiler import compileScenicAST  # noqa: E402
from scenic.syntax.parser import parse_string  # noqa: E402
from scenic.syntax.translator import scenarioFromFile  # noqa: E402

SEED = 3
for name in sys.argv[2:]:
    random.seed(SEED)
    numpy.random.seed(SEED)
    result = {"name": Path(name).stem}
    try:
        tree, _ = compileScenicAST(parse_string(Path(name).read_text(), "exec", filename=name), filename=name)
        result["hash"] = hashlib.blake2b(ast.dump(tree).encode(), digest_size=4).hexdigest()
        scenario = scenarioFromFile(name, mode2D=True)
        random.seed(SEED)
        numpy.random.seed(SEED)
        scene, iterations = scenario.generate(maxIterations=300)
        result["scene"] = [(o.position.x, o.position.y, o.heading) for o in scene.objects]
        result["iterations"] = iterations
    except Exception as error:
        result["error"] = f"{type(error).__name__}: {error}"
    print(json.dumps(result), flush=True)
