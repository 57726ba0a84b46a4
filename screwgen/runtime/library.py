"""Shared libraries of generated C: compiled once, cached by content in a folder of the user, and loaded.

The key of an entry is the hash of sources, flags and compiler. What was asked for has a name in the cache, too, so that
sources need not be written to be found (:mod:`.asked`): a small file with the key of the entry. An entry is a library
that ends in the digest of its key and itself, so one that is truncated, or stands under the name of another, is
detected without loading it. It is built aside and renamed, so processes may build the same library at once. If the
folder cannot be written, the library is built in a temporary folder. The same holds if others than this user and root
can write to the folder, because its contents run as this user. The folder may be deleted at any time.
"""

from __future__ import annotations

import ctypes
import hashlib
import os
import shlex
import shutil
import stat
import subprocess
import tempfile
import time
import warnings
from collections.abc import Callable, Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor
from contextlib import suppress
from functools import lru_cache
from pathlib import Path

from ..errors import ScrewgenError
from ..files import open_regular
from ..spec.load import one_line

FLAGS = ("-std=c99", "-fPIC", "-shared")
PROGRAMS = ("main.c", "check.c")
"""Sources that are not part of a library."""

MAX_ENTRIES = 256
"""The largest number of entries; beyond it the least recently used are deleted."""

ABANDONED = 24 * 3600.0
"""The age in seconds at which a build folder is taken for that of a killed process."""

ROOT = 0
"""The system's user, who is trusted."""

MAX_NAMES = 4 * MAX_ENTRIES
"""The largest number of names of what was asked for."""

DIGEST = hashlib.sha256().digest_size


def load(
    files: Mapping[str, str] | Callable[[], Mapping[str, str]],
    flags: Sequence[str],
    compiler: str | None = None,
    cache: bool | str | os.PathLike = True,
    asked: str = "",
) -> ctypes.CDLL:
    """The library of C files by name, from the cache if it is there.

    `files`: or what makes them, which is called only where the cache has no entry of the name `asked`, a text that two
    sets of files never share. `compiler`: by default the environment's CC, else cc. `cache`: a folder, True for the
    user's (`cache_folder`), or False to build and forget. Raises ScrewgenError where there is no compiler or it fails.
    """
    command = compiler_command(compiler)
    flags = (*flags, *_once(tuple(command), tuple(flags)))
    folder = cache_folder() if cache is True else Path(cache) if cache else None
    kept = folder if folder is not None and _trusted(folder) else None
    name = asked and _key({"asked": asked}, flags, command)
    if kept and name and (library := _named(kept, name)):
        return library
    made = files() if callable(files) else files
    used = {n: text for n, text in made.items() if n.endswith((".c", ".h")) and n not in PROGRAMS}
    if kept:
        with suppress(OSError):
            key = _key(used, flags, command)
            library = _kept(kept, key) or _build_and_keep(kept, key, used, command, flags)
            _keep_name(kept, name, key)
            return library
    with tempfile.TemporaryDirectory(prefix="screwgen-") as place:
        return ctypes.CDLL(str(_compiled(Path(place), used, command, flags)))


def binary(files: Mapping[str, str], flags: Sequence[str], objects: dict[str, bytes]) -> bytes:
    """The shared library of C files by name, as `load` compiles it; raises ScrewgenError where that fails.

    `objects` keeps what was compiled, by source, for libraries that share sources, headers and flags.
    """
    with tempfile.TemporaryDirectory(prefix="screwgen-") as place:
        return _compiled(Path(place), files, compiler_command(), flags, objects).read_bytes()


def cache_folder() -> Path | None:
    """The folder of the cache: SCREWGEN_CACHE, else screwgen in XDG_CACHE_HOME or ~/.cache; None without a home."""
    if named := os.environ.get("SCREWGEN_CACHE"):
        return Path(named).absolute()
    base = os.environ.get("XDG_CACHE_HOME")
    if base and os.path.isabs(base):
        return Path(base) / "screwgen"
    try:
        return Path.home() / ".cache" / "screwgen"
    except RuntimeError:
        return None


def compiler_command(compiler: str | None = None) -> list[str]:
    """The compiler and its leading arguments; raises ScrewgenError where there is none."""
    text, command = _compiler_and_name(compiler)
    if not command or shutil.which(command[0]) is None:
        raise ScrewgenError(f"no C compiler '{text}'; install gcc or name one in the environment variable CC")
    return command


def has_compiler() -> bool:
    """Whether there is a C compiler; raises ScrewgenError where CC is no command at all."""
    command = _compiler_and_name(None)[1]
    return bool(command) and shutil.which(command[0]) is not None


def _compiler_and_name(compiler: str | None) -> tuple[str, list[str]]:
    """The compiler's command as a text, and as a list."""
    text = compiler or os.environ.get("CC") or "cc"
    try:
        return text, shlex.split(text)
    except ValueError as error:
        raise ScrewgenError(f"the C compiler {text!r} is no command ({error}); mend the quotes in CC") from None


def _compiled(
    folder: Path,
    files: Mapping[str, str],
    command: Sequence[str],
    flags: Sequence[str],
    objects: dict[str, bytes] | None = None,
) -> Path:
    """Write the files into a folder and compile them; raises ScrewgenError where the compiler fails."""
    for name, text in files.items():
        (folder / name).parent.mkdir(exist_ok=True)
        (folder / name).write_text(text)
    sources = sorted(name for name in files if name.endswith(".c") and name not in PROGRAMS and "/" not in name)
    places, kept = {name: folder / f"{name[:-2]}.o" for name in sources}, {} if objects is None else objects
    missing = [name for name in sources if files[name] not in kept]
    with ThreadPoolExecutor(min(os.cpu_count() or 1, len(sources))) as pool:
        list(pool.map(lambda name: _run([*command, *FLAGS[:2], *flags, "-c", name], folder), missing))
    for name in set(sources) - set(missing):
        places[name].write_bytes(kept[files[name]])
    if objects is not None:
        objects.update((files[name], places[name].read_bytes()) for name in missing)
    _run([*command, *FLAGS, *flags, "-o", "model.so", *(place.name for place in places.values()), "-lm"], folder)
    return folder / "model.so"


def _run(command: list[str], folder: Path) -> None:
    done = _run_compiler(command, folder)
    if done.returncode:
        lines = done.stderr.strip().splitlines() or [f"exit status {done.returncode}"]
        said = next((line for line in lines if "error" in line), lines[0])
        raise ScrewgenError(f"{command[0]} failed on the generated C: {said}")


def _run_compiler(command: Sequence[str], folder: Path | None = None) -> subprocess.CompletedProcess[str]:
    """Run the compiler; its output may be in any encoding. Raises ScrewgenError if it cannot be started."""
    try:
        return subprocess.run(
            command, cwd=folder, capture_output=True, text=True, errors="replace", stdin=subprocess.DEVNULL
        )
    except (OSError, ValueError) as error:
        reason = getattr(error, "strerror", None) or error
        raise ScrewgenError(f"the C compiler {command[0]} cannot be run: {reason}; name another one in CC") from None


# ------------------------------------------------------------------------------ entries


def _key(files: Mapping[str, str], flags: tuple[str, ...], command: Sequence[str]) -> str:
    digest = hashlib.sha256()
    for part in (*_identity(tuple(command), flags), *flags, *(x for item in sorted(files.items()) for x in item)):
        digest.update(f"{len(part)}:".encode() + part.encode())
    return digest.hexdigest()


@lru_cache(maxsize=32)
def _identity(command: tuple[str, ...], flags: tuple[str, ...]) -> tuple[str, ...]:
    """A text that identifies the compiler, its version, its target and the meaning of flags such as -march=native."""
    asked = ([*command, "--version"], [*command, *flags, "-dM", "-E", "-x", "c", os.devnull])
    return (*command, *(_run_compiler(line).stdout for line in asked))


@lru_cache(maxsize=32)
def _once(command: tuple[str, ...], flags: tuple[str, ...]) -> tuple[str, ...]:
    """The flag by which GCC compiles for this processor alone what it would compile twice, with the same bits.

    See `TARGETS` in the generated `real.h`. None beside options of the caller for processors.
    """
    if any(flag.startswith("-m") for flag in flags):
        return ()
    macros = _run_compiler([*command, "-march=native", "-dM", "-E", "-x", "c", os.devnull]).stdout.split()
    return ("-mavx",) if "__AVX__" in macros and "__clang__" not in macros else ()


def _trusted(folder: Path) -> bool:
    """Whether only this user and root can write to the cache, which is created if needed; warns if not."""
    try:
        folder.mkdir(mode=0o700, parents=True, exist_ok=True)
        if _private(folder.stat()):
            return True
    except OSError:
        return False
    what = f"{one_line(str(folder))} is no cache of compiled models: others can write in it, or own it"
    warnings.warn(f"{what}; chmod go-w it, or name another folder in SCREWGEN_CACHE", stacklevel=2)
    return False


def _private(status: os.stat_result) -> bool:
    """Whether a folder or file is this user's or the system's, and writable for no one else."""
    own = not hasattr(os, "geteuid") or status.st_uid in (ROOT, os.geteuid())
    return own and not status.st_mode & (stat.S_IWGRP | stat.S_IWOTH)


def _kept(folder: Path, key: str) -> ctypes.CDLL | None:
    """The library of an entry; None if there is none that is complete and fits this machine."""
    path = folder / f"{key}.so"
    try:
        with open_regular(path) as stream:
            ours, data = _private(os.fstat(stream.fileno())), stream.read()
        if not ours or _seal(key, data[:-DIGEST]) != data[-DIGEST:]:
            return None
        library = ctypes.CDLL(str(path))
    except OSError:
        return None
    with suppress(OSError):
        os.utime(path)
    return library


def _named(folder: Path, name: str) -> ctypes.CDLL | None:
    """The library of what was asked for by a name; None where the cache does not know it."""
    try:
        with open_regular(folder / f"{name}.key") as stream:
            ours, key = _private(os.fstat(stream.fileno())), stream.read().decode("ascii", "replace")
    except OSError:
        return None
    stated, _, seal = key.partition(" ")
    return _kept(folder, stated) if ours and seal == _seal(name, stated.encode()).hex() else None


def _keep_name(folder: Path, name: str, key: str) -> None:
    """Let the cache know an entry by the name by which it was asked for."""
    if not name:
        return
    with suppress(OSError), tempfile.TemporaryDirectory(prefix="building-", dir=folder) as place:
        path = Path(place) / "name"
        path.touch(mode=0o600)
        path.write_text(f"{key} {_seal(name, key.encode()).hex()}")
        os.replace(path, folder / f"{name}.key")


def _seal(key: str, library: bytes) -> bytes:
    """What binds the bytes of a library to the key that they were built for."""
    return hashlib.sha256(key.encode() + library).digest()


def _build_and_keep(
    folder: Path, key: str, files: Mapping[str, str], command: Sequence[str], flags: Sequence[str]
) -> ctypes.CDLL:
    """Build in a temporary folder inside the cache, put the entry in its place and load it; raises OSError."""
    with tempfile.TemporaryDirectory(prefix="building-", dir=folder) as place:
        built = _compiled(Path(place), files, command, flags)
        with built.open("ab") as stream:
            stream.write(_seal(key, built.read_bytes()))
        built.chmod(0o700)
        os.replace(built, folder / f"{key}.so")
    _prune(folder)
    return ctypes.CDLL(str(folder / f"{key}.so"))


def _prune(folder: Path) -> None:
    with suppress(OSError):
        for pattern, most in (("*.so", MAX_ENTRIES), ("*.key", MAX_NAMES)):
            for path in sorted(folder.glob(pattern), key=lambda path: path.stat().st_mtime, reverse=True)[most:]:
                path.unlink()
        for path in folder.glob("building-*"):
            if time.time() - path.stat().st_mtime > ABANDONED:
                shutil.rmtree(path, ignore_errors=True)
