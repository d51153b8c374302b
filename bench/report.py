#!/usr/bin/env python3
"""Writes docs/speed.md, docs/accuracy.md, their plots and the cost table of README.md from the CSV files of prt_bench
and accuracy.

usage: report.py [--speed CSV] [--accuracy CSV] [--peers CSV] [--root DIRECTORY] [--check]

Without options it reads bench/results/{speed,accuracy,peers}.csv of the tree that it stands in; a file that is not
there is left out, with what depends on it. --peers takes the CSV of a prt_bench with peers plugged in (peer.h), and
keeps in bench/results/peers.csv the groups in which a peer took part. Needs gnuplot for the plots. --check writes
nothing and exits with 1 unless pages and README say what the files say.
"""
import argparse
import csv
import pathlib
import re
import shutil
import subprocess
import sys

NOTE = "<!-- Written by bench/report.py from bench/results/*.csv: do not edit. `make docs` measures and writes anew. -->"

CHOOSE = "How many bands, rays and bits to use, and error against time of every choice: [choose.md](choose.md)."

# What each job computes, for headings. A job that is not listed appears under its own name.
TITLES = {
    "eval": "Evaluate the basis in one direction (`prt_sh_eval`)",
    "eval_n": "Evaluate many directions, row by row (`prt_sh_eval_n`)",
    "eval_soa": "Evaluate many directions, coefficient by coefficient (`prt_sh_eval_soa`)",
    "at": "Reconstruct a function in one direction (`prt_sh_at`)",
    "dot": "Integrate a product (`prt_sh_dot`)",
    "add_sample": "Add one sample of a function (`prt_sh_add_sample`)",
    "delta": "Project a directional light (`prt_sh_delta`)",
    "cone": "Project a cone (`prt_sh_cone`)",
    "sphere": "Project a sphere (`prt_sh_sphere`)",
    "cosine_lobe": "Project a clamped cosine (`prt_sh_cosine_lobe`)",
    "hemisphere": "Project sky and ground (`prt_sh_hemisphere`)",
    "equirect": "Project a latitude-longitude map, ns a texel (`prt_sh_project_equirect_rgb`, 256 x 128)",
    "cubemap": "Project a cube map, ns a texel (`prt_sh_project_cubemap_rgb`, 6 x 64 x 64)",
    "convolve": "Convolve with a zonal kernel (`prt_sh_convolve`)",
    "irradiance": "Irradiance from radiance (`prt_sh_irradiance`)",
    "window": "Window the bands (`prt_sh_window`)",
    "rotate": "Rotate one vector in one call (`prt_sh_rotate`)",
    "rotate_z": "Rotate about z (`prt_sh_rotate_z`)",
    "zonal_to": "Turn a zonal function (`prt_sh_zonal_to`)",
    "rotation": "Build rotation matrices (`prt_sh_rotation`)",
    "rotate_by": "Rotate one vector by built matrices (`prt_sh_rotate_by`)",
    "rotate_by_n": "Rotate many vectors by built matrices",
    "convert": "Coefficients of another program (`prt_sh_convert`)",
    "axes": "Axes of another world (`prt_sh_convert_axes`)",
    "product": "Multiply two functions (`prt_sh_product`)",
    "product_soa": "Multiply many pairs (`prt_sh_product_soa`)",
    "mask": "Mask a light by a filter (`prt_sh_mask`)",
    "exp": "Exponential of a log visibility (`prt_sh_exp`)",
    "log": "Logarithm of a visibility (`prt_sh_log`)",
    "dering": "Smooth until nothing is negative (`prt_sh_dering`)",
    "ch_eval": "Evaluate cpherical harmonics in one direction (`prt_ch_eval`)",
    "ch_eval_n": "Evaluate cpherical harmonics in many directions, row by row (`prt_ch_eval_n`)",
    "ch_eval_soa": "Evaluate cpherical harmonics, coefficient by coefficient (`prt_ch_eval_soa`)",
    "ch_at": "Reconstruct from cpherical coefficients (`prt_ch_at`)",
    "ch_from_sh": "Spherical to cpherical coefficients (`prt_ch_from_sh`)",
    "sh_from_ch": "Cpherical to spherical coefficients (`prt_sh_from_ch`)",
    "ch_rotate": "Rotate a cpherical function (`prt_ch_rotate`)",
    "ch_product": "Multiply two cpherical functions (`prt_ch_product`)",
    "ch_dot": "Integrate a product of cpherical functions (`prt_ch_dot`)",
    "axes_map": "The map between two worlds (`prt_axes_map`)",
    "shader_constants": "Irradiance as shader constants (`prt_sh_pack_irradiance`)",
    "window_weight": "One weight of a window (`prt_window_weight`)",
    "minimum": "Least value of a function (`prt_sh_minimum`)",
    "quaternion": "Rotation of a quaternion (`prt_rotation_from_quaternion`)",
    "triple": "One triple product coefficient (`prt_sh_triple`)",
    "product_matrix": "The matrix of a product (`prt_sh_product_matrix`)",
    "product_by": "Multiply by a matrix made before (`prt_sh_product_by_n`)",
    "ch_moments": "Cpherical moments to and from coefficients (`prt_ch_from_moments`)",
    "ch_norm": "One factor of the cpherical basis (`prt_ch_norm`)",
    "fiv_shade 1 occluder": "Irradiance under one moving occluder (`prt_fiv_shade_n`)",
    "fiv_shade 10 occluders": "Irradiance under 10 moving occluders, ns an occluder (`prt_fiv_shade_n`)",
    "fiv_shade 60 occluders": "Irradiance under 60 moving occluders, ns an occluder (`prt_fiv_shade_n`)",
    "fiv_lookup": "Look up what an occluder hides (`prt_fiv_lookup`)",
    "fiv_self": "Shadow of an object on itself (`prt_fiv_self`)",
    "fiv_vector": "One irradiance vector (`prt_fiv_add`, `prt_fiv_irradiance`)",
    "fiv_total": "Irradiance of the whole environment (`prt_fiv_total`)",
    "fiv_transfer_light": "A light for turning occluders (`prt_fiv_transfer_light`)",
    "fiv_table": "Tables of irradiance vectors, ns a sample (`prt_fiv_pack`, `_unpack`, `prt_fiv_transfer_samples`)",
    "fiv_packed_size": "Size of a packed table (`prt_fiv_packed_size`)",
    "vo_dd": "Vector occluders, diffuse; \"bands\" counts lights (`prt_vo_shade_n`)",
    "vo_all": "Vector occluders, all terms; \"bands\" counts lights (`prt_vo_shade_n`)",
    "vo_pack": "Pack and unpack vector occluders (`prt_vo_pack`)",
    "vo_index": "Vector occluders with a table of materials, 5 (`prt_vo_index`, `prt_vo_expand`)",
    "vo_size": "Size of packed vector occluders (`prt_vo_size`)",
    "vo_bend": "Bend vector occluders under water (`prt_vo_bend`)",
    "reference": "Slow evaluators for tests (`prt_reference_sh`, `prt_reference_project`)",
    "result_string": "Text of a result (`prt_result_string`)",
    "unpack": "Transfer of packed transfer (`prt_transfer_unpack`)",
    "diffuse_n": "Shade from transfer, three colours (`prt_shade_diffuse_n`)",
    "incident_n": "Light through a transfer matrix (`prt_shade_incident_n`)",
    "glossy_n": "Shade a glossy lobe (`prt_shade_glossy_n`)",
    "phong": "Factors of Phong's lobe (`prt_phong_zonal`)",
    "local_frame": "A frame about a normal (`prt_local_frame`)",
}

COLOURS = ["#1b6ca8", "#d1495b", "#2e8b57", "#b5651d", "#6a4c93", "#555555", "#e0a100", "#00868b"]


def complain(text):
    sys.exit("report.py: " + text)


def arguments(description, *names):
    options = argparse.ArgumentParser(description=description)
    options.add_argument("--root", type=pathlib.Path, default=pathlib.Path(__file__).resolve().parent.parent)
    options.add_argument("--check", action="store_true", help="write nothing; fail unless the pages are up to date")
    for name in names:
        options.add_argument("--" + name, type=pathlib.Path)
    return options.parse_args()


def put(pages, check):
    """Writes each (path, text), or with `check` leaves the program where one does not begin with its text."""
    stale = [path for path, text in pages if check and (not path.exists() or not path.read_text().startswith(text))]
    for path in stale:
        print(f"{path} does not say what bench/results/ says: make docs-tables writes it anew", file=sys.stderr)
    if stale:
        sys.exit(1)
    for path, text in pages:
        if not check:
            path.parent.mkdir(exist_ok=True)
            path.write_text(text)


class Table:
    """A CSV file whose stamp stands in lines that begin with '#'."""

    def __init__(self, path):
        lines = path.read_text().splitlines()
        self.stamp = [line[2:] for line in lines if line.startswith("# ")]
        self.rows = list(csv.DictReader(line for line in lines if not line.startswith("#")))
        self.indexes = {}
        if not self.rows:
            complain(f"{path} has no rows; measure again with make docs")

    def where(self, **wanted):
        keys = tuple(sorted(wanted))
        if keys not in self.indexes:
            index = self.indexes[keys] = {}
            for row in self.rows:
                index.setdefault(tuple(row[k] for k in keys), []).append(row)
        return self.indexes[keys].get(tuple(str(wanted[k]) for k in keys), [])

    def values(self, column, **wanted):
        """The different values of a column, in order of appearance."""
        return list(dict.fromkeys(r[column] for r in self.where(**wanted)))

    def one(self, column, **wanted):
        found = self.where(**wanted)
        return float(found[0][column]) if found else None


def figure(value, digits=3):
    """Three significant digits, without exponents for the range of ordinary times."""
    if value is None:
        return ""
    if value == 0:
        return "0"
    if not 1e-3 <= abs(value) < 1e7:
        return f"{value:.2g}"
    text = f"{value:.{digits}g}"
    return f"{float(text):.0f}" if "e" in text else text


def markdown(header, rows):
    aligned = ["|" + "|".join("---" if i == 0 else "--:" for i in range(len(header))) + "|"]
    return "\n".join(["| " + " | ".join(header) + " |"] + aligned +
                     ["| " + " | ".join(row) + " |" for row in rows]) + "\n"


def stamp(table):
    lines = []
    for line in table.stamp:
        key, _, flags = line.partition(": ")
        if "double" in key or (key.startswith("flags of") and "plain" in key):
            continue
        lines.append("- " + line.replace("flags of float_", "flags of ") if ":" in line else "- " + line)
    if any("_plain" in line for line in table.stamp):
        lines.append("- `plain` builds add -DPRT_NO_SIMD, double adds -DPRT_DOUBLE")
    return "\n".join(lines) + "\n"


def plot(root, name, title, xlabel, ylabel, series, extra=""):
    """series: (label, [(x, y)], gnuplot style). Logarithmic axes."""
    if not shutil.which("gnuplot"):
        print("report.py: gnuplot is not installed; plots are left as they are")
        return
    out = root / "docs" / "plots" / (name + ".svg")
    out.parent.mkdir(parents=True, exist_ok=True)
    drawn, data = [], []
    for label, points, style in series:
        points = [(x, y) for x, y in points if x and y]
        if points:
            drawn.append(f'"-" title "{label}" with {style}')
            data.append("\n".join(f"{x:g} {y:g}" for x, y in points) + "\ne\n")
    script = f'''set terminal svg size 760,460 font "sans-serif,13" background rgb "white"
set output "{out}"
set title "{title}" noenhanced
set xlabel "{xlabel}"
set ylabel "{ylabel}"
set logscale xy
set autoscale xfix
set format y "10^{{%T}}"
set grid lt 1 lc rgb "#dddddd" lw 0.5
set key outside right top vertical Left reverse spacing 1.1
{extra}
plot ''' + ", ".join(drawn) + "\n" + "".join(data)
    done = subprocess.run(["gnuplot"], input=script, text=True, capture_output=True)
    if done.returncode:
        complain("gnuplot failed: " + done.stderr.strip())


def line(i, dash=1, point=7):
    return f'linespoints lc rgb "{COLOURS[i % len(COLOURS)]}" lw 1.6 dt {dash} pt {point} ps 0.5'


# ---------------------------------------------------------------------------------------------------------- speed


def job_table(speed, job):
    """One row for each number of bands; columns for each candidate in float and double, and the builds of the first."""
    names = speed.values("name", job=job, peer=0)
    first = names[0]
    header = ["bands", "flops", "bytes"] + [f"{n}, {p}" for n in names for p in ("float", "double")]
    header += ["± %", "float, portable", "float, portable plain C", "to a plain write", "to a copy", "to peak flops"]
    rows = []
    for bands in speed.values("bands", job=job, peer=0):
        at = dict(job=job, bands=bands, peer=0)
        native = dict(name=first, build="native", precision="float", **at)
        moved = sum(speed.one(f"bytes_{way}", **native) or 0 for way in ("read", "written"))
        row = [bands if bands != "0" else "", figure(speed.one("flops", name=first, **at) or None),
               figure(moved or None)]
        for name in names:
            for precision in ("float", "double"):
                row.append(figure(speed.one("ns", name=name, build="native", precision=precision, **at)))
        row.append(figure(100 * (speed.one("spread", **native) or 0), 2))
        for build in ("portable", "portable plain"):
            row.append(figure(speed.one("ns", name=first, build=build, precision="float", **at)))
        row.append(figure(speed.one("of_write", **native) or None, 2))
        row.append(figure(speed.one("of_copy", **native) or None, 2))
        row.append(figure(speed.one("of_flops", **native) or None, 2))
        rows.append(row)
    empty = [i for i in range(1, len(header)) if not any(row[i] for row in rows)]
    keep = [i for i in range(len(header)) if i not in empty]
    return markdown([header[i] for i in keep], [[row[i] for i in keep] for row in rows])


def curve(speed, job, name, precision="float", build="native", column="ns"):
    rows = speed.where(job=job, name=name, precision=precision, build=build)
    return [(float(r["bands"]), float(r[column])) for r in rows]


def plot_eval_time(root, speed):
    write = [(b, ns / ratio) for (b, ns), (_, ratio) in
             zip(curve(speed, "eval_soa", "prt_sh_eval_soa"),
                 curve(speed, "eval_soa", "prt_sh_eval_soa", column="of_write")) if ratio]
    plot(root, "eval_time", "Evaluating the basis, float", "bands", "ns a direction", [
        ("textbook K P", curve(speed, "eval", "textbook K P"), line(5)),
        ("recurrence", curve(speed, "eval", "recurrence, any band"), line(3)),
        ("one direction", curve(speed, "eval", "prt_sh_eval"), line(0)),
        ("many, rows", curve(speed, "eval_n", "prt_sh_eval_n"), line(1)),
        ("many, SoA", curve(speed, "eval_soa", "prt_sh_eval_soa"), line(2)),
        ("plain write", write, line(4, dash=3, point=0)),
    ], 'set xtics (1, 2, 3, 4, 5, 6, 8, 10, 16, 32, 64)')


def side_by_side(peers):
    """How the plugged-in libraries compare: time over that of prt.h's own native row of the same group."""
    text = []
    for job in peers.values("job"):
        names = peers.values("name", job=job, peer=1)
        if not names:
            continue
        own = peers.values("name", job=job, peer=0)[0]
        rows = []
        for precision in ("float", "double"):
            for bands in peers.values("bands", job=job, peer=1, precision=precision):
                at = dict(job=job, bands=bands, precision=precision, build="native")
                mine = peers.one("ns", name=own, **at)
                theirs = [peers.one("ns", name=n, **at) for n in names]
                if mine:
                    rows.append([f"{bands}, {precision}", figure(mine)] +
                                [f"{figure(t)} ({t / mine:.2f}x)" if t else "" for t in theirs])
        rows.sort(key=lambda r: (r[0].split(", ")[1] == "double", int(r[0].split(",")[0])))
        text.append(f"### {TITLES.get(job, job)}\n\n" + markdown(["bands", own] + names, rows))
    return "\n".join(text)


def keep_peers(path, kept):
    """Copies the groups in which a peer took part."""
    lines = path.read_text().splitlines(keepends=True)
    head = next(line for line in lines if not line.startswith("#"))

    def group(row):
        return row["job"], row["bands"], row["precision"]
    rows = {line: next(csv.DictReader([head, line])) for line in lines if not line.startswith("#") and line != head}
    wanted = {group(row) for row in rows.values() if row["peer"] == "1"}
    kept.write_text("".join(line for line in lines if line not in rows or group(rows[line]) in wanted))


def speed_page(root, speed, peers):
    text = [f"# Speed\n\n{NOTE}\n", f"{CHOOSE}\n", stamp(speed), """
Nanoseconds for one item: the median of interleaved rounds, so that ratios within a table are firmer than the times.
*Flops*, *bytes* (read and written, float), *±* (half the interquartile range) and the ceilings are those of the first
column. *To a plain write* and *to a copy* are the time over that of `memset` and `memcpy` on the same output bytes; *to
peak flops* over the time that the same operations take at the machine's peak rate of multiply-adds. All ceilings run in
the same rounds. `native` columns use all that the machine has, *portable* the compiler's default target, *plain C* that with `PRT_NO_SIMD`.
[bench/results/speed.csv](../bench/results/speed.csv) has every figure: spreads, minima, cycles, bytes, all builds.

![Time against bands](plots/eval_time.svg)
"""]
    if (root / "docs" / "plots" / "eval_pareto.svg").exists():
        text.append("What the choice of evaluator costs and gives, each line from 2 to 64 bands:\n\n"
                    "![Error against time](plots/eval_pareto.svg)\n")
    for job in speed.values("job"):
        text.append(f"## {TITLES.get(job, job)}\n\n{job_table(speed, job)}")
    if peers:
        text.append("## Beside other libraries\n\nTheir sources were fetched, compiled with the flags of `native` and "
                    "measured in the same run as prt.h (bench/peer.h tells how to do it again); ns, and the factor to "
                    "prt.h.\n\n" + stamp(peers) + "\n" + side_by_side(peers))
    return root / "docs" / "speed.md", "\n".join(text)


# ------------------------------------------------------------------------------------------------------- accuracy


def worst(accuracy, column, **wanted):
    found = [float(r[column]) for r in accuracy.where(**wanted)]
    return max(found) if found else None


def break_down(accuracy, precision):
    """Where the textbook form first fails: the fewest bands with a value that is lost or not finite, away from poles."""
    first = {}
    for r in accuracy.where(form="textbook K P", precision=precision, where="elsewhere"):
        for kind in ("lost", "not_finite"):
            if int(r[kind]) and kind not in first:
                first[kind] = r["bands"]
    parts = []
    tested = max(int(n) for n in accuracy.values("bands", form="textbook K P", precision=precision))
    if "lost" in first:
        parts.append(f"values vanish from {first['lost']} bands")
    if "not_finite" in first:
        parts.append(f"NaN or infinity from {first['not_finite']}")
    return f"{precision}: " + (" and ".join(parts) if parts else f"no value lost up to {tested} bands")


def plot_eval_error(root, accuracy):
    series = []
    for label, colour, wanted in (("textbook, ", 1, dict(form="textbook K P")), ("", 0, dict(form="prt_sh_eval")),
                                  ("away from poles, ", 2, dict(form="prt_sh_eval", where="elsewhere"))):
        for precision, dash in (("float", 1), ("double", 2)):
            points = [(float(n), worst(accuracy, "error", precision=precision, bands=n, **wanted))
                      for n in accuracy.values("bands", precision=precision, **wanted)]
            style = f'lines lc rgb "{COLOURS[colour]}" lw 2 dt {dash}'
            series.append((label + precision, [p for p in points if p[0] > 1], style))
    plot(root, "eval_error", "Largest error of prt_sh_eval", "bands", "absolute error", series,
         "set xtics (2, 4, 8, 16, 32, 64, 128, 256, 512, 1024)")


def accuracy_page(root, accuracy):
    shown = [str(n) for n in (1, 2, 3, 4, 5, 6, 8, 10, 13, 16, 24, 32, 48, 64, 96, 128, 256, 512, 1024)]
    shown = [n for n in shown if accuracy.where(bands=n)]
    rows = []
    for n in shown:
        row = [n]
        for precision in ("float", "double"):
            at = dict(form="prt_sh_eval", precision=precision, bands=n)
            row += [figure(worst(accuracy, "error", **at)), figure(worst(accuracy, "error", where="elsewhere", **at)),
                    figure(worst(accuracy, "own_error", **at)), figure(worst(accuracy, "rms", **at))]
        for precision in ("float", "double"):
            at = dict(form="textbook K P", precision=precision, bands=n)
            broken = sum(int(r["not_finite"]) for r in accuracy.where(**at))
            row.append("NaN" if broken else figure(worst(accuracy, "error", **at)))
        rows.append(row)
    header = ["bands", "float", "away from poles", "beyond input rounding", "rms",
              "double", "away from poles", "beyond input rounding", "rms", "textbook float", "textbook double"]
    finite = all(r["not_finite"] == "0" for r in accuracy.rows if r["form"] != "textbook K P")
    others = []
    for form in [f for f in accuracy.values("form") if f not in ("prt_sh_eval", "textbook K P")]:
        for n in [n for n in shown if n in ("3", "5", "8", "10", "16", "32", "64", "256", "1024")]:
            at = dict(form=form, bands=n)
            others.append([f"{form}, {n}"] + [figure(worst(accuracy, "error", precision=p, **at)) for p in
                                              ("float", "double")] +
                          [figure(worst(accuracy, "own_error", precision=p, **at)) for p in ("float", "double")])
    counts = {w: int(accuracy.where(form="prt_sh_eval", precision="float", bands=1, where=w)[0]["values"])
              for w in ("poles", "elsewhere")}
    text = f"""# Accuracy

{NOTE}

{CHOOSE}

{stamp(accuracy)}
Largest absolute error of a coefficient of the basis over {counts['poles']} directions at and near the poles (down to
1e-30 from them) and {counts['elsewhere']} elsewhere. Truth comes from MPFR with 256 bits, at exactly the binary numbers
(x,y,z) that the function was given, normalised there. *Beyond input rounding* compares with the polynomials at these
numbers without normalising them: it is what the evaluation itself adds, the rest is due to (x,y,z) not being of length
1 exactly, and grows near the poles with the square of the band. {'Every value is finite, in all forms but the textbook one.' if finite else '**Some values are not finite.**'}

![Error against bands](plots/eval_error.svg)

{markdown(header, rows)}
The textbook form K(l,m) P(l,m)(cos t) cos(m p) takes sin t = sqrt(1 - z^2) from a rounded z and multiplies factorials:
{break_down(accuracy, 'float')}; {break_down(accuracy, 'double')}; and near the poles it loses half of the digits at any
number of bands.

## The other evaluators

{markdown(["evaluator, bands", "float", "double", "float, beyond input rounding", "double, beyond input rounding"], others)}"""
    return root / "docs" / "accuracy.md", text


def plot_pareto(root, speed, accuracy):
    choices = [("textbook", "eval", "textbook K P", "textbook K P", 5), ("recurrence", "eval", "recurrence, any band",
               "recurrence, any band", 3), ("one direction", "eval", "prt_sh_eval", "prt_sh_eval", 0),
               ("many, SoA", "eval_soa", "prt_sh_eval_soa", "prt_sh_eval_soa", 2)]
    series = []
    for label, job, name, form, colour in choices:
        for precision, dash in (("float", 1), ("double", 2)):
            points = []
            for bands, ns in curve(speed, job, name, precision):
                error = worst(accuracy, "error", form=form, precision=precision, bands=int(bands))
                if error and bands > 1:
                    points.append((ns, error))
            series.append((f"{label}, {precision}", points, line(colour, dash)))
    plot(root, "eval_pareto", "Evaluation: error against time, 2 to 64 bands", "ns a direction", "largest error", series)


# --------------------------------------------------------------------------------------------------------- README


def readme_page(root, speed, accuracy):
    path = root / "README.md"
    begin, end = "<!-- BEGIN TABLE cost -->", "<!-- END TABLE cost -->"
    if not path.exists() or begin not in path.read_text() or end not in path.read_text():
        complain(f"README.md has no place for the table ({begin} ... {end})")
    columns = [("evaluate one direction", "eval", "prt_sh_eval"), ("one of many", "eval_soa", "prt_sh_eval_soa"),
               ("reconstruct", "at", "prt_sh_at"), ("rotate", "rotate", "prt_sh_rotate"),
               ("product", "product", "prt_sh_product"), ("shade a vertex", "diffuse_n", "prt_shade_diffuse_n")]
    columns = [c for c in columns if speed.where(job=c[1], name=c[2])]
    rows = []
    for n in ("2", "3", "4", "5", "6", "8", "10"):
        row = [n, str(int(n) ** 2)]
        for _, job, name in columns:
            row.append(figure(speed.one("ns", job=job, name=name, bands=n, build="native", precision="float")))
        for precision in ("float", "double"):
            row.append(figure(worst(accuracy, "error", form="prt_sh_eval", precision=precision, bands=n), 2))
        rows.append(row)
    header = ["bands", "coefficients"] + [c[0] for c in columns] + ["error, float", "error, double"]
    of = {key: value for key, _, value in (line.partition(": ") for line in speed.stamp)}
    table = markdown(header, rows) + (f"\nNanoseconds, float, {of.get('machine', '')} at {of.get('clock', '?')}, "
                                      f"{of.get('compiler', '')}, `{of.get('flags of float_native', '')}`; largest "
                                      "error of the basis against MPFR, poles included. More in "
                                      "[docs/speed.md](docs/speed.md) and [docs/accuracy.md](docs/accuracy.md).\n")
    return path, re.sub(re.escape(begin) + ".*?" + re.escape(end), lambda _: f"{begin}\n{table}{end}",
                        path.read_text(), flags=re.S)


def main():
    options = arguments("Writes the tables and plots of docs/ from measurements.", "speed", "accuracy", "peers")
    if options.peers:
        if not options.peers.exists():
            complain(f"cannot read {options.peers}")
        kept = options.root / "bench" / "results" / "peers.csv"
        keep_peers(options.peers, kept)
        options.peers = kept
    tables = {}
    for name in ("speed", "accuracy", "peers"):
        path = getattr(options, name) or options.root / "bench" / "results" / (name + ".csv")
        if not path.exists() and getattr(options, name):
            complain(f"cannot read {path}")
        tables[name] = Table(path) if path.exists() else None
    root, speed, accuracy, peers = options.root, tables["speed"], tables["accuracy"], tables["peers"]
    pages = []
    if accuracy:
        pages.append(accuracy_page(root, accuracy))
    if speed and accuracy:
        pages.append(readme_page(root, speed, accuracy))
    if speed:
        pages.append(speed_page(root, speed, peers))
    if not options.check:
        if accuracy:
            plot_eval_error(root, accuracy)
        if speed:
            plot_eval_time(root, speed)
        if speed and accuracy:
            plot_pareto(root, speed, accuracy)
    put(pages, options.check)


if __name__ == "__main__":
    main()
