# `make run` and `make test` set up everything they need; the other targets build on the same environment.
PYTHON ?= python3
VENV ?= .venv
TORCH_INDEX ?=
BIN = $(VENV)/bin
STAMP = $(VENV)/.installed
SAMPLE = "At night in the rain the ego follows a truck on a straight road at 50 km/h. After five seconds the truck brakes hard, and the ego has to brake as well."

.PHONY: run test test-full nightly lint bench bench-check bench-dryrun bench-interpret bench-retrieval bench-through bench-fresh bench-ui clean

$(VENV)/bin/python:
	$(PYTHON) -m venv $(VENV)

$(STAMP): $(VENV)/bin/python pyproject.toml constraints.txt
	$(BIN)/pip install --quiet --upgrade "pip>=23" "setuptools>=77"
	$(BIN)/pip install --quiet $(if $(TORCH_INDEX),--index-url $(TORCH_INDEX)) torch==2.13.0
	$(BIN)/pip install --quiet -c constraints.txt -e .
	touch $(STAMP)

$(VENV)/.dev: $(STAMP)
	$(BIN)/pip install --quiet -c constraints.txt -e ".[dev]"
	touch $(VENV)/.dev

run: $(STAMP)
	@if [ -t 0 ] && [ -t 1 ]; then $(BIN)/c2s app; else $(BIN)/c2s generate $(SAMPLE); fi

test: $(VENV)/.dev
	$(BIN)/pytest -q -m "not full and not nightly" -n 2 --dist loadfile

test-full: $(VENV)/.dev
	$(BIN)/pytest -q -m "not nightly" -n 2 --dist loadfile

nightly: $(VENV)/.dev
	$(BIN)/pytest -q

lint: $(VENV)/.dev
	$(BIN)/ruff check .
	$(BIN)/lint-imports
	$(BIN)/mypy c2s_engine c2s_tui

bench: $(STAMP)
	$(BIN)/c2s bench --method embedded

bench-check: $(VENV)/.dev
	$(BIN)/python -m c2s_bench.perf.bench_check

bench-interpret: $(STAMP)
	$(BIN)/python -m c2s_bench.interpret

bench-retrieval: $(STAMP)
	$(BIN)/python -m c2s_bench.retrieval

bench-dryrun: $(STAMP)
	$(BIN)/python -m c2s_bench.perf.bench_dryrun

bench-through: $(STAMP)
	$(BIN)/python -m c2s_bench.through --records

bench-fresh: $(STAMP)
	$(BIN)/c2s bench --runs 3 $(foreach file,$(wildcard benchmark/fresh/*.yaml),--records $(file))

bench-ui: $(STAMP)
	$(BIN)/python -m c2s_bench.ui

clean:
	rm -rf $(VENV) build dist *.egg-info
