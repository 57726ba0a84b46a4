# make demo: derive, generate, compile and run the two-link arm. make paper: the paper's Section 7 run again, with its
# figures and a report. make test: the whole test suite.
# All make .venv on first use; nothing but Python 3.11, gcc, make and git is needed.
PYTHON ?= python3.11
VENV = .venv
BIN = $(VENV)/bin
READY = $(VENV)/.ready
WORKERS ?= 2
export PYTHONDONTWRITEBYTECODE = 1
# Two workers share the cores: threads of the linear algebra would only get into each other's way.
export OMP_NUM_THREADS = 1
export OPENBLAS_NUM_THREADS = 1

demo: $(READY)
	$(BIN)/python examples/demo.py

paper: $(READY)
	$(BIN)/python examples/ella_paper.py

test: $(READY)
	$(BIN)/python -m pytest -n $(WORKERS) -q -p no:cacheprovider $(ARGS)

lint: $(READY)
	$(BIN)/ruff check --no-cache screwgen tests examples bench

bench: $(READY)
	$(BIN)/python bench/bench.py

# Regenerate the committed output of the examples.
generated: $(READY)
	$(BIN)/python examples/regenerate.py

$(READY): pyproject.toml constraints.txt
	@echo "making $(VENV), once: about a minute"
	$(PYTHON) -m venv $(VENV)
	$(BIN)/python -m pip install --quiet --disable-pip-version-check --constraint constraints.txt --editable '.[test]'
	touch $@

clean:
	rm -rf $(VENV) build

.PHONY: demo paper test lint bench generated clean
