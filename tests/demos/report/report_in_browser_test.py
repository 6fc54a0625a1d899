#!/usr/bin/env python3
"""Opens a report of polhode_compare in Chromium and uses it as a reader would.

    report_in_browser_test.py REPORT.html [--screenshot OUT.png] [--dark] [--width W] [--height H]

Needs chromium and chromedriver. The exit code is 0 if all checks pass. The screenshot is of the whole page.
"""

import argparse
import os
import sys
import time

from page_probe import PageProbe
from web_driver import Browser

READY_WITHIN_S = 30


class Checks:
    def __init__(self):
        self.failed = 0

    def expect(self, holds, text, seen=""):
        print(("ok      " if holds else "FAILED  ") + text + ("" if holds or seen == "" else f": {seen}"), flush=True)
        self.failed += not holds


def wait_until(condition, seconds):
    until = time.monotonic() + seconds
    while not condition():
        if time.monotonic() > until:
            return False
        time.sleep(0.05)
    return True


def check_file(checks, path):
    size = os.path.getsize(path)
    checks.expect(size < 2_000_000, "the file has less than 2 MB", size)


def check_opening(checks, browser, probe, path):
    browser.open(path)
    ready = wait_until(probe.is_ready, READY_WITHIN_S)
    checks.expect(ready, f"it is ready within {READY_WITHIN_S} s", probe.text("#trouble"))
    if not ready:
        return False
    title = browser.run("return document.title;")
    name = probe.data("scenario")["name"]
    checks.expect(title == f"{name}: Polhode report", "the title names the scenario", title)
    checks.expect(probe.text("#command") == probe.data("command"), "the command is shown", probe.text("#command"))
    checks.expect(not probe.playing(), "it does not start to play by itself")
    rows = browser.run("return document.querySelectorAll('#figures tbody tr').length;")
    checks.expect(rows == len(probe.data("contenders")), "the table has a row for each contender", rows)
    return True


def check_plots(checks, probe, when=""):
    for name, pixels in probe.plot_line_pixels().items():
        checks.expect(pixels > 50, f"the plot {name} has lines{when}", f"{pixels} pixels of a line's colour")


def check_stage(checks, probe):
    probe.seek(0)
    start = probe.stage_picture()
    colours = probe.view_colours(start)
    checks.expect(min(colours) > 20, "a body is drawn in every view", f"colours in each: {colours}")
    probe.seek(max(1, probe.last() // 3))
    checks.expect(probe.stage_picture() != start, "the bodies move from one time to another")


def check_scrubber(checks, browser, probe):
    probe.seek(0)
    steps = min(7, probe.last())
    lines, picture = probe.time_lines(), probe.stage_picture()
    browser.run("document.getElementById('scrubber').focus();")
    browser.press(*["Right"] * steps)
    checks.expect(wait_until(lambda: probe.index() == steps, 3), "the slider moves by the keyboard", probe.index())
    probe.settle()
    moved = probe.time_lines()
    checks.expect(len(moved) > 0 and all(a < b for a, b in zip(lines, moved)),
                  "the slider moves the line of every plot", f"{lines} to {moved}")
    checks.expect(probe.stage_picture() != picture, "the slider moves the bodies")


def check_keys(checks, browser, probe):
    browser.run("document.activeElement.blur(); document.querySelector('h1').click();")
    browser.press("End")
    checks.expect(probe.index() == probe.last(), "End goes to the end", probe.index())
    browser.press("Left")
    checks.expect(probe.index() == probe.last() - 1, "Left goes one record back", probe.index())
    browser.press("Home")
    checks.expect(probe.index() == 0, "Home goes to the start", probe.index())
    browser.press("Right")
    checks.expect(probe.index() == 1, "Right goes one record on", probe.index())
    speed = probe.speed()
    browser.press("+")
    faster = probe.speed()
    browser.press("-", "-")
    checks.expect(faster > speed > probe.speed(), "+ and - change the speed", (speed, faster, probe.speed()))
    browser.press("h")
    checks.expect(probe.is_help_open(), "H opens the help")
    browser.press("Escape")
    checks.expect(not probe.is_help_open(), "Escape closes the help")


def check_playing(checks, browser, probe):
    probe.seek(0)
    browser.press("Space")
    checks.expect(probe.playing(), "Space plays")
    if probe.last() > 50:
        checks.expect(wait_until(lambda: probe.index() > 3, 5), "time goes on while it plays", probe.index())
    browser.press("Space")
    checks.expect(not probe.playing(), "Space pauses")
    index = probe.index()
    time.sleep(0.4)
    checks.expect(probe.index() == index, "time stands while it does not play", probe.index())


def check_hiding(checks, browser, probe):
    number = min(1, len(probe.data("contenders")) - 1)
    probe.seek(probe.last() // 2 + 1)
    before, lines = probe.contender_pixels(number), probe.time_lines()
    box = f"#contender-list label:nth-child({number + 1}) input"
    browser.click(box)
    probe.settle()
    checks.expect(probe.is_hidden(f"#viewports > :nth-child({number + 1})"), "a hidden contender's view is gone")
    checks.expect(probe.is_hidden(f"#plot-energy_J .legend > :nth-child({number + 1})"), "its legend is gone")
    after = probe.contender_pixels(number)
    checks.expect(after < before, "its line is gone from the plots", f"{before} and then {after} pixels")
    browser.click(box)
    probe.settle()
    checks.expect(probe.time_lines() == lines, "the time stands", f"{lines} and then {probe.time_lines()}")
    checks.expect(not probe.is_hidden(f"#viewports > :nth-child({number + 1})"), "it can be shown again")
    checks.expect(abs(probe.contender_pixels(number) - before) <= 0.02 * before, "its line is back in the plots")


def check_plot_drag(checks, browser, probe):
    probe.seek(0)
    end = browser.run("const report = window.polhodeReport; return report.end_s;")
    click, drag = [(0.25, 0.5)], [(0.25, 0.5), (0.5, 0.5), (0.75, 0.4)]
    for places, text in [(click, "a click in a plot"), (drag, "a drag in a plot")]:
        browser.drag("#plot-energy_J .u-over", *places)
        probe.settle()
        share = places[-1][0]
        distance = abs(probe.time() - share * end)
        # The nearest record, to a pixel of the mouse.
        allowed = end / probe.last() + 0.01 * end
        checks.expect(distance <= allowed, f"{text} moves the time there", f"{probe.time()} s of {end} s")
        value = browser.run("return Number(document.getElementById('scrubber').value);")
        checks.expect(value == probe.index() and (value > 0 or probe.last() < 4), f"{text} moves the slider", value)


def check_phone(checks, browser, probe, window):
    browser.resize(390, 844)
    probe.settle()
    width = browser.run("return document.documentElement.scrollWidth;")
    checks.expect(width <= 390, "390 pixels are wide enough for the page", f"{width} pixels")
    box = browser.run("const box = document.querySelector('.scroll-box'); return [box.clientWidth, box.scrollWidth];")
    checks.expect(box[0] < 390 and box[1] > box[0], "there the table scrolls in its own box", box)
    check_plots(checks, probe, " on a phone")
    browser.resize(*window)
    probe.settle()


def check_themes(checks, browser, probe, dark):
    background = "return getComputedStyle(document.body).backgroundColor;"
    before, picture = browser.run(background), probe.stage_picture()
    browser.set_dark(not dark)
    probe.settle()
    after = browser.run(background)
    checks.expect(before != after, "dark mode has another background", after)
    checks.expect(probe.stage_picture() != picture, "dark mode redraws the bodies")
    check_plots(checks, probe, " in the other theme")
    browser.set_dark(dark)
    probe.settle()


def check_quiet(checks, browser, probe):
    """Expects that the page so far has printed no complaints and made no requests."""
    complaints = probe.complaints()
    checks.expect(not complaints, "the console has no error and no warning", complaints)
    entries = browser.run("return performance.getEntriesByType('resource').map(entry => entry.name);")
    checks.expect(not entries, "the page loads no resource", entries)
    requests = probe.network_requests()
    checks.expect(not requests, "the page asks nothing of the network", requests)
    links = browser.run("return Array.from(document.querySelectorAll('[src], [href]'), e => e.getAttribute('src') ||"
                        " e.getAttribute('href')).filter(link => /^(https?:)?\\/\\//.test(link));")
    checks.expect(not links, "the page refers to no address", links)
    handlers = browser.run("return Array.from(document.querySelectorAll('*')).filter(e => Array.from(e.attributes)"
                           ".some(a => a.name.startsWith('on'))).map(e => e.outerHTML.slice(0, 60));")
    checks.expect(not handlers, "no element has a handler in its attributes", handlers)


def check_without_webgl(checks, path):
    with Browser(flags=["--disable-3d-apis"]) as browser:
        probe = PageProbe(browser)
        browser.open(path)
        checks.expect(wait_until(probe.is_ready, READY_WITHIN_S), "it is ready without WebGL", probe.text("#trouble"))
        checks.expect(not probe.is_hidden("#stage-missing"), "it says that WebGL is missing")
        check_plots(checks, probe, " without WebGL")
        checks.expect(not probe.complaints(), "the console is silent without WebGL")


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("report")
    parser.add_argument("--screenshot", metavar="OUT.png")
    parser.add_argument("--dark", action="store_true")
    parser.add_argument("--width", type=int, default=1280)
    parser.add_argument("--height", type=int, default=900)
    options = parser.parse_args()
    window = (options.width, options.height)

    checks = Checks()
    check_file(checks, options.report)
    with Browser(*window, options.dark) as browser:
        probe = PageProbe(browser)
        if check_opening(checks, browser, probe, options.report):
            check_plots(checks, probe)
            check_stage(checks, probe)
            check_scrubber(checks, browser, probe)
            check_keys(checks, browser, probe)
            check_playing(checks, browser, probe)
            check_hiding(checks, browser, probe)
            check_plot_drag(checks, browser, probe)
            if options.screenshot:
                with open(options.screenshot, "wb") as file:
                    file.write(browser.whole_page())
            check_phone(checks, browser, probe, window)
            check_themes(checks, browser, probe, options.dark)
        check_quiet(checks, browser, probe)
    check_without_webgl(checks, options.report)
    print(f"{checks.failed} checks failed" if checks.failed else "all checks passed")
    return 1 if checks.failed else 0


if __name__ == "__main__":
    sys.exit(main())
