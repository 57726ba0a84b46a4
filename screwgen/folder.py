"""Writing a folder as a whole: beside its place first, then by renaming; nothing that is not ours is touched."""

from __future__ import annotations

import hashlib
import os
import shutil
import tempfile
from collections.abc import Mapping
from pathlib import Path

from .errors import ScrewgenError, UsageError

MANIFEST = "MANIFEST.sha256"


def write_folder(path: str | os.PathLike, files: Mapping[str, bytes], replaces: tuple[str, ...]) -> list[str]:
    """Make ``path`` hold ``files`` (relative names), in place of what it held in the folders ``replaces``.

    What an earlier call wrote into other folders stays.  Raises :class:`UsageError` if ``path`` holds files
    that no call wrote, or that were changed since; then, and on any failure, nothing is written.
    """
    target = Path(os.path.abspath(path))
    earlier = check_folder(target)
    kept = {name: (target / name).read_bytes() for name in earlier if name.partition("/")[0] not in replaces}
    tree = {**kept, **files}
    tree[MANIFEST] = "".join(f"{_digest(tree[name])}  {name}\n" for name in sorted(tree)).encode()
    try:
        target.parent.mkdir(parents=True, exist_ok=True)
        staged = Path(tempfile.mkdtemp(prefix=f".{target.name}-", dir=target.parent))
    except OSError as error:
        raise UsageError(f"{target}: cannot be written: {error.strerror}; choose another folder") from None
    try:
        _fill(staged, tree)
        _swap(staged, target)
    except OSError as error:
        raise ScrewgenError(f"{target}: cannot be written: {error.strerror}") from None
    finally:
        shutil.rmtree(staged, ignore_errors=True)
    return sorted(tree)


def check_folder(target: Path) -> dict[str, str]:
    """The digests of the files that an earlier call wrote; refuses a folder that holds anything else."""
    if not target.exists() and not target.is_symlink():
        return {}
    if not target.is_dir() or target.is_symlink():
        raise UsageError(f"{target}: is not a folder; choose another name")
    known = _manifest(target)
    for file in sorted(f for f in target.rglob("*") if not f.is_dir()):
        name = file.relative_to(target).as_posix()
        if name == MANIFEST and known:
            continue
        if name not in known:
            remedy = "remove it (make clean removes what make built) or choose another folder"
            raise UsageError(f"{target}: holds '{name}', which screwgen did not write; {remedy}")
        if file.is_symlink() or _digest(file.read_bytes()) != known[name]:
            raise UsageError(
                f"{target}: '{name}' was changed since it was generated; choose another folder or remove it"
            )
    return {name: digest for name, digest in known.items() if (target / name).is_file()}


def _manifest(target: Path) -> dict[str, str]:
    """What the manifest lists; nothing if there is none or it is not ours."""
    try:
        lines = (target / MANIFEST).read_text().splitlines()
        listed = {name: digest for digest, name in (line.split("  ", 1) for line in lines)}
        return {name: digest for name, digest in listed.items() if ".." not in Path(name).parts and name[:1] != "/"}
    except (OSError, ValueError):
        return {}


def _digest(data: bytes) -> str:
    return hashlib.sha256(data).hexdigest()


def _fill(folder: Path, tree: Mapping[str, bytes]) -> None:
    for name, data in tree.items():
        file = folder / name
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_bytes(data)
    folder.chmod(0o755)


def _swap(staged: Path, target: Path) -> None:
    """Put the staged folder in the target's place; what was there comes back if that fails."""
    if not target.exists():
        staged.rename(target)
        return
    aside = Path(tempfile.mkdtemp(prefix=f".{target.name}-old-", dir=target.parent))
    try:
        target.rename(aside / "folder")
        try:
            staged.rename(target)
        except OSError:
            (aside / "folder").rename(target)
            raise
    finally:
        shutil.rmtree(aside, ignore_errors=True)
