#!/usr/bin/env python3
"""Another program's triangles of our own bows: writes each preset as STEP, lets gmsh mesh it with edges of so many
metres, measures the mesh, and compares the four angles with those asked for. An angle off by more than 0.3 deg and its
spread is a fault. Needs gmsh (Debian: gmsh)."""
import argparse
import json
import os
import shutil
import subprocess
import sys

import common

BOUND = 0.3  # deg
ANGLES = ("stem", "waterline", "buttock", "flare")


def remeshed(place, study, edge):
    """Requested angles and what `icebow measure` says of gmsh's mesh."""
    asked = json.loads(study.read_text())["bow"]
    step, mesh = place.path / (study.stem + ".step"), place.path / (study.stem + ".stl")
    written = place.run("hull", study, "--out", step)
    if written.returncode != 0:
        raise SystemExit(written.stderr)
    size = str(1000.0 * edge)  # gmsh reads STEP in millimetres
    subprocess.run(["gmsh", "-2", "-clmin", size, "-clmax", size, "-bin", "-format", "stl", "-o", str(mesh), str(step)],
                   check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    measured = place.run("measure", mesh, "--unit", "mm", "--json", timeout=3000)
    if measured.returncode != 0:
        raise SystemExit(measured.stderr)
    return {name: asked[name + "_deg"] for name in ANGLES}, json.loads(measured.stdout)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--edge", type=float, default=1.0, help="of the triangles [m]; default: 1")
    parser.add_argument("--program", default=str(common.ROOT / "build/release/icebow"))
    chosen = parser.parse_args()
    if not shutil.which("gmsh") or not os.access(chosen.program, os.X_OK):
        parser.error(f"gmsh and {chosen.program} are needed")
    faults, worst = 0, dict.fromkeys(ANGLES, 0.0)
    with common.Place(chosen.program) as place:
        for study in sorted((common.ROOT / "studies/families").glob("*.json")):
            asked, found = remeshed(place, study, chosen.edge)
            words = []
            for name in ANGLES:
                off, spread = found["angles_deg"][name] - asked[name], found["angles_spread_deg"][name]
                worst[name] = max(worst[name], abs(off))
                faults += abs(off) > BOUND + spread
                words.append(f"{name} {off:+.3f} ± {spread:.3f}")
            print(f"{study.stem}: {', '.join(words)}", flush=True)
    print("largest: " + ", ".join(f"{name} {off:.3f}" for name, off in worst.items()) + f" deg; {faults} faults")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
