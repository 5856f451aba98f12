"""What the fuzzers begin with: small files of the tests, what the program writes of the tiny study, and what earlier
runs have found worth keeping (tests/fuzz/corpus, a folder each)."""
import hashlib
import json
import os
import pathlib
import shutil
import sqlite3
import struct
import subprocess

import common

FUZZERS = ("study", "mesh", "store", "result", "files", "records")
KEPT = common.HERE.parent / "fuzz/corpus"
MOST_KEPT = 18  # files for each fuzzer


def seeds(directory, program):
    """Small ones: files of the tests, and what the program writes of the tiny study."""
    for folder in ("good", "bad", "bad_beyond_schema"):
        for file in sorted((common.ROOT / "tests/study/files" / folder).glob("*.json")):
            (directory / "study" / f"{folder}_{file.name}").write_bytes(file.read_bytes())
    solid = {b"\0": b"ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
                    b"element face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n",
             b"\1": b"v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 2 0\ng bow\nf 1 2 3 4 5\nf 1/1 2/2 -1\n",
             b"\2": b"solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\n"
                    b"endfacet\nendsolid a\n"}
    for kind, content in solid.items():
        (directory / "mesh" / str(kind[0])).write_bytes(kind + content)
    corners = struct.pack("<9f", 0, 0, 0, 1, 0, 0, 0, 1, 0)
    (directory / "mesh/binary_ply").write_bytes(
        b"\0" + solid[b"\0"].partition(b"0 0 0\n")[0].replace(b"ascii", b"binary_little_endian") + corners +
        struct.pack("<B3i", 3, 0, 1, 2))
    (directory / "mesh/binary_stl").write_bytes(
        b"\2" + bytes(80) + struct.pack("<I3f", 1, 0, 0, 1) + corners + bytes(2))
    (directory / "files/csv").write_bytes(b"\0# a\nadvance_m,Fx_N\n0,1\n1,-2\n2,nan\n")
    (directory / "files/svg").write_bytes(b"\1<svg xmlns=\"http://www.w3.org/2000/svg\" class=\"lines-plan\"><g id=\"a\">"
                                          b"<path d=\"M0 0L1 1\"/><text x=\"1\">t</text></g></svg>")
    (directory / "files/obj").write_bytes(b"\2" + solid[b"\1"])
    (directory / "files/list").write_bytes(b"\3" + bytes(96))
    for kind, content in (
            (0, '{"key": "k", "name": "d001", "status": "ok", "reason": "", "parameters": [["/bow/stem_deg", 20]], '
                '"result": {"metrics": {}}, "wall_seconds": null}'),
            (2, '{"state": "decided", "best_within": 0.1, "confidence": 0.95, "budget_core_h": 1, "legs": [{"sailed_to_m": '
                '{"a": 20, "b": 10}, "in": ["a"], "leader": "a", "most_above_best": null, "core_hours": 0.1}], '
                '"keys": {"a": "k", "b": "l"}, "targets_m": {"k": 20}}'),
            (3, '{"step": 3, "steps": 10, "advance_m": 0.5, "load_N": -1e3}'), (3, '{"machine_trouble": "a disk"}'),
            (4, 'name;/bow/stem_deg;"/operation/speed_kn"\n"a; b";20;3\n\nc;21.5;4\n')):
        (directory / f"records/{kind}_{len(content)}").write_bytes(bytes([kind]) + content.encode())
    if os.access(program, os.X_OK):
        with common.Place(program) as place:
            path = place.write("s.json", common.study(evaluators=["lindqvist"], ranking={"by": "lindqvist_breaking"}))
            place.run("run", path, "--out", place.path / "o")
            small_stores(place.path / "o/results.sqlite", directory / "store")
            place.run("simulate", place.write("t.json", common.study(designs=[])), "--out", place.path / "r")
            (directory / "result/one").write_text(brief(json.loads((place.path / "r/result.json").read_text())))
            rows = sqlite3.connect(place.path / "o/results.sqlite").execute("SELECT name, result FROM evaluations")
            for name, result in rows:
                (directory / "result" / name).write_text(brief(json.loads(result)))
            (directory / "files/history").write_bytes(b"\0" + (place.path / "r/history.csv").read_bytes()[:3000])
            (directory / "files/lines").write_bytes(b"\1" + (place.path / "r/lines.svg").read_bytes())
    if not any((directory / "result").iterdir()):
        (directory / "result/one").write_text(json.dumps({"metrics": {"full_scale": {"mean_load_N": 1}}}))


def brief(value):
    """As JSON without blanks, numbers with four digits: the fuzzer changes what a reader looks at the more often."""
    def short(part):
        if isinstance(part, dict):
            return {key: short(one) for key, one in part.items()}
        if isinstance(part, list):
            return [short(one) for one in part[:4]]
        return float(f"{part:.4g}") if isinstance(part, float) else part
    return json.dumps(short(value), separators=(",", ":"))


def small_stores(store, directory):
    """In pages of 512 bytes; one as it is, one of the version that had no digests, whose rows are read as they stand."""
    for name, version in (("one", 2), ("old", 1)):
        shutil.copy(store, directory / name)
        database = sqlite3.connect(directory / name, isolation_level=None)
        database.execute(f"PRAGMA user_version = {version}")
        database.execute("PRAGMA page_size = 512")
        database.execute("VACUUM")
        database.close()


def gathered(directory, program):
    """A folder of inputs for each fuzzer."""
    for name in FUZZERS:
        (directory / name).mkdir(exist_ok=True)
        for file in sorted((KEPT / name).glob("*")):
            shutil.copy(file, directory / name)
    seeds(directory, program)


def features_of(control):
    """By libFuzzer's notes of a merge: of each file what only it and few others reach."""
    files, reached = [], {}
    for line in control.read_text().splitlines():
        words = line.split()
        if words and words[0] == "FT":
            reached[files[int(words[1])]] = set(words[2:])
        elif len(words) == 1 and "/" in line:
            files.append(line)
    return reached


def keep(fuzzer, name, corpus, most_bytes):
    """Of a corpus the files that together reach most, few and small, into the repository."""
    control = corpus.parent / f"{name}.merge"
    (corpus.parent / f"{name}.merged").mkdir()
    subprocess.run([fuzzer, "-merge=1", f"-merge_control_file={control}", f"-max_len={most_bytes}",
                    corpus.parent / f"{name}.merged", corpus], check=True, capture_output=True)
    reached, chosen, known = features_of(control), [], set()
    while len(chosen) < MOST_KEPT:
        best = max(reached, key=lambda file: len(reached[file] - known) / (100 + os.path.getsize(file)))
        if not reached[best] - known:
            break
        chosen.append(best)
        known |= reached.pop(best)
    shutil.rmtree(KEPT / name, ignore_errors=True)
    (KEPT / name).mkdir(parents=True)
    for file in chosen:
        content = pathlib.Path(file).read_bytes()
        (KEPT / name / hashlib.sha1(content).hexdigest()[:12]).write_bytes(content)
    print(f"{name}: {len(chosen)} files kept", flush=True)
