"""Writes generated/: the committed output of the example robots. Usage: regenerate.py [FOLDER]."""

import sys
from pathlib import Path

import screwgen

ROOT = Path(__file__).resolve().parents[1]
EXAMPLES = ("ella", "six_link")


def main(folder: Path) -> None:
    for name in EXAMPLES:
        model = screwgen.derive(screwgen.load(ROOT / "examples" / f"{name}.toml"))
        files = model.write(folder / name)
        print(f"{folder / name}: {len(files)} files")


if __name__ == "__main__":
    main(Path(sys.argv[1]) if len(sys.argv) > 1 else ROOT / "generated")
