"""A headless Chromium, driven through pipes by its own protocol, so that nothing but the browser need be installed."""

import base64
import io
import itertools
import json
import os
import select
import subprocess
import time
from pathlib import Path

import numpy as np
from matplotlib.image import imread

FLAGS = (
    "--headless=new --no-sandbox --disable-gpu-sandbox --use-angle=swiftshader --enable-unsafe-swiftshader "
    "--no-first-run --disable-dev-shm-usage --hide-scrollbars --disable-background-networking --disable-sync "
    "--disable-component-update --mute-audio --force-device-scale-factor=1 --remote-debugging-pipe"
).split()
PATIENCE = 60.0


class Page:
    """A page in a browser that can `go` to an address, `run` a script and tell `complaints`."""

    def open(self, path: Path) -> None:
        self.go(Path(path).resolve().as_uri())
        self.until("document.readyState === 'complete' && window.screwgen && window.screwgen.ready > 0")

    def until(self, condition: str) -> None:
        limit = time.monotonic() + PATIENCE
        while not self.run(f"Boolean({condition})"):
            assert time.monotonic() < limit, f"{condition}; {self.complaints}"
            time.sleep(0.02)


class Browser(Page):
    """One page. `requests`: the addresses that it asked for; `complaints`: errors and warnings of its console."""

    def __init__(self, program: str, profile: Path, size=(800, 600)):
        inward, outward = os.pipe(), os.pipe()
        ends = {3: inward[0], 4: outward[1]}
        command = [program, *FLAGS, f"--user-data-dir={profile}", f"--window-size={size[0]},{size[1]}", "about:blank"]
        shell = f'exec "$@" 3<&{ends[3]} 4>&{ends[4]}'
        self.process = subprocess.Popen(
            ["bash", "-c", shell, "bash", *command], pass_fds=tuple(ends.values()), stderr=subprocess.DEVNULL
        )
        for end in ends.values():
            os.close(end)
        self.out, self.into, self.buffer = inward[1], outward[0], b""
        self.numbers, self.session, self.events = itertools.count(1), None, []
        target = self.call("Target.createTarget", url="about:blank")["targetId"]
        self.session = self.call("Target.attachToTarget", targetId=target, flatten=True)["sessionId"]
        for domain in ("Page", "Runtime", "Network", "Log"):
            self.call(f"{domain}.enable")
        self.resize(*size)

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.session = None
        try:
            self.call("Browser.close")
            self.process.wait(10)
        except (OSError, TimeoutError, subprocess.TimeoutExpired):
            self.process.kill()
            self.process.wait()
        os.close(self.out)
        os.close(self.into)

    def call(self, method: str, **given):
        number = next(self.numbers)
        message = {"id": number, "method": method, "params": given}
        if self.session:
            message["sessionId"] = self.session
        os.write(self.out, json.dumps(message).encode() + b"\0")
        while True:
            found = self._next()
            if found.get("id") == number:
                assert "error" not in found, found
                return found["result"]
            self.events.append(found)

    def _next(self) -> dict:
        limit = time.monotonic() + PATIENCE
        while b"\0" not in self.buffer:
            if not select.select([self.into], [], [], max(limit - time.monotonic(), 0.0))[0]:
                raise TimeoutError("the browser does not answer")
            data = os.read(self.into, 1 << 20)
            if not data:
                raise TimeoutError("the browser has ended")
            self.buffer += data
        message, _, self.buffer = self.buffer.partition(b"\0")
        return json.loads(message)

    def resize(self, width: int, height: int, mobile: bool = False) -> None:
        self.call("Emulation.setDeviceMetricsOverride", width=width, height=height, deviceScaleFactor=1, mobile=mobile)

    def go(self, url: str) -> None:
        self.call("Page.navigate", url=url)

    def run(self, script: str):
        """The value of an expression."""
        found = self.call("Runtime.evaluate", expression=script, returnByValue=True, awaitPromise=True)
        assert "exceptionDetails" not in found, found["exceptionDetails"]
        return found["result"].get("value")

    def point(self, x: float, y: float) -> None:
        """Moves the pointer to a place of the page as it is shown."""
        self.call("Input.dispatchMouseEvent", type="mouseMoved", x=x, y=y)

    def picture(self, path: Path | None = None) -> np.ndarray:
        """The page as (height, width, 3), 0 to 255."""
        data = base64.b64decode(self.call("Page.captureScreenshot", format="png")["data"])
        if path is not None:
            Path(path).write_bytes(data)
        return np.round(255 * imread(io.BytesIO(data), format="png")[:, :, :3]).astype(int)

    @property
    def requests(self) -> list[str]:
        sent = [e["params"]["request"]["url"] for e in self.events if e.get("method") == "Network.requestWillBeSent"]
        return [url for url in sent if not url.startswith("data:")]

    @property
    def complaints(self) -> list[str]:
        out = []
        for event in self.events:
            given = event.get("params", {})
            if event.get("method") == "Runtime.exceptionThrown":
                out.append(
                    given["exceptionDetails"].get("exception", given["exceptionDetails"]).get("description", "error")
                )
            elif event.get("method") == "Runtime.consoleAPICalled" and given["type"] in ("error", "warning", "assert"):
                out.append(" ".join(str(x.get("value", x.get("description"))) for x in given["args"]))
            elif event.get("method") == "Log.entryAdded" and given["entry"]["level"] in ("error", "warning"):
                out.append(given["entry"]["text"])
        return out
