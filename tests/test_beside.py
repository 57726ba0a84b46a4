"""Work beside: a second process does it, with its warnings; where that one fails or is killed, this one does."""

import os
import signal
import threading
import time
import warnings

import pytest
from helpers import arm, link, model_of

from screwgen import beside as besides
from screwgen.beside import beside


@pytest.fixture(autouse=True)
def _two_cores(monkeypatch):
    """A machine that may copy processes, whatever other tests have imported or begun."""
    monkeypatch.setattr(besides, "WITH_THREADS", ())
    monkeypatch.setattr(threading, "active_count", lambda: 1)
    monkeypatch.setattr(os, "sched_getaffinity", lambda _: {0, 1})


def test_a_second_process_does_the_work_with_its_warnings():
    def work():
        warnings.warn("large", UserWarning, stacklevel=2)
        return os.getpid(), b"x" * 10_000_000

    with beside(work) as done, pytest.warns(UserWarning, match="large"):
        process, data = done()
    assert process != os.getpid() and data == b"x" * 10_000_000


@pytest.mark.parametrize("end", ["error", "killed", "no pickle"])
def test_what_the_second_process_cannot_do_this_one_does(end):
    here = os.getpid()

    def work():
        if os.getpid() == here:
            return "here"
        if end == "killed":
            os.kill(os.getpid(), signal.SIGKILL)
        if end == "error":
            raise ValueError
        return lambda: None

    with beside(work) as done:
        assert done() == "here"


def test_an_error_of_the_work_is_raised_here():
    def work():
        raise ValueError("of the work")

    with beside(work) as done, pytest.raises(ValueError, match="of the work"):
        done()


def test_an_error_here_ends_the_second_process():
    begun = time.monotonic()
    with pytest.raises(KeyError), beside(lambda: time.sleep(60)):
        raise KeyError
    assert time.monotonic() - begun < 30
    with pytest.raises(ChildProcessError):
        os.waitpid(-1, os.WNOHANG)


@pytest.mark.parametrize("lacking", ["core", "system", "quiet"])
def test_one_process_does_it_where_there_may_be_no_second(lacking, monkeypatch):
    if lacking == "core":
        monkeypatch.setattr(os, "sched_getaffinity", lambda _: {0})
    if lacking == "system":
        monkeypatch.setattr(besides.sys, "platform", "darwin")
    if lacking == "quiet":
        monkeypatch.setattr(threading, "active_count", lambda: 2)
    with beside(os.getpid) as done:
        assert done() == os.getpid()


def test_documents_are_made_where_no_second_process_may_be(monkeypatch, tmp_path):
    monkeypatch.setattr(os, "sched_getaffinity", lambda _: {0})
    model = model_of(arm(link("boom", axes="z", bodies=[{"at": "tip", "mass": 1.0}])))
    with model.documents_beside():
        model.write(tmp_path, targets=("latex",))
    assert list((tmp_path / "latex").glob("*.tex"))
