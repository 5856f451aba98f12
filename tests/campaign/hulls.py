#!/usr/bin/env python3
"""Damages meshes of the presets at random (tests/support/damaged_mesh.h: panels turned over, gaps, T-junctions, holes,
slivers, islands, walls and tanks inside, a deckhouse, coarse coordinates ...) and counts what the import makes of them:
accepted with a volume within 0.5 % and angles within 0.5 deg of the sound hull's, refused with a reason, off and told
by a warning or the spread, or wrong without a word. The last is a fault."""
import argparse
import collections
import concurrent.futures
import os
import pathlib
import re
import subprocess
import sys
import time

import common

OUTCOMES = ("mended", "told", "wrong")


def batch(program, meshes, first):
    """Counts by outcome and reason, and the lines that tell of single meshes."""
    done = subprocess.run([program, str(meshes), str(first)], capture_output=True, text=True)
    counts = re.search(r"^(\d+) meshes: (\d+) mended .*?, (\d+) off and told .*?, (\d+) wrong", done.stdout, re.M)
    if not counts or int(counts.group(1)) != meshes:
        raise SystemExit(f"{program} {meshes} {first} ended with {done.returncode}: {done.stdout[-500:]}{done.stderr[-500:]}")
    outcome = collections.Counter(dict(zip(OUTCOMES, map(int, counts.groups()[1:]))))
    refused = collections.Counter({why: int(n) for n, why in re.findall(r"^  refused (\d+): (.*)$", done.stdout, re.M)})
    return outcome, refused, re.findall(r"^seed .*$", done.stdout, re.M)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--meshes", type=int, default=10000, help="default: 10000")
    parser.add_argument("--seed", type=int, default=0, help="of the first mesh; each has its own")
    parser.add_argument("--jobs", type=int, default=os.cpu_count() or 1)
    parser.add_argument("--program", default=str(common.ROOT / "build/release/bench/damaged_meshes"))
    chosen = parser.parse_args()
    if not os.access(chosen.program, os.X_OK):
        parser.error(f"{chosen.program} is no program: build the target damaged_meshes, or give --program")
    size, end = 250, chosen.seed + chosen.meshes
    parts = [(min(size, end - first), first) for first in range(chosen.seed, end, size)]
    outcome, refused, began = collections.Counter(), collections.Counter(), time.time()
    with concurrent.futures.ThreadPoolExecutor(chosen.jobs) as pool:
        for counts, reasons, lines in pool.map(lambda part: batch(str(pathlib.Path(chosen.program).resolve()), *part), parts):
            outcome.update(counts)
            refused.update(reasons)
            for line in lines:
                print(line, flush=True)
    for why, n in refused.most_common():
        print(f"  refused {n}: {why}")
    print(f"{chosen.meshes} meshes: {outcome['mended']} accepted with volume and angles right, {sum(refused.values())} refused, "
          f"{outcome['told']} off and told, {outcome['wrong']} wrong without a word; {time.time() - began:.0f} s")
    return 1 if outcome["wrong"] else 0


if __name__ == "__main__":
    sys.exit(main())
