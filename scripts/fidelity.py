#!/usr/bin/env python3
# Prints how far the raster frame is from the reference, and how long both take: docs/fidelity.md holds the last tables.
# SPDX-License-Identifier: MIT
# fidelity.py [qualities|lights|equal] [--samples N] [--size WxH]; needs build/facet, and python3-numpy and
# python3-openimageio for `equal`.
#   qualities  each --quality on every bundled scene (2,048 samples: 20 minutes on 2 cores)
#   lights     every kind of light alone, `final`, on showcase
#   equal      `final` and the reference at the same error, under the studio
import argparse
import json
import statistics
import subprocess
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
QUALITIES = ["draft", "standard", "final"]
ALONE = ["--env", "black", "--exposure", "1", "--no-file-lights"]
LIGHTS = {
    "studio": ["--env", "studio", "--no-file-lights"],
    "sky": ["--env", "sky", "--no-file-lights"],
    "sun alone": [*ALONE, "--light", "directional:azimuth=60,elevation=40,lux=3"],
    "file's own": ["--env", "black"],
}
SCENES = ["furnace", "spheres", "showcase", "cornell", "ball", "relief"]
OWN_LIGHT_ALONE = ["subsurface"]  # its paths are long: one row
AT = "position=1.6 2.6 2.2"
AIMED = f"{AT},target=0 0.5 0"
KINDS = {
    "point": f"point:{AT},candela=30",
    "spot": f"spot:{AIMED},candela=30,inner=15,outer=25",
    "IES": f"ies:file=builtin:downlight,candela=30,{AIMED}",
    "rect": f"rect:{AIMED},nit=60,width=1,height=0.5",
    "disk": f"disk:{AIMED},nit=40,radius=0.5",
    "sphere": f"sphere:{AT},nit=60,radius=0.4",
    "tube": f"tube:{AIMED},nit=150,width=1.5,radius=0.05",
    "sun": "directional:azimuth=60,elevation=40,lux=3",
    "sun of 10 degrees": "directional:azimuth=60,elevation=40,lux=3,angle=10",
}


def run(facet, arguments, ok=(0,)):
    out = subprocess.run([facet, *arguments], capture_output=True, text=True)
    if out.returncode not in ok:
        raise SystemExit(out.stderr)
    return json.loads(out.stdout.splitlines()[0])


def render(options, scene, light, output, more):
    command = ["render", f"builtin:{scene}", "--size", options.size, "--tonemap", "none", "--background", "none"]
    return run(options.facet, [*command, "--depth", "16", "--json", "-q", *light, *more, "-o", str(output)])


def seconds(drawn):
    return drawn["ms"]["render"] / 1000


def fixed_exposure(options, scene, light, picture):
    if "--exposure" in light:
        return light
    return [*light, "--exposure", repr(render(options, scene, light, picture, ["--quality", "standard"])["exposure"])]


def rmse(options, truth, picture):
    return run(options.facet, ["diff", str(truth), str(picture), "--mask", "--json"])["rmse"]


def row(*cells):
    print("|", " | ".join(cells), "|", flush=True)


def head(*cells):
    row(*cells)
    row(*["---"] * len(" | ".join(cells).split(" | ")))  # a cell may be two columns


def qualities(options, folder):
    truth, picture = folder / "truth.png", folder / "picture.png"
    head("scene", "light", *(f"{q}, RMSE | s" for q in QUALITIES), "reference's noise | s")
    errors = {quality: [] for quality in QUALITIES}
    for scene in [*SCENES, *OWN_LIGHT_ALONE]:
        listed = run(options.facet, ["info", f"builtin:{scene}", "--json"])["lights"]
        for name, light in LIGHTS.items():
            if name == "file's own" and not listed or name != "file's own" and scene in OWN_LIGHT_ALONE:
                continue
            fixed = fixed_exposure(options, scene, light, picture)
            report = render(options, scene, fixed, truth, ["--reference", str(options.samples)])["reference"]
            cells = []
            for quality in QUALITIES:
                drawn = render(options, scene, fixed, picture, ["--quality", quality])
                errors[quality].append(rmse(options, truth, picture))
                cells.append(f"{errors[quality][-1]:.4f} | {seconds(drawn):.2f}")
            row(scene, name, *cells, f"{report['noise']:.4f} | {report['trace_s']:.1f}")
    row("median", "", *(f"{statistics.median(errors[q]):.4f} | " for q in QUALITIES), "|")


def lights(options, folder):
    truth, picture = folder / "truth.png", folder / "picture.png"
    head("light alone", "final, RMSE", "s", "reference's noise")
    for name, spec in KINDS.items():
        light = [*ALONE, "--light", spec]
        noise = render(options, "showcase", light, truth, ["--reference", str(options.samples)])["reference"]["noise"]
        drawn = render(options, "showcase", light, picture, ["--quality", "final"])
        row(name, f"{rmse(options, truth, picture):.4f}", f"{seconds(drawn):.1f}", f"{noise:.4f}")


def equal(options, folder):
    """Two references of `samples` with other random numbers tell their own error, which falls as one over the root of the
    samples, and together that of a picture without theirs in it: the mean of (picture - one) (picture - other)."""
    import numpy
    import OpenImageIO

    def load(path):
        pixels = OpenImageIO.ImageBuf(str(path)).get_pixels(OpenImageIO.FLOAT).astype(float)
        return pixels[..., :3] * pixels[..., 3:], pixels[..., 3] > 0

    head("scene", "final, RMSE", "s", "reference of that error", "s", "ratio")
    ratios = []
    for scene in SCENES:
        picture = folder / "picture.png"
        light = fixed_exposure(options, scene, LIGHTS["studio"], picture)
        halves, spent_s = [], 0.0
        for seed in ("1", "2"):
            truth = folder / f"truth{seed}.png"
            more = ["--reference", str(options.samples), "--seed", seed]
            spent_s += render(options, scene, light, truth, more)["reference"]["trace_s"] / 2
            halves.append(load(truth))
        drawn = render(options, scene, light, picture, ["--quality", "final"])
        (one, covered), (other, _), (drawn_pixels, drawn_covered) = *halves, load(picture)
        mask = covered | drawn_covered
        of_reference = numpy.mean((one - other)[mask] ** 2) / 2
        of_picture = numpy.mean(((drawn_pixels - one) * (drawn_pixels - other))[mask])
        times = of_reference / of_picture
        ratios.append(times * spent_s / seconds(drawn))
        row(scene, f"{of_picture**0.5:.4f}", f"{seconds(drawn):.0f}", f"{times * options.samples:.0f} samples",
            f"{times * spent_s:.0f}", f"1 : {ratios[-1]:.1f}")
    row("median", "", "", "", "", f"1 : {statistics.median(ratios):.1f}")


def main():
    tables = {"qualities": (qualities, 2048, "320x180"), "lights": (lights, 2048, "320x180"),
              "equal": (equal, 192, "1280x720")}
    parser = argparse.ArgumentParser(description="How far the raster frame is from the reference.")
    parser.add_argument("table", nargs="?", choices=tables, default="qualities")
    parser.add_argument("--samples", type=int)
    parser.add_argument("--size")
    parser.add_argument("--facet", default=str(ROOT / "build" / "facet"))
    options = parser.parse_args()
    of, samples, size = tables[options.table]
    options.samples = options.samples or samples
    options.size = options.size or size
    with tempfile.TemporaryDirectory() as folder:
        of(options, Path(folder))


if __name__ == "__main__":
    main()
