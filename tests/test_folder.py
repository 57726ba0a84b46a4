"""A generated folder is written as a whole or not at all, and nothing foreign is touched."""

import os
import signal
import sys

import pytest

import screwgen.folder as folder
from screwgen.errors import UsageError
from screwgen.unfinished import claimed_folder

FILES = {"c/a.c": b"int a;\n", "c/sub/b.c": b"int b;\n"}
NEW = {"c/new.c": b"int n;\n"}
KEPT = {"latex/x.tex": b"x"}


def test_writes_everything_and_a_manifest(tmp_path):
    names = folder.write_folder(tmp_path / "new" / "out", FILES, ("c",))
    assert names == [folder.MANIFEST, *sorted(FILES)]
    assert {n: (tmp_path / "new" / "out" / n).read_bytes() for n in FILES} == FILES
    assert [p.name for p in (tmp_path / "new").iterdir()] == ["out"]


def test_replaces_only_what_it_is_asked_to(tmp_path):
    out = tmp_path / "out"
    folder.write_folder(out, FILES | {"latex/x.tex": b"x"}, ("c", "latex"))
    folder.write_folder(out, {"c/new.c": b"int n;\n"}, ("c",))
    assert sorted(p.relative_to(out).as_posix() for p in out.rglob("*") if p.is_file()) == [
        folder.MANIFEST,
        "c/new.c",
        "latex/x.tex",
    ]


def held(out) -> dict[str, bytes]:
    """All that is in a folder but the manifest."""
    files = {p.relative_to(out).as_posix(): p.read_bytes() for p in out.rglob("*") if p.is_file()}
    return {name: data for name, data in files.items() if name != folder.MANIFEST}


@pytest.mark.parametrize("make", [os.mkdir, os.mkfifo, lambda path: os.symlink(".", path)], ids=["dir", "fifo", "link"])
@pytest.mark.parametrize("name", ["mine", "c/mine"])
def test_refuses_what_is_no_file(tmp_path, make, name):
    """An empty folder, a link to a folder: nothing of a user's is taken away."""
    out = tmp_path / "out"
    folder.write_folder(out, FILES, ("c",))
    make(out / name)
    with pytest.raises(UsageError, match=f"holds '{name}', which screwgen did not write"):
        folder.write_folder(out, NEW, ("c",))
    assert os.path.lexists(out / name) and held(out) == FILES


@pytest.mark.parametrize("name", ["c/a.c", folder.MANIFEST])
def test_a_pipe_in_the_place_of_a_file_is_refused(tmp_path, name):
    out = tmp_path / "out"
    folder.write_folder(out, FILES, ("c",))
    (out / name).unlink()
    os.mkfifo(out / name)
    with pytest.raises(UsageError, match=r"was changed|did not write"):
        folder.write_folder(out, NEW, ("c",))


@pytest.mark.parametrize("name", ["notes.txt", "c/main.o", "other/deep/file"])
def test_refuses_foreign_files(tmp_path, name):
    out = tmp_path / "out"
    folder.write_folder(out, FILES, ("c",))
    (out / name).parent.mkdir(parents=True, exist_ok=True)
    (out / name).write_text("mine")
    with pytest.raises(UsageError, match="did not write"):
        folder.write_folder(out, {"c/new.c": b""}, ("c",))
    assert (out / name).read_text() == "mine"
    assert (out / "c/a.c").read_bytes() == FILES["c/a.c"]


def test_refuses_a_changed_file(tmp_path):
    out = tmp_path / "out"
    folder.write_folder(out, FILES, ("c",))
    (out / "c/a.c").write_text("edited")
    with pytest.raises(UsageError, match="was changed"):
        folder.write_folder(out, FILES, ("c",))
    assert (out / "c/a.c").read_text() == "edited"


def test_refuses_what_is_no_folder(tmp_path):
    (tmp_path / "file").write_text("x")
    with pytest.raises(UsageError, match="not a folder"):
        folder.write_folder(tmp_path / "file", FILES, ("c",))
    (tmp_path / "link").symlink_to(tmp_path)
    with pytest.raises(UsageError, match="not a folder"):
        folder.write_folder(tmp_path / "link", FILES, ("c",))


def test_a_failure_leaves_the_old_folder(tmp_path, monkeypatch):
    out = tmp_path / "out"
    folder.write_folder(out, FILES, ("c",))

    def fail(*_):
        raise OSError(28, "No space left on device")

    monkeypatch.setattr(folder, "_fill", fail)
    with pytest.raises(folder.ScrewgenError, match="No space"):
        folder.write_folder(out, {"c/new.c": b""}, ("c",))
    assert (out / "c/a.c").read_bytes() == FILES["c/a.c"]
    assert [p.name for p in tmp_path.iterdir()] == ["out"]


def without_exchange(*_):
    raise OSError(22, "Invalid argument")


def test_a_failure_between_two_renamings_brings_the_old_folder_back(tmp_path, monkeypatch):
    out = tmp_path / "out"
    folder.write_folder(out, FILES, ("c",))
    real, calls = os.rename, []

    def second_fails(source, target):
        calls.append(source)
        if len(calls) == 2:
            raise OSError(5, "Input/output error")
        return real(source, target)

    monkeypatch.setattr(folder, "_exchange", without_exchange)
    monkeypatch.setattr(folder.os, "rename", second_fails)
    with pytest.raises(folder.ScrewgenError, match="Input/output"):
        folder.write_folder(out, NEW, ("c",))
    assert held(out) == FILES and os.listdir(tmp_path) == ["out"]


def killed(out, number: int, exchange: bool, calls: int) -> int:
    """How a process ends that replaces FILES in `out` by NEW and gets a signal behind so many changes of names."""
    child = os.fork()
    if child:
        return os.waitstatus_to_exitcode(os.waitpid(child, 0)[1])
    try:
        signal.signal(signal.SIGINT, signal.default_int_handler)
        signal.signal(signal.SIGTERM, lambda *_: sys.exit(143))
        done = []
        for place, name in ((folder.os, "rename"), (folder, "_exchange" if exchange else "_swap")):
            setattr(place, name, ending(getattr(place, name), number, done, calls))
        folder._exchange = folder._exchange if exchange else without_exchange
        folder.write_folder(out, NEW, ("c",))
        os._exit(0)
    except BaseException as error:
        os._exit(130 if isinstance(error, KeyboardInterrupt) else 143 if isinstance(error, SystemExit) else 1)


def ending(real, number: int, done: list, calls: int):
    """`real`, at whose beginning or end the signal comes when so many of its kind were counted."""

    def counted(*arguments):
        count(done, calls, number)
        result = real(*arguments)
        count(done, calls, number)
        return result

    return counted


def count(done: list, calls: int, number: int) -> None:
    done.append(1)
    if len(done) == calls:
        os.kill(os.getpid(), number)


@pytest.mark.parametrize("exchange", [True, False], ids=["exchange", "renamings"])
@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM, signal.SIGKILL])
def test_a_kill_at_any_moment_loses_nothing(tmp_path, number, exchange):
    """There is the old folder or the new one, whole; if not, the next call brings the old one back first."""
    for calls in range(1, 3 if exchange else 7):
        place = tmp_path / f"kill{calls}"
        out = place / "out"
        folder.write_folder(out, FILES | KEPT, ("c", "latex"))
        status = killed(out, number, exchange, calls)
        assert status == {signal.SIGINT: 130, signal.SIGTERM: 143, signal.SIGKILL: -9}[number]
        if exchange or number != signal.SIGKILL:
            assert held(out) in (FILES | KEPT, NEW | KEPT)
            assert number == signal.SIGKILL or os.listdir(place) == ["out"]
        folder.write_folder(out, NEW, ("c",))
        assert held(out) == NEW | KEPT


def test_an_interruption_behind_the_exchange_says_so(tmp_path, monkeypatch):
    out, real = tmp_path / "out", folder._swap
    folder.write_folder(out, FILES, ("c",))

    def interrupted(*arguments):
        real(*arguments)
        raise KeyboardInterrupt

    monkeypatch.setattr(folder, "_swap", interrupted)
    with pytest.raises(KeyboardInterrupt, match="was written already"):
        folder.write_folder(out, NEW, ("c",))
    assert held(out) == NEW and os.listdir(tmp_path) == ["out"]


def test_what_a_killed_process_never_finished_goes_with_the_next_call(tmp_path):
    """And what one that lives is writing stays."""
    killed, writing = (tmp_path / f".out-new-{letter}0000000" for letter in "ab")
    killed.mkdir()
    (killed / "model.c").touch()
    with claimed_folder(writing):
        folder.write_folder(tmp_path / "out", FILES, ("c",))
        assert sorted(os.listdir(tmp_path)) == [writing.name, "out"]


def test_the_folder_keeps_its_mode(tmp_path):
    out = tmp_path / "out"
    out.mkdir(mode=0o700)
    for _ in range(2):
        folder.write_folder(out, FILES, ("c",))
        assert out.stat().st_mode & 0o777 == 0o700


def test_refuses_the_folder_of_work_and_those_above_it(tmp_path, monkeypatch):
    (tmp_path / "out" / "deep").mkdir(parents=True)
    (tmp_path / "out" / "link").symlink_to(".")
    monkeypatch.chdir(tmp_path / "out" / "deep")
    for name in (".", "..", str(tmp_path), "../link/../deep"):
        with pytest.raises(UsageError, match="current folder"):
            folder.write_folder(name, FILES, ("c",))
