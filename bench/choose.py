#!/usr/bin/env python3
"""Writes docs/choose.md, how many bands, rays and bits a scene needs and what they cost, and its plots, from the CSV
files of bench/trade, bench/bake and prt_bench.

usage: choose.py [--root DIRECTORY] [--check]      reads DIRECTORY/bench/results/{trade,speed,bake-speed}.csv

--check writes nothing and exits with 1 unless docs/choose.md says what the files say.
"""
import statistics
import sys

import report
from report import Table, figure, line, markdown, plot

NOTE = "<!-- Written by bench/choose.py from bench/results/*.csv: do not edit. `make docs` measures anew. -->"
SOFT, HARD = "overcast sky", "bare sun"
WANTED = (0.2, 0.1, 0.05, 0.02, 0.01, 0.005)
STORED = {"float": ("float", 4, "prt_shade_diffuse_n"), "half": ("half", 2, "prt_shade_packed_n, half"),
          "16": ("16 bits", 2, "prt_shade_packed_n, 16 bits"), "8": ("8 bits", 1, "prt_shade_packed_n, 8 bits")}

# The other measured choices: what is traded, the page, and the plots of error against time (or the like) in docs/.
TRADES = [
    ("how to evaluate the basis", "accuracy.md", ["plots/eval_pareto.svg"]),
    ("how to rotate", "rotation.md", ["plots/rotation_pareto.svg"]),
    ("how to multiply", "operations.md", ["plots/product_pareto.svg"]),
    ("logarithms, exponentials, windows, deringing, lights", "operations.md",
     ["plots/log_pareto.svg", "plots/exp_pareto.svg", "plots/smooth_pareto.svg", "plots/analytic_pareto.svg",
      "plots/light_pareto.svg"]),
    ("chains of masks, or logarithms", "masks.md", ["plots/blockers_pareto.svg"]),
    ("cpherical or spherical harmonics", "rotation.md", ["plots/ch_pareto.svg"]),
    ("which sample set", "bake.md", ["bake-error.svg"]),
    ("how many bounces", "bounce.md", ["plots/bounce*.svg"]),
    ("moving occluders: size and storage of tables", "fiv.md", ["plots/fiv*.svg"]),
    ("vector occluders: how many, which law", "vo.md", ["plots/vo-error.svg", "plots/vo-occluders.svg",
                                                       "plots/vo-split.svg"]),
    ("what keeps an error, asked of a scene", "advise.md", ["plots/advise*.svg"]),
    ("float or double at the extremes", "stability.md", ["plots/stability*.svg"]),
]


class Trade:
    """Errors by set-up and light, the worst over the meshes."""

    def __init__(self, table):
        self.error, self.off_float = {}, {}
        for r in table.rows:
            key = (r["light"], int(r["bands"]), int(r["rays"]), r["storage"])
            self.error[key] = max(float(r["rmse"]), self.error.get(key, 0))
            self.off_float[key] = max(float(r["off_float"]), self.off_float.get(key, 0))
        self.lights = list(dict.fromkeys(k[0] for k in self.error))
        self.maps = [l for l in self.lights if l not in (SOFT, HARD)]
        self.bands = sorted({k[1] for k in self.error})
        self.rays = sorted({k[2] for k in self.error} - {0})
        self.meshes = table.values("mesh")

    def of(self, lights, pick, *setup):
        return pick([self.error[(l,) + setup] for l in lights])


def bake_ns(bake, bands):
    """Of a ray: the row of as many bands, or the next."""
    rows = sorted((int(r["bands"]), float(r["bake_ns"])) for r in bake.rows if r["build"] == "native"
                  and r["rays"] == "1024")
    return next((ns for b, ns in rows if b >= bands), rows[-1][1])


def shade_ns(speed, bands, storage):
    return speed.one("ns", job="diffuse_n", name=STORED[storage][2], build="native", precision="float", bands=bands)


def cheapest(trade, lights, pick, wanted):
    """Fewest bytes, then fewest rays; None where nothing that was tried is good enough."""
    tried = sorted((b * b * STORED[s][1], r, b, s) for b in trade.bands for r in trade.rays for s in STORED)
    for size, rays, bands, storage in tried:
        error = trade.of(lights, pick, bands, rays, storage)
        if error <= wanted:
            return size, rays, bands, storage, error
    return None


def percent(value):
    return figure(100 * value, 2) + " %"


def choice_table(trade, speed, bake):
    classes = (("overcast sky", [SOFT], max), ("a photographed environment", trade.maps, statistics.median_low),
               ("any of the six environments", trade.maps, max), ("bare sun", [HARD], max))
    rows = []
    for name, lights, pick in classes:
        last = None
        for wanted in WANTED:
            found = cheapest(trade, lights, pick, wanted)
            if not found:
                best = min(trade.of(lights, pick, trade.bands[-1], r, "float") for r in trade.rays)
                rows.append([f"{name}, {percent(wanted)}", f"not with {trade.bands[-1]}", "", "", "", "", "",
                             f"{percent(best)} at best"])
                break
            if found == last:
                rows[-1][0] = f"{name}, {percent(wanted)}"
                continue
            last = found
            size, rays, bands, storage, error = found
            rows.append([f"{name}, {percent(wanted)}", str(bands), str(rays), STORED[storage][0], str(size),
                         figure(shade_ns(speed, bands, storage)), figure(rays * bake_ns(bake, bands) / 1000),
                         percent(error)])
    return markdown(["light, wanted error", "bands", "rays a vertex", "storage", "bytes a vertex",
                     "shading, ns a vertex", "baking, µs a vertex", "error measured"], rows)


def bands_table(trade):
    return markdown(["bands", "coefficients"] + trade.lights,
                    [[str(b), str(b * b)] + [percent(trade.error[(l, b, 0, "float")]) for l in trade.lights]
                     for b in trade.bands])


def rays_table(trade):
    columns = [(b, l) for b in (3, 5, 8) for l in (SOFT, "forest", HARD)]
    name = {0: "without noise"}
    return markdown(["rays"] + [f"{b} bands, {l}" for b, l in columns],
                    [[name.get(r, str(r))] + [percent(trade.error[(l, b, r, "float")]) for b, l in columns]
                     for r in trade.rays + [0]])


def storage_table(trade, speed):
    rows, lights = [], (SOFT, "forest", HARD)
    for bands in (3, 5, 8, 10):
        for s, (name, size, _) in STORED.items():
            rows.append([f"{bands}, {name}", str(bands * bands * size), figure(shade_ns(speed, bands, s))] +
                        [percent(trade.error[(l, bands, 0, s)]) for l in lights] +
                        [percent(trade.off_float[(l, bands, 0, s)]) if s != "float" else "" for l in lights])
    return markdown(["bands, storage", "bytes a vertex", "shading, ns a vertex"] + list(lights) +
                    [f"{l}, of that by storage" for l in lights], rows)


def draw(root, trade):
    plot(root, "bands_rmse", "Bands against error", "bands", "RMSE of exit radiance over its mean",
         [(l, [(b, trade.error[(l, b, 0, "float")]) for b in trade.bands], line(i, point=5 + i % 4))
          for i, l in enumerate(trade.lights)], "set xtics (1, 2, 3, 4, 5, 6, 8, 10)")
    plot(root, "rays_rmse", "Rays against error", "rays a vertex", "RMSE of exit radiance over its mean",
         [(f"{l}, {b} bands", [(r, trade.error[(l, b, r, "float")]) for r in trade.rays], line(i, dash, 5 + i))
          for i, l in enumerate((SOFT, "forest", HARD)) for b, dash in ((3, 3), (5, 2), (8, 1))],
         "set xrange [50:5200]; set xtics (64, 256, 1024, 4096)")
    plot(root, "storage_pareto", "Storage: error against bytes, 2 to 10 bands", "bytes a vertex",
         "RMSE of exit radiance over its mean",
         [(f"{l}, {STORED[s][0]}", [(b * b * STORED[s][1], trade.error[(l, b, 0, s)]) for b in trade.bands if b > 1],
           line(i, dash, 5 + i)) for l, dash in ((SOFT, 1), (HARD, 3)) for i, s in enumerate(STORED)] +
         [(f"{STORED[s][0]} alone, {SOFT}", [(b * b * STORED[s][1], trade.off_float[(SOFT, b, 0, s)])
                                            for b in trade.bands if b > 1], line(i, 2, 5 + i))
          for i, s in enumerate(STORED) if s != "float"])


def trades(root):
    """Links to what is there: other programs draw these, so --check does not ask for them."""
    lines = []
    for what, page, plots in TRADES:
        drawn = [p for pattern in plots for p in sorted((root / "docs").glob(pattern))]
        if not (root / "docs" / page).exists() or not drawn:
            continue
        links = ", ".join(f"[{p.stem}]({p.relative_to(root / 'docs')})" for p in drawn)
        lines.append(f"| {what} | [{page}]({page}) | {links} |")
    return "| choice | page | plots |\n|---|---|---|\n" + "\n".join(lines) + "\n"


def page(root, table, speed, bake, linked):
    trade = Trade(table)
    given = dict(l.split(": ", 1) for l in table.stamp if ": " in l)
    return "\n".join([f"""# How many bands, rays and bits

{NOTE}

Look up your light and the error that you can live with:

{choice_table(trade, speed, bake)}
The cheapest of what was tried, by bytes, then by rays: 1 to {trade.bands[-1]} bands, {', '.join(map(str, trade.rays))} rays,
float, half, 16 and 8 bits. Errors are the root mean square over {given['points']} vertices and colours of what exit
radiance at albedo 1 is off from ray tracing, over its mean, at the worse of two meshes on a floor
({', '.join(trade.meshes)}); rows whose set-up is the next row's are left out. *A photographed environment*: at least
three of six environment maps (examples/data) are as good or better. Shading and baking: one thread, the machine below,
everything in the caches; the ranges of packed transfer take another 8 bytes a coefficient for the whole mesh. Your own
scene: `advise mesh environment` measures it, [advise.md](advise.md).
""", report.stamp(table), f"""## Bands

![Error against bands](plots/bands_rmse.svg)

Transfer from {given['rays of the truth']} rays, so that bands alone err. Errors in percent of the mean.

{bands_table(trade)}
Unshadowed transfer has nothing at l = 3, 5, 7, ...: the step from 3 to 4 bands, or 5 to 6, serves shadows alone.

## Rays

![Error against rays](plots/rays_rmse.svg)

{rays_table(trade)}
## Storage

![Error against bytes](plots/storage_pareto.svg)

Packed by `prt_transfer_pack`, shaded by `prt_shade_packed_n`, ranges over the vertices that were looked at. Without
noise of rays. *By storage*: the root mean square difference from shading with floats, over the same mean.

{storage_table(trade, speed)}
## Other choices, measured elsewhere

""" + (trades(root) if linked else "")])


def main():
    options = report.arguments("Writes docs/choose.md from measurements.")
    root, results = options.root, options.root / "bench" / "results"
    files = [results / (name + ".csv") for name in ("trade", "speed", "bake-speed")]
    for path in files:
        if not path.exists():
            report.complain(f"cannot read {path}; measure with make docs")
    table, speed, bake = map(Table, files)
    if not options.check:
        draw(root, Trade(table))
    report.put([(root / "docs" / "choose.md", page(root, table, speed, bake, not options.check))], options.check)


if __name__ == "__main__":
    sys.exit(main())
