"""Compiled models in threads, in other processes, and under Ctrl-C."""

import pickle
import signal
import sys
import threading
import time
from contextlib import contextmanager

import numpy as np
import pytest
from conftest import require_tool
from helpers import example
from test_compile import state

import screwgen


@pytest.fixture(scope="module")
def ella():
    require_tool("cc")
    return example("ella").compile()


def test_threads_may_share_an_instance(ella):
    """Their calls take turns; each gets its own results."""
    given = [state(ella.model, seed) for seed in range(4)]
    expected = [ella.forward_dynamics(*x)[0] for x in given]
    wrong, before = [], sys.getswitchinterval()

    def work(x, answer):
        wrong.extend(1 for _ in range(3000) if not np.array_equal(ella.forward_dynamics(*x)[0], answer))

    sys.setswitchinterval(1e-6)
    threads = [threading.Thread(target=work, args=pair) for pair in zip(given, expected, strict=True)]
    for t in threads:
        t.start()
    for t in threads:
        t.join()
    sys.setswitchinterval(before)
    assert not wrong


def test_what_was_compiled_can_be_pickled(ella):
    """As executors need it: what was said travels, the rest is made again."""
    given, p = state(ella.model), np.array(ella.model.parameter_values) * 1.1
    heavy = ella.fresh(p)
    model, again = pickle.loads(pickle.dumps((ella.model, heavy)))
    assert again.model is model and model.robot == ella.model.robot
    for a, b in ((again, heavy), (model.compile(), ella)):
        assert np.array_equal(a.forward_dynamics(*given)[0], b.forward_dynamics(*given)[0])


@pytest.mark.parametrize("work", ["step", "rollout", "rollout in threads"])
def test_long_work_can_be_interrupted(ella, work):
    q, v, tau, _ = state(ella.model)
    x0, many = np.tile(np.r_[q, v], (50, 1)), 10**6
    calls = {
        "step": lambda: ella.step(q, v, 0 * tau, None, 1e-5, count=many),
        "rollout": lambda: screwgen.rollout(ella.model, x0, step=1e-6, steps=1000, substeps=1000),
        "rollout in threads": lambda: screwgen.rollout(ella.model, x0, step=1e-6, steps=1000, substeps=1000, threads=2),
    }
    screwgen.rollout(ella.model, x0, step=1e-5, steps=1)
    clock = time.perf_counter()
    with interrupted(0.2), pytest.raises(KeyboardInterrupt):
        calls[work]()
    assert time.perf_counter() - clock < 2.0


@contextmanager
def interrupted(seconds):
    """Ctrl-C in so many seconds."""
    before = signal.signal(signal.SIGALRM, signal.default_int_handler)
    signal.setitimer(signal.ITIMER_REAL, seconds)
    try:
        yield
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0)
        signal.signal(signal.SIGALRM, before)
