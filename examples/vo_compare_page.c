/* What vo_compare writes: contact sheets, plots, and the page. */
#define _POSIX_C_SOURCE 200809L
#include "vo_compare.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "../bench/bench.h"
#include "plot.h"
#include "replacement.h"
#include "vector.h"

/* ---- pictures ---- */

enum { MOST_COLUMNS = TECHNIQUE_COUNT + 1, MOST_ROWS = 4 };

typedef struct sheet_row { stage *s; int which, set; const char *name; } sheet_row;

void caption(sheet_cell *cell, const score *s) {
    snprintf(cell->first, sizeof cell->first, "RMSE %.1f %%", 100 * s->rmse);
    snprintf(cell->second, sizeof cell->second, "SSIM %.3f", s->ssim);
}

/* One row: the reference, then the techniques in order. */
static int fill_row(const sheet_row *row, int matte, int paths, int columns, const technique *order, picture *pictures,
                    sheet_cell *cells, why *w) {
    int k;
    if (paint_reference(row->s, matte, row->which, row->set, &pictures[0], w)) return -1;
    cells[0].shown = &pictures[0];
    snprintf(cells[0].first, sizeof cells[0].first, "noise %.1f %%", 100 * row->s->noise[matte][row->which][row->set]);
    snprintf(cells[0].second, sizeof cells[0].second, "%d paths a pixel",
             paths * PATH_HALVES * SAMPLES_A_PIXEL * SAMPLES_A_PIXEL);
    for (k = 1; k < columns; k++) {
        if (paint(row->s, matte, row->which, row->set, order[k - 1], &pictures[k], NULL, w)) return -1;
        cells[k].shown = &pictures[k];
        caption(&cells[k], &row->s->scores[matte][row->which][order[k - 1]][row->set]);
    }
    return 0;
}

static int write_sheet(const study *d, const char *file, const char *title, int matte, int rows, const sheet_row *row,
                       int columns, const technique *order, why *w) {
    static picture pictures[MOST_ROWS * MOST_COLUMNS];
    static sheet_cell cells[MOST_ROWS * MOST_COLUMNS];
    const char *heads[MOST_COLUMNS], *names[MOST_ROWS];
    double exposures[MOST_ROWS];
    char path[1024];
    contact_sheet s;
    int k, failed = 0;
    memset(&s, 0, sizeof s);
    memset(pictures, 0, sizeof pictures);
    memset(cells, 0, sizeof cells);
    heads[0] = "path traced";
    for (k = 1; k < columns; k++) heads[k] = technique_names[order[k - 1]];
    for (k = 0; k < rows && !failed; k++) {
        failed = fill_row(&row[k], matte, d->o.paths, columns, order, pictures + k * columns, cells + k * columns, w);
        names[k] = row[k].name;
        exposures[k] = failed ? 1 : picture_exposure(&pictures[k * columns]);
    }
    s.title = title;
    s.rows = rows;
    s.columns = columns;
    s.per_pixel = SAMPLES_A_PIXEL;
    s.width = s.height = d->o.size;
    s.heads = heads;
    s.names = names;
    s.exposures = exposures;
    s.cells = cells;
    s.foot[0] = "RMSE: of linear radiance over the pixels of the scene, relative to the mean of the path-traced "
                "picture. All techniques shade vertices.";
    if (matte) s.foot[1] = "CH3 and CH6 use inner products as coefficients, as the thesis does; with its Gram matrix "
                           "CH gives the pictures of SH.";
    snprintf(path, sizeof path, "%s/gallery/%s", d->o.out, file);
    if (!failed) failed = contact_sheet_write(&s, path, w);
    for (k = 0; k < rows * columns; k++) picture_free(&pictures[k]);
    if (!failed) printf("%s\n", path);
    return failed;
}

int write_pictures(study *d, why *w) {
    static const technique all[] = { TECHNIQUE_VO_DD, TECHNIQUE_VO_DD_CAP, TECHNIQUE_SH6, TECHNIQUE_SH3,
                                     TECHNIQUE_CH6,   TECHNIQUE_CH3,       TECHNIQUE_AO,  TECHNIQUE_PHONG };
    static const technique shining[] = { TECHNIQUE_VO, TECHNIQUE_VO_CAP, TECHNIQUE_VO_DD, TECHNIQUE_SH6_GLOSSY,
                                         TECHNIQUE_AO, TECHNIQUE_PHONG };
    sheet_row matte[3], bright[3];
    int k;
    for (k = 0; k < 3; k++) {
        matte[k].s = k == 2 ? &d->statue : &d->shapes;
        matte[k].which = k == 0 ? AROUND : SKY;
        matte[k].set = 0;
        bright[k].s = &d->shapes;
        bright[k].which = k == 2 ? SKY : AROUND;
        bright[k].set = k == 1 ? 3 : 0;
    }
    matte[0].name = "shapes\n1 point light";
    matte[1].name = "shapes\nsky as 32 lights";
    matte[2].name = "statue\nsky as 32 lights";
    bright[0].name = "shapes\n1 point light";
    bright[1].name = "shapes\n8 point lights";
    bright[2].name = "shapes\nsky as 32 lights";
    return write_sheet(d, "vo.jpg", "Vector occluders beside other techniques, diffuse scenes", 1, 3, matte, 9, all,
                       w) ||
                   write_sheet(d, "vo-shining.jpg", "Vector occluders, shining scene", 0, 3, bright, 7, shining, w)
               ? -1
               : 0;
}

/* ---- plots ---- */

/* The same place across for all series. */
static void place_all(plot *p, int place, double x) {
    int k;
    for (k = 0; k < PLOT_SERIES; k++) p->x[k][place] = x;
}

static int draw_plot(const study *d, const char *file, const plot *p, why *w) {
    char path[1100];
    snprintf(path, sizeof path, "%s/plots/%s", d->o.out, file);
    return plot_draw(p, path, w);
}

static int plot_lights(const study *d, why *w) {
    static const technique timed[] = { TECHNIQUE_PHONG, TECHNIQUE_VO_DD, TECHNIQUE_VO, TECHNIQUE_SH3, TECHNIQUE_SH6 };
    static const technique judged[] = { TECHNIQUE_PHONG, TECHNIQUE_AO,  TECHNIQUE_VO_DD, TECHNIQUE_VO_DD_CAP,
                                        TECHNIQUE_SH3,   TECHNIQUE_SH6, TECHNIQUE_CH6 };
    static plot p, q;
    int k, set;
    p.title = "Shading time";
    q.title = "Error, diffuse shapes";
    p.across = q.across = "point lights";
    p.up = "ns a vertex";
    q.up = "RMSE, % of the mean";
    p.more = q.more = "set logscale xy\nset xtics (1,2,4,8,16,32)\nset xrange [1:32]";
    p.places = q.places = SETS;
    p.series = 5;
    q.series = 8;
    for (set = 0; set < SETS; set++) {
        place_all(&p, set, light_counts[set]);
        place_all(&q, set, light_counts[set]);
        for (k = 0; k < 5; k++)
            p.y[k][set] = 1e9 * d->shapes.seconds[timed[k]][set] / d->shapes.shining.mesh.point_count;
        for (k = 0; k < 7; k++) q.y[k][set] = 100 * d->shapes.scores[1][AROUND][judged[k]][set].rmse;
        q.y[7][set] = 100 * d->shapes.at_vertices[1][AROUND][set].rmse;
    }
    for (k = 0; k < 5; k++) p.names[k] = technique_names[timed[k]];
    for (k = 0; k < 7; k++) q.names[k] = technique_names[judged[k]];
    q.names[7] = "truth at vertices";
    return draw_plot(d, "vo-decay.svg", &p, w) || draw_plot(d, "vo-error.svg", &q, w) ? -1 : 0;
}

/* One occluder of form factor 1/4, as figure 7.7: a cap of 30 degrees, the light on its way outwards. */
static int plot_laws(const study *d, why *w) {
    static plot p;
    prt_vo_params laws[3];
    int i;
    laws[0] = sine_law(1.5);
    laws[1] = sine_law(5.5);
    laws[2] = cap_law(5);
    p.title = "Light that one round occluder of form factor 1/4 lets through";
    p.across = "angle between occlusion vector and light, degrees";
    p.up = "share of the light";
    p.more = "set yrange [-0.02:1.02]\nset xrange [0:90]";
    p.series = 5;
    p.places = 91;
    p.names[0] = "sine law, N = 1.5"; p.names[1] = "sine law, N = 5.5"; p.names[2] = "cap law, light of 5 deg";
    p.names[3] = "truth, light of 5 deg"; p.names[4] = "truth, point light";
    for (i = 0; i < p.places; i++) {
        int k;
        place_all(&p, i, i);
        for (k = 0; k < 3; k++) p.y[k][i] = shadow_law_of_cap(&laws[k], 30 * degree, i * degree);
        p.y[3][i] = shadow_truth_of_cap(30 * degree, 5 * degree, i * degree);
        p.y[4][i] = shadow_truth_of_cap(30 * degree, 0, i * degree);
    }
    return draw_plot(d, "vo-laws.svg", &p, w);
}

static int plot_splits(const study *d, why *w) {
    static plot p;
    int k;
    p.title = "Shadows of the shapes by number of occluders";
    p.across = "occluders that a vertex sees, mean";
    p.up = "RMS error of the shadow factor, point light";
    p.more = "set logscale x\nset yrange [0:*]";
    p.series = 4;
    p.places = SPLITS;
    p.names[0] = "sine law, N = 1.5"; p.names[1] = "sine law, N = 4"; p.names[2] = "cap law, light of 5 deg";
    p.names[3] = "cap law, light of 20 deg";
    for (k = 0; k < SPLITS; k++) {
        const split_study *s = &d->splits[k];
        place_all(&p, k, s->seen);
        p.y[0][k] = s->sine.rms; p.y[1][k] = s->strong.rms; p.y[2][k] = s->cap.rms; p.y[3][k] = s->wide.rms;
    }
    return draw_plot(d, "vo-split.svg", &p, w);
}

/* Pictures' error by what a vertex holds, for the strongest occluders alone; 0 occluders would have no place on the
   logarithmic axis. */
static int plot_keeps(const study *d, why *w) {
    static plot p;
    int cut, k, points = d->shapes.shining.mesh.point_count;
    p.title = "Shapes under 8 lights, strongest occluders of a vertex alone";
    p.across = "bytes a vertex, indexed";
    p.up = "RMSE, % of the mean";
    p.more = "set logscale x 2\nset yrange [0:*]";
    p.series = 4;
    p.places = KEEPS - 1;
    p.names[0] = "6 parts, sine law"; p.names[1] = "6 parts, cap law";
    p.names[2] = "48 occluders, sine law"; p.names[3] = "48 occluders, cap law";
    for (cut = 0; cut < CUTS; cut++) {
        for (k = 1; k < KEEPS; k++) {
            const keep_study *s = &d->keeps[cut][k];
            p.x[2 * cut][k - 1] = p.x[2 * cut + 1][k - 1] =
                (double)prt_vo_size(PRT_VO_INDEXED_DIFFUSE, points, (int)(s->seen * points + 0.5), 6) / points;
            p.y[2 * cut][k - 1] = 100 * s->by_sine.rmse;
            p.y[2 * cut + 1][k - 1] = 100 * s->by_cap.rmse;
        }
    }
    return draw_plot(d, "vo-occluders.svg", &p, w);
}

int write_plots(const study *d, why *w) {
    return plot_lights(d, w) || plot_laws(d, w) || plot_splits(d, w) || plot_keeps(d, w) ? -1 : 0;
}

/* ---- the page ---- */

static const double mebi = 1048576, mega = 1e6;

/* The form in which a technique of VO keeps its occluders. */
static prt_vo_form form_of(technique how) {
    return how == TECHNIQUE_VO_DD || how == TECHNIQUE_VO_DD_CAP ? PRT_VO_INDEXED_DIFFUSE : PRT_VO_INDEXED;
}

static int is_of_six(technique how) {
    return how == TECHNIQUE_SH6 || how == TECHNIQUE_CH6 || how == TECHNIQUE_SH6_GLOSSY;
}

static double bytes_of(const study *d, technique how) {
    const techniques *t = &d->shapes.baked;
    double points = t->scene->mesh.point_count;
    if (how == TECHNIQUE_PHONG) return 0;
    if (how == TECHNIQUE_AO) return points * sizeof(prt_real);
    if (how >= TECHNIQUE_SH3) {
        int n = PRT_SH_COUNT(techniques_bands[is_of_six(how)]);
        return points * 3 * n * (how >= TECHNIQUE_SH3_GLOSSY ? 1 + n : 1) * sizeof(prt_real);
    }
    return (double)prt_vo_size(form_of(how), t->scene->mesh.point_count, t->occluder_count, t->material_count);
}

static void bake_times(const techniques *t, technique how, double pass[2]) {
    int six = is_of_six(how), ch = how == TECHNIQUE_CH3 || how == TECHNIQUE_CH6;
    pass[0] = how == TECHNIQUE_PHONG ? 0 : how >= TECHNIQUE_SH3 ? t->sh_seconds[six][0] : t->ao_seconds;
    pass[1] = how <= TECHNIQUE_AO          ? 0
              : how <= TECHNIQUE_VO_DD_CAP ? t->vo_dd_seconds
              : how < TECHNIQUE_SH3        ? t->vo_seconds
                                           : t->sh_seconds[six][1] + (ch ? t->ch_seconds[six] : 0);
    if (how >= TECHNIQUE_SH3_GLOSSY) pass[1] += t->glossy_seconds[six];
}

static void write_table_of_costs(const study *d, FILE *to) {
    static const char *const thesis[TECHNIQUE_COUNT] = { "0, 5500 fps, 0",      "58, 5500, 0.019",
                                                         "58 + 60, 4700, 1.03", "",
                                                         "58 + 85, 3500, 2.05", "",
                                                         "60 + 63, 5100, 2.07", "62 + 68, 2500, 8.26",
                                                         "56 + 61, 5100, 2.07", "60 + 66, 2500, 8.26", "", "" };
    const stage *s = &d->shapes;
    const double points = s->shining.mesh.point_count;
    int how;
    fprintf(
        to,
        "\n## Table 7.1 again\n\nShapes scene: %d triangles, %d vertices, %d parts, %d rays a vertex in each pass. "
        "Bake: processor "
        "seconds, pass 1 + pass 2.\nShading: processor time a vertex on one core, all terms that the technique has; "
        "*a light more* is the "
        "slope from 1 to 32 lights.\nStorage: what shading reads; a vertex sees %.2f occluders in the mean. RMSE and "
        "SSIM: one point light, "
        "diffuse scene (for DD+DS+SS and the glossy ones: shining).\n\n| technique | bake s | ns a vertex, 1 light | "
        "8 lights | a light "
        "more | bytes a vertex | "
        "MiB | RMSE | SSIM | thesis: bake s, frame rate, MB |\n|---|---:|---:|---:|---:|---:|---:|---:|---:|---|\n",
        s->shining.mesh.triangle_count, s->shining.mesh.point_count, s->shining.part_count, d->o.rays,
        s->baked.occluder_count / points);
    for (how = 0; how < TECHNIQUE_COUNT; how++) {
        const double *seconds = s->seconds[how];
        double pass[2], bytes = bytes_of(d, (technique)how);
        const score *e = &s->scores[takes_part(1, (technique)how)][AROUND][how][0];
        bake_times(&s->baked, (technique)how, pass);
        fprintf(to, "| %s | %.1f + %.1f | %.1f | %.1f | %.2f | %.1f | %.2f | %.1f %% | %.3f | %s |\n",
                technique_names[how], pass[0], pass[1], 1e9 * seconds[0] / points, 1e9 * seconds[3] / points,
                1e9 * (seconds[SETS - 1] - seconds[0]) / points / 31, bytes / points, bytes / mebi, 100 * e->rmse,
                e->ssim, thesis[how]);
    }
    fprintf(
        to,
        "\nSH and CH carry one bounce in three planes of coefficients, as the thesis' SH/DD. The transfer of CH is "
        "that of SH, converted "
        "(in the time of pass 2).\nWith its Gram matrix CH gives what SH gives: exit radiance at the vertices "
        "differs by at most %.1e of its "
        "root mean square.\n",
        d->ch_differs);
}

static void write_scores(const stage *s, int matte, int which, FILE *to) {
    int sets = sets_of(&s->rigs[which]), set, how;
    fprintf(to, "\n| RMSE %%, SSIM |");
    for (set = 0; set < sets; set++) {
        int lights = s->rigs[which].group_count == 1 ? s->rigs[which].light_count : light_counts[set];
        fprintf(to, " %d light%s |", lights, lights > 1 ? "s" : "");
    }
    fprintf(to, "\n|---|");
    for (set = 0; set < sets; set++) fprintf(to, "---:|");
    fprintf(to, "\n| *noise of the reference* |");
    for (set = 0; set < sets; set++) fprintf(to, " %.2f |", 100 * s->noise[matte][which][set]);
    fprintf(to, "\n| *reference at the vertices* |");
    for (set = 0; set < sets; set++)
        fprintf(to, " %.1f, %.3f |", 100 * s->at_vertices[matte][which][set].rmse,
                s->at_vertices[matte][which][set].ssim);
    for (how = 0; how < TECHNIQUE_COUNT; how++) {
        if (!takes_part(matte, (technique)how)) continue;
        fprintf(to, "\n| %s |", technique_names[how]);
        for (set = 0; set < sets; set++)
            fprintf(to, " %.1f, %.3f |", 100 * s->scores[matte][which][how][set].rmse,
                    s->scores[matte][which][how][set].ssim);
    }
    fprintf(to, "\n");
}

static void write_errors(const study *d, FILE *to) {
    fprintf(
        to,
        "\n## Error by number of lights\n\n![RMSE by number of lights](plots/vo-error.svg)\n\nPoint lights around "
        "the shapes, at about "
        "twice the scene's radius. The path-traced picture has all bounces to the sixth, each technique at most "
        "one.\n*Reference at the "
        "vertices* is the truth at the vertices, interpolated: no technique that shades vertices can do "
        "better.\n\nDiffuse scene:\n");
    write_scores(&d->shapes, 1, AROUND, to);
    fprintf(to, "\nShining scene. SH takes part with transfer matrices, light to arriving radiance, and Phong's lobe "
            "in as many bands:\n");
    write_scores(&d->shapes, 0, AROUND, to);
    fprintf(to, "\nThe environment as 32 point lights, shapes, diffuse:\n");
    write_scores(&d->shapes, 1, SKY, to);
    fprintf(to, "\nThe same, shining:\n");
    write_scores(&d->shapes, 0, SKY, to);
    fprintf(to, "\nThe same, a statue among balls, diffuse (%d vertices, %d parts, %.2f occluders a vertex):\n",
            d->statue.shining.mesh.point_count, d->statue.shining.part_count,
            (double)d->statue.baked.occluder_count / d->statue.shining.mesh.point_count);
    write_scores(&d->statue, 1, SKY, to);
}

/* The batch against the loop, and both against what arithmetic alone would take. */
static void write_limits(const study *d, FILE *to) {
    static const char *const terms[TERMS] = { "DD + DS + SS", "DD" };
    const double points = d->shapes.shining.mesh.point_count;
    int k, b;
    fprintf(
        to,
        "\nOne call of `prt_vo_shade_n` for all vertices against "
        "`prt_vo_shade` for each, 8 lights: %.0f against %.0f "
        "ns a vertex with all terms, **%.2f times as fast**; %.0f against %.0f with DD, %.2f times as fast (target: "
        "4).\n\nThe arithmetic limit: additions, multiplications and divisions of the formulas, counted in "
        "`bench/vo_operations.h`, over the rate at which the same build multiplies and adds on vectors without "
        "waiting, measured in the same run. *Waiting*: points side by side wait for the one that has most "
        "occluders. Sine law, 8 lights.\n\n"
        "| build | points side by side | terms | operations a point, occluder and light | operations a vertex | ns a "
        "vertex | ns at the peak | peak, 10^9/s | times the limit | of it waiting |\n"
        "|---|---:|---|---:|---:|---:|---:|---:|---:|---:|\n",
        1e9 * d->forms[0].seconds[0] / points, 1e9 * d->forms[0].loop / points,
        d->forms[0].loop / d->forms[0].seconds[0], 1e9 * d->forms[1].seconds[0] / points,
        1e9 * d->forms[1].loop / points, d->forms[1].loop / d->forms[1].seconds[0]);
    for (b = 0; b < BUILDS; b++) {
        for (k = 0; k < TERMS; k++) {
            const limit *l = &d->forms[k].limits[b];
            double least = l->operations / l->rate;
            fprintf(to, "| `%s` | %d | %s | %.0f | %.0f | %.1f | %.1f | %.1f | %.2f | %.2f |\n", l->flags, l->lanes,
                    terms[k], l->both, l->operations / points, 1e9 * l->seconds / points, 1e9 * least / points,
                    1e-9 * l->rate, l->seconds / least, (l->operations + l->carried) / l->operations);
        }
    }
}

/* Shading from each form. */
static void write_forms(const study *d, FILE *to) {
    static const char *const names[FORMS] = { "plain", "indexed", "packed" };
    const double points = d->shapes.shining.mesh.point_count;
    const form_times *all = &d->forms[0], *dd = &d->forms[1];
    int k;
    fprintf(to, "\nShading from them, 8 lights, ns a vertex, and the difference (root mean square, relative):\n\n"
                "| form | all terms | differs | VO/DD | differs |\n|---|---:|---:|---:|---:|\n");
    for (k = 0; k < FORMS; k++)
        fprintf(to, "| %s | %.0f | %.1e | %.0f | %.1e |\n", names[k], 1e9 * all->seconds[k] / points, all->differs[k],
                1e9 * dd->seconds[k] / points, dd->differs[k]);
}

static void write_decay(const study *d, FILE *to) {
    const double points = d->shapes.shining.mesh.point_count;
    int how, set;
    fprintf(
        to,
        "\n## Figure 7.21 again: time by number of lights\n\n![Time a vertex by number of "
        "lights](plots/vo-decay.svg)\n\nNanoseconds a "
        "vertex on one core.\n\n| technique |");
    for (set = 0; set < SETS; set++) fprintf(to, " %d |", light_counts[set]);
    fprintf(to, "\n|---|---:|---:|---:|---:|---:|---:|\n");
    for (how = 0; how < TECHNIQUE_COUNT; how++) {
        fprintf(to, "| %s |", technique_names[how]);
        for (set = 0; set < SETS; set++) fprintf(to, " %.0f |", 1e9 * d->shapes.seconds[how][set] / points);
        fprintf(to, "\n");
    }
    write_limits(d, to);
}

typedef struct storage_row { const char *name; prt_vo_form form; double limit; const char *thesis; } storage_row;

static void write_storage(const study *d, FILE *to) {
    static const storage_row rows[] = {
        { "VO/DD, indexed: `prt_vo_indexed_diffuse`", PRT_VO_INDEXED_DIFFUSE, 1.03, "1.03" },
        { "VO/DD, packed: `prt_vo_packed_diffuse`", PRT_VO_PACKED_DIFFUSE, 1.03 / 2, "" },
        { "full set, indexed: `prt_vo_indexed`", PRT_VO_INDEXED, 2.05, "2.05" },
        { "full set, packed: `prt_vo_packed`", PRT_VO_PACKED, 2.05 / 2, "" },
        { "full set, plain: `prt_vo_occluder`", PRT_VO_PLAIN, 0, "" } };
    const techniques *t = &d->shapes.baked;
    const int points = 5013;
    size_t k;
    fprintf(
        to,
        "\n## Storage\n\nAt the thesis' %d vertices with 5 occluders each, and with those that a vertex sees here "
        "(%.2f in the mean; %d dropped). Bytes as `prt_vo_size` counts them: "
        "occluders, an index of 4 bytes a vertex, "
        "a table of %d materials. The thesis' MB are 2^20 bytes: its 67,244 vectors of 16 bytes are %.2f of them.\n\n"
        "| | bytes an occluder | MiB, seen here | MiB, 5 each | MB (10^6), 5 each | limit | thesis |\n"
        "|---|---:|---:|---:|---:|---:|---:|\n",
        points, t->occluder_count / (double)t->scene->mesh.point_count, t->dropped, t->material_count,
        67244 * 16 / mebi);
    for (k = 0; k < sizeof rows / sizeof *rows; k++) {
        double each = (double)(prt_vo_size(rows[k].form, 0, 1, 0) - prt_vo_size(rows[k].form, 0, 0, 0));
        double here = (double)prt_vo_size(rows[k].form, t->scene->mesh.point_count, t->occluder_count,
                                          t->material_count);
        double full = (double)prt_vo_size(rows[k].form, points, 5 * points, t->material_count);
        fprintf(to, "| %s | %.0f | %.2f | %.3f | %.3f | ", rows[k].name, each, here / mebi, full / mebi, full / mega);
        if (rows[k].limit > 0) fprintf(to, "%.3f", rows[k].limit);
        fprintf(to, " | %s |\n", rows[k].thesis);
    }
    fprintf(to,
            "\nLimits are the thesis' sizes and half of them, in its MB. In MB of "
            "10^6 bytes they hold too, but for packed "
            "VO/DD: its occluders alone take %.3f, with the index of vertices it is over.\n",
            5.0 * points * (double)sizeof(prt_vo_packed_diffuse) / mega);
    write_forms(d, to);
}

static const char *const light_names[LIGHT_CASES] = { "far point", "5°",   "15°",    "30°",
                                                      "at 2",      "at 1", "at 1/2", "at 1/4" };

static void write_law_row(FILE *to, const char *name, const shadow_error *e) {
    int a;
    fprintf(to, "| %s |", name);
    for (a = 0; a < LIGHT_CASES; a++) fprintf(to, " %.3f, %+.3f |", e[a].rms, e[a].bias);
    fprintf(to, "\n");
}

enum { THESIS = 2, STANDARD = 1 };     /* N = 1.5 among strengths, 5 degrees among cap_angles */

/* Which of some laws errs least with a kind of light. */
static int best_of(int count, const shadow_error (*laws)[LIGHT_CASES], int which) {
    int k, best = 0;
    for (k = 1; k < count; k++) if (laws[k][which].rms < laws[best][which].rms) best = k;
    return best;
}

/* How often the cap law is closer to the traced picture than the sine law: of *all rows of scores, in RMSE and SSIM. */
static void compare_pictures(const stage *s, int matte, int which, technique sine, technique cap, int *all, int *rmse,
                             int *ssim) {
    int set;
    for (set = 0; set < sets_of(&s->rigs[which]); set++) {
        const score *a = &s->scores[matte][which][sine][set], *b = &s->scores[matte][which][cap][set];
        ++*all;
        *rmse += b->rmse < a->rmse;
        *ssim += b->ssim > a->ssim;
    }
}

/* Pictures by the laws, and what angle a light of the cap law should have. */
static void write_pictured(const study *d, FILE *to) {
    double mean[PICTURE_LAWS], ssim[PICTURE_LAWS];
    int k, i, best = 2, alike = 2;
    fprintf(to, "Pictures by the same laws, VO/DD, RMSE %% and SSIM:\n\n| law | "
                "shapes, 1 light | 8 lights | 32 lights | "
                "sky | statue, sky | mean |\n|---|---:|---:|---:|---:|---:|---:|\n");
    for (k = 0; k < PICTURE_LAWS; k++) {
        if (k < 2) fprintf(to, "| sine, N = %g |", k ? 4 : 1.5);
        else fprintf(to, "| cap, light of %g° |", cap_angles[k - 2]);
        for (i = 0, mean[k] = ssim[k] = 0; i < PICTURED; i++) {
            const score *s = &d->pictured[k][i];
            fprintf(to, " %.1f, %.3f |", 100 * s->rmse, s->ssim);
            mean[k] += 100 * s->rmse / PICTURED;
            ssim[k] += s->ssim / PICTURED;
        }
        fprintf(to, " %.1f, %.3f |\n", mean[k], ssim[k]);
        if (k > 2 && mean[k] < mean[best]) best = k;
        if (k > 2 && ssim[k] > ssim[alike]) alike = k;
    }
    fprintf(to,
            "\nIn these pictures the default of %g° errs by %.1f %% in the mean, SSIM %.3f; the least mean RMSE, %.1f %%, is "
            "that of %g°, the best mean SSIM, %.3f, that of %g°. Wider lights err less in single factors, as the first "
            "table shows, and lose the edges of shadows.\n",
            cap_angles[STANDARD], mean[2 + STANDARD], ssim[2 + STANDARD], mean[best], cap_angles[best - 2], ssim[alike],
            cap_angles[alike - 2]);
}

/* Which law is closer to the truth, in numbers. */
static void write_verdict(const study *d, FILE *to) {
    const law_study *l = &d->laws;
    int closer = 0, closest = 0, k, all = 0, rmse = 0, ssim = 0;
    double least = 1, most = -1;
    for (k = 0; k < LIGHT_CASES; k++) {
        double less = 1 - l->cap[STANDARD][k].rms / l->sine[THESIS][k].rms;
        closer += less > 0;
        closest += l->cap[STANDARD][k].rms < l->sine[best_of(STRENGTHS, l->sine, k)][k].rms;
        if (less < least) least = less;
        if (less > most) most = less;
    }
    compare_pictures(&d->shapes, 1, AROUND, TECHNIQUE_VO_DD, TECHNIQUE_VO_DD_CAP, &all, &rmse, &ssim);
    compare_pictures(&d->shapes, 0, AROUND, TECHNIQUE_VO, TECHNIQUE_VO_CAP, &all, &rmse, &ssim);
    compare_pictures(&d->shapes, 1, SKY, TECHNIQUE_VO_DD, TECHNIQUE_VO_DD_CAP, &all, &rmse, &ssim);
    compare_pictures(&d->shapes, 0, SKY, TECHNIQUE_VO, TECHNIQUE_VO_CAP, &all, &rmse, &ssim);
    compare_pictures(&d->statue, 1, SKY, TECHNIQUE_VO_DD, TECHNIQUE_VO_DD_CAP, &all, &rmse, &ssim);
    fprintf(to,
            "\n**Which is closer to the truth:** the cap law at its default of %g° "
            "errs less than the thesis' N = %g with "
            "%d of these %d lights, by %.0f to %.0f %% (negative: more), and less "
            "than the best N of each column with "
            "%d. In the tables of errors above, pictures by the cap law are closer "
            "to the traced ones than by the sine "
            "law in %d of %d (RMSE), %d of %d (SSIM).\n\n",
            cap_angles[STANDARD], strengths[THESIS], closer, LIGHT_CASES, 100 * least, 100 * most, closest, rmse, all,
            ssim, all);
    write_pictured(d, to);
    fprintf(to, "\nThe best parameter for each light: ");
    for (k = 0; k < LIGHT_CASES; k++) {
        int n = best_of(STRENGTHS, l->sine, k), a = best_of(CAPS, l->cap, k);
        fprintf(to, "%s%s N = %g (%.3f), cap %g° (%.3f)", k ? "; " : "", light_names[k], strengths[n],
                l->sine[n][k].rms, cap_angles[a], l->cap[a][k].rms);
    }
    fprintf(to,
            ". No law knows how far a light is: of one nearer than what would hide it, the shadow is wrong by "
            "any.\n");
}

static void write_laws(const study *d, FILE *to) {
    char name[64];
    int k;
    fprintf(
        to,
        "\n## Shadow laws\n\n![What one round occluder lets through](plots/vo-laws.svg)\n\nThe thesis' law is "
        "sin(b)^(2 N F), N = 1.5 in its "
        "figures; `PRT_VO_CAP` takes an occluder for a round cap of its form factor and the light for\na disc. Error "
        "of the shadow factor, the "
        "product over occluders, against traced light: %d directions at each vertex of the shapes, spread "
        "by\ncosine; root mean square, and mean "
        "(positive: too much light). Far lights by their angular radius; point lights by their distance from the "
        "vertex, in radii of the scene.\n\n| law |",
        d->o.directions);
    for (k = 0; k < LIGHT_CASES; k++) fprintf(to, " %s |", light_names[k]);
    fprintf(to, "\n|---|");
    for (k = 0; k < LIGHT_CASES; k++) fprintf(to, "---:|");
    fprintf(to, "\n");
    write_law_row(to, "no shadow", d->laws.none);
    write_law_row(to, "ambient occlusion", d->laws.ao);
    for (k = 0; k < STRENGTHS; k++) {
        snprintf(name, sizeof name, "sine, N = %g", strengths[k]);
        write_law_row(to, name, d->laws.sine[k]);
    }
    for (k = 0; k < CAPS; k++) {
        snprintf(name, sizeof name, "cap, light of %g°", cap_angles[k]);
        write_law_row(to, name, d->laws.cap[k]);
    }
    write_verdict(d, to);
    fprintf(to, "\n![A ball under a low light](gallery/vo-laws.jpg)\n");
}

static void write_caustics(const study *d, FILE *to) {
    fprintf(
        to,
        "\n## Caustics\n\n![Balls of "
        "glass](gallery/vo-glass.jpg)\n\nThe reference follows "
        "photons through the glass (Snell's law, total reflection), and paths of the camera; its noise is %.1f %%. "
        "Errors are of what is not "
        "glass.\nRMSE is ruled by the few places where light is focused, which no technique at the vertices reaches; "
        "without caustics it is "
        "%.0f %%, with them %.0f %%, SSIM %.3f and %.3f.\n",
        100 * d->glass_noise, 100 * d->glass_scores[2].rmse, 100 * d->glass_scores[0].rmse, d->glass_scores[2].ssim,
        d->glass_scores[0].ssim);
}

static void write_keeps(const study *d, FILE *to) {
    static const char *const titles[CUTS] = { "one occluder for each of the 6 parts", "cut into 48 occluders" };
    const int points = d->shapes.shining.mesh.point_count;
    int cut, k;
    fprintf(to,
            "\n## How many occluders a vertex\n\n![Error by bytes a vertex](plots/vo-occluders.svg)\n\nOf what a "
            "vertex sees the strongest K alone are kept (`max_occluders` of the bake); shapes under 8 lights, VO/DD. "
            "RMSE %% and SSIM of pictures, root mean square error of the shadow "
            "factor of a far point light; sine law "
            "of N = 1.5, cap law of 5°.\n");
    for (cut = 0; cut < CUTS; cut++) {
        fprintf(to,
                "\nShapes, %s:\n\n| K | a vertex sees | ns a vertex | bytes a vertex, "
                "indexed | packed | picture, sine | "
                "picture, cap | factor, sine | factor, cap |\n|---:|---:|---:|---:|---:|---:|---:|---:|---:|\n",
                titles[cut]);
        for (k = 0; k < KEEPS; k++) {
            const keep_study *s = &d->keeps[cut][k];
            int seen = (int)(s->seen * points + 0.5);
            fprintf(to, "| %d | %.2f | %.0f | %.0f | %.0f | %.1f, %.3f | %.1f, %.3f | %.3f | %.3f |\n", keeps[cut][k],
                    s->seen, 1e9 * s->seconds / points,
                    (double)prt_vo_size(PRT_VO_INDEXED_DIFFUSE, points, seen, 6) / points,
                    (double)prt_vo_size(PRT_VO_PACKED_DIFFUSE, points, seen, 0) / points, 100 * s->by_sine.rmse,
                    s->by_sine.ssim, 100 * s->by_cap.rmse, s->by_cap.ssim, s->sine.rms, s->cap.rms);
        }
    }
}

static void write_savings(const study *d, FILE *to) {
    static const char *const names[SAVINGS] = { "nothing", "caustics", "DS and SS", "DD", "caustics, DS and SS",
                                                "all but shadows" };
    const double points = d->pool.shining.mesh.point_count;
    int k;
    fprintf(to,
            "\n## What leaving out saves\n\nThe sea floor below, where everything "
            "occurs: %d vertices, 4 parts of which "
            "one is transmissive and three shine; %d rays a vertex, 8 lights, cap "
            "law. `prt_vo_unneeded` tells what no "
            "part of a scene can cause, and bakes leave that out by themselves. Change: root mean square at the "
            "vertices, relative to everything.\n\n| left out | bake, pass 2, s | "
            "ns a vertex | bytes a vertex, indexed "
            "| change |\n|---|---:|---:|---:|---:|\n",
            (int)points, saving_rays(d));
    for (k = 0; k < SAVINGS; k++) {
        const saving *s = &d->savings[k];
        fprintf(to, "| %s | %.1f | %.0f | %.0f | %.1f %% |\n", names[k], s->bake_seconds, 1e9 * s->seconds / points,
                s->bytes, 100 * s->differs);
    }
}

static void write_effects(const study *d, FILE *to) {
    const double points = d->pool.shining.mesh.point_count;
    int k;
    fprintf(to,
            "\n## Effects\n\n![Waves over the floor of a "
            "sea](gallery/vo-waves.jpg)\n\n`prt_vo_bend` turns occlusion and "
            "caustic vectors as five trains of plane waves pass; nothing is baked "
            "anew. To use it: scale positions by "
            "the waves' radians a unit (%g here), give each wave an axis along the surface and one across, bend all "
            "occluders of a vertex into a second array, and shade that; `caustic_angle` sets how sharp the lines are "
            "(%g° here). Bending costs %.0f ns a vertex, shading %.0f (1 light). Change from still water, root mean "
            "square: ",
            waves_a_unit, waves_sharpness, 1e9 * d->bend_seconds / points, 1e9 * d->pool_seconds / points);
    for (k = 0; k < FRAMES; k++)
        fprintf(to, "%s%.0f %% at t = %g", k ? ", " : "", 100 * d->waves[k].differs, frame_times[k]);
    fprintf(to, "; the mean stays within %.0f %%.\n\n![Drained colour](gallery/vo-drain.jpg)\n\n",
            100 * fmax(fmax(fabs(d->waves[0].mean - 1), fabs(d->waves[1].mean - 1)),
                       fmax(fabs(d->waves[2].mean - 1), fabs(d->waves[3].mean - 1))));
    fprintf(to, "`prt_vo_params.dd` below 0 takes light of its neighbours' colours "
                "from a place instead of sending it, "
                "never below black; no cost of its own. Mean radiance: ");
    for (k = 1; k < DRAINS; k++)
        fprintf(to, "%s%.1f %% at %g", k > 1 ? ", " : "", 100 * d->drained[k].mean, drains[k]);
    fprintf(to, " (dd = 1: 100 %%).\n");
}

static void write_splits(const study *d, FILE *to) {
    const double points = d->shapes.shining.mesh.point_count;
    int k;
    fprintf(
        to,
        "\n## Splitting objects into occluders\n\n![Shadow error by number of "
        "occluders](plots/vo-split.svg)\n\n`prt_vo_split` cuts the parts, "
        "by area, into so many occluders in all; none is dropped. Shadow factors against traced ones of point "
        "lights, as above;\nVO/DD with the "
        "cap law, 8 lights; memory packed (`prt_vo_packed_diffuse`).\n\n| occluders | a vertex sees | bake s | ns a "
        "vertex | bytes a vertex | sine, "
        "N = 1.5 | sine, N = 4 | cap, 5° | cap, 20° |\n|---:|---:|---:|---:|---:|---:|---:|---:|---:|\n");
    for (k = 0; k < SPLITS; k++) {
        const split_study *p = &d->splits[k];
        fprintf(to, "| %d | %.1f | %.1f | %.0f | %.0f | %.3f, %+.3f | %.3f, %+.3f | %.3f, %+.3f | %.3f, %+.3f |\n",
                p->occluders, p->seen, p->bake_seconds, 1e9 * p->seconds / points,
                4 + p->seen * (double)sizeof(prt_vo_packed_diffuse), p->sine.rms, p->sine.bias, p->strong.rms,
                p->strong.bias, p->cap.rms, p->cap.bias, p->wide.rms, p->wide.bias);
    }
    fprintf(to,
            "\nFrom %d to %d occluders the error falls by %.0f %% (sine, N = 1.5), "
            "%.0f %% (N = 4), %.0f %% (cap, 5°) and "
            "%.0f %% (cap, 20°). The sine law gains little: factors of pieces "
            "multiply to about that of the whole, as "
            "their exponents add up, and the width of a shadow is in the exponent. Caps follow the outline; what "
            "remains are gaps between round caps (the second numbers: light leaks in).\n",
            d->splits[0].occluders, d->splits[SPLITS - 1].occluders,
            100 * (1 - d->splits[SPLITS - 1].sine.rms / d->splits[0].sine.rms),
            100 * (1 - d->splits[SPLITS - 1].strong.rms / d->splits[0].strong.rms),
            100 * (1 - d->splits[SPLITS - 1].cap.rms / d->splits[0].cap.rms),
            100 * (1 - d->splits[SPLITS - 1].wide.rms / d->splits[0].wide.rms));
}

static void write_sky(const study *d, FILE *to) {
    int k;
    fprintf(
        to,
        "\n## How many point lights an environment needs\n\nDirect light at the vertices of the shapes, `%s` cut "
        "into so many point lights "
        "(median cut), against %d.\n\n| lights |",
        strrchr(d->o.environment, '/') ? strrchr(d->o.environment, '/') + 1 : d->o.environment, SKY_TRUTH);
    for (k = 0; k < SKY_COUNTS - 1; k++) fprintf(to, " %d |", sky_counts[k]);
    fprintf(to, "\n|---|---:|---:|---:|---:|---:|---:|---:|\n| RMSE %% |");
    for (k = 0; k < SKY_COUNTS - 1; k++) fprintf(to, " %.1f |", 100 * d->sky_errors[k]);
    fprintf(to, "\n");
}

int write_page(const study *d, why *w) {
    char path[1024];
    replacement r;
    FILE *to;
    snprintf(path, sizeof path, "%s/vo.md", d->o.out);
    if (replacement_open(path, &r, w)) return -1;
    to = r.file;
    fprintf(
        to,
        "<!-- Written by examples/vo_compare: do not edit. `make vo` measures and writes anew. -->\n# Vector "
        "occluders, measured\n\nSection 7.6 "
        "of Sherif's thesis (2013) run again with `prt_vo_shade_n` and `prt_bake_vo`, beside what else lights "
        "vertices from a bake.\nprt.h %s; "
        "machine: %s; compiler: %s; flags: %s; rays by Embree.\n\n![Contact sheet](gallery/vo.jpg)\n\n![Contact "
        "sheet, shining](gallery/vo-shining.jpg)\n",
        PRT_VERSION, bench_cpu_name(), EXAMPLE_COMPILER, EXAMPLE_FLAGS);
    write_table_of_costs(d, to);
    write_errors(d, to);
    write_decay(d, to);
    write_storage(d, to);
    write_laws(d, to);
    write_caustics(d, to);
    write_splits(d, to);
    write_keeps(d, to);
    write_savings(d, to);
    write_effects(d, to);
    write_sky(d, to);
    if (replacement_commit(&r, w)) return -1;
    printf("%s\n", path);
    return 0;
}
