"""Chromium without a screen, driven as a reader would: pages of several widths, light and dark."""
import importlib.util
import os
import shutil
import sys
import time
from pathlib import Path

DEBIAN_PYTHON = "/usr/bin/python3"
SKIP = 77


def need():
    """Leaves the test, saying why, where there is no browser to drive."""
    if importlib.util.find_spec("selenium") is None:
        # Debian's package is for Debian's own interpreter.
        if os.path.exists(DEBIAN_PYTHON) and sys.executable != DEBIAN_PYTHON and "PLUMBLINE_AGAIN" not in os.environ:
            os.execve(DEBIAN_PYTHON, [DEBIAN_PYTHON, *sys.argv], {**os.environ, "PLUMBLINE_AGAIN": "yes"})
        leave("python3-selenium is not installed")
    for program in ("chromium", "chromedriver"):
        if shutil.which(program) is None:
            leave(f"{program} is not installed")
    from selenium.common.exceptions import WebDriverException
    try:
        with Browser() as window:
            draws = window.run("return document.createElement('canvas').getContext('webgl') !== null")
    except WebDriverException as error:
        leave(f"Chromium does not start: {str(error).splitlines()[0]}", "")
    if not draws:
        leave("Chromium draws nothing in space (WebGL) on this machine", "")


def leave(why, remedy="; scripts/setup --with-browser installs it"):
    print(f"this test is skipped: {why}{remedy}")
    sys.exit(SKIP)


class Browser:
    """One window; a context manager."""

    def __init__(self):
        from selenium import webdriver
        from selenium.webdriver.chrome.options import Options
        from selenium.webdriver.chrome.service import Service

        options = Options()
        for argument in ("--headless=new", "--no-sandbox", "--disable-dev-shm-usage", "--use-gl=angle",
                         "--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--ignore-gpu-blocklist",
                         "--disable-background-networking", "--hide-scrollbars"):
            options.add_argument(argument)
        options.set_capability("goog:loggingPrefs", {"browser": "ALL", "performance": "ALL"})
        self.driver = webdriver.Chrome(service=Service(shutil.which("chromedriver")), options=options)
        self.driver.set_script_timeout(120)  # a processor that draws for a graphics card may be busy

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.driver.quit()

    def shape(self, width, height=900, theme="light"):
        self.driver.execute_cdp_cmd("Emulation.setDeviceMetricsOverride",
                                    {"width": width, "height": height, "deviceScaleFactor": 1, "mobile": width < 600})
        self.driver.execute_cdp_cmd("Emulation.setEmulatedMedia",
                                    {"features": [{"name": "prefers-color-scheme", "value": theme}]})

    def open(self, page, patience_s=60):
        """Loads a file from the disk; the seconds until it was built and had drawn its first picture."""
        self.messages()
        self.requests()
        begin = time.monotonic()
        self.driver.get(Path(page).resolve().as_uri())
        while not self.run("return document.documentElement.dataset.built === 'yes'"):
            if time.monotonic() - begin > patience_s or self.messages(keep=True):
                raise AssertionError(f"{page} was not built: {self.messages()}")
            time.sleep(0.05)
        self.run_async("requestAnimationFrame(() => requestAnimationFrame(arguments[0]))")
        return time.monotonic() - begin

    def run(self, script, *arguments):
        return self.driver.execute_script(script, *arguments)

    def run_async(self, script):
        return self.driver.execute_async_script(script)

    def messages(self, keep=False):
        """What the console said since the last call, warnings of the graphics driver left out."""
        self.kept = getattr(self, "kept", []) + [
            entry["message"] for entry in self.driver.get_log("browser")
            if not any(driver in entry["message"] for driver in ("GPU stall", "GL Driver Message", "swiftshader"))]
        said = self.kept
        if not keep:
            self.kept = []
        return said

    def requests(self):
        """Addresses that were asked for since the last call."""
        import json
        asked = []
        for entry in self.driver.get_log("performance"):
            message = json.loads(entry["message"])["message"]
            if message["method"] == "Network.requestWillBeSent":
                asked.append(message["params"]["request"]["url"])
        return asked

    def print_pdf(self):
        import base64
        return base64.b64decode(self.driver.execute_cdp_cmd("Page.printToPDF", {"printBackground": True, "preferCSSPageSize": True})["data"])

    def press(self, element, *keys):
        element.send_keys(*keys)

    def find(self, selector):
        return self.driver.find_elements("css selector", selector)
