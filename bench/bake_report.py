#!/usr/bin/env python3
"""Writes docs/bake.md and docs/bake-error.svg from the CSV files of bench/bake.

usage: bake_report.py [--root DIRECTORY]     reads DIRECTORY/bench/results/bake-{speed,error}.csv
"""
import argparse
import csv
import math
import pathlib
import subprocess
import sys

SETS = {
    "jittered_sphere": "jittered grid, sphere [Chapter 2010]",
    "random_cosine": "independent, cosine",
    "jittered_cosine": "jittered grid, cosine",
    "sobol_cosine": "Sobol, Owen scrambled, cosine",
    "fibonacci_hemisphere": "Fibonacci, uniform hemisphere",
    "fibonacci_subtract": "Fibonacci, cosine, less the blocked",
    "fibonacci_cosine": "**Fibonacci, cosine**",
}

TEXT = """<!-- Written by bench/bake_report.py: do not edit. `make docs` measures and writes anew. -->
# Baking: error and cost

## Error against rays

![Error of transfer against rays a point, for each sample set](bake-error.svg)

Root mean square error over the vertices, in the 2-norm of the coefficients. {error_stamp}.

{error_table}

`prt_bake_transfer` traces the last column: the Fibonacci lattice, shifted at random for each point, cosine-weighted.
The error of 2500 samples of [Chapter 2010] is reached with {equal}.

Half the samples of the jittered grid lie below the horizon; they count here as the thesis counts them, though no ray
need be traced for them. Uniform over the hemisphere the lattice is as good within a few percent, and so is the exact
unshadowed transfer less the blocked part; the plain cosine-weighted sum was chosen, for its first coefficient is the
open share of the rays exactly, and a point that sees nothing has transfer 0.

## Cost beside the rays

Nanoseconds a ray: `rtcOccluded1M` alone on the bake's own rays, the whole bake with Embree, and the bake with recorded
answers in place of Embree (sampling, writing rays, evaluating and summing the basis). Processor time, the least of 15
rounds of each, taken in turns.
{speed_stamp}.

{speed_table}
"""


def read(path):
    try:
        lines = path.read_text().splitlines()
    except OSError as problem:
        sys.exit(f"bake_report.py: {problem}; measure first with make docs")
    stamp = "; ".join(line[2:] for line in lines if line.startswith("# "))
    rows = list(csv.DictReader(line for line in lines if not line.startswith("#")))
    if not rows:
        sys.exit(f"bake_report.py: {path} has no rows; measure again with make docs")
    return stamp, rows


def table(heads, rows):
    lines = ["| " + " | ".join(heads) + " |", "|" + "---:|" * len(heads)]
    return "\n".join(lines + ["| " + " | ".join(row) + " |" for row in rows])


def rays_for(name, level, errors):
    """Where the falling curve of errors crosses the level, on logarithmic axes."""
    curve = [(float(row["rays"]), float(row[name])) for row in errors]
    for (x0, y0), (x1, y1) in zip(curve, curve[1:]):
        if y1 <= level <= y0:
            return f"{x0 * (x1 / x0) ** (math.log(y0 / level) / math.log(y0 / y1)):.0f}"
    return f"more than {curve[-1][0]:.0f}"


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--root", type=pathlib.Path, default=pathlib.Path(__file__).resolve().parent.parent)
    root = parser.parse_args().root
    results, docs = root / "bench/results", root / "docs"
    error_stamp, errors = read(results / "bake-error.csv")
    speed_stamp, speeds = read(results / "bake-speed.csv")
    script = root / "bench/bake_error.gp"
    names = f"csv='{results / 'bake-error.csv'}'; out='{docs / 'bake-error.svg'}'"
    drawn = subprocess.run(["gnuplot", "-e", names, script], capture_output=True, text=True)
    if drawn.returncode:
        sys.exit("bake_report.py: gnuplot failed: " + drawn.stderr.strip())
    level = next(float(row["jittered_sphere"]) for row in errors if row["rays"] == "2500")
    equal = "; ".join(f"{rays_for(name, level, errors)} ({label.strip('*')})" for name, label in SETS.items()
                      if name != "jittered_sphere")
    text = TEXT.format(
        equal=equal,
        error_stamp=error_stamp, speed_stamp=speed_stamp,
        error_table=table(["rays"] + list(SETS.values()),
                          [[row["rays"]] + [f"{float(row[name]):.5f}" for name in SETS] for row in errors]),
        speed_table=table(["build", "bands", "rays a point", "Embree alone", "whole bake", "bake alone", "ratio"],
                          [[r["build"], r["bands"], r["rays"], f"{float(r['bare_ns']):.1f}",
                            f"{float(r['bake_ns']):.1f}", f"{float(r['overhead_ns']):.2f}",
                            f"{100 * float(r['overhead_over_bare']):.1f} %"] for r in speeds]))
    (docs / "bake.md").write_text(text)


if __name__ == "__main__":
    main()
