"""Reads a report in the browser: its times, its pictures, its console."""

import json
import struct
import time
import zlib

# Counts the pixels of a plot that have one of the colours, up to rounding. `colours` are names of CSS properties.
COUNT_PIXELS = """
const [selector, names] = arguments;
const style = getComputedStyle(document.documentElement);
const wanted = names.map(name => style.getPropertyValue(name).trim()).map(
  hex => [1, 3, 5].map(i => parseInt(hex.slice(i, i + 2), 16)));
let count = 0;
for (const canvas of document.querySelectorAll(selector)) {
  if (canvas.width === 0 || canvas.height === 0) continue;
  // Of a copy: the browser warns of a page that reads its own drawings again and again.
  const copy = new OffscreenCanvas(canvas.width, canvas.height).getContext("2d", {willReadFrequently: true});
  copy.drawImage(canvas, 0, 0);
  const data = copy.getImageData(0, 0, canvas.width, canvas.height).data;
  for (let i = 0; i < data.length; i += 4) {
    if (data[i + 3] > 250 && wanted.some(c => c.every((v, k) => Math.abs(v - data[i + k]) < 3))) ++count;
  }
}
return count;
"""


class PageProbe:
    def __init__(self, browser):
        self.browser = browser
        self.run = browser.run

    def is_ready(self):
        return self.run("return document.documentElement.dataset.ready === 'true';")

    def settle(self):
        """Waits until the page has drawn its present state."""
        time.sleep(0.3)
        self.browser.request("POST", "/execute/async", {
            "script": "const done = arguments[0]; requestAnimationFrame(() => requestAnimationFrame(() => done(null)));",
            "args": []})

    def data(self, key):
        return self.run("return JSON.parse(document.getElementById('report-data').textContent)[arguments[0]];", key)

    def text(self, selector):
        return self.run("const e = document.querySelector(arguments[0]);"
                        "return e ? e.textContent : 'is missing';", selector)

    def is_hidden(self, selector):
        return self.run("const e = document.querySelector(arguments[0]);"
                        "return !e || e.getClientRects().length === 0;", selector)

    def is_help_open(self):
        return self.run("return document.getElementById('help-dialog').open;")

    # The playback.

    def of_report(self, key):
        return self.run("return window.polhodeReport[arguments[0]];", key)

    def index(self):
        return self.of_report("index")

    def last(self):
        return self.of_report("last")

    def time(self):
        return self.of_report("t_s")

    def playing(self):
        return self.of_report("playing")

    def speed(self):
        return self.of_report("speed")

    def seek(self, index):
        self.run("const slider = document.getElementById('scrubber'); slider.value = arguments[0];"
                 "slider.dispatchEvent(new Event('input'));", index)
        self.settle()

    # Plots.

    def time_lines(self):
        return self.run("return Array.from(document.querySelectorAll('.plot .time-line'), line =>"
                        " line.getBoundingClientRect().left - line.parentElement.getBoundingClientRect().left);")

    def plot_line_pixels(self):
        """Returns for each plot that is not empty how many pixels have the colour of one of its lines."""
        ids = self.run("return Array.from(document.querySelectorAll('.plot:not(.is-empty)'), plot => plot.id);")
        contenders = [f"--contender-{number}" for number in range(len(self.data("contenders")))]
        axes = ["--ink-x", "--ink-y", "--ink-z"]
        return {plot: self.run(COUNT_PIXELS, f"#{plot} canvas", axes if plot == "plot-axis_energy_J" else contenders)
                for plot in ids}

    def contender_pixels(self, number):
        return self.run(COUNT_PIXELS, ".plot:not(#plot-axis_energy_J) canvas", [f"--contender-{number}"])

    # The views in 3D.

    def stage_picture(self):
        """Returns a PNG of the bodies without the elements above them: the same bytes for the same picture."""
        self.run("document.getElementById('stage').scrollIntoView();"
                 "const style = document.createElement('style'); style.id = 'probe';"
                 "style.textContent = '#viewports, #viewports *, #transport, #transport *, #contenders, #contenders *"
                 " { visibility: hidden !important } body { background: gray !important }';"
                 "document.head.append(style);")
        self.settle()
        picture = self.browser.screenshot("#stage-canvas")
        self.run("document.getElementById('probe').remove();")
        return picture

    def view_colours(self, picture):
        """Returns the number of colours in each of the views."""
        width, channels, pixels = png_pixels(picture)
        windows = self.run("const all = document.getElementById('stage-canvas').getBoundingClientRect();"
                           "return Array.from(document.querySelectorAll('.window'), window => {"
                           "const box = window.getBoundingClientRect();"
                           "return [box.left - all.left, box.top - all.top, box.width, box.height].map(Math.round); });")
        counts = []
        for left, top, columns, rows in windows:
            colours = set()
            for y in range(top, top + rows):
                start = (y * width + left) * channels
                line = pixels[start:start + columns * channels]
                colours.update(line[i:i + channels] for i in range(0, len(line), channels))
            counts.append(len(colours))
        return counts

    # The browser's log.

    def complaints(self):
        # Some drivers report on the page's console that screenshots are slow.
        return [entry["message"] for entry in self.browser.log("browser")
                if entry["level"] in ("SEVERE", "WARNING") and "GL Driver Message" not in entry["message"]]

    def network_requests(self):
        messages = [json.loads(entry["message"])["message"] for entry in self.browser.log("performance")]
        page = self.run("return location.href;")
        asked = []
        for message in messages:
            parameters = message["params"]
            # The browser's start page makes many requests.
            if message["method"] == "Network.requestWillBeSent" and parameters["documentURL"].startswith("file:"):
                asked.append(parameters["request"]["url"])
            elif message["method"] == "Network.webSocketCreated":
                asked.append(parameters["url"])
        return [address for address in asked if address != page and not address.startswith(("data:", "blob:"))]


def png_pixels(png):
    """Returns width, number of channels and all pixels. Reads what browsers write: 8 bits per channel, not interlaced."""
    position, compressed = 8, b""
    while position < len(png):
        length, kind = struct.unpack(">I4s", png[position:position + 8])
        content = png[position + 8:position + 8 + length]
        if kind == b"IHDR":
            width, height, _, colour_type = struct.unpack(">IIBB", content[:10])
        elif kind == b"IDAT":
            compressed += content
        position += 12 + length
    channels = {2: 3, 6: 4}[colour_type]
    raw, stride = zlib.decompress(compressed), width * channels
    rows, above = [], bytearray(stride)
    for row in range(height):
        start = row * (stride + 1)
        above = unfiltered(raw[start], raw[start + 1:start + 1 + stride], above, channels)
        rows.append(bytes(above))
    return width, channels, b"".join(rows)


def unfiltered(kind, line, above, channels):
    """Decodes a line of a PNG from its differences to the pixels on the left (a), above (b) and above left (c)."""
    line = bytearray(line)
    if kind == 2:
        return bytearray((x + b) & 255 for x, b in zip(line, above))
    if kind == 0:
        return line
    for i, x in enumerate(line):
        a = line[i - channels] if i >= channels else 0
        b = above[i]
        c = above[i - channels] if i >= channels else 0
        if kind == 1:
            predicted = a
        elif kind == 3:
            predicted = (a + b) // 2
        else:
            predicted = min((a, b, c), key=lambda near: abs(a + b - c - near))
        line[i] = (x + predicted) & 255
    return line
