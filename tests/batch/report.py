"""The contact sheet in a real Chromium: what it shows, finds, sorts and enlarges.

    report.py FACET"""
# SPDX-License-Identifier: MIT
import json
import shutil
import sys
import tempfile
import time
from pathlib import Path

from selenium import webdriver
from selenium.webdriver.chrome.options import Options
from selenium.webdriver.chrome.service import Service
from selenium.webdriver.common.keys import Keys
from selenium.webdriver.support.ui import Select

from kit import check, run


def browser():
    options = Options()
    for flag in ("--headless=new", "--no-sandbox", "--disable-gpu", "--disable-dev-shm-usage", "--window-size=1200,900"):
        options.add_argument(flag)
    options.binary_location = shutil.which("chromium")
    options.set_capability("goog:loggingPrefs", {"browser": "ALL"})
    return webdriver.Chrome(service=Service(shutil.which("chromedriver")), options=options)


def make(facet, folder):
    """A sheet of six items: four that changed or not against a baseline, one that failed, one that is new."""
    def job(roughness):
        return {
            "facet": 1, "output": "out/{scene}-{index}.png",
            "defaults": {"size": [320, 240], "samples": 1, "env": "overcast"},
            "items": [
                {"scene": "builtin:spheres", "camera": ["auto", "orbit:azimuth=90"]},
                {"scene": "builtin:ball", "set": {"material.*.roughness": roughness}},
                {"scene": "no-such-file <script>alert(1)</script>.glb"},
            ],
        }
    path = folder / "job <b>.json"
    path.write_text(json.dumps(job([0.1, 0.9])))
    run(facet, "batch", path, "-q", code=1)
    (folder / "good").mkdir()
    shutil.move(folder / "out", folder / "good/out")
    changed = job([0.1, 0.3, 0.5])
    path.write_text(json.dumps(changed))
    run(facet, "batch", path, "-q", "--baseline", folder / "good", "--max-flip", "0.001", "--report", folder / "sheet.html", code=1)
    return folder / "sheet.html"


def main():
    facet = Path(sys.argv[1]).resolve()
    with tempfile.TemporaryDirectory() as scratch:
        page = make(facet, Path(scratch))
        text = page.read_text()
        check("http://" not in text.replace("http://www.w3.org", "") and "https://" not in text, "the page needs nothing else")
        driver = browser()
        try:
            driver.get(page.as_uri())
            find = lambda css: driver.find_elements("css selector", css)
            names = lambda: [card.find_element("css selector", ".name").text for card in find(".card")]
            check(len(find(".card")) == 6, f"six cards: {names()}")
            check("job <b>.json" in driver.find_element("id", "title").text, "the job's name, as text")
            states = sorted(card.get_attribute("class").split()[-1] for card in find(".card"))
            check(states == ["changed", "failed", "new", "same", "same", "same"], f"states: {states}")
            shown = [image for image in find(".card img") if image.get_property("naturalWidth") > 100]
            check(len(shown) == 5, f"five pictures are there: {len(shown)}")
            # Sorted by change: the changed one first.
            check("failed" in find(".card")[0].get_attribute("class"), "what failed first")
            check("changed" in find(".card")[1].get_attribute("class"), "then what changed most")
            Select(driver.find_element("id", "sort")).select_by_value("name")
            check(names() == sorted(names()), f"by name: {names()}")
            search = driver.find_element("id", "search")
            search.send_keys("roughness=0.3")
            check(names() == ["ball-3.png"], f"found by a setting: {names()}")
            search.send_keys(Keys.BACKSPACE * len("roughness=0.3"))
            check(len(find(".card")) == 6, "all again")
            next(button for button in find("#states button") if button.text == "same").click()
            check(len(find(".card")) == 3, f"without those that are the same: {names()}")
            # The zoom of what changed: picture at full size, baseline, difference.
            next(card for card in find(".card") if "changed" in card.get_attribute("class")).click()
            large = driver.find_element("id", "large")

            def wait_for(width):
                end = time.time() + 10
                while large.get_property("naturalWidth") != width:
                    check(time.time() < end, f"a picture {width} wide: {large.get_property('naturalWidth')}")
                    time.sleep(0.05)

            wait_for(320)
            check(large.get_attribute("src").startswith("file:"), "the file itself")
            for name in ("Baseline", "Difference"):
                next(button for button in find("#views button") if button.text == name).click()
                wait_for(320)
            detail = driver.find_element("id", "detail").text
            for word in ("FLIP", "facet render builtin:ball", "roughness=0.3", "peak memory", "SHA-256"):
                check(word in detail, f"{word} in {detail}")
            first = driver.find_element("id", "zoom-name").text
            driver.find_element("id", "zoom").send_keys(Keys.ARROW_RIGHT)
            check(driver.find_element("id", "zoom-name").text != first, "the arrow key goes on")
            driver.find_element("id", "close").click()
            check(not driver.find_element("id", "zoom").is_displayed(), "closed")
            failed = next(card for card in find(".card") if "failed" in card.get_attribute("class"))
            check("No such file" in failed.text, f"the error is told: {failed.text}")
            driver.set_window_size(400, 800)
            width = driver.execute_script("return document.documentElement.scrollWidth - document.documentElement.clientWidth")
            check(width <= 0, f"a phone scrolls sideways by {width}")
            messages = [entry["message"] for entry in driver.get_log("browser")]
            check(not messages, f"console: {messages}")
        finally:
            driver.quit()
    print("ok")


main()
