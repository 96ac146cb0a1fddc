"""`python -m c2s_bench.retrieval`: the retrieval benchmark, with the large generated shelf."""

from c2s_bench.retrieval.run import main

main()
