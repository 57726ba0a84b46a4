"""Wrong robot files: each is refused in one line that names the file, the key, the fault and the remedy."""

import os

import pytest
from bad_robot_files import GOOD, LINE, MODES, NO_EIZ, PAIR, WRONG, WRONG_FREQUENCIES, refusal

from screwgen.errors import RobotFileError
from screwgen.spec import load


@pytest.fixture(scope="module")
def path(tmp_path_factory):
    return tmp_path_factory.mktemp("robots") / "bot.toml"


def test_the_good_file_is_good(path):
    path.write_text(GOOD, encoding="utf-8")
    assert load(path).links[1].name == "fore"


@pytest.mark.parametrize(("old", "new", "where", "fragment"), WRONG)
def test_wrong_file_is_refused_in_one_line(path, old, new, where, fragment):
    assert GOOD.count(old) >= 1
    path.write_text(GOOD.replace(old, new, 1), encoding="utf-8")
    message = refusal(path)
    assert message.startswith(where) and fragment in message
    assert not message.removeprefix(where)[:1].isalnum()


@pytest.mark.parametrize(("frequencies", "section", "modes", "where", "fragment"), WRONG_FREQUENCIES)
def test_wrong_frequencies_are_refused_in_one_line(path, frequencies, section, modes, where, fragment):
    others = "axial = 1, bending_z = 2, torsion = 1"
    counts = f"{modes}, {others}" if modes else others
    table = f"{{ {counts}, frequencies = {frequencies} }}"
    path.write_text(GOOD.replace(LINE, f"{{ {section} }}").replace(MODES, table), encoding="utf-8")
    message = refusal(path)
    assert message.startswith(where) and fragment in message
    assert not message.removeprefix(where)[:1].isalnum() and "(and " not in message


def test_measured_frequencies_in_their_place_are_good(path):
    table = MODES.replace(" }", f", frequencies = {PAIR} }}")
    path.write_text(GOOD.replace(LINE, f"{{ {NO_EIZ} }}").replace(MODES, table), encoding="utf-8")
    assert load(path).links[0].modes.measured == ("bending_y",)


def test_frequencies_belong_to_the_modes(path):
    path.write_text(GOOD.replace("frame_at = 0.1", f"frequencies = {PAIR}"), encoding="utf-8")
    assert refusal(path).startswith("links[0].frequencies (link upper): is an unknown key")


def test_several_faults_are_counted(path):
    path.write_text(GOOD.replace("length = 0.4", "length = -1").replace("-9.81", "nan"), encoding="utf-8")
    message = refusal(path)
    assert message == "gravity[2]: is nan; it must be a finite number; 1 more fault in the file"


def test_a_misspelt_key_is_named_before_the_key_it_leaves_missing(path):
    path.write_text(GOOD.replace("length = 0.4", "Length = 0.4"), encoding="utf-8")
    assert refusal(path).startswith("links[1].Length (link fore): is an unknown key; did you mean length? ")


# What is not even text


def test_missing_file(tmp_path):
    assert refusal(tmp_path / "none.toml") == "there is no such file; check the path"


def test_folder(tmp_path):
    assert refusal(tmp_path) == "is a directory; name a TOML file in it"


def test_file_as_folder(path):
    path.write_text(GOOD)
    assert refusal(path / "bot.toml") == "cannot be read: Not a directory; check the path"


def test_forbidden_file(path, monkeypatch):
    def forbidden(*_, **__):
        raise PermissionError

    monkeypatch.setattr("builtins.open", forbidden)
    assert refusal(path) == "may not be read; check its permissions"


def test_impossible_names(tmp_path):
    for name in ("a\0b", "a\nb", "x" * 5000, os.fsdecode(b"\xff\xfe")):
        with pytest.raises(RobotFileError) as caught:
            load(str(tmp_path / name))
        assert str(caught.value).isprintable()


def test_binary_file(path):
    path.write_bytes(b'name = "bot"\n\xff\xfe\x00')
    assert refusal(path) == "line 2: is not UTF-8 text; save it as TOML in UTF-8"


def test_huge_file(path):
    path.write_bytes(b"#" * 5_000_000)
    assert refusal(path).startswith("is too large")


def test_empty_file(path):
    path.write_bytes(b"")
    assert refusal(path).startswith("name: is missing")


def test_byte_order_mark_and_windows_line_ends_are_welcome(path):
    path.write_bytes(b"\xef\xbb\xbf" + GOOD.replace("\n", "\r\n").encode())
    assert load(path).name == "bot"
