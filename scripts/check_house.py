#!/usr/bin/env python3
# Holds the sources to docs/house.md: floors, cycles, twins, tables, GL calls, terms, headers. Prints every breach.
# SPDX-License-Identifier: MIT
import re
import sys
from pathlib import Path

MOST_INCLUDES_DEEP = 12
ROOMS_WITH_GL = {"gl", "frame", "studio"}
INCLUDE = re.compile(r'^\s*#\s*include\s+"([^"]+)"', re.M)
COMMENT = re.compile(r'//[^\n]*|/\*.*?\*/|"(?:\\.|[^"\\\n])*"', re.S)


def without_comments(text):
    """Comments and strings blanked, include lines kept."""
    return COMMENT.sub(lambda m: m[0] if m[0].startswith('"') and "/" in m[0] else " ", text)


def read_house(root):
    """The floors of the rooms, and the two lists of exceptions, from docs/house.md."""
    text = (root / "docs/house.md").read_text()
    block = text.split("```")[1].split("\nglsl/")[0]
    floors = {name: int(floor) for floor, name in re.findall(r"(?:^|\s)(\d) ([a-z]+)/", block)}
    without_shaders = re.search(r"without shaders of their own: (.*)", text)[1].split()
    no_term = re.search(r"that are no term: (.*)", text)[1].split()
    return floors, set(without_shaders), set(no_term)


def room_of(path, src):
    parts = path.relative_to(src).parts
    return parts[0] if len(parts) > 1 else ""


def check_floors(files, src, floors):
    for path, text in files.items():
        room = room_of(path, src)
        if room not in floors:
            yield f"{path}: the room {room}/ is not in docs/house.md"
            continue
        for target in INCLUDE.findall(text):
            other = target.split("/")[0]
            if other in floors and other != room and floors[other] >= floors[room]:
                way = "sideways" if floors[other] == floors[room] else "upwards"
                yield f"{path}: includes {target}, {way} (floor {floors[room]} to {floors[other]})"


def check_chains(files, src):
    graph = {p: [src / t for t in INCLUDE.findall(text) if (src / t) in files] for p, text in files.items()}
    depth, open_files = {}, []

    def walk(path):
        if path in depth:
            return depth[path]
        if path in open_files:
            chain = open_files[open_files.index(path):] + [path]
            raise RecursionError(" -> ".join(str(p.relative_to(src)) for p in chain))
        open_files.append(path)
        depth[path] = 1 + max((walk(other) for other in graph[path]), default=0)
        open_files.pop()
        return depth[path]

    for path in graph:
        try:
            if walk(path) > MOST_INCLUDES_DEEP:
                yield f"{path}: a chain of includes {depth[path]} deep (at most {MOST_INCLUDES_DEEP})"
        except RecursionError as cycle:
            yield f"{path}: a cycle of includes: {cycle}"
            return  # every file that reaches it would say so again


def check_twins(root, without_shaders):
    for folder in sorted((root / "src/frame").glob("*/")):
        if not any(folder.iterdir()) or not folder.is_dir() or folder.name in without_shaders:
            continue
        if not any((root / "glsl/frame" / folder.name).glob("*")):
            yield f"{folder}: has no twin glsl/frame/{folder.name} (docs/house.md lists the exceptions)"


def check_tables(files, src):
    headers = {}
    for path, text in files.items():
        for target in INCLUDE.findall(text):
            if not (target.startswith("tables/") and target.endswith(".def")):
                continue
            if room_of(path, src) == "tables" and path.suffix == ".h":
                headers.setdefault(target, set()).add(path)
            elif "dispatch" not in path.name:
                yield f"{path}: expands {target}; only its header and a dispatch file may"
    for target, paths in headers.items():
        if len(paths) > 1:
            yield f"{target}: expanded by more than one header: {', '.join(sorted(p.name for p in paths))}"


def check_gl_calls(files, src):
    call = re.compile(r"\b(?:gl[A-Z]\w*|api_?(?:\(\))?(?:\.|->)[A-Z]\w*)\s*\(")
    for path, text in files.items():
        if room_of(path, src) in ROOMS_WITH_GL:
            continue
        for found in call.findall(without_comments(text)):
            yield f"{path}: a GL call outside gl/, frame/ and studio/: {found}"


def check_terms(root, no_term):
    table = root / "src/tables/brdf_terms.def"
    cells = re.findall(r'^TERM\(\s*\w+,\s*\w+,\s*"([\w ]*)"', table.read_text(), re.M)
    rows = {name for cell in cells for name in cell.split()}  # a row may need several files
    files = {p.stem for p in (root / "glsl/brdf").glob("*.glsl")} - no_term
    for name in sorted(files - rows):
        yield f"glsl/brdf/{name}.glsl: has no row in {table.name}"
    for name in sorted(rows - files):
        yield f"{table.name}: names {name}, but there is no glsl/brdf/{name}.glsl"


def check_header_names(root):
    """src/, glsl/ and tests/ are all searched for headers, so one path in two of them hides a header."""
    seen = {}
    for folder in ("src", "glsl", "tests"):
        for path in sorted((root / folder).rglob("*.h")):
            name = path.relative_to(root / folder)
            if name in seen:
                yield f"{path}: hides {seen[name]}"
            seen.setdefault(name, path)


def breaches(root):
    src = root / "src"
    floors, without_shaders, no_term = read_house(root)
    if len(floors) < 9:
        yield "docs/house.md: the floors could not be read from its first block"
    files = {p: p.read_text() for p in sorted(src.rglob("*")) if p.suffix in {".h", ".cpp", ".def"}}
    yield from check_floors(files, src, floors)
    yield from check_chains(files, src)
    yield from check_twins(root, without_shaders)
    yield from check_tables(files, src)
    yield from check_gl_calls(files, src)
    yield from check_terms(root, no_term)
    yield from check_header_names(root)


def main():
    root = Path(sys.argv[1] if len(sys.argv) > 1 else Path(__file__).parent.parent).resolve()
    found = [line.replace(f"{root}/", "") for line in breaches(root)]
    print("\n".join(found) if found else "check_house: every line is in its room")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
