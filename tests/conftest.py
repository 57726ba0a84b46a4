"""What all tests share: outside tools, the summary of what they kept from running, and hypothesis' manners."""

import ctypes
import gc
import importlib
import os
import shutil
import signal
import sys
import tempfile
import threading
from collections import Counter
from contextlib import suppress
from pathlib import Path
from types import ModuleType
from typing import NoReturn

import hypothesis.configuration
import pytest
from hypothesis import settings

from screwgen.backends.numpy import numeric

MISSING = "tool not installed: "
NAMED = os.environ.get("CC")
GROWTH = 1_500_000_000
"""Bytes by which a process of tests grows until it forgets what it has derived."""
limit = [2 * GROWTH]
frozen: list[bool] = []
"""Whether a file's tests have left what is no longer looked through, and may be of no use now."""
STATM = Path("/proc/self/statm")
KEEPING = tuple(str(Path(__file__).resolve().parents[1] / name) + os.sep for name in ("screwgen", "tests"))
"""Folders of the modules that keep what they have derived."""
UNOPTIMISED = os.path.join(os.path.dirname(__file__), "tools", "cc")
SLOWEST = "ella_paper guides mpc examples bench static_analysis firmware generated c_code latex_pages cli_paper".split()

# The same examples on every machine and every day, and nothing written into the checkout.
hypothesis.configuration.set_hypothesis_home_dir(os.path.join(tempfile.gettempdir(), "screwgen-hypothesis"))
settings.register_profile("screwgen", derandomize=True, deadline=None, database=None, print_blob=False)
settings.load_profile("screwgen")
os.environ.setdefault("CFLAGS", "-O0")  # of generated folders' own Makefiles
# of JAX's compiler, which takes a quarter less time over what runs once
os.environ.setdefault("XLA_FLAGS", "--xla_backend_optimization_level=0 --xla_cpu_parallel_codegen_split_count=1")
os.environ.setdefault("SYMPY_CACHE_SIZE", "20000")  # a robot needs more than sympy's thousand entries
os.environ.setdefault("SCREWGEN_CACHE", os.path.join(tempfile.gettempdir(), f"screwgen-cache-{os.getuid()}"))


@pytest.fixture(scope="session", autouse=True)
def _temporary_folder(worker_id):
    """What tests, and libraries that they call, put into the system's temporary folder is removed when all is done."""
    before, tempfile.tempdir = os.environ.get("TMPDIR"), tempfile.mkdtemp(prefix=f"screwgen-{worker_id}-")
    os.environ["TMPDIR"] = tempfile.tempdir
    yield
    shutil.rmtree(tempfile.tempdir, ignore_errors=True)
    tempfile.tempdir = None
    os.environ.pop("TMPDIR") if before is None else os.environ.update(TMPDIR=before)


def pytest_configure():
    """The process of the tests.

    Derived robots are kept for all tests: looking through them for garbage again and again took a quarter of the time.
    A job in the background of a shell ignores Ctrl-C, and so would all that it starts.
    """
    gc.set_threshold(100_000, 50, 50)
    _compile_quickly()
    if threading.current_thread() is threading.main_thread():
        signal.signal(signal.SIGINT, signal.default_int_handler)


def _compile_quickly():
    """Libraries of double precision that nobody optimises are compiled by tcc where it is installed.

    It takes a twentieth of gcc's time. It folds constants with more digits, so tests that compare bits, or round to
    single precision, give further flags. Folders, batches and FMUs are built by cc, with their own flags and warnings.
    """
    from screwgen.runtime import compiled, estimator, library, mpc

    tcc = shutil.which("tcc")

    def load(files, flags, compiler=None, cache=True, asked=""):
        quick = list(flags) == ["-O0"] and os.environ.get("CC", "cc") == "cc"
        return library.load(files, flags, compiler or (tcc if quick else None), cache, asked)

    for module in (compiled, estimator, mpc) if tcc else ():
        module.load = load


@pytest.fixture(autouse=True)
def _bounded():
    """A process of tests that has grown large forgets what is derived: thousands of robots would fill the machine."""
    yield
    if resident() < limit[0]:
        return
    kept = [module for module in [*sys.modules.values()] if (getattr(module, "__file__", "") or "").startswith(KEEPING)]
    for value in [value for module in kept for value in vars(module).values() if hasattr(value, "cache_clear")]:
        value.cache_clear()
    numeric._COMPILED.clear()
    if frozen:
        gc.unfreeze()
    frozen.clear()
    gc.collect()
    gc.freeze()
    with suppress(AttributeError):  # of C libraries other than GNU's
        ctypes.CDLL(None).malloc_trim(0)  # else what is free again need not go back to the system
    limit[0] = max(resident() + GROWTH, 2 * GROWTH)


def resident() -> int:
    """Bytes of memory that this process has; 0 on systems that do not say."""
    return int(STATM.read_text().split()[1]) * os.sysconf("SC_PAGE_SIZE") if STATM.exists() else 0


@pytest.fixture(scope="module", autouse=True)
def _frozen():
    """What the tests of a file leave is kept for all tests: no later search for garbage looks through it again."""
    yield
    gc.collect()
    gc.freeze()
    frozen.append(True)


@pytest.fixture(autouse=True)
def _quick_models(request, monkeypatch):
    """What tests and the commands that they call compile is not optimised, unless they give flags.

    Optimising takes ten times as long as compiling. Programs that tests start have the product's flags.
    """
    from screwgen.robot_model import RobotModel

    if "examples" not in request.keywords:
        monkeypatch.setattr(RobotModel, "compiler_flags", ("-O0",))


@pytest.hookimpl(tryfirst=True)
def pytest_runtest_setup(item):
    """Examples and guides keep the product's flags, to which `tests/tools/cc` adds -O0, unless CC names a compiler."""
    os.environ["CC"] = NAMED or (UNOPTIMISED if "examples" in item.keywords else "cc")


def swept(cases, *kept) -> list:
    """The cases of a sweep: `make test` takes those to be kept, `make test-long` the others."""
    return [case if case in kept else pytest.param(case, marks=pytest.mark.long) for case in cases]


def pytest_addoption(parser):
    said = "leave out what tests/thorough.txt says: further cases of functions that take long, and what is slow"
    parser.addoption("--short", action="store_true", help=said)


@pytest.hookimpl(trylast=True)
def pytest_collection_modifyitems(config, items):
    """The slowest files first: with several workers, none of them is begun when all the rest is done."""
    items.sort(key=lambda item: item.path.stem.removeprefix("test_") not in SLOWEST)
    _row_by_row(items)
    if config.getoption("--short"):
        lines = (Path(__file__).parent / "thorough.txt").read_text(encoding="utf-8").splitlines()
        left_out = _left_out(items, dict(reversed(line.split(" ", 1)) for line in lines))
        config.hook.pytest_deselected(items=[item for item in items if item in left_out])
        items[:] = [item for item in items if item not in left_out]


def _row_by_row(items) -> None:
    """A robot of the matrix is derived and compiled once for all its checks, those that take long among them."""
    places = [k for k, item in enumerate(items) if "test_every_feature_meets_every" in item.nodeid]
    ordered = sorted((items[k] for k in places), key=lambda item: item.callspec.params["row"])
    for k, item in zip(places, ordered, strict=True):
        items[k] = item


def _left_out(items, said) -> set:
    """The cases of functions, `tests/test_stops.py::test_a_stop`, that are left out: all but the `first`, or all."""
    cases = {name: [] for name in said}
    for item in items:
        name = item.nodeid.partition("[")[0]
        if name in cases:
            cases[name].append(item)
    return {item for name, own in cases.items() for item in own[said[name] == "first" :]}


def require_tool(name: str) -> str:
    """The path of an outside tool. Where it is missing the test is skipped, or fails if REQUIRE_TOOLS=1."""
    path = shutil.which(name)
    if path is None:
        lacking(name)
    return path


def lacking(name: str) -> NoReturn:
    """Skips a test for want of a tool, which may have a reason behind it; fails it if REQUIRE_TOOLS=1."""
    if os.environ.get("REQUIRE_TOOLS") == "1":
        pytest.fail(MISSING + name)
    pytest.skip(MISSING + name, allow_module_level=True)


def package(name: str) -> ModuleType:
    """A package of the extras. Where it is missing the test, or the module that asks, is skipped as `lacking` says."""
    try:
        return importlib.import_module(name)
    except ImportError:
        lacking(name)


def missing_tools(reports) -> Counter:
    """How many tests were skipped for want of which tool; reports of xdist's workers count too."""
    reasons = (r.longrepr[2] for r in reports if isinstance(r.longrepr, tuple))
    return Counter(reason.partition(MISSING)[2] for reason in reasons if MISSING in reason)


def pytest_terminal_summary(terminalreporter):
    for tool, count in sorted(missing_tools(terminalreporter.stats.get("skipped", [])).items()):
        tests = "test" if count == 1 else "tests"
        terminalreporter.write_line(f"could not run for want of a tool: {tool} ({count} {tests})", yellow=True)
