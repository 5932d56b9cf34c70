# SPDX-License-Identifier: Apache-2.0
"""A headless Chromium, controlled over its debugging pipe (Chrome DevTools Protocol)."""
import base64
import itertools
import json
import os
import subprocess
import time


class Browser:
    def __init__(self, program, folder, width=1120, height=900):
        to_browser, self.to = os.pipe()
        self.back, from_browser = os.pipe()
        command = (f'exec 3<&{to_browser} 4>&{from_browser}; exec "{program}" --headless --no-sandbox --disable-gpu '
                   f'--no-first-run --user-data-dir="{folder}/browser" --window-size={width},{height} '
                   f'--remote-debugging-pipe about:blank')
        self.process = subprocess.Popen(["bash", "-c", command], pass_fds=(to_browser, from_browser),
                                        stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL,
                                        stderr=subprocess.DEVNULL, env=dict(os.environ, HOME=folder))
        os.close(to_browser)
        os.close(from_browser)
        self.numbers, self.rest, self.session = itertools.count(1), b"", None
        page = self.call("Target.createTarget", url="about:blank")["targetId"]
        self.session = self.call("Target.attachToTarget", targetId=page, flatten=True)["sessionId"]
        self.call("Page.enable")
        self.call("Emulation.setDeviceMetricsOverride", width=width, height=height, deviceScaleFactor=1, mobile=False)

    def call(self, method, **params):
        number = next(self.numbers)
        message = {"id": number, "method": method, "params": params}
        if self.session:
            message["sessionId"] = self.session
        os.write(self.to, json.dumps(message).encode() + b"\0")
        while True:
            while b"\0" not in self.rest:
                got = os.read(self.back, 1 << 16)
                assert got, "the browser has ended"
                self.rest += got
            one, self.rest = self.rest.split(b"\0", 1)
            answer = json.loads(one)
            if answer.get("id") == number:
                assert "error" not in answer, (method, answer)
                return answer["result"]

    def open(self, address):
        self.call("Page.navigate", url="about:blank")  # else another part after # loads nothing
        self.call("Page.navigate", url=address)

    def run(self, script, waits=False):
        """The value of a script; `waits`: the result of its promise."""
        answer = self.call("Runtime.evaluate", expression=script, returnByValue=True, awaitPromise=waits)
        assert "exceptionDetails" not in answer, (script, answer)
        return answer["result"].get("value")

    def wait_for(self, script, turns=300):
        for _ in range(turns):
            if self.run(script):
                return
            time.sleep(0.1)
        raise AssertionError(f"never true: {script}; the page: {self.run('document.body.innerText')}")

    def picture(self, file, dark=False, height=None):
        """The page as PNG: all of it, or its first `height` pixels."""
        scheme = "dark" if dark else "light"
        self.call("Emulation.setEmulatedMedia", features=[{"name": "prefers-color-scheme", "value": scheme}])
        time.sleep(0.3)  # another event comes, and is drawn in these colors
        height = height or self.run("document.documentElement.scrollHeight")
        width = self.run("innerWidth")
        data = self.call("Page.captureScreenshot", captureBeyondViewport=True,
                         clip={"x": 0, "y": 0, "width": width, "height": height, "scale": 1})["data"]
        with open(file, "wb") as out:
            out.write(base64.b64decode(data))

    def end(self):
        """Ends the browser and its processes, so that they write into its folder no longer."""
        self.session = None
        try:
            self.call("Browser.close")
            self.process.wait(10)
        except (AssertionError, OSError, subprocess.TimeoutExpired):
            self.process.kill()
            self.process.wait()
