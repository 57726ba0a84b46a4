"""Atomic writing of a folder: built beside its place, then exchanged; only screwgen's own files are replaced.

The new folder is `.DIR-new-…` beside DIR until it is whole. Linux exchanges the two names at once, so DIR is the old
folder or the new one at every moment. Elsewhere DIR is renamed to `.DIR-old-…` for the time of a second renaming; a
process that is killed between the two leaves that folder, and the next call brings it back.
"""

from __future__ import annotations

import ctypes
import errno
import glob
import hashlib
import os
import secrets
import shutil
import stat
import sys
from collections.abc import Callable, Iterable, Mapping
from pathlib import Path

from .errors import ScrewgenError, UsageError
from .unfinished import claimed_folder, remove_if_abandoned

MANIFEST = "MANIFEST.sha256"
AT_FDCWD, RENAME_EXCHANGE = -100, 2
"""Of Linux' renameat2."""


def write_folder(path: str | os.PathLike, files: Mapping[str, bytes], replaces: tuple[str, ...]) -> list[str]:
    """Make ``path`` hold ``files`` (relative names), in place of what it held in the folders ``replaces``.

    What an earlier call wrote into other folders stays.  Raises :class:`UsageError` if ``path`` holds anything
    that no call wrote, or that was changed since; then, and on any failure or interruption, nothing is written.
    """
    target = Path(os.path.abspath(path))
    try:
        _recover(target)
        earlier = check_folder(target)
        kept = {name: (target / name).read_bytes() for name in earlier if name.partition("/")[0] not in replaces}
        tree = {**kept, **files}
        tree[MANIFEST] = "".join(f"{_digest(tree[name])}  {name}\n" for name in sorted(tree)).encode()
        target.parent.mkdir(parents=True, exist_ok=True)
        _put(target, tree)
    except OSError as error:
        raise ScrewgenError(f"{target}: cannot be written: {error.strerror}; choose another folder") from None
    return sorted(tree)


def check_folder(target: Path) -> dict[str, str]:
    """The digests of the files that an earlier call wrote; refuses a folder that holds anything else."""
    if not os.path.lexists(target):
        return {}
    if not target.is_dir() or target.is_symlink():
        raise UsageError(f"{target}: is not a folder; choose another name")
    here, place = Path.cwd(), Path(os.path.realpath(target))
    if place in (here, *here.parents):
        raise UsageError(f"{target}: is the current folder or one above it, which cannot be replaced; name one in it")
    known = _manifest(target)
    products = built(known)
    folders = {parent.as_posix() for name in known for parent in Path(name).parents}
    for entry in sorted(target.rglob("*")):
        name = entry.relative_to(target).as_posix()
        if name in products or (name == MANIFEST and known) or (name in folders and _mode(entry, stat.S_ISDIR)):
            continue
        if name not in known:
            remedy = "remove it (make clean removes what make built) or choose another folder"
            raise UsageError(f"{target}: holds '{name}', which screwgen did not write; {remedy}")
        if not _mode(entry, stat.S_ISREG) or _digest(entry.read_bytes()) != known[name]:
            raise UsageError(
                f"{target}: '{name}' was changed since it was generated; choose another folder or remove it"
            )
    return {name: digest for name, digest in known.items() if (target / name).is_file()}


def _mode(entry: Path, kind: Callable[[int], bool]) -> bool:
    """Whether an entry is of a kind itself, without following it."""
    return kind(entry.lstat().st_mode)


def built(known: Iterable[str]) -> set[str]:
    """What the generated Makefile makes of the files that are known, its folder included: to be built again."""
    out: set[str] = set()
    for name in known:
        folder, _, file = name.rpartition("/")
        stem, _, kind = file.rpartition(".")
        programs = (f"lib{stem}.a", stem, f"{stem}_check", f"{stem}_check_float")
        made = {"c": (f"{stem}.o",), "h": programs}.get(kind, ())
        out |= {f"{folder}/build/{x}" for x in made} | ({f"{folder}/build"} if made else set())
    return out


def _manifest(target: Path) -> dict[str, str]:
    """What the manifest lists; nothing if there is none or it is not ours."""
    try:
        if not _mode(target / MANIFEST, stat.S_ISREG):
            return {}
        lines = (target / MANIFEST).read_text().splitlines()
        listed = {name: digest for digest, name in (line.split("  ", 1) for line in lines)}
        return {name: digest for name, digest in listed.items() if ".." not in Path(name).parts and name[:1] != "/"}
    except (OSError, ValueError):
        return {}


def _digest(data: bytes) -> str:
    return hashlib.sha256(data).hexdigest()


def _put(target: Path, tree: Mapping[str, bytes]) -> None:
    """Write the tree beside its place, then let it take the place; the mode of a folder that is there stays."""
    staged, aside = _beside(target, "new"), _beside(target, "old")
    mode, inode = stat.S_IMODE(target.stat().st_mode) if target.exists() else None, -1
    try:
        with claimed_folder(staged, 0o777 if mode is None else 0o700):
            inode = staged.stat().st_ino
            _fill(staged, tree)
            if mode is not None:
                staged.chmod(mode)
            _swap(staged, target, aside)
    except KeyboardInterrupt:
        if os.path.lexists(target) and target.stat().st_ino == inode:
            raise KeyboardInterrupt(f"interrupted when {target} was written already") from None
        raise
    finally:
        if os.path.lexists(aside) and not os.path.lexists(target):
            os.rename(aside, target)
        for folder in (staged, aside):
            shutil.rmtree(folder, ignore_errors=True)


def _beside(target: Path, role: str) -> Path:
    return target.with_name(f".{target.name}-{role}-{secrets.token_hex(4)}")


def _fill(folder: Path, tree: Mapping[str, bytes]) -> None:
    for name, data in tree.items():
        file = folder / name
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_bytes(data)


def _swap(staged: Path, target: Path, aside: Path) -> None:
    """Put the staged folder in the target's place; the previous folder is then `staged`, or `aside`."""
    if not os.path.lexists(target):
        os.rename(staged, target)
        return
    try:
        _exchange(staged, target)
    except OSError:
        os.rename(target, aside)
        os.rename(staged, target)


def _exchange(a: Path, b: Path) -> None:
    """Exchange two names at once; raises OSError if the system or its file system cannot."""
    if sys.platform != "linux":
        raise OSError(errno.ENOSYS, os.strerror(errno.ENOSYS))
    rename = getattr(ctypes.CDLL(None, use_errno=True), "renameat2", None)
    names = AT_FDCWD, os.fsencode(a), AT_FDCWD, os.fsencode(b)
    if rename is None or rename(*names, RENAME_EXCHANGE):
        code = ctypes.get_errno() or errno.ENOSYS
        raise OSError(code, os.strerror(code))


def _recover(target: Path) -> None:
    """Restore the folder that a killed process left between two renamings; remove unfinished folders."""
    for role in ("old", "new"):
        left = list(target.parent.glob(f".{glob.escape(target.name)}-{role}-{'?' * 8}"))
        if left and role == "old" and not os.path.lexists(target):
            os.rename(max(left, key=lambda folder: folder.stat().st_mtime), target)
        for folder in left:
            remove_if_abandoned(folder)
