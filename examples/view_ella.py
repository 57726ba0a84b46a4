"""ELLA in the viewer, with a second run as its ghost: the same torque law, but twice the payload.

Writes build/viewer/ella.html and, where there is a Chromium, the picture of the guide, build/viewer/viewer.png.
"""

import shutil
import subprocess
import tempfile
from pathlib import Path

from demo import SET_POINTS, with_rotors

import screwgen

ROOT = Path(__file__).resolve().parents[1]
FOLDER = ROOT / "build" / "viewer"
BROWSERS = ("chromium", "chromium-browser", "google-chrome")
FLAGS = "--headless=new --no-sandbox --use-angle=swiftshader --enable-unsafe-swiftshader --hide-scrollbars".split()
SHOT = "t=0.72&theme=light&show=drive&smooth"
"""What the picture shows: the part of the page's address behind the #."""


def main() -> None:
    FOLDER.mkdir(parents=True, exist_ok=True)
    page = FOLDER / "ella.html"
    model = screwgen.derive(with_rotors(screwgen.load(ROOT / "examples" / "ella.toml")))
    law = screwgen.PD((400.0, 400.0, 120.0), (28.0, 28.0, 12.0), SET_POINTS, duration=1.2, q_start=(0.0,) * 3)
    rest = screwgen.equilibrium(model, [0.0, 0.0, 0.0], hold=True)
    runs = [
        screwgen.simulate(model, 2.0, 1e-3, q0=rest.q, controller=law, parameters={"forearm.bodies[0].mass": mass})
        for mass in (2.1, 4.2)
    ]
    screwgen.view(*runs, labels=["payload 2.1 kg", "payload 4.2 kg"]).save(page)
    print(page.relative_to(ROOT))
    if browser := next(filter(None, map(shutil.which, BROWSERS)), None):
        print(shot(browser, page, FOLDER / "viewer.png").relative_to(ROOT))


def shot(browser: str, page: Path, picture: Path) -> Path:
    """A picture of the page."""
    with tempfile.TemporaryDirectory() as profile:
        flags = [*FLAGS, f"--user-data-dir={profile}", f"--screenshot={picture}", "--window-size=1000,680"]
        command = [browser, *flags, "--virtual-time-budget=3000", f"{page.as_uri()}#{SHOT}"]
        subprocess.run(command, check=True, capture_output=True, timeout=120)
    return picture


if __name__ == "__main__":
    main()
