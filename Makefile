# make demo: derive, generate, compile and run the two-link arm. make paper: the paper's Section 7 run again, with its
# figures and a report. make test: the tests that try every feature. make test-all: all that CI runs.
# make examples: every example and guide, in short form. make test-long: the rest of the sweeps.
# All make .venv on first use, with the packages that the program needs; those of the tests come when tests are asked for.
# Nothing but Python 3.11, gcc, make and git is needed.
PYTHON ?= python3.11
VENV = .venv
BIN = $(VENV)/bin
READY = $(VENV)/.ready
TESTS = $(VENV)/.tests
BENCH = .venv-bench
MINIMA = .venv-minima
ROBOTS = $(VENV)/.robots
WORKERS ?= 2
# Puts packages into the environment $(1): by pip, or by uv where UV gives its command, in a sixth of the time.
# Neither compiles Python that nothing may import: what a program imports it compiles, once.
install = $(if $(UV),VIRTUAL_ENV=$(1) $(UV) pip install,$(1)/bin/python -m pip --disable-pip-version-check install --no-compile) --quiet
QUIET = -q -p no:cacheprovider
# Compiled Python is kept, but not beside its sources. Without it each process compiles sympy again, for seconds.
unexport PYTHONDONTWRITEBYTECODE
export PYTHONPYCACHEPREFIX = $(CURDIR)/$(VENV)/pycache
# Programs that tests start call make themselves: flags such as --jobs are not theirs.
unexport MAKEFLAGS
# Two workers share the cores: threads of the linear algebra would only get into each other's way.
export OMP_NUM_THREADS = 1
export OPENBLAS_NUM_THREADS = 1

demo: $(READY)
	$(BIN)/python examples/demo.py

paper: $(READY)
	$(BIN)/python examples/ella_paper.py

# Model-predictive control of ELLA in closed loop against the generated C, beside PD: build/mpc.
mpc: $(READY)
	$(BIN)/python examples/mpc_ella.py

# acados from PyPI for examples/nmpc_acados.py, into build/acados.
acados: $(READY)
	$(BIN)/python examples/with_acados/install.py

# Two tasks in real time with acados, beside IPOPT: build/nmpc_acados. Some minutes.
nmpc-acados: acados
	$(BIN)/python examples/nmpc_acados.py

test: $(TESTS)
	$(BIN)/python -m pytest -n $(WORKERS) --dist worksteal $(QUIET) --short $(ARGS)

# All that CI runs: every case, also every example and guide, the sweeps and the analysers over generated C.
test-all: $(TESTS)
	$(BIN)/python -m pytest -n $(WORKERS) --dist worksteal $(QUIET) -m 'not long' $(ARGS)

# The examples in their short forms with their assertions, and every block of the guides; what they compile is not
# optimised.
examples: $(TESTS)
	$(BIN)/python -m pytest -n $(WORKERS) --dist worksteal $(QUIET) -m 'examples and not long' $(ARGS)

# Every URDF of example-robot-data against Pinocchio. The package, 130 MB to load, is an extra of its own.
robots: $(ROBOTS)
	$(BIN)/python -m pytest -n $(WORKERS) --dist worksteal $(QUIET) -m examples tests/test_urdf_robots.py $(ARGS)

# What both leave out: the rest of the sweeps over random robots, layouts, bindings, compilers, bases and numbers of
# modes; documents of more robots; more mutants of robot files; ten thousand steps of the filter and a million of ELLA;
# the short form of `make firmware`. About half an hour.
test-long: $(TESTS)
	$(BIN)/python -m pytest -n $(WORKERS) --dist worksteal $(QUIET) -m long $(ARGS)

# The guides: runs every block of them, takes their pictures to docs/pictures, builds build/docs. What the examples draw takes some minutes, once.
docs: $(TESTS) build/bode_ella.png build/ekf_ella.png build/bracket/bracket.png build/mpc/report.html build/ella_paper/report.html build/nmpc_acados/results.json build/viewer/viewer.png
	$(BIN)/python docs/tools/pages.py build/guides
	$(BIN)/python docs/tools/pictures.py
	$(BIN)/mkdocs build --quiet
	@echo "build/docs/index.html"

build/bode_ella.png: examples/bode_ella.py | $(TESTS)
	$(BIN)/python $<

build/ekf_ella.png: examples/ekf_ella.py | $(READY)
	$(BIN)/python $<

build/bracket/bracket.png: examples/bracket.py | $(TESTS)
	$(BIN)/python $<

build/viewer/viewer.png: examples/view_ella.py examples/demo.py $(wildcard templates/view/*) | $(READY)
	$(BIN)/python $<

build/mpc/report.html: examples/mpc_ella.py $(wildcard examples/mpc/*.py) | $(READY)
	$(BIN)/python $<

build/nmpc_acados/results.json: examples/nmpc_acados.py $(wildcard examples/with_acados/*.py) | $(READY)
	$(BIN)/python examples/with_acados/install.py
	$(BIN)/python $<

build/ella_paper/report.html: examples/ella_paper.py $(wildcard examples/ella/*.py) | $(READY)
	$(BIN)/python $<

# The lowest versions that pyproject.toml allows, in an environment of their own: a round of all commands.
minima: $(MINIMA)/.ready
	$(MINIMA)/bin/python tests/minima.py

# Style and types of the Python.
style: $(TESTS)
	$(BIN)/ruff check --no-cache screwgen tests examples bench firmware docs
	$(BIN)/mypy

# Style, types, and analysers, sanitizers and valgrind over the C of a small robot.
lint: style
	$(BIN)/python -m pytest -n $(WORKERS) $(QUIET) -m 'analysis and not long'

# The generated C against what else computes the same; the other tools live in an environment of their own.
bench: $(BENCH)/.ready
	$(BENCH)/bin/python bench/bench.py $(ARGS)

# The same work with Pinocchio, MuJoCo, SoRoMoX, PyElastica, Exudyn and acados. Some six minutes for the first time.
peers: $(BENCH)/.ready acados
	$(BENCH)/bin/python bench/peers.py $(ARGS)

# How a step and its derivatives grow with a chain of 8 to 64 flexible links. Some five minutes.
growing: $(BENCH)/.ready
	$(BENCH)/bin/python bench/growing.py $(ARGS)

# ELLA's modes under PD, a beam that is spun up, a pendulum and the rod of a slider-crank against Exudyn's geometrically
# exact beams. Some minutes.
exact-beams: $(BENCH)/.ready
	$(BENCH)/bin/python bench/exact_beams.py $(ARGS)
	$(BENCH)/bin/python bench/exact_swings.py
	$(BENCH)/bin/python bench/exact_slider_crank.py

# Which basis, how many modes: errors against finite elements, and operations. Some minutes.
mode-table: $(TESTS)
	$(BIN)/python tests/mode_table.py $(ARGS)

# What ELLA costs on a Cortex-M4F, a Cortex-M7 and a RISC-V: cross-compiled, run under QEMU, held against the budgets.
firmware: $(READY)
	$(BIN)/python firmware/firmware.py --workers $(WORKERS) $(ARGS)
	$(BIN)/python firmware/estimate.py
	$(BIN)/python firmware/payload.py $(filter --record,$(ARGS))
	$(BIN)/python firmware/slopes.py $(filter --record,$(ARGS))
	$(BIN)/python firmware/predictive.py $(filter --record,$(ARGS))
	$(BIN)/python firmware/motions.py $(filter --record,$(ARGS))

# Every analyser over the C of three robots in all layouts and precisions: gcc -fanalyzer, clang-tidy, cppcheck with its
# MISRA addon, sanitizers, valgrind. Some minutes.
analyse-c: $(TESTS)
	$(BIN)/python tests/analyse_c.py

# Ten million steps of ELLA: what drifts. Some minutes.
long-run: $(TESTS)
	$(BIN)/python tests/long_run.py

# Three hundred random robots with everything at once, of which every eighth is compiled, against the oracle. An hour.
mixed-arms: $(TESTS)
	$(BIN)/python tests/mixed_arms.py 0 300

# Regenerate the committed output of the examples, and the tables of the documents.
generated: $(TESTS)
	$(BIN)/python examples/regenerate.py
	$(BIN)/python docs/tools/functions_page.py
	$(BIN)/python docs/tools/robot_page.py
	$(BIN)/python docs/tools/features_page.py

$(READY): pyproject.toml constraints.txt
	@echo "making $(VENV), once: about half a minute"
	$(PYTHON) -m venv $(VENV)
	$(call install,$(VENV)) --constraint constraints.txt --editable .
	touch $@

$(TESTS): $(READY)
	@echo "adding the packages of the tests to $(VENV), once: about a minute"
	$(call install,$(VENV)) --constraint constraints.txt --editable '.[test]'
	touch $@

$(ROBOTS): $(TESTS)
	$(call install,$(VENV)) --constraint constraints.txt --editable '.[robots]'
	touch $@

$(BENCH)/.ready: pyproject.toml constraints.txt bench/requirements.txt
	@echo "making $(BENCH), once: about a minute"
	$(PYTHON) -m venv $(BENCH)
	$(call install,$(BENCH)) --constraint constraints.txt --editable '.[test]'
	@grep -v '^#' bench/requirements.txt | while read -r package; do \
	    $(call install,$(BENCH)) --constraint constraints.txt "$$package" || \
	    echo "bench: $$package could not be installed; the rows that need it will be missing"; \
	done
	touch $@

$(MINIMA)/.ready: pyproject.toml tests/minima.py
	@echo "making $(MINIMA), once: about a minute"
	$(PYTHON) -m venv $(MINIMA)
	$(PYTHON) tests/minima.py --list >$(MINIMA)/minima.txt
	$(call install,$(MINIMA)) --constraint $(MINIMA)/minima.txt --editable .
	touch $@

clean:
	rm -rf $(VENV) $(BENCH) $(MINIMA) build

.PHONY: demo paper mpc acados nmpc-acados docs test test-all examples robots test-long style lint bench peers growing exact-beams mode-table analyse-c long-run mixed-arms firmware generated minima clean
