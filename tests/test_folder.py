"""A generated folder is written as a whole or not at all, and nothing foreign is touched."""

import pytest

import screwgen.folder as folder
from screwgen.errors import UsageError

FILES = {"c/a.c": b"int a;\n", "c/sub/b.c": b"int b;\n"}


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


def test_an_interrupt_while_swapping_brings_the_old_folder_back(tmp_path, monkeypatch):
    out = tmp_path / "out"
    folder.write_folder(out, FILES, ("c",))
    real, calls = folder.Path.rename, []

    def second_fails(self, target):
        calls.append(self)
        if len(calls) == 2:
            raise OSError(5, "Input/output error")
        return real(self, target)

    monkeypatch.setattr(folder.Path, "rename", second_fails)
    with pytest.raises(folder.ScrewgenError, match="Input/output"):
        folder.write_folder(out, {"c/new.c": b""}, ("c",))
    assert (out / "c/a.c").read_bytes() == FILES["c/a.c"]
