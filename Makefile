# make demo: derive, generate, compile and run the two-link arm. make test: the whole test suite.
# Both make .venv on first use; nothing but Python 3.11, gcc, make and git is needed.
PYTHON ?= python3.11
VENV = .venv
BIN = $(VENV)/bin
READY = $(VENV)/.ready
WORKERS ?= 2
export PYTHONDONTWRITEBYTECODE = 1

demo: $(READY)
	$(BIN)/python examples/demo.py

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

.PHONY: demo test lint bench generated clean
