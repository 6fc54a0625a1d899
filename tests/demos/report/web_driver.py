"""A browser driven by chromedriver over the WebDriver protocol, with Python's standard library only."""

import base64
import json
import os
import shutil
import socket
import subprocess
import tempfile
import time
import urllib.error
import urllib.request

ELEMENT = "element-6066-11e4-a52e-4f735466cecf"  # the protocol's name for a reference to an element

FLAGS = [
    "--headless=new", "--no-sandbox", "--no-first-run", "--disable-quic", "--disable-sync",
    "--disable-background-networking", "--disable-component-update", "--hide-scrollbars",
    # WebGL without a graphics card. --disable-gpu would draw only a part of large canvases.
    "--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader",
]

KEYS = {"Space": " ", "End": "\ue010", "Home": "\ue011", "Left": "\ue012", "Right": "\ue014", "Escape": "\ue00c"}


class Browser:
    """A session with its own profile, which ends with the `with` block."""

    def __init__(self, width=1280, height=900, dark=False, flags=()):
        self.window = (width, height)
        self.dark = dark
        self.flags = [*FLAGS, *flags]

    def __enter__(self):
        with socket.socket() as free:
            free.bind(("127.0.0.1", 0))
            port = free.getsockname()[1]
        self.profile = tempfile.mkdtemp(prefix="report_in_browser_")
        # A wrapper script around the browser may print to stderr.
        self.driver = subprocess.Popen([shutil.which("chromedriver") or "chromedriver", f"--port={port}"],
                                       stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        self.address = f"http://127.0.0.1:{port}"
        try:
            self.open_session()
        except BaseException:
            self.__exit__()
            raise
        return self

    def open_session(self):
        until = time.monotonic() + 20
        while True:
            try:
                if self.request("GET", "/status")["ready"]:
                    break
            except (ConnectionError, urllib.error.URLError):
                if time.monotonic() > until or self.driver.poll() is not None:
                    raise
            time.sleep(0.1)
        options = {"args": [*self.flags, f"--user-data-dir={self.profile}", "--window-size=%d,%d" % self.window]}
        binary = shutil.which("chromium") or shutil.which("google-chrome")
        if binary:
            options["binary"] = binary
        session = self.request("POST", "/session", {"capabilities": {"alwaysMatch": {
            "browserName": "chrome", "goog:chromeOptions": options,
            "goog:loggingPrefs": {"browser": "ALL", "performance": "ALL"}}}})
        self.address += "/session/" + session["sessionId"]
        self.resize(*self.window)
        self.set_dark(self.dark)

    def __exit__(self, *_):
        if "/session/" in self.address:
            try:
                self.request("DELETE", "")
            except (OSError, RuntimeError):
                pass
        self.driver.terminate()
        try:
            self.driver.wait(10)
        except subprocess.TimeoutExpired:
            self.driver.kill()
        shutil.rmtree(self.profile, ignore_errors=True)

    def request(self, method, path, body=None):
        data = None if body is None else json.dumps(body).encode()
        request = urllib.request.Request(self.address + path, data, {"Content-Type": "application/json"}, method=method)
        # No proxy: the driver is on this machine.
        opener = urllib.request.build_opener(urllib.request.ProxyHandler({}))
        try:
            with opener.open(request, timeout=90) as answer:
                return json.load(answer)["value"]
        except urllib.error.HTTPError as error:
            value = json.load(error)["value"]
            raise RuntimeError(f"{value['error']}: {value['message']}") from None

    def devtools(self, command, **parameters):
        return self.request("POST", "/goog/cdp/execute", {"cmd": command, "params": parameters})

    def open(self, path):
        self.request("POST", "/url", {"url": "file://" + os.path.abspath(path)})

    def run(self, script, *arguments):
        return self.request("POST", "/execute/sync", {"script": script, "args": list(arguments)})

    def find(self, selector):
        found = self.request("POST", "/element", {"using": "css selector", "value": selector})
        return found[ELEMENT]

    def click(self, selector):
        self.request("POST", f"/element/{self.find(selector)}/click", {})

    def press(self, *names):
        """Presses keys, given by name, in the focused element."""
        actions = []
        for name in names:
            key = KEYS.get(name, name)
            actions += [{"type": "keyDown", "value": key}, {"type": "keyUp", "value": key}]
        self.request("POST", "/actions", {"actions": [{"type": "key", "id": "keyboard", "actions": actions}]})

    def drag(self, selector, *places):
        """Presses the mouse at the first place in the element and drags it over the others. Places are fractions."""
        box = self.run("const e = document.querySelector(arguments[0]); e.scrollIntoView({block: 'center'});"
                       "const r = e.getBoundingClientRect(); return [r.left, r.top, r.width, r.height];", selector)
        points = [(round(box[0] + x * box[2]), round(box[1] + y * box[3])) for x, y in places]
        move = [{"type": "pointerMove", "duration": 50, "x": x, "y": y} for x, y in points]
        actions = [move[0], {"type": "pointerDown", "button": 0}, *move[1:], {"type": "pointerUp", "button": 0}]
        self.request("POST", "/actions", {"actions": [
            {"type": "pointer", "id": "mouse", "parameters": {"pointerType": "mouse"}, "actions": actions}]})

    def screenshot(self, selector=None):
        path = "/screenshot" if selector is None else f"/element/{self.find(selector)}/screenshot"
        return base64.b64decode(self.request("GET", path))

    def whole_page(self):
        """Takes a picture of the whole page, beyond the window."""
        self.run("window.scrollTo(0, 0);")
        width, height = self.run("return [innerWidth, document.documentElement.scrollHeight];")
        picture = self.devtools("Page.captureScreenshot", format="png", captureBeyondViewport=True,
                                clip={"x": 0, "y": 0, "width": width, "height": height, "scale": 1})
        return base64.b64decode(picture["data"])

    def resize(self, width, height):
        """Sets the page's size, also below that of the browser's smallest window."""
        self.devtools("Emulation.setDeviceMetricsOverride", width=width, height=height, deviceScaleFactor=1, mobile=False)

    def set_dark(self, dark):
        self.devtools("Emulation.setEmulatedMedia",
                      features=[{"name": "prefers-color-scheme", "value": "dark" if dark else "light"}])

    def log(self, kind):
        """Returns the log since the last call."""
        return self.request("POST", "/se/log", {"type": kind})
