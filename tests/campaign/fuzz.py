#!/usr/bin/env python3
"""Builds the fuzzers (preset "fuzz": clang, its libFuzzer, address and undefined-behaviour sanitizers) and runs each
for so many inputs from a small corpus: study files, meshes, stores, results, and what a report and a checkpoint hold
besides. A crash, a hang of 10 s or a broken promise ends it; the input is then kept in build/fuzz."""
import argparse
import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile

import common

BUILD = common.ROOT / "build/fuzz"
FUZZERS = ("study", "mesh", "store", "result", "files")


def build():
    subprocess.run(["cmake", "--preset", "fuzz"], cwd=common.ROOT, check=True, stdout=subprocess.DEVNULL)
    subprocess.run(["cmake", "--build", str(BUILD), "--target", *("fuzz_" + name for name in FUZZERS)],
                   cwd=common.ROOT, check=True)


def seeds(directory, program):
    """Small ones: files of the tests, and what the program writes of the tiny study."""
    for name in FUZZERS:
        (directory / name).mkdir(exist_ok=True)
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
    (directory / "files/csv").write_bytes(b"\0# a\nadvance_m,Fx_N\n0,1\n1,-2\n2,nan\n")
    (directory / "files/svg").write_bytes(b"\1<svg xmlns=\"http://www.w3.org/2000/svg\" class=\"lines-plan\"><g id=\"a\">"
                                          b"<path d=\"M0 0L1 1\"/><text x=\"1\">t</text></g></svg>")
    (directory / "files/obj").write_bytes(b"\2" + solid[b"\1"])
    (directory / "files/list").write_bytes(b"\3" + bytes(96))
    if os.access(program, os.X_OK):
        with common.Place(program) as place:
            path = place.write("s.json", common.study(evaluators=["lindqvist"], ranking={"by": "lindqvist_breaking"}))
            place.run("run", path, "--out", place.path / "o")
            (directory / "store/one").write_bytes((place.path / "o/results.sqlite").read_bytes())
            place.run("simulate", place.write("t.json", common.study(designs=[])), "--out", place.path / "r")
            (directory / "result/one").write_bytes((place.path / "r/result.json").read_bytes())
    if not any((directory / "result").iterdir()):
        (directory / "result/one").write_text(json.dumps({"metrics": {"full_scale": {"mean_load_N": 1}}}))


def fuzz(name, corpus, runs, seconds, seed):
    limit = [f"-max_total_time={seconds}"] if seconds else []
    result = subprocess.run([str(BUILD / f"fuzz_{name}"), f"-runs={runs}", *limit, f"-seed={seed}", "-timeout=10",
                             "-rss_limit_mb=2048", "-max_len=20000", "-print_final_stats=1",
                             f"-artifact_prefix={BUILD}/found_{name}_", str(corpus)],
                            capture_output=True, text=True, errors="replace")
    done = re.search(r"stat::number_of_executed_units:\s*(\d+)", result.stderr)
    covered = re.findall(r"cov: (\d+)", result.stderr)
    print(f"{name}: {done.group(1) if done else '?'} inputs, {covered[-1] if covered else '?'} edges covered, "
          f"{'no finding' if result.returncode == 0 else 'A FINDING'}", flush=True)
    if result.returncode != 0:
        print(result.stderr[-3000:])
    for left in pathlib.Path("/dev/shm").glob("icebow_fuzz_*"):
        left.unlink(missing_ok=True)
    return result.returncode != 0


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--runs", type=int, default=1000000, help="inputs for each fuzzer; default: a million")
    parser.add_argument("--seconds", type=int, default=0, help="at most, for each; default: as long as it takes")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--only", choices=FUZZERS, action="append")
    parser.add_argument("--program", default=str(common.ROOT / "build/release/icebow"), help="for the corpus")
    chosen = parser.parse_args()
    build()
    with tempfile.TemporaryDirectory(prefix="icebow_corpus_") as directory:
        seeds(pathlib.Path(directory), chosen.program)
        found = sum(fuzz(name, pathlib.Path(directory) / name, chosen.runs, chosen.seconds, chosen.seed)
                    for name in chosen.only or FUZZERS)
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
