#!/usr/bin/env python3
# Lessons in a real browser: pages.py FACET. Pages load without a complaint in both languages, sliders and switches
# change the canvas, and WebGL's numbers are those of `facet brdf eval`.
# SPDX-License-Identifier: MIT
# Needs Debian's chromium, chromium-driver and python3-selenium (scripts/packages.txt).
import math
import subprocess
import sys
import tempfile
from pathlib import Path

from selenium import webdriver
from selenium.webdriver.chrome.options import Options
from selenium.webdriver.chrome.service import Service

MODELS = {
    "": {},
    "distribution=beckmann": {"distribution": 1},
    "distribution=blinn-phong": {"distribution": 2},
    "masking=smith": {"masking": 1},
    "masking=schlick-direct,multiscatter=off": {"masking": 2, "multiscatter": 1},
    "fresnel=dielectric": {"fresnel": 1},
    "diffuse=burley": {"diffuse": 1},
    "diffuse=eon": {"diffuse": 2},
    "multiscatter=off": {"multiscatter": 1},
    "multiscatter=kulla-conty": {"multiscatter": 2},
}
DESK, PHONE = (1100, 900), (400, 800)  # px
failures = []


def expect(holds, what):
    if not holds:
        failures.append(what)
        print("FAILED:", what)


def run(facet, *words, folder=None, text=None):
    return subprocess.run([facet, *words], cwd=folder, input=text, capture_output=True, text=True, timeout=600)


def browser():
    options = Options()
    for flag in ("--headless=new", "--no-sandbox", "--disable-dev-shm-usage", "--use-angle=swiftshader",
                 "--enable-unsafe-swiftshader", f"--window-size={DESK[0]},{DESK[1]}"):
        options.add_argument(flag)
    options.binary_location = "/usr/bin/chromium"
    options.set_capability("goog:loggingPrefs", {"browser": "ALL"})
    driver = webdriver.Chrome(service=Service("/usr/bin/chromedriver"), options=options)
    driver.set_page_load_timeout(120)
    driver.set_script_timeout(120)
    return driver


def check_page(driver, path, language):
    name = f"{path.parent.name}/{path.name}"
    driver.get(path.as_uri())
    for entry in driver.get_log("browser"):
        expect(entry["level"] not in ("SEVERE", "WARNING"), f"{name}: {entry['message'][:300]}")
    expect(driver.execute_script("return document.documentElement.lang") == language, f"{name}: language")
    for width, height in (PHONE, DESK):
        driver.set_window_size(width, height)
        wide = driver.execute_script("return document.documentElement.scrollWidth - innerWidth")
        expect(wide <= 0, f"{name}: {wide} px wider than a window of {width}")
    broken = driver.execute_script("return [...document.images].filter(i => !i.naturalWidth || (!i.alt && !i.closest('.cards'))).length")
    expect(broken == 0, f"{name}: {broken} pictures do not show or have no text")
    if path.name == "index.html":
        expect(driver.execute_script("return document.querySelectorAll('.cards a').length") >= 1, f"{name}: no lessons")
        return
    sizes = driver.execute_script("return [...document.querySelectorAll('math')].map(m => m.getBoundingClientRect().height)")
    expect(sizes and min(sizes) > 5, f"{name}: formulas of height {sizes}")
    expect(driver.execute_script("return typeof window.facet") == "object", f"{name}: no canvas")


def check_canvas(driver, name):
    """Every slider that is shown, and every value of every switch, changes what the page draws or says."""
    state = "facet.show(); return document.querySelector('canvas.ball').toDataURL() + document.querySelector('canvas.curve').toDataURL() + document.querySelector('table.values').textContent"
    sliders = driver.execute_script("return [...document.querySelectorAll('#live input')].map(i => [i.name, +i.min, +i.max, +i.value])")
    before = driver.execute_script(state)
    for slider, low, high, value in sliders:
        near = abs(low + 0.37 * (high - low) - value) < 0.1 * (high - low)
        driver.execute_script("""const i = document.querySelector(`#live input[name=${arguments[0]}]`);
            i.value = arguments[1]; i.dispatchEvent(new Event('input'))""",
                              slider, low + (0.61 if near else 0.37) * (high - low))
        after = driver.execute_script(state)
        expect(after != before, f"{name}: slider {slider} changes nothing")
        before = after
    for button in range(driver.execute_script("return document.querySelectorAll('#live .models button').length")):
        driver.execute_script("document.querySelectorAll('#live .models button')[arguments[0]].click()", button)
        after = driver.execute_script(state)
        expect(button == 0 or after != before, f"{name}: model {button} changes nothing")
        before = after


def check_numbers(driver, facet):
    """The probe against `facet brdf eval`: 1/255 of the value or of 1, as the larger is."""
    terms = ["D", "G", "V", "F", "specular", "diffuse", "full"]
    worst = 0.0
    surfaces = [(r, m, f0, v, l) for r in (0.2, 0.5, 1.0) for m in (0.0, 0.6, 1.0) for f0 in (0.04, 0.3)
                for v, l in ((20, 50), (70, 60), (45, 10))]
    for model, chosen in MODELS.items():
        rows, seen = ["term,model,roughness,metallic,f0,n_dot_v,n_dot_l,phi"], []
        # Every number takes a frame, seconds without a GPU: the default model at every fifth (all roughnesses, metals, F0 and
        # directions come up), the others at three.
        for r, m, f0, v, l in surfaces[::5] if model == "" else surfaces[::18]:
            values = driver.execute_script("""
                facet.take(0); for (const [slot, index] of Object.entries(arguments[0])) facet.choose(slot, index);
                const [r, m, f0, v, l] = arguments[1];
                for (const [n, x] of Object.entries({roughness: r, metallic: m, f0, base: 1, view_deg: v, light_deg: l, azimuth_deg: 0})) facet.set(n, x);
                return facet.values()""", chosen, [r, m, f0, v, l])
            for term in terms:
                rows.append(f"{term},{model.replace(',', ';')},{r},{m},{f0},{math.cos(math.radians(v))},{math.cos(math.radians(l))},180")
                seen.append(values[term])
        asked = run(facet, "brdf", "eval", "--input", "-", text="\n".join(rows) + "\n")
        expect(asked.returncode == 0, f"brdf eval {model}: {asked.stderr}")
        for row, line, value in zip(rows[1:], asked.stdout.splitlines()[1:], seen):
            truth = float(line.split(",")[-3])
            off = abs(truth - value) / max(1.0, abs(truth))
            worst = max(worst, off)
            expect(off <= 1 / 255, f"{row}: WebGL {value}, brdf eval {truth}")
    print(f"largest difference of WebGL and brdf eval: {worst:.2g} (at most {1 / 255:.2g})")


def check_furnace(driver):
    """In the white furnace a white ball of the default model is the background; the lecture's is not."""
    driver.execute_script("facet.take(0); facet.furnace(true); for (const [n, x] of Object.entries({base: 1, metallic: 1, roughness: 0.8})) facet.set(n, x)")
    corner, middle = driver.execute_script("return [facet.pixel(0.02, 0.02), facet.pixel(0.5, 0.5)]")
    expect(max(abs(a - b) for a, b in zip(corner, middle)) <= 2, f"furnace: {corner} beside {middle}")
    driver.execute_script("facet.choose('multiscatter', 1)")
    middle = driver.execute_script("return facet.pixel(0.5, 0.5)")
    expect(corner[0] - middle[0] > 20, f"furnace without compensation: {corner} beside {middle}")


def main(facet):
    with tempfile.TemporaryDirectory() as temporary:
        english, russian = Path(temporary) / "en", Path(temporary) / "ru"
        # Those whose parts differ (their pictures take the time): lessons.unit reads all, commands.cli runs the commands of all.
        made = run(facet, "teach", "-o", str(english), "-q", "cook-torrance", "fresnel", "geometry", "half-vector", "layers",
                   "light", "specular-gloss")
        expect(made.returncode == 0, made.stderr)
        size = sum(f.stat().st_size for f in english.iterdir())
        expect(size < 25e6, f"{size} bytes in all")
        made = run(facet, "teach", "-o", str(russian), "-q", "--lang", "ru", "energy", "geometry")
        expect(made.returncode == 0, made.stderr)
        kept = run(facet, "teach", "energy", "-o", str(russian))
        expect(kept.returncode == 2 and "not empty" in kept.stderr, f"a full folder: {kept.stderr}")
        driver = browser()
        try:
            for folder, language in ((english, "en"), (russian, "ru")):
                for page in sorted(folder.glob("*.html")):
                    check_page(driver, page, language)
                    if language == "en" and page.stem in ("cook-torrance", "geometry", "half-vector", "light"):
                        check_canvas(driver, page.stem)
                    if language == "en" and page.stem == "cook-torrance":
                        check_numbers(driver, facet)
                        check_furnace(driver)
        finally:
            driver.quit()
    print(f"{len(failures)} failures")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1]))
