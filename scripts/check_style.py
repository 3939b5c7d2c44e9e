#!/usr/bin/env python3
# Holds the sources to the habits a machine can judge: clang-format, first lines, length. Prints every breach.
# SPDX-License-Identifier: MIT
import re
import shutil
import subprocess
import sys
from pathlib import Path

MOST_LINES = 400      # fails
MANY_LINES = 300      # is reported: which second thing does the file do?
LICENCE = "SPDX-License-Identifier: MIT"
WANTED_CLANG_FORMAT = " 14."  # Debian 12's; other versions break lines elsewhere
CODE = {".cpp", ".h"}
SHADERS = {".glsl", ".vert", ".frag", ".comp"}


def files_of(root):
    for top in ("src", "tests", "glsl"):
        for path in sorted((root / top).rglob("*")):
            if path.suffix in CODE | SHADERS | {".def"} and path.is_file():
                yield path


def check_heads(path, lines):
    if not lines or not lines[0].startswith("// ") or len(lines[0]) < 12:
        yield f"{path}:1: the first line says in one sentence what the file is"
    # A term's whole text is compiled into other files, and a table's rows are: neither is a unit of its own.
    if path.suffix in CODE and not any(LICENCE in line for line in lines[:6]):
        yield f"{path}:2: no line '// {LICENCE}'"


def check_length(path, lines):
    if len(lines) > MOST_LINES:
        yield f"{path}: {len(lines)} lines (at most {MOST_LINES}): which second thing does it do?"
    elif len(lines) > MANY_LINES:
        print(f"note: {path}: {len(lines)} lines (aim: {MANY_LINES})")


def check_format(paths):
    program = shutil.which("clang-format-14") or shutil.which("clang-format")
    if program is None:
        print("note: clang-format is not here; the layout was not checked")
        return
    version = subprocess.run([program, "--version"], capture_output=True, text=True, check=True).stdout
    if WANTED_CLANG_FORMAT not in version:
        print(f"note: {version.strip()}: not version 14; the layout was not checked")
        return
    run = subprocess.run([program, "--dry-run", "-Werror", *map(str, paths)], capture_output=True, text=True)
    badly = sorted(set(re.findall(r"^(/[^:\n]+):\d+:\d+: error: ", run.stderr, re.M)))
    for path in badly:
        yield f"{path}: not as .clang-format lays it out; clang-format -i mends it"
    if run.returncode != 0 and not badly:
        yield f"clang-format failed: {run.stderr.strip()[:400]}"


def main():
    root = Path(sys.argv[1] if len(sys.argv) > 1 else Path(__file__).parent.parent).resolve()
    found = []
    paths = list(files_of(root))
    for path in paths:
        lines = path.read_text().splitlines()
        found += [*check_heads(path, lines), *check_length(path, lines)]
    found += check_format([p for p in paths if p.suffix in CODE])
    print("\n".join(line.replace(f"{root}/", "") for line in found) or f"check_style: {len(paths)} files in order")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
