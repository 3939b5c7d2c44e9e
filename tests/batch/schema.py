"""The JSON Schema of job files against the reader itself: both take, or both refuse.

    schema.py FACET SOURCE_FOLDER"""
# SPDX-License-Identifier: MIT
import json
import sys
import tempfile
from pathlib import Path

import jsonschema

from kit import check, run

BALL = {"scene": "builtin:ball"}


def job(item, **more):
    return {"facet": 1, "output": "{index}.png", "items": [{**BALL, **item}], **more}


GOOD = [
    job({}),
    job({}, **{"$schema": "job.schema.json"}),
    {"facet": 1, "defaults": {**BALL, "output": "a{index}.png"}, "items": [{}, {"samples": 2}]},
    job({"size": [64, 32]}), job({"size": "64x32"}), job({"size": [[64, 32], "16x16"]}),
    job({"samples": 4}), job({"samples": "4"}), job({"samples": [1, 2]}), job({"samples": {"random": [1, 9], "count": 2}}),
    job({"env": ["studio", "sky"]}), job({"env_rotation": [0, 90.5]}), job({"env_rotation": {"random": [0, 1], "seed": 3}}),
    job({"exposure": 1}), job({"exposure": "auto"}), job({"ev": -3.5}), job({"ev": [1, 2]}),
    job({"no_file_lights": True}), job({"no_file_lights": [True, False]}), job({"strict": 1}),
    job({"light": ["point:candela=1"]}), job({"light": "point:candela=1"}), job({"light": [["point:candela=1"], []]}),
    job({"aov": ["depth", "normal"]}), job({"aov": "all"}), job({"aov_format": "npy"}),
    job({"quality": "draft"}), job({"quality": ["draft", "final"]}), job({"depth": 16}),
    job({"camera": "auto"}), job({"camera": {"sphere": 3, "elevation": [0, 45], "distance": 2, "target": [0, 1, 0]}}),
    job({"set": {"material.*.roughness": [0.1, 0.9], "material.*.base_color": [1, 0, 0]}}),
    job({"set": {"material.*.base_color": [[1, 0, 0], "#ff0000"]}}), job({"set": ["material.*.roughness=1"]}),
    job({"set": [{"material.*.roughness": 0}, {"material.*.metallic": 1}]}),
    job({"set": {"material.*.roughness": {"random": [0, 1], "count": 4}}}),
    job({"material": ["*=gold"]}), job({"frames": {"orbit": 12}}),
    {"facet": 1, "output": "{scene}.png", "items": [{"scene": ["builtin:ball", "builtin:spheres"]}]},
    job({}, data_set="set"),
]
BAD = [
    [], "a job", {}, {"facet": 1}, job({}, facet=2), {"output": "a.png", "items": [BALL]},
    {"facet": 1, "output": "a.png", "items": []}, {"facet": 1, "output": "a.png", "items": {}},
    {"facet": 1, "output": "a.png", "items": [{}]}, {"facet": 1, "items": [BALL]}, {"facet": 1, "output": "", "items": [BALL]},
    job({"samplse": 4}), job({}, itmes=1), job({"samples": -1}), job({"samples": 5000}), job({"samples": 1.5}),
    job({"samples": "many"}), job({"samples": None}), job({"samples": {"random": [1]}}), job({"samples": {"count": 3}}),
    job({"samples": {"random": [1, 2], "cuont": 3}}), job({"size": [64]}), job({"size": "64"}), job({"size": [0, 4]}),
    job({"scene": 4}), job({"scene": [4]}), job({"env_rotation": "north"}), job({"env_rotation": 1e5}),
    job({"no_file_lights": "yes"}), job({"quality": "best"}), job({"depth": 12}), job({"aov_format": "exr"}),
    job({"light": [3]}), job({"light": {"point": 1}}), job({"set": {"material.*.roughness": None}}),
    job({"set": {"material.*.roughness": {"low": 0}}}), job({"set": 3}),
    job({"frames": {"orbit": 0}}), job({"frames": {"orbits": 3}}), job({"frames": 36}), job({"frames": {}}),
    job({"camera": {"sphere": 0}}), job({"camera": {"shpere": 3}}), job({"camera": {"sphere": 3, "distance": 0}}),
    job({"allow_read": ["/"]}), job({}, data_set=3), job({}, output=3),
]


def main():
    facet, source = Path(sys.argv[1]).resolve(), Path(sys.argv[2])
    schema = json.loads((source / "resources/job.schema.json").read_text())
    jsonschema.Draft7Validator.check_schema(schema)
    validator = jsonschema.Draft7Validator(schema)
    with tempfile.TemporaryDirectory() as scratch:
        path = Path(scratch) / "job.json"
        for is_good, jobs in ((True, GOOD), (False, BAD)):
            for one in jobs:
                path.write_text(json.dumps(one))
                done = run(facet, "batch", path, "--dry-run")
                text = json.dumps(one)
                check((done.returncode == 0) == is_good, f"the reader: {text}\n{done.stderr}")
                errors = [error.message for error in validator.iter_errors(one)]
                check((not errors) == is_good, f"the schema: {text}\n{errors}")
    print(f"ok: {len(GOOD)} jobs that both take, {len(BAD)} that both refuse")


main()
