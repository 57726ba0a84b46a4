"""The process of a command: closed streams, encodings that lack letters, pipes in the place of files, warnings."""

import io
import json
import os
import re
import subprocess
import sys
import warnings
from pathlib import Path

import pytest

from screwgen.cli import process as cli_process
from screwgen.cli.main import main
from screwgen.studies import predictive

ELLA = str(Path(__file__).resolve().parents[1] / "examples" / "ella.toml")


@pytest.fixture
def process(monkeypatch):
    """`main` as a process runs it, with an stdout of a kind; the signals stay those of the tests."""
    monkeypatch.setattr(cli_process, "_tidy_when_told_to_end", lambda: None)

    def run(stdout, *arguments: str) -> int:
        monkeypatch.setattr(sys, "argv", ["screwgen", *arguments])
        monkeypatch.setattr(sys, "stdout", stdout)
        return main()

    return run


@pytest.mark.parametrize("arguments", [("modes", ELLA), ("--version",), ("paper", "E7")], ids="-".join)
def test_a_closed_stdout_is_none(process, capsys, arguments):
    assert process(None, *arguments) == 0
    sys.stdout.close()
    assert capsys.readouterr().err == ""


def test_all_streams_closed(process, monkeypatch):
    for name in ("stdin", "stderr"):
        monkeypatch.setattr(sys, name, None)
    assert process(None, "modes", "none.toml") == 2
    for name in ("stdin", "stdout", "stderr"):
        getattr(sys, name).close()


@pytest.mark.parametrize("stage", ["process", "main", "commands"])
def test_an_interruption_is_one_line_from_the_first_import_on(stage, tmp_path):
    """The signal comes where a module of the command line is imported, as from a person who has changed his mind."""
    (tmp_path / "stop.py").write_text(
        "import os, runpy, signal, sys\n"
        "class Stop:\n"
        "    def find_spec(self, name, *more):\n"
        f"        if name == 'screwgen.cli.{stage}':\n"
        "            os.kill(os.getpid(), signal.SIGINT)\n"
        "sys.meta_path.insert(0, Stop())\n"
        "sys.argv[1:] = ['evaluate', 'none.toml']\n"
        "runpy.run_module('screwgen', run_name='__main__')\n"
    )
    found = subprocess.run([sys.executable, tmp_path / "stop.py"], capture_output=True, text=True)
    assert (found.returncode, found.stderr) == (130, "screwgen: error: interrupted; nothing was written\n")


@pytest.mark.parametrize("encoding", ["cp1252", "latin-1", "ascii"])
def test_an_encoding_that_lacks_letters_gets_escapes(process, capsys, encoding):
    for arguments in (("analyse", ELLA, "--samples", "0"), ("paper", "34")):
        out = io.TextIOWrapper(io.BytesIO(), encoding=encoding)
        assert process(out, *arguments) == 0 and capsys.readouterr().err == ""
        assert "\\u03c1" in out.buffer.getvalue().decode(encoding)


def test_json_is_json_in_any_encoding(process):
    found = []
    for encoding in ("utf-8", "cp1252", "ascii"):
        out = io.TextIOWrapper(io.BytesIO(), encoding=encoding)
        assert process(out, "paper", "34", "E7", "--json") == 0
        found.append(json.loads(out.buffer.getvalue().decode(encoding)))
    assert found[0] == found[1] == found[2] and not json.dumps(found[0], ensure_ascii=False).isascii()


def test_warnings_for_users_take_one_line(process, capsys, monkeypatch, tmp_path):
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("CC", "cc 'x")
    short = ("simulate", ELLA, "--duration", "2e-3", "--step", "1e-3", "-o", "run.npz")
    assert process(io.TextIOWrapper(io.BytesIO()), *short) == 0
    (line,) = capsys.readouterr().err.splitlines()
    assert line.startswith("screwgen: warning: the run goes on in NumPy: the C compiler")


def test_deprecations_of_packages_are_none_of_the_users(capsys):
    """Some packages derive them from `UserWarning` too."""
    with cli_process.warnings_as_lines():
        warnings.warn(type("Old", (UserWarning, DeprecationWarning), {})("use another"), stacklevel=1)
        warnings.warn("the link bends", UserWarning, stacklevel=1)
    assert capsys.readouterr().err == "screwgen: warning: the link bends\n"


@pytest.mark.parametrize(
    ("words", "wanted"),
    [
        ("screwgen mo", {"modes"}),
        ("screwgen generate --ba", {"--batch"}),
        ("screwgen modes --j", {"--joints", "--json"}),
    ],
)
@pytest.mark.parametrize("shell", ["bash", "zsh", "fish"])
def test_shells_complete_commands_and_options(capsys, monkeypatch, shell, words, wanted):
    monkeypatch.setenv("_SCREWGEN_COMPLETE", f"complete_{shell}")
    given = {"COMP_WORDS": words, "COMP_CWORD": len(words.split()) - 1, "_TYPER_COMPLETE_ARGS": words}
    for name, value in (given | {"_TYPER_COMPLETE_FISH_ACTION": "get-args"}).items():
        monkeypatch.setenv(name, str(value))
    with pytest.raises(SystemExit) as end:
        main([])
    assert end.value.code == 0
    assert wanted <= set(re.findall(r"[-\w]+", capsys.readouterr().out))


@pytest.mark.parametrize("line", ["modes pipe", "modes ELLA --posture pipe", "analyse ELLA --controller pd:pipe"])
def test_a_pipe_in_the_place_of_a_file_is_refused(capsys, monkeypatch, tmp_path, line):
    """It would be waited for, for ever."""
    monkeypatch.chdir(tmp_path)
    os.mkfifo("pipe")
    assert main(line.replace("ELLA", ELLA).split()) == 2
    assert capsys.readouterr().err.startswith("screwgen: error: pipe: is not a regular file; name a")


def test_what_the_shell_hands_over_is_read(capsys):
    """A substituted process, `--posture <(…)`, is a pipe as well."""
    reader, writer = os.pipe()
    os.write(writer, b"[0.1, 0.2, 0.3]")
    os.close(writer)
    assert main(["modes", ELLA, "--posture", f"/dev/fd/{reader}"]) == 0
    os.close(reader)
    assert " Hz" in capsys.readouterr().out


def test_a_terminal_is_told_that_a_predictive_controller_is_built(monkeypatch):
    """Its derivation and compilation take minutes; what is no terminal stays silent."""
    monkeypatch.setenv("TERM", "xterm")
    monkeypatch.setattr(predictive, "fitted", lambda *_: "fitted")
    monkeypatch.setattr(predictive, "CompiledMpc", lambda *given: given)
    for watched in (True, False):
        stream = io.StringIO()
        monkeypatch.setattr(stream, "isatty", lambda watched=watched: watched)
        monkeypatch.setattr(sys, "stderr", stream)
        assert predictive.controller("model", "mpc.toml") == ("model", "fitted")
        said = stream.getvalue()
        assert ("linearising" in said and "compiling the predictive controller" in said) == watched == bool(said)
