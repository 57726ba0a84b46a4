"""docs/pictures: what the guides show of the pictures that their blocks and the examples have drawn.

    python docs/tools/pictures.py      # takes them from build/; `make docs` does, after it has drawn them

They are committed, so that the guides show them wherever the repository is read. Their bytes depend on the build of
matplotlib; nothing compares them. A test compares which there are, and the size of those that a page's blocks draw.
"""

from __future__ import annotations

import re
import shutil
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent))

from pages import GUIDES, ROOT

PICTURES, BUILD = ROOT / "docs" / "pictures", ROOT / "build"
MEASURED = frozenset({"peers/peers.png", "peers/growing.png"})
"""Pictures of benchmarks: `make peers` and `make growing` draw them into build/, with the times of a machine."""
SHOWN = re.compile(r"!\[[^\]]+\]\(pictures/([^)]+)\)")


def shown() -> set[str]:
    """The pictures that the guides show: their paths below docs/pictures, which are those below build/ too."""
    return {name for page in GUIDES for name in SHOWN.findall(page.read_text(encoding="utf-8"))}


def main() -> int:
    """Replace the folder by what is shown; status 1, and nothing done, where one has not been drawn."""
    missing = sorted(name for name in shown() if not (BUILD / name).is_file())
    if missing:
        print(f"pictures: not in build/: {', '.join(missing)}; `make docs` draws them", file=sys.stderr)
        return 1
    for old in PICTURES.rglob("*"):
        if old.is_file() and old.relative_to(PICTURES).as_posix() not in MEASURED:
            old.unlink()
    for name in sorted(shown()):
        (PICTURES / name).parent.mkdir(parents=True, exist_ok=True)
        shutil.copyfile(BUILD / name, PICTURES / name)
    return 0


if __name__ == "__main__":
    sys.exit(main())
