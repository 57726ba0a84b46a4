"""A headless Firefox, driven through a socket by Marionette, its own protocol: nothing but the browser is installed."""

from __future__ import annotations

import itertools
import json
import socket
import subprocess
import time
from pathlib import Path

from browser import PATIENCE, Page

PREFERENCES = {
    "marionette.port": 0,  # any free one; Firefox writes it into the profile
    "browser.shell.checkDefaultBrowser": False,
    "datareporting.policy.dataSubmissionEnabled": False,
    "toolkit.telemetry.enabled": False,
    "app.update.disabledForTesting": True,
    "browser.startup.page": 0,
    "browser.startup.homepage_override.mstone": "ignore",
    "security.sandbox.content.level": 0,
    "layout.css.devPixelsPerPx": "1.0",
}
SAID = """
return Cc["@mozilla.org/consoleAPI-storage;1"].getService(Ci.nsIConsoleAPIStorage).getEvents()
  .filter(x => ["error", "warn", "assert"].includes(x.level)).map(x => x.arguments.map(String).join(" "));
"""
"""What the page itself wrote to its console."""
COMPLAINTS = """
return Services.console.getMessageArray().filter(x => x instanceof Ci.nsIScriptError && !(x.flags & x.infoFlag) &&
  /^(file|data|http)/.test(x.sourceName)).map(x => x.errorMessage)
  .filter(x => !x.startsWith("Invalid markup: Incorrect number of children for"));
"""
"""Errors and warnings about pages, not about the browser itself.

Firefox 153 counts the children of an element of MathML also where its parser pauses in the middle of one, in any long
page; `test_latex_links` counts them in the whole page.
"""
SIZE = """
const style = gBrowser.selectedBrowser.style;
for (const bound of ["min", "max"]) {
  style.setProperty(bound + "-width", arguments[0] + "px");
  style.setProperty(bound + "-height", arguments[1] + "px");
}
"""
EVALUATE = "return window.wrappedJSObject.eval(arguments[0]);"


class Firefox(Page):
    """One page, with the methods of `browser.Browser`. What `run` evaluates sees the page's own names."""

    def __init__(self, program: str, profile: Path, size=(800, 600)):
        profile.mkdir(parents=True, exist_ok=True)
        lines = [f"user_pref({json.dumps(name)}, {json.dumps(value)});" for name, value in PREFERENCES.items()]
        (profile / "user.js").write_text("\n".join(lines), encoding="utf-8")
        command = [program, "--headless", "--marionette", "--remote-allow-system-access", "--no-remote"]
        command += ["--profile", str(profile), "about:blank"]
        self.process = subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        self.numbers, self.socket = itertools.count(1), None
        try:
            self._connect(profile / "MarionetteActivePort")
            self.call("WebDriver:NewSession", capabilities={"alwaysMatch": {"pageLoadStrategy": "normal"}})
            self.resize(*size)
        except BaseException:
            self._end()
            raise

    def __enter__(self):
        return self

    def __exit__(self, *_):
        try:
            self.call("Marionette:Quit", flags=["eForceQuit"])
            self.process.wait(20)
        except (OSError, TimeoutError, subprocess.TimeoutExpired):
            pass
        self._end()

    def _end(self) -> None:
        if self.socket is not None:
            self.socket.close()
        self.process.kill()
        self.process.wait()

    def _connect(self, file: Path) -> None:
        limit = time.monotonic() + PATIENCE
        while not (file.is_file() and file.read_text()):
            assert self.process.poll() is None and time.monotonic() < limit, "Firefox does not start"
            time.sleep(0.05)
        self.socket = socket.create_connection(("127.0.0.1", int(file.read_text())), PATIENCE)
        self.stream = self.socket.makefile("rb")
        self._next()  # who speaks

    def _next(self):
        digits = b""
        while not digits.endswith(b":"):
            found = self.stream.read(1)
            if not found:
                raise TimeoutError("the browser has ended")
            digits += found
        return json.loads(self.stream.read(int(digits[:-1])))

    def call(self, method: str, **given):
        number = next(self.numbers)
        message = json.dumps([0, number, method, given]).encode()
        self.socket.sendall(b"%d:%s" % (len(message), message))
        while True:
            _, answered, error, result = self._next()
            if answered == number:
                assert error is None, error
                return result

    def _of_the_browser(self, script: str, *arguments):
        """The value of a script with the rights of the browser itself."""
        self.call("Marionette:SetContext", value="chrome")
        try:
            return self.call("WebDriver:ExecuteScript", script=script, args=list(arguments), sandbox="system")["value"]
        finally:
            self.call("Marionette:SetContext", value="content")

    def resize(self, width: int, height: int, mobile: bool = False) -> None:
        """Of the page: a window has a least width, what it shows has none."""
        self.call("WebDriver:SetWindowRect", width=max(width, 500) + 50, height=height + 150)
        self._of_the_browser(SIZE, width, height)
        self.until(f"innerWidth === {width} && innerHeight === {height}")

    def go(self, url: str) -> None:
        self.call("WebDriver:Navigate", url=url)

    def open(self, path: Path) -> None:
        self._of_the_browser("Services.console.reset()")
        super().open(path)

    def run(self, script: str):
        """The value of an expression."""
        return self.call("WebDriver:ExecuteScript", script=EVALUATE, args=[script], sandbox="default")["value"]

    def point(self, x: float, y: float) -> None:
        """Moves the pointer to a place of the page as it is shown."""
        move = {"type": "pointerMove", "x": round(x), "y": round(y), "duration": 0, "origin": "viewport"}
        mouse = {"type": "pointer", "id": "mouse", "parameters": {"pointerType": "mouse"}, "actions": [move]}
        self.call("WebDriver:PerformActions", actions=[mouse])

    @property
    def requests(self) -> list[str]:
        own, *others = self.run("[location.href, ...performance.getEntriesByType('resource').map(x => x.name)]")
        return [own, *(url for url in others if not url.startswith("data:"))]

    @property
    def complaints(self) -> list[str]:
        said = self.call("WebDriver:ExecuteScript", script=SAID, args=[], sandbox="system")["value"]
        return self._of_the_browser(COMPLAINTS) + said
