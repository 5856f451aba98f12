#!/usr/bin/env python3
"""The limit of fine lattices from a study of layers, and each lattice's distance from it.

    build/release/icebow run studies/convergence/layers.json --out DIR
    studies/convergence/extrapolate.py DIR [--write]

Fits mean load = F0 + c (1/layers)^p to the means of the runs, weighted with their standard errors, for p = 1 and p = 2. The limit
is the middle of the two; its 95 % interval is that of the fits and half their difference, added: which power is right is not known.
--write puts the ratios load / F0 into bias.json beside this script, from which the next build takes them. Standard library only.
"""

import argparse
import json
import math
import pathlib
import sys

TABLE = pathlib.Path(__file__).resolve().parent / "bias.json"


def read_runs(directory):
    """(strength, contact) of the study and {layers: [(mean, standard error), ...]} of the runs that are ok."""
    study = json.loads((directory / "study.json").read_text())
    ice = study.get("ice", {})
    calibrated = ice.get("model") == "calibrated"
    strength = "calibration" if calibrated else "stretch" if ice.get("critical_stretch") else "toughness"
    model = (strength, study.get("solver", {}).get("contact", "crushing" if calibrated else "relocation"))
    runs = {}
    for file in sorted(directory.glob("designs/*/result.json")):
        if "~" in file.parent.name:
            continue  # of an earlier version of the study file
        result = json.loads(file.read_text())
        if result.get("status") != "ok" or not result.get("simulation"):
            continue
        ci95 = result["metrics"]["mean_load_ci95_N"]
        if ci95 is None:
            continue
        runs.setdefault(result["simulation"]["nz"], []).append((result["metrics"]["mean_load_N"], ci95 / 1.96))
    return model, runs


def pooled(values):
    """Mean and standard error: the scatter of repeats where there are three or more, else the runs' own."""
    n = len(values)
    mean = sum(v for v, _ in values) / n
    own = math.sqrt(sum(s * s for _, s in values)) / n
    if n < 3:
        return mean, own
    scatter = math.sqrt(sum((v - mean) ** 2 for v, _ in values) / (n - 1) / n)
    return mean, max(scatter, own)


def fitted(points, power):
    """Weighted least squares of F0 + c x^power over (x, F, standard error): F0 and its standard error."""
    sums = [0.0] * 5
    for x, load, error in points:
        w, t = 1.0 / error**2, x**power
        for i, term in enumerate((w, w * t, w * t * t, w * load, w * t * load)):
            sums[i] += term
    s, st, stt, sf, stf = sums
    determinant = s * stt - st * st
    return (stt * sf - st * stf) / determinant, math.sqrt(stt / determinant)


def limit_of(points):
    """F0 and the half width of its 95 % interval."""
    first, second = fitted(points, 1), fitted(points, 2)
    statistical = 1.96 * max(first[1], second[1])
    return 0.5 * (first[0] + second[0]), statistical + 0.5 * abs(first[0] - second[0])


def entries_of(model, runs):
    points = {layers: pooled(values) for layers, values in sorted(runs.items())}
    limit, half = limit_of([(1.0 / layers, mean, error) for layers, (mean, error) in points.items()])
    print(f"limit of fine lattices: {limit:.2f} +- {half:.2f} N (95 %), model scale")
    if limit <= half:
        sys.exit("the limit cannot be told from zero: more advance, more repeats or finer lattices are needed")
    entries = []
    for layers, (mean, error) in points.items():
        ratio = mean / limit
        ci95 = ratio * math.hypot(1.96 * error / mean, half / limit)
        print(f"{layers} layers: {mean:.2f} +- {1.96 * error:.2f} N, {ratio:.3f} +- {ci95:.3f} of the limit")
        entries.append({"layers": layers, "strength": model[0], "contact": model[1],
                        "load_over_limit": round(ratio, 4), "ci95": round(ci95, 4)})
    return entries


def write_table(path, entries):
    table = json.loads(path.read_text())
    key = lambda e: (e["strength"], e["contact"], e["layers"])
    kept = {key(e): e for e in table["entries"]}
    kept.update({key(e): e for e in entries})
    table["entries"] = [kept[k] for k in sorted(kept)]
    path.write_text(json.dumps(table, indent=2) + "\n")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("directory", type=pathlib.Path, help="of `icebow run`")
    parser.add_argument("--write", action="store_true", help="write the table")
    parser.add_argument("--table", type=pathlib.Path, default=TABLE)
    arguments = parser.parse_args()
    model, runs = read_runs(arguments.directory)
    if len(runs) < 3:
        sys.exit(f"{arguments.directory}: runs of {len(runs)} different numbers of layers are ok; a fit takes 3")
    if model[0] == "toughness":
        sys.exit("ice of one toughness is the stronger, the finer its lattice is: its load has no limit. Give critical_stretch, or calibrated ice")
    entries = entries_of(model, runs)
    if arguments.write:
        write_table(arguments.table, entries)


if __name__ == "__main__":
    main()
