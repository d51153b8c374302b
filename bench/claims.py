#!/usr/bin/env python3
"""What prt.h aims at, and what was measured: one line for each aim, with its limit and the command that measures it.

usage: claims.py [--check]          from bench/results/*.csv and docs/gallery/demo.csv; writes docs/claims.md, or exits
                                    with 1 unless that says what the files say
       claims.py --measure BUILD    measures anew with the programs under BUILD/bench and BUILD/examples (some minutes),
                                    prints the same table, and exits with 1 where a limit is not kept

Peers are measured where they were plugged in (bench/peer.h): the rows about them come from bench/results/peers.csv.
"""
import csv
import math
import pathlib
import subprocess
import sys
import tempfile

import report

ROOT = pathlib.Path(__file__).resolve().parent.parent
RESULTS = ROOT / "bench" / "results"
NOTE = "<!-- Written by bench/claims.py from bench/results/*.csv and docs/gallery/demo.csv: do not edit. -->"

# A CSV file, the command that writes it (FILE stands for the place), and what of it is needed to say how to repeat it.
COMMANDS = {
    "accuracy": ["bench/accuracy", "--csv", "FILE"],
    "speed": ["bench/prt_bench", "--filter", "=eval float =5 native", "--csv", "FILE"],
    "soa": ["bench/prt_bench", "--filter", "=eval_soa float =5 native", "--csv", "FILE"],
    "bake-speed": ["bench/bake", "speed", "--csv", "FILE"],
    "bake-error": ["bench/bake", "error", "--csv", "FILE"],
    "demo": ["examples/demo", "--out", "DIRECTORY"],
}
COMMITTED = {name: RESULTS / (name + ".csv") for name in COMMANDS}
COMMITTED["soa"] = RESULTS / "speed.csv"
COMMITTED["demo"] = ROOT / "docs" / "gallery" / "demo.csv"


def read(path):
    with open(path) as file:
        return list(csv.DictReader(line for line in file if not line.startswith("#")))


def stamp(path):
    return [line[2:].strip() for line in open(path) if line.startswith("# ")]


def measure(build, name, directory):
    path = directory / (name + ".csv")
    words = [str(build / COMMANDS[name][0])] + COMMANDS[name][1:]
    if name == "demo":
        path = directory / "demo.csv"
    words = [str(path) if w == "FILE" else str(directory) if w == "DIRECTORY" else w for w in words]
    if subprocess.run(words, stdout=subprocess.DEVNULL).returncode:
        sys.exit(f"claims.py: {' '.join(words)} failed")
    return read(path)


def command(name):
    if name == "demo":
        return "`make demo`"
    words = COMMANDS[name][:-2] if "--csv" in COMMANDS[name] else COMMANDS[name]
    return "`" + " ".join(f'"{w}"' if " " in w else w for w in words) + "`"


def where(rows, **wanted):
    return [r for r in rows if all(r[k] == str(v) for k, v in wanted.items())]


def rays_for(error, rows, column):
    """Where the curve of errors falls below the one wanted, straight between points of its log-log plot."""
    points = [(float(r["rays"]), float(r[column])) for r in rows]
    for (n0, e0), (n1, e1) in zip(points, points[1:]):
        if e1 <= error <= e0:
            t = (math.log(error) - math.log(e0)) / (math.log(e1) - math.log(e0))
            return math.exp(math.log(n0) + t * (math.log(n1) - math.log(n0)))
    return points[0][0] if points[0][1] <= error else math.inf


def accuracy_rows(rows):
    own = [r for r in rows if r["form"] != "textbook K P"]
    for column, bands, limits in (("error", 13, (4e-6, 1e-14)), ("own_error", 1024, (1e-2, 1e-10))):
        for precision, limit in zip(("float", "double"), limits):
            worst = max(float(r[column]) for r in where(own, precision=precision, bands=bands))
            what = "largest error" if column == "error" else "largest error beyond input rounding"
            yield f"Evaluation, {bands} bands, {precision}: {what}", limit, worst, "accuracy"
    yield "Evaluation, 1 to 1024 bands: values that are not finite", 0, sum(int(r["not_finite"]) for r in own), "accuracy"


def speed_rows(speed, soa, peers):
    one = dict(job="eval", name="prt_sh_eval", precision="float", bands=5, build="native")
    many = dict(job="eval_soa", name="prt_sh_eval_soa", precision="float", bands=5, build="native")
    yield "One direction, 5 bands, float: ns (limit for 3.9 GHz)", 5.7, float(where(speed, **one)[0]["ns"]), "speed"
    yield "1024 directions, 5 bands, float: time over that of memset", 1.5, float(where(soa, **many)[0]["of_write"]), "soa"
    for job, own in (("eval", one), ("eval_soa", many)):
        mine = where(peers, **own)
        for r in where(peers, job=job, peer=1, precision="float", bands=5, build="native"):
            what = "One direction" if job == "eval" else "1024 directions"
            yield f"{what}, 5 bands, float: time over that of {r['name']}", 1, float(mine[0]["ns"]) / float(r["ns"]), "peers"


def bake_rows(speed, error):
    for build in ("native", "portable"):
        worst = max(float(r["overhead_over_bare"]) for r in where(speed, build=build, bands=5))
        yield f"Bake, 5 bands, {build}: what it costs beside its rays, over them", 0.15, worst, "bake-speed"
    target = float(where(error, rays=2500)[0]["jittered_sphere"])
    yield ("Bake: rays that reach the error of 2500 jittered samples [Chapter 2010]", 600,
           rays_for(target, error, "fibonacci_cosine"), "bake-error")


def demo_rows(rows):
    for r in where(rows, bands=8, shadowed=1):
        for prefix, what in (("", "bunny and pedestal"), ("bunny_", "bunny")):
            above = float(r[prefix + "rmse_percent"]) - float(r[prefix + "floor_percent"])
            error = float(r[prefix + "standard_error_of_difference_percent"])
            yield (f"Demo, 8 bands, {r['environment']}, {what}: RMSE less its floor of {r[prefix + 'floor_percent']} %, "
                   "in standard errors", 2, above / error, "demo")


def table(data, peers):
    lines = ["| aim | at most | measured | kept | by |", "|---|--:|--:|---|---|"]
    kept = True
    rows = list(accuracy_rows(data["accuracy"])) + list(speed_rows(data["speed"], data["soa"], peers))
    rows += list(bake_rows(data["bake-speed"], data["bake-error"])) + list(demo_rows(data["demo"]))
    for what, limit, value, name in rows:
        good = value <= limit
        kept = kept and good
        by = "`bench/prt_bench` with peers (bench/peer.h)" if name == "peers" else command(name)
        lines.append(f"| {what} | {limit:.3g} | {value:.3g} | {'yes' if good else '**no**'} | {by} |")
    return "\n".join(lines) + "\n", kept


def main():
    peers = read(RESULTS / "peers.csv")
    if len(sys.argv) == 3 and sys.argv[1] == "--measure":
        with tempfile.TemporaryDirectory() as directory:
            data = {name: measure(pathlib.Path(sys.argv[2]), name, pathlib.Path(directory)) for name in COMMANDS}
        text, kept = table(data, peers)
        print(text, end="")
        sys.exit(0 if kept else 1)
    check = sys.argv[1:] == ["--check"]
    if sys.argv[1:] and not check:
        sys.exit(__doc__)
    text, _ = table({name: read(path) for name, path in COMMITTED.items()}, peers)
    machine = [line for line in stamp(COMMITTED["speed"]) if line.startswith(("machine", "compiler", "clock"))]
    report.put([(ROOT / "docs" / "claims.md", f"""# What prt.h aims at, and what was measured

{NOTE}

Programs stand under `build/tools/` after `make bench` and `make demo`; each prints the figure with the options given here.
`make claims` measures all of it anew, peers apart, and prints this table. {'; '.join(machine)}.

{text}""")], check)


if __name__ == "__main__":
    main()
