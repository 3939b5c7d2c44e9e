#!/usr/bin/env python3
"""Thumbnails of a model library: `facet batch` (without rays: the others have none) beside f3d, one process a picture, and three.js in one reused page.

    tests/bench/thumbnails.py FACET MODELS HDRI [--three FOLDER] [--rounds N]

100 pictures at 256x256 of the models below MODELS that all programs read, from three sides. Rates are pictures a minute, medians
of the rounds; f3d and three.js render a part of the pictures. Needs Debian's f3d and xvfb; for three.js chromium,
chromium-driver, python3-selenium and an unpacked npm package (npm pack three)."""
# SPDX-License-Identifier: MIT
import argparse
import base64
import functools
import http.server
import json
import os
import shutil
import statistics
import subprocess
import sys
import tempfile
import threading
import time
from pathlib import Path

SIDES_DEG = (35, 125, 250)
PICTURES = 100


def make_job(folder, models, env, name):
    items = []
    for number, model in enumerate(models):
        sides = [SIDES_DEG[i] for i in range(3) if i * len(models) + number < PICTURES]
        items.append({"scene": str(model), "camera": [f"orbit:azimuth={side},elevation=15" for side in sides]})
    job = {"facet": 1, "output": name + "/{folder}-{index:03}.png", "defaults": {"size": [256, 256], "env": env, "shadows": "off"}, "items": items}
    path = folder / f"{name}.json"
    path.write_text(json.dumps(job))
    return path


def facet_rate(facet, job, roots, workers, rounds):
    """Pictures a minute, and the largest worker in MB."""
    seconds, peak = [], 0
    for _ in range(rounds + 1):
        start = time.perf_counter()
        done = subprocess.run([facet, "batch", job, "--restart", "--jobs", str(workers), "--threads", "1", "--json", "-q",
                               *[word for root in roots for word in ("--allow-read", root)]], capture_output=True, text=True)
        seconds.append(time.perf_counter() - start)
        if done.returncode:
            raise SystemExit(done.stderr)
        lines = [json.loads(line) for line in done.stdout.splitlines()]
        peak = max(peak, max(line["peak_rss"] for line in lines[:-1]))
        count = lines[-1]["done"]
    # The first round fills the shader cache.
    return 60.0 * count / statistics.median(seconds[1:]), peak / 1e6


def f3d_rate(models, hdri, count, folder):
    """Pictures a minute; a model that it hangs on counts neither way."""
    taken, made = 0.0, 0
    for number in range(count):
        look = ["--hdri", str(hdri)] if hdri else []
        start = time.perf_counter()
        try:
            subprocess.run(["f3d", str(models[number % len(models)]), "--output", str(folder / f"f3d-{number}.png"), "--resolution",
                            "256,256", *look, "-t", "-q", "-a"], capture_output=True, timeout=20)
        except subprocess.TimeoutExpired:
            continue
        taken += time.perf_counter() - start
        made += 1
    return 60.0 * made / taken


PAGE = """<!doctype html><meta charset="utf-8"><script type="importmap">
{"imports": {"three": "/three/build/three.module.js", "three/addons/": "/three/examples/jsm/"}}</script>
<script type="module">
import * as THREE from 'three';
import { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js';
import { RGBELoader } from 'three/addons/loaders/RGBELoader.js';
const renderer = new THREE.WebGLRenderer({ antialias: true, preserveDrawingBuffer: true });
renderer.setSize(256, 256);
renderer.toneMapping = THREE.ACESFilmicToneMapping;
document.body.append(renderer.domElement);
const sky = await new RGBELoader().loadAsync('/env.hdr');
sky.mapping = THREE.EquirectangularReflectionMapping;
const environment = new THREE.PMREMGenerator(renderer).fromEquirectangular(sky).texture;
const loader = new GLTFLoader();
window.picture = async (url, azimuth) => {
  const scene = new THREE.Scene();
  scene.environment = scene.background = environment;
  const gltf = await loader.loadAsync(url);
  scene.add(gltf.scene);
  const box = new THREE.Box3().setFromObject(gltf.scene), center = box.getCenter(new THREE.Vector3());
  const radius = box.getSize(new THREE.Vector3()).length() / 2 || 1, distance = radius / Math.sin(Math.PI / 12);
  const camera = new THREE.PerspectiveCamera(30, 1, radius / 100, distance * 4);
  const a = azimuth * Math.PI / 180, e = 15 * Math.PI / 180;
  camera.position.set(Math.sin(a) * Math.cos(e), Math.sin(e), Math.cos(a) * Math.cos(e)).multiplyScalar(distance).add(center);
  camera.lookAt(center);
  renderer.render(scene, camera);
  const data = renderer.domElement.toDataURL('image/png');
  gltf.scene.traverse((o) => { if (o.geometry) o.geometry.dispose();
    for (const m of [o.material].flat()) if (m) { for (const t of Object.values(m)) if (t && t.isTexture) t.dispose(); m.dispose(); } });
  return data;
};
window.ready = true;
</script>"""


def three_rate(three, models, hdri, count, folder):
    from selenium import webdriver
    from selenium.webdriver.chrome.options import Options
    from selenium.webdriver.chrome.service import Service

    root = folder / "web"
    root.mkdir()
    (root / "index.html").write_text(PAGE)
    (root / "three").symlink_to(Path(three).resolve())
    (root / "models").symlink_to(models[0].parent.parent)
    shutil.copy(hdri, root / "env.hdr")

    class Quiet(http.server.SimpleHTTPRequestHandler):
        def log_message(self, *_):
            pass

    server = http.server.ThreadingHTTPServer(("127.0.0.1", 0), functools.partial(Quiet, directory=root))
    threading.Thread(target=server.serve_forever, daemon=True).start()
    options = Options()
    for flag in ("--headless=new", "--no-sandbox", "--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader"):
        options.add_argument(flag)
    options.binary_location = shutil.which("chromium")
    driver = webdriver.Chrome(service=Service(shutil.which("chromedriver")), options=options)
    try:
        driver.set_script_timeout(120)
        driver.get(f"http://127.0.0.1:{server.server_port}/index.html")
        while not driver.execute_script("return window.ready === true"):
            time.sleep(0.05)
        draw = ("const done = arguments[arguments.length - 1];"
                "picture(arguments[0], arguments[1]).then(done, (e) => done('error ' + e));")
        failed = 0
        start = time.perf_counter()
        for number in range(count):
            model = models[number % len(models)]
            url = "/models/" + str(model.relative_to(models[0].parent.parent))
            data = driver.execute_async_script(draw, url, SIDES_DEG[number // len(models) % 3])
            if data.startswith("data:"):
                (folder / f"three-{number}.png").write_bytes(base64.b64decode(data.split(",")[1]))
            else:
                failed += 1
        return 60.0 * (count - failed) / (time.perf_counter() - start), failed
    finally:
        driver.quit()
        server.shutdown()


def main():
    arguments = argparse.ArgumentParser()
    arguments.add_argument("facet")
    arguments.add_argument("models", type=Path)
    arguments.add_argument("hdri", type=Path)
    arguments.add_argument("--three")
    arguments.add_argument("--rounds", type=int, default=3)
    options = arguments.parse_args()
    models = [path for path in sorted(options.models.resolve().glob("*/*.gl[bt]*")) if path.suffix in (".glb", ".gltf")]
    with tempfile.TemporaryDirectory() as scratch:
        folder = Path(scratch)
        usable = [path for path in models
                  if subprocess.run([options.facet, "render", path, "--size", "8x8", "--samples", "1", "-o", folder / "x.png", "-q"],
                                    capture_output=True).returncode == 0]
        result = {"facet": 1, "models": len(usable), "pictures": PICTURES}
        roots = [options.models.resolve(), options.hdri.resolve().parent]
        with_hdri = make_job(folder, usable, str(options.hdri.resolve()), "hdri")
        plain = make_job(folder, usable, "studio", "plain")
        for name, job in (("hdri", with_hdri), ("plain", plain)):
            for workers in (1, 2):
                result[f"{name}_{workers}"], peak = facet_rate(options.facet, job, roots, workers, options.rounds)
                result["peak_mb"] = max(result.get("peak_mb", 0.0), peak)
            result[f"{name}_scaling"] = result[f"{name}_2"] / result[f"{name}_1"] / 2
        print(json.dumps(result), file=sys.stderr)
        if shutil.which("f3d") and shutil.which("xvfb-run"):
            screen = subprocess.Popen(["Xvfb", ":87", "-screen", "0", "640x480x24"], stderr=subprocess.DEVNULL)
            os.environ["DISPLAY"] = ":87"
            time.sleep(1)
            result["f3d_hdri"] = f3d_rate(usable, options.hdri.resolve(), 18, folder)
            result["f3d_plain"] = f3d_rate(usable, None, len(usable), folder)
            screen.terminate()
            del os.environ["DISPLAY"]
            print(json.dumps(result), file=sys.stderr)
            result["times_f3d_hdri"] = result["hdri_2"] / result["f3d_hdri"]
            result["times_f3d_plain"] = result["plain_2"] / result["f3d_plain"]
        if options.three:
            result["three"], result["three_failed"] = three_rate(options.three, usable, options.hdri.resolve(), PICTURES, folder)
            result["times_three"] = result["hdri_2"] / result["three"]
    print(json.dumps({key: round(value, 2) for key, value in result.items()}))


main()
