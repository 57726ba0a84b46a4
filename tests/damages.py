"""Ways to damage a file: its bytes, its text, and the arrays, headers and members of NumPy's files."""

from __future__ import annotations

import io
import re
import struct
import zipfile
from collections.abc import Callable

import numpy as np

NUMBER = re.compile(rb"(?<![\w.])-?\d+(?:\.\d+)?(?:[eE][-+]?\d+)?")
WORDS = [*b"nan inf -inf -1 0 1e308 -1e308 1e-308 5e-324 1e400".split(), b"9" * 5000]
WORDS += b'true "" [] {} [[1.0]] null 1979-05-27 1_000 0x7fffffff 99999999999 1000 10000'.split()
NESTED = [b"[" * 20000, b"{" * 20000, b"(" * 20000, b'{"a":' * 20000, b"a." * 20000, b"<a>" * 20000, b"[[" * 5000]
STRANGE = [b"\xff\xfe", b"\xc3", b"\x00", b"\xef\xbb\xbf", b"\xed\xa0\x80", "\u202e\u2028".encode(), b"\r", b"\x1b[31m"]
BOMB = 700 * 2**20
"""Bytes of zeros in a member that is packed to a thousandth."""
Rng = np.random.Generator


# ------------------------------------------------------------------------------ bytes


def flipped(data: bytes, rng: Rng) -> bytes:
    out = bytearray(data)
    for _ in range(int(rng.integers(1, 9))):
        out[rng.integers(len(out))] ^= 1 << int(rng.integers(8))
    return bytes(out)


def cut(data: bytes, rng: Rng) -> bytes:
    return data[: rng.integers(len(data))]


def moved(data: bytes, rng: Rng) -> bytes:
    """A piece is left out, or stands twice, or elsewhere."""
    a, b, c = sorted(rng.integers(len(data), size=3))
    return [data[:a] + data[b:], data[:b] + data[a:], data[:a] + data[b:c] + data[a:b] + data[c:]][rng.integers(3)]


def filled(data: bytes, rng: Rng) -> bytes:
    """Some bytes in a row are random, or all ones."""
    a, size = int(rng.integers(len(data))), int(rng.integers(1, 64))
    return data[:a] + (rng.bytes(size) if rng.integers(2) else b"\xff" * size) + data[a + size :]


BYTES = [flipped, cut, moved, filled]


# ------------------------------------------------------------------------------ text


def number(data: bytes, rng: Rng) -> bytes:
    found = list(NUMBER.finditer(data))
    chosen = found[rng.integers(len(found))]
    return data[: chosen.start()] + WORDS[rng.integers(len(WORDS))] + data[chosen.end() :]


def lines(data: bytes, rng: Rng) -> bytes:
    """A line is left out, or stands twice, or two change places."""
    rows = data.split(b"\n")
    a, b = (int(x) for x in rng.integers(len(rows), size=2))
    if (how := rng.integers(3)) == 0:
        del rows[a]
    elif how == 1:
        rows.insert(b, rows[a])
    else:
        rows[a], rows[b] = rows[b], rows[a]
    return b"\n".join(rows)


def inserted(data: bytes, rng: Rng) -> bytes:
    """Deep nesting, or what is no text, at the start of a line or of a value."""
    choice = NESTED if rng.integers(2) else STRANGE
    places = [0, *(m.end() for m in re.finditer(rb'[\n=:"]', data))]
    at = places[rng.integers(len(places))]
    return data[:at] + choice[rng.integers(len(choice))] + data[at:]


TEXT = [*[number] * 5, lines, lines, inserted, *BYTES]


# ------------------------------------------------------------------------------ arrays


def header(descr: str, shape: str, version: tuple[int, int] = (1, 0), fortran: str = "False") -> bytes:
    """The head of a .npy file with any text in it."""
    text = f"{{'descr': {descr}, 'fortran_order': {fortran}, 'shape': {shape}, }}\n".encode("latin1")
    return b"\x93NUMPY" + bytes(version) + struct.pack("<H" if version == (1, 0) else "<I", len(text)) + text


HEADERS: list[Callable[[], bytes]] = [
    lambda: header("'<f8'", "(100000000000,)"),
    lambda: header("'<f8'", "(-3,)"),
    lambda: header("'<f8'", "(10**9,)"),
    lambda: header("'<f8'", f"({10**30}, {10**30})"),
    lambda: header("'<f8'", "(0, 100000000000000000000)"),
    lambda: header("'<f8'", "(True, 3)"),
    lambda: header("'<f8'", "(2.0,)"),
    lambda: header("'<f8'", "(" * 4000),
    lambda: header("'<f8'", "-" * 4000 + "1"),
    lambda: header("'|O'", "(2,)"),
    lambda: header("'<U1000000000'", "(1,)"),
    lambda: header("'<U0'", "(3,)"),
    lambda: header("'<f16'", "(3,)"),
    lambda: header("[('a', '<f8'), ('b', 'O')]", "(3,)"),
    lambda: header("'<f8, <f8'", "(3,)"),
    lambda: header("{'names': 1}", "(3,)"),
    lambda: header("'<M8[s]'", "(3,)"),
    lambda: header("'\u00e4'", "(3,)"),
    lambda: header("'''", "(3,)"),
    lambda: header("'<f8'", "(3L,)"),
    lambda: header("'<f8'", "(3,", fortran="True"),
    lambda: header("'<f8'", "(3,)", (2, 0)),
    lambda: header("'<f8'", "(3,)", (3, 0)),
    lambda: header("'<f8'", "(3,)", (9, 9)),
    lambda: b"\x93NUMPY\x02\x00\xff\xff\xff\xff{",
    lambda: b"",
]


def npy(array: np.ndarray) -> bytes:
    out = io.BytesIO()
    np.lib.format.write_array(out, array, allow_pickle=True)
    return out.getvalue()


def damaged_head(rng: Rng) -> bytes:
    return HEADERS[rng.integers(len(HEADERS))]() + rng.bytes(int(rng.integers(3)) * 24)


def _values(array: np.ndarray, rng: Rng) -> np.ndarray:
    """Some entries are extreme: not finite, negative, out of range."""
    out = np.array(array)
    if not out.size or out.dtype.kind not in "iuf":
        return out
    whole = [-1, 2**31 - 1, -(2**31), int(out.max()) + 1, 0]
    extreme = [np.nan, np.inf, -np.inf, 1e308, -1e308, 1e-308, -1.0, 0.0, *map(float, whole)]
    for _ in range(int(rng.integers(1, 4))):
        choice = extreme if out.dtype.kind == "f" else whole
        out.reshape(-1)[rng.integers(out.size)] = choice[rng.integers(len(choice))]
    return out


def _types(array: np.ndarray, rng: Rng) -> np.ndarray:
    kind = ["<i8", "<u1", "?", "<c16", "U", "S", "O", ">f4", "<f2", "<u8", "<M8[s]", "V8"][rng.integers(12)]
    try:
        with np.errstate(all="ignore"):
            return array.astype(kind)
    except (TypeError, ValueError):
        return np.array(["\U0001f600", "nan", ""])


def _shapes(array: np.ndarray, rng: Rng) -> np.ndarray:
    made = [array.reshape(-1), array[None], array[..., None], array.reshape(-1)[:-1], np.zeros(()), array.T]
    made += [np.zeros((0, 3)), np.concatenate([array.reshape(-1)] * 2), np.asfortranarray(array)]
    return made[rng.integers(len(made))]


ARRAYS = [_values, _values, _types, _shapes]


def one_array(data: bytes, rng: Rng) -> bytes:
    """A .npy file whose array or head is another."""
    if rng.uniform() < 0.3:
        return damaged_head(rng)
    return npy(ARRAYS[rng.integers(len(ARRAYS))](np.load(io.BytesIO(data)), rng))


# ------------------------------------------------------------------------------ members


def packed(members: list[tuple[str, bytes]], how: int = zipfile.ZIP_STORED) -> bytes:
    out = io.BytesIO()
    with zipfile.ZipFile(out, "w", how) as file:
        for name, content in members:
            file.writestr(name, content)
    return out.getvalue()


def _members(data: bytes) -> list[tuple[str, bytes]]:
    with zipfile.ZipFile(io.BytesIO(data)) as file:
        return [(name, file.read(name)) for name in file.namelist()]


def other_member(data: bytes, rng: Rng) -> bytes:
    """One member holds another array, or another head."""
    members = _members(data)
    k = int(rng.integers(len(members)))
    name, content = members[k]
    members[k] = name, one_array(content, rng)
    return packed(members, (zipfile.ZIP_STORED, zipfile.ZIP_DEFLATED)[rng.integers(2)])


def exchanged(data: bytes, rng: Rng) -> bytes:
    """Members change places, are left out, or have names that are none."""
    members = _members(data)
    a, b = (int(x) for x in rng.integers(len(members), size=2))
    if (how := rng.integers(4)) == 0:
        members[a], members[b] = (members[a][0], members[b][1]), (members[b][0], members[a][1])
    elif how == 1:
        del members[a]
    elif how == 2:
        members[a] = ["../" + members[a][0], "\u00e4\n.npy", " ", "set_\x1b[31m.npy"][rng.integers(4)], members[a][1]
    else:
        members += [(f"m{k}.npy", b"") for k in range(20000)]
    return packed(members)


def lied(data: bytes, rng: Rng) -> bytes:
    """A field of a member's entry in the directory, and of its own head, says something else: flags, method, sizes."""
    data, step = packed(_members(data), zipfile.ZIP_DEFLATED), int(rng.integers(5))
    out, central = bytearray(data), [m.start() for m in re.finditer(rb"PK\x01\x02", data)]
    at = central[rng.integers(len(central))]
    local = struct.unpack_from("<I", data, at + 42)[0]
    offset, size, value = [
        (8, 2, 1),  # encrypted
        (10, 2, (9, 12, 14, 99, 97)[rng.integers(5)]),
        (24, 4, (0, 1, 2**31, 2**32 - 2)[rng.integers(4)]),
        (20, 4, (0, 1, 2**31)[rng.integers(3)]),
        (42, 4, (1, 2**31, 2**32 - 2)[rng.integers(3)]),
    ][step]
    out[at + offset : at + offset + size] = value.to_bytes(size, "little")
    if step < 4:
        out[local + offset - 2 : local + offset - 2 + size] = value.to_bytes(size, "little")
    return bytes(out)


def bomb(name: str) -> bytes:
    """A .npz file of a member that is packed to a thousandth of its size."""
    head, out = header("'<f8'", f"({BOMB // 8},)"), io.BytesIO()
    with zipfile.ZipFile(out, "w", zipfile.ZIP_DEFLATED, compresslevel=1) as file, file.open(name, "w") as member:
        member.write(head)
        for _ in range(BOMB // 2**20):
            member.write(bytes(2**20))
    return out.getvalue()


def exploded(data: bytes, rng: Rng) -> bytes:
    """A member unpacks to far more than the file has."""
    members = _members(data)
    name = members[rng.integers(len(members))][0]
    out = io.BytesIO(bomb(name))
    with zipfile.ZipFile(out, "a") as file:
        for other, content in members:
            if other != name:
                file.writestr(other, content)
    return out.getvalue()


MEMBERS = [*[other_member] * 9, *[exchanged, lied] * 2, *BYTES]
RARE, SELDOM = [exploded], 0.01
"""Damages that take seconds to make, and how often members are damaged so."""


def damage(data: bytes, kinds: list[Callable[[bytes, Rng], bytes]], rng: Rng) -> bytes:
    """One or, seldom, several damages."""
    if kinds is MEMBERS and rng.uniform() < SELDOM:
        return RARE[0](data, rng)
    first = kinds[rng.integers(len(kinds))](data, rng)
    return first if rng.uniform() < 0.8 or len(first) < 9 else BYTES[rng.integers(len(BYTES))](first, rng)
