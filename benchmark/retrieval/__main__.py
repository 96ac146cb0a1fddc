"""`python -m c2s_bench.retrieval`: the retrieval benchmark, with the large generated shelf."""

import os

os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")  # as in the worker

from c2s_bench.retrieval.run import main  # noqa: E402

main()
