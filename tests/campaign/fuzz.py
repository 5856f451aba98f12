#!/usr/bin/env python3
"""Builds the fuzzers (preset "asan": clang, its libFuzzer, address and undefined-behaviour sanitizers) and runs each
for so many inputs from a small corpus: study files, meshes, stores, results, records between processes, tables of
designs, and what a report and a checkpoint hold besides. A crash, a hang of 2 minutes or a broken promise ends it; the
input is then kept in build/asan, as is the corpus, from which the next run goes on. --keep writes the few files that
reach most into tests/fuzz/corpus. With --replay the inputs are made by chance instead, without clang: by the programs
replay_* of an ordinary build, which leaves the last input beside each."""
import argparse
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import time

import common
import corpus

BUILD = common.ROOT / "build/asan"
FUZZERS = corpus.FUZZERS
# Longer inputs are slower and reach no more: a small study, mesh, table, store in pages of 512 bytes, result.
LONGEST = {"study": 1500, "mesh": 400, "store": 11000, "result": 7000, "files": 3000, "records": 400}
HANG = 120  # seconds by the clock: on a machine with ten programs a core an input of 10 ms has taken 14 s
PLAIN = "-entropic=0"  # keeping count of rare features takes longer than most inputs
FAST = {"ASAN_OPTIONS": "detect_leaks=0:malloc_context_size=1:quarantine_size_mb=16"}  # short stacks of allocations


def build():
    subprocess.run(["cmake", "--preset", "asan"], cwd=common.ROOT, check=True, stdout=subprocess.DEVNULL)
    subprocess.run(["cmake", "--build", str(BUILD), "--target", *("fuzz_" + name for name in FUZZERS)],
                   cwd=common.ROOT, check=True)


def fuzz(name, directory, runs, seconds, seed):
    limit, begin = [f"-max_total_time={seconds}"] if seconds else [], time.time()
    result = subprocess.run([str(BUILD / f"fuzz_{name}"), f"-runs={runs}", *limit, f"-seed={seed}", f"-timeout={HANG}",
                             "-rss_limit_mb=2048", f"-max_len={LONGEST[name]}", "-print_final_stats=1", PLAIN,
                             f"-report_slow_units={HANG // 2}",
                             f"-artifact_prefix={BUILD}/found_{name}_", str(directory)],
                            capture_output=True, text=True, errors="replace", env={**os.environ, **FAST})
    done = re.search(r"stat::number_of_executed_units:\s*(\d+)", result.stderr)
    covered = re.findall(r"cov: (\d+)", result.stderr)
    print(f"{name}: {done.group(1) if done else '?'} inputs in {time.time() - begin:.0f} s, "
          f"{covered[-1] if covered else '?'} edges covered, "
          f"{'no finding' if result.returncode == 0 else 'A FINDING'}", flush=True)
    if result.returncode != 0:
        print(result.stderr[-3000:])
    for left in pathlib.Path("/dev/shm").glob("icebow_fuzz_*"):
        left.unlink(missing_ok=True)
    return result.returncode != 0


def replay(build, name, directory, runs):
    """Of a fuzzer that came without libFuzzer: whether it has found something."""
    program = pathlib.Path(build).resolve() / f"replay_{name}"
    try:
        result = subprocess.run([str(program), str(runs), str(directory)], capture_output=True, text=True, errors="replace",
                                timeout=60 + runs / 20)
        words = result.stdout if result.returncode == 0 else f"exit {result.returncode}: {result.stderr[-2000:]}"
        found = result.returncode != 0
    except subprocess.TimeoutExpired:
        words, found = "a hang", True
    print(f"{name}: {words.strip()}{f'; A FINDING: {program}.last' if found else ''}", flush=True)
    return found


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--runs", type=int, default=1000000, help="inputs for each fuzzer; default: a million")
    parser.add_argument("--seconds", type=int, default=0, help="at most, for each; default: as long as it takes")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--only", choices=FUZZERS, action="append")
    parser.add_argument("--replay", metavar="BUILD", help="directory of an ordinary build: no clang, no coverage")
    parser.add_argument("--program", default=str(common.ROOT / "build/release/icebow"), help="for the corpus")
    parser.add_argument("--keep", action="store_true", help="the best of the corpus in tests/fuzz/corpus")
    chosen = parser.parse_args()
    names = chosen.only or FUZZERS
    if chosen.replay:
        with tempfile.TemporaryDirectory(prefix="icebow_corpus_") as place:
            corpus.gathered(pathlib.Path(place), chosen.program)
            return 1 if sum(replay(chosen.replay, name, pathlib.Path(place) / name, chosen.runs) for name in names) else 0
    build()
    inputs = BUILD / "corpus"
    inputs.mkdir(exist_ok=True)
    corpus.gathered(inputs, chosen.program)
    found = sum(fuzz(name, inputs / name, chosen.runs, chosen.seconds, chosen.seed) for name in names)
    for name in names if chosen.keep and not found else ():
        corpus.keep(BUILD / f"fuzz_{name}", name, inputs / name, min(4000, LONGEST[name]))
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
