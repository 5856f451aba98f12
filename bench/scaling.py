#!/usr/bin/env python3
"""Strong and weak scaling of bench/kernel over MPI ranks, for every rank grid.

    bench/scaling [--json] [--ranks 1,2,4] [--steps N] [--repeats N]

Strong: the reference slab shared by more ranks. Weak: the slab's width grows with the ranks. Without --ranks: powers
of two up to the usable cores.
"""
import argparse
import json

from launch import announce, kernel, machine, positive, rank_counts, run_main, usable_cores

NX, NY, NZ = 500, 250, 3
NARROWEST = 32  # particles along x that a rank needs (src/solver/lattice/lattice.h: two blocks)


def cases(ranks):
    """(scaling, rank, ranks along x, width) of every run."""
    for n in ranks:
        for along_x in (p for p in range(1, n + 1) if n % p == 0 and p * NARROWEST <= NX):
            yield "strong", n, along_x, NY
            yield "weak", n, along_x, NY * n


def measure(options):
    best = {}
    for repeat in range(options.repeats):  # turns, so that a busy machine slows every case
        announce(f"repeat {repeat + 1} of {options.repeats}")
        for case in cases(options.ranks):
            _, ranks, along_x, ny = case
            run = kernel(ranks, "--steps", options.steps, "--nx", NX, "--ny", ny, "--nz", NZ, "--along-x", along_x)
            if case not in best or run["ms_per_step"] < best[case]["ms_per_step"]:
                best[case] = run
    return best


def rows(best):
    """Efficiency against the fewest ranks: strong in time x ranks, weak in time (work grows with the ranks)."""
    base = {scaling: min((case for case in best if case[0] == scaling), key=lambda case: case[1])
            for scaling in ("strong", "weak")}
    for case, run in best.items():
        first, n0 = best[base[case[0]]], base[case[0]][1]
        # ns/bond x ranks is the work of a bond: it covers both, and a weak slab's slightly different edges.
        efficiency = first["ns_per_bond"] * n0 / (run["ns_per_bond"] * run["ranks"])
        yield {"scaling": case[0], "ranks": run["ranks"], "along_x": run["ranks_along_x"],
               "along_y": run["ranks_along_y"], "lattice": run["lattice"], "bonds": run["bonds"],
               "ms_per_step": run["ms_per_step"], "ns_per_bond": run["ns_per_bond"], "efficiency": efficiency,
               "halo_bytes_per_step": run["halo_bytes_per_step"]}


def print_table(table, oversubscribed):
    print(f"{'scaling':8} {'ranks':>5} {'grid x*y':>8} {'lattice':>13} {'ms/step':>9} {'ns/bond':>8} "
          f"{'efficiency':>10} {'kB/step sent':>12}")
    for row in sorted(table, key=lambda row: (row["scaling"], row["ranks"], row["along_x"])):
        grid, lattice = f"{row['along_x']}*{row['along_y']}", "x".join(map(str, row["lattice"]))
        print(f"{row['scaling']:8} {row['ranks']:5} {grid:>8} {lattice:>13} {row['ms_per_step']:9.3f} "
              f"{row['ns_per_bond']:8.4f} {row['efficiency']:10.2f} {row['halo_bytes_per_step'] / 1e3:12.1f}")
    if oversubscribed:
        print("more ranks than usable cores: those times say nothing about scaling")


def parse():
    parser = argparse.ArgumentParser(description="strong and weak scaling of bench/kernel")
    parser.add_argument("--json", action="store_true")
    parser.add_argument("--ranks", type=rank_counts, help="comma-separated, e.g. 1,2,4")
    parser.add_argument("--steps", type=positive, default=60)
    parser.add_argument("--repeats", type=positive, default=2)
    options = parser.parse_args()
    if not options.ranks:
        options.ranks = [2**p for p in range(usable_cores().bit_length())]
    return options


def main():
    options = parse()
    before = machine()
    table = list(rows(measure(options)))
    oversubscribed = max(options.ranks) > usable_cores()
    if options.json:
        print(json.dumps({"benchmark": "scaling", "rows": table, "oversubscribed": oversubscribed,
                          "machine": before}, indent=2))
    else:
        print_table(table, oversubscribed)


if __name__ == "__main__":
    run_main(main)
