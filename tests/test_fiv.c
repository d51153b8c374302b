/* Room >>fiv: lookup, horizon, overlap and shading against textbook code in double, closed forms and quadrature. */
#define PRT_IMPLEMENTATION
#include "prt.h"
#include "test.h"
#include "geometry.h"

#define EPS BY_PRECISION((double)FLT_EPSILON, DBL_EPSILON)
enum { THETAS = 9, PHIS = 16, RHOS = 5, SAMPLES = THETAS * PHIS * RHOS };

/* ---- small helpers ---- */

static const prt_fiv nothing;                                  /* what a call that fails leaves as it was */

static void components(const prt_fiv *f, double out[9]) {
    const prt_vec3 v[3] = { f->r, f->g, f->b };
    int k;
    for (k = 0; k < 3; k++) { out[3 * k] = (double)v[k].x; out[3 * k + 1] = (double)v[k].y; out[3 * k + 2] = (double)v[k].z; }
}

static prt_fiv fiv_of(const double v[9]) {
    prt_fiv f = nothing;
    f.r = vec3(v[0], v[1], v[2]); f.g = vec3(v[3], v[4], v[5]); f.b = vec3(v[6], v[7], v[8]);
    return f;
}

static int finite_rgb(prt_rgb c) { return isfinite((double)c.r) && isfinite((double)c.g) && isfinite((double)c.b); }

static int within(prt_rgb c, prt_rgb total) {
    return c.r >= 0 && c.g >= 0 && c.b >= 0 && c.r <= total.r && c.g <= total.g && c.b <= total.b;
}

/* ---- textbook lookup and shading, in double ---- */

static const prt_real some_rho[RHOS] = { 1, PRT__R(1.3), 2, 3, PRT__R(4.5) };
static prt_fiv some_samples[SAMPLES];

static prt_fiv_table random_table(void) {
    prt_fiv_table t = { THETAS, PHIS, RHOS, some_rho, 1, some_samples, NULL };
    double v[9];
    int i, k;
    for (i = 0; i < SAMPLES; i++) {
        for (k = 0; k < 9; k++) v[k] = signed_uniform();
        some_samples[i] = fiv_of(v);
    }
    return t;
}

static void textbook_lookup(const prt_fiv_table *t, prt_vec3 to, double out[9]) {
    double x = (double)to.x, y = (double)to.y, z = (double)to.z, r = sqrt(x * x + y * y + z * z), w[3], sample[9], sum = 0;
    double theta = acos(z / r) / pi * (t->theta_count - 1), phi = atan2(y, x) / (2 * pi) * t->phi_count;
    double last = (double)t->rho[t->rho_count - 1], at = fmin(fmax(r, (double)t->rho[0]), last);
    int i, j, k = 0, c, n;
    if (phi < 0) phi += t->phi_count;
    i = theta >= t->theta_count - 1 ? t->theta_count - 2 : (int)theta;
    j = (int)phi % t->phi_count;
    while (k < t->rho_count - 2 && at >= (double)t->rho[k + 1]) k++;
    w[0] = theta - i; w[1] = phi - floor(phi); w[2] = (at - (double)t->rho[k]) / ((double)t->rho[k + 1] - (double)t->rho[k]);
    for (n = 0; n < 9; n++) out[n] = 0;
    for (c = 0; c < 8; c++) {
        int index = ((k + (c >> 2)) * t->theta_count + i + (c >> 1 & 1)) * t->phi_count + (j + (c & 1)) % t->phi_count;
        double weight = (c >> 2 ? w[2] : 1 - w[2]) * (c >> 1 & 1 ? w[0] : 1 - w[0]) * (c & 1 ? w[1] : 1 - w[1]);
        if (t->inside && t->inside[index]) continue;
        components(&t->samples[index], sample);
        sum += weight;
        for (n = 0; n < 9; n++) out[n] += weight * sample[n];
    }
    for (n = 0; n < 9; n++) out[n] = sum > 0 ? out[n] / sum * (r > last ? last * last / r / r : 1) : 0;
}

static double dot3(const double *a, prt_vec3 b) { return a[0] * (double)b.x + a[1] * (double)b.y + a[2] * (double)b.z; }

static double textbook_cut(double u) { return (u * acos(-u) + sqrt(1 - u * u) * (2 + u * u) / 3) / pi; }

/* What an occluder takes, one channel. */
static double textbook_taken(const double *fiv, prt_vec3 to, double radius, prt_vec3 normal, unsigned flags) {
    double v[3], r, s, d, u, size = sqrt(fiv[0] * fiv[0] + fiv[1] * fiv[1] + fiv[2] * fiv[2]);
    v[0] = (double)to.x; v[1] = (double)to.y; v[2] = (double)to.z;
    r = sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
    d = dot3(v, normal);
    s = fmin(1, radius / r);
    u = fmax(-1, fmin(1, d / r / s));
    if (u <= -1) return 0;
    if (flags & PRT_FIV_PAPER_PARTIAL) return fmax(0, dot3(fiv, normal) * (fmax(-1, fmin(1, d / radius)) + 1) / 2);
    return fmax(0, dot3(fiv, normal) + size * s * (textbook_cut(u) - u));
}

/* Area that two discs share, radii a and b, centres d apart. */
static double textbook_lens(double a, double b, double d) {
    if (d >= a + b) return 0;
    if (d <= fabs(a - b)) return pi * fmin(a, b) * fmin(a, b);
    return a * a * acos((d * d + a * a - b * b) / (2 * d * a)) + b * b * acos((d * d + b * b - a * a) / (2 * d * b))
           - sqrt((a + b - d) * (d + a - b) * (d - a + b) * (d + a + b)) / 2;
}

/* Of a disc under even light that would take the total's irradiance from a whole sky, the part that takes so much. */
static double textbook_filled(double taken, double total, prt_vec3 to, double radius, prt_vec3 normal, unsigned flags) {
    double v[3], whole[3], r, s;
    int k;
    v[0] = (double)to.x; v[1] = (double)to.y; v[2] = (double)to.z;
    r = sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
    s = fmin(1, radius / r);
    for (k = 0; k < 3; k++) whole[k] = s * s * v[k] / r * total;
    return fmin(1, taken / fmax(textbook_taken(whole, to, radius, normal, flags), s * s * total / 1024));
}

static double disc_of(prt_vec3 to, double radius) {
    double r = sqrt((double)to.x * (double)to.x + (double)to.y * (double)to.y + (double)to.z * (double)to.z);
    return 2 * sin(asin(fmin(1, radius / r)) / 2);
}

static double chord(prt_vec3 a, prt_vec3 b) {
    double la = sqrt((double)a.x * (double)a.x + (double)a.y * (double)a.y + (double)a.z * (double)a.z);
    double lb = sqrt((double)b.x * (double)b.x + (double)b.y * (double)b.y + (double)b.z * (double)b.z);
    double x = (double)a.x / la - (double)b.x / lb, y = (double)a.y / la - (double)b.y / lb;
    double z = (double)a.z / la - (double)b.z / lb;
    return sqrt(x * x + y * y + z * z);
}

/* Equations 11, 13 and 14 for every channel, the last for discs that are filled in part if the flag says so. */
static void textbook_shade(prt_rgb total, prt_vec3 normal, int count, const prt_fiv_hidden *h, unsigned flags,
                           double out[3]) {
    double totals[3], taken[100][3];
    int i, j, c;
    totals[0] = (double)total.r; totals[1] = (double)total.g; totals[2] = (double)total.b;
    for (i = 0; i < count; i++) {
        double v[9];
        components(&h[i].fiv, v);
        for (c = 0; c < 3; c++)
            taken[i][c] = fmin(totals[c], textbook_taken(v + 3 * c, h[i].to_centre, (double)h[i].radius, normal, flags));
    }
    for (c = 0; c < 3; c++) {
        double sum = 0, most = 0, both = 0;
        for (i = 0; i < count; i++) {
            sum += taken[i][c];
            most = fmax(most, taken[i][c]);
            for (j = 0; j < i && !(flags & PRT_FIV_NO_OVERLAP); j++) {
                double a = disc_of(h[i].to_centre, (double)h[i].radius), b = disc_of(h[j].to_centre, (double)h[j].radius);
                double f = 1, g = 1, lens = textbook_lens(a, b, chord(h[i].to_centre, h[j].to_centre)) / pi;
                if ((flags & PRT_FIV_FILLED_OVERLAP) && !(a == b && chord(h[i].to_centre, h[j].to_centre) == 0)) {
                    f = textbook_filled(taken[i][c], totals[c], h[i].to_centre, (double)h[i].radius, normal, flags);
                    g = textbook_filled(taken[j][c], totals[c], h[j].to_centre, (double)h[j].radius, normal, flags);
                }
                lens *= f * g > 0 ? f * g / (f * a * a + g * b * b) : 0;
                both += fmin(lens * (taken[i][c] + taken[j][c]), fmin(taken[i][c], taken[j][c]));
            }
        }
        out[c] = totals[c] - fmin(fmax(sum - both, most), fmin(sum, totals[c]));
    }
}

/* ---- vectors ---- */

static void vectors_of_directions_add_up(void **state) {
    prt_fiv f = nothing;
    prt_rgb e;
    (void)state;
    memset(&f, 0, sizeof f);
    prt_fiv_add(&f, vec3(0, 0, 1), rgb(1, 2, 3));
    prt_fiv_add(&f, vec3(PRT__R(0.6), 0, PRT__R(-0.8)), rgb(10, 0, 5));
    e = prt_fiv_irradiance(&f, vec3(0, 0, 1));
    assert_near(e.r, 1 - 8, 8 * EPS * 9); assert_near(e.g, 2, 0); assert_near(e.b, 3 - 4, 8 * EPS * 7);
    e = prt_fiv_irradiance(&f, vec3(1, 0, 0));
    assert_near(e.r, 6, 8 * EPS * 6); assert_near(e.g, 0, 0); assert_near(e.b, 3, 8 * EPS * 3);
    prt_fiv_add(NULL, vec3(0, 0, 1), rgb(1, 1, 1));
    e = prt_fiv_irradiance(NULL, vec3(0, 0, 1));
    assert_true(e.r == 0 && e.g == 0 && e.b == 0);
}

/* The vector of a cap of radiance 1 is pi sin^2(a) along its axis: summed over a fine ring quadrature. */
static void vector_of_a_cap(void **state) {
    const double half = 0.7;
    prt_fiv f = nothing;
    int i, j;
    (void)state;
    memset(&f, 0, sizeof f);
    for (i = 0; i < 200; i++)
        for (j = 0; j < 64; j++) {
            double z = 1 - (1 - cos(half)) * (i + 0.5) / 200, r = sqrt(1 - z * z), a = 2 * pi * j / 64;
            double w = 2 * pi * (1 - cos(half)) / (200 * 64);
            prt_fiv_add(&f, vec3(r * cos(a), z, r * sin(a)), rgb(w, 2 * w, 0));
        }
    assert_near(f.r.y, pi * sin(half) * sin(half), 200 * 64 * EPS);
    assert_near(f.g.y, 2 * pi * sin(half) * sin(half), 400 * 64 * EPS);
    assert_near(f.r.x, 0, 100 * EPS); assert_near(f.r.z, 0, 100 * EPS); assert_near(f.b.y, 0, 0);
}

/* ---- lookup ---- */

static void lookup_returns_samples_at_their_places(void **state) {
    prt_fiv_table t = random_table();
    double got[9], want[9];
    prt_fiv f = nothing;
    int i, j, k, n;
    (void)state;
    for (k = 0; k < RHOS; k++)
        for (i = 0; i < THETAS; i++)
            for (j = 0; j < PHIS; j++) {
                double theta = pi * i / (THETAS - 1), phi = 2 * pi * j / PHIS, r = (double)some_rho[k];
                if (i == 0 || i == THETAS - 1) continue;                   /* poles: below */
                assert_int_equal(prt_fiv_lookup(&t, vec3(r * sin(theta) * cos(phi), r * sin(theta) * sin(phi),
                                                         r * cos(theta)), &f), PRT_OK);
                components(&f, got);
                components(&some_samples[(k * THETAS + i) * PHIS + j], want);
                for (n = 0; n < 9; n++) assert_near(got[n], want[n], 60 * EPS);
            }
}

static void lookup_is_trilinear(void **state) {
    prt_fiv_table t = random_table();
    unsigned char inside[SAMPLES];
    double got[9], want[9];
    int k, n, with;
    (void)state;
    for (k = 0; k < SAMPLES; k++) inside[k] = (unsigned char)(uniform() < 0.3);
    for (with = 0; with < 2; with++) {
        t.inside = with ? inside : NULL;
        for (k = 0; k < 4000; k++) {
            prt_vec3 to = scaled(random_direction(), 0.5 + 6 * uniform());
            prt_fiv f = nothing;
            assert_int_equal(prt_fiv_lookup(&t, to, &f), PRT_OK);
            components(&f, got);
            textbook_lookup(&t, to, want);
            if (with && want[0] == 0 && want[1] == 0) continue;            /* all eight inside: another test */
            for (n = 0; n < 9; n++) assert_near(got[n], want[n], with ? 5e5 * EPS : 100 * EPS);
        }
    }
}

static void lookup_is_continuous_over_poles_and_seam(void **state) {
    prt_fiv_table t = random_table();
    prt_fiv a = nothing, b = nothing;
    double va[9], vb[9];
    int k, n;
    (void)state;
    for (k = 0; k < RHOS * PHIS; k++)                                      /* a pole is one place: one value */
        some_samples[(k / PHIS * THETAS) * PHIS + k % PHIS] = some_samples[k / PHIS * THETAS * PHIS];
    for (k = 0; k < 64; k++) {
        double angle = 2 * pi * k / 64;
        assert_int_equal(prt_fiv_lookup(&t, vec3(0, 0, 2), &a), PRT_OK);
        assert_int_equal(prt_fiv_lookup(&t, vec3(1e-7 * cos(angle), 1e-7 * sin(angle), 2), &b), PRT_OK);
        components(&a, va); components(&b, vb);
        for (n = 0; n < 9; n++) assert_near(va[n], vb[n], 2e-6);
    }
    for (k = 0; k < 64; k++) {
        double theta = pi * (k + 0.5) / 64, r = 1 + 5 * uniform();
        assert_int_equal(prt_fiv_lookup(&t, vec3(r * sin(theta), 1e-7, r * cos(theta)), &a), PRT_OK);
        assert_int_equal(prt_fiv_lookup(&t, vec3(r * sin(theta), -1e-7, r * cos(theta)), &b), PRT_OK);
        components(&a, va); components(&b, vb);
        for (n = 0; n < 9; n++) assert_near(va[n], vb[n], 1e-4);
    }
}

static void lookup_falls_off_with_the_solid_angle(void **state) {
    prt_fiv_table t = random_table();
    prt_vec3 dir = random_direction();
    prt_fiv a = nothing, b = nothing;
    double va[9], vb[9];
    int n;
    (void)state;
    assert_int_equal(prt_fiv_lookup(&t, scaled(dir, (double)some_rho[RHOS - 1]), &a), PRT_OK);
    assert_int_equal(prt_fiv_lookup(&t, scaled(dir, 10 * (double)some_rho[RHOS - 1]), &b), PRT_OK);
    components(&a, va); components(&b, vb);
    for (n = 0; n < 9; n++) assert_near(vb[n], va[n] / 100, 2 * EPS);
    assert_int_equal(prt_fiv_lookup(&t, scaled(dir, 0.001), &a), PRT_OK);  /* nearer than the first: as the first */
    assert_int_equal(prt_fiv_lookup(&t, scaled(dir, (double)some_rho[0]), &b), PRT_OK);
    components(&a, va); components(&b, vb);
    for (n = 0; n < 9; n++) assert_near(va[n], vb[n], 60 * EPS);
}

/* Between geometric distances, a factor q apart, 1/rho^2 is met within (1+q^-2)/2 ((1+q)/2)^2 - 1. */
static void interpolation_error_of_geometric_distances(void **state) {
    const double q = 1.07, bound = (1 + 1 / q / q) / 2 * (1 + q) * (1 + q) / 4 - 1;
    prt_real rho[12];
    prt_fiv samples[12];
    prt_fiv_table t = { 1, 1, 12, rho, 1, samples, NULL };
    double worst[11];
    int k, i;
    (void)state;
    for (k = 0; k < 12; k++) {
        rho[k] = (prt_real)(1.05 * pow(q, k));
        memset(&samples[k], 0, sizeof samples[k]);
        samples[k].g.z = (prt_real)(pi / ((double)rho[k] * (double)rho[k]));
    }
    for (k = 0; k < 11; k++) {
        worst[k] = 0;
        for (i = 0; i <= 100; i++) {
            double r = (double)rho[k] + ((double)rho[k + 1] - (double)rho[k]) * i / 100;
            prt_fiv f = nothing;
            assert_int_equal(prt_fiv_lookup(&t, vec3(0, 0, r), &f), PRT_OK);
            worst[k] = fmax(worst[k], fabs((double)f.g.z * r * r / pi - 1));
        }
        assert_at_most(worst[k], bound * 1.02 + 8 * EPS);
        assert_at_most(bound * 0.98, worst[k] + 8 * EPS);
    }
    print_message("interpolation in distance, factor 1.07: %.4f of the value in every interval\n", worst[5]);
}

/* ---- horizon ---- */

/* Share of pi sin^2 a that a cap of radiance 1, half-angle a, whose axis is at zenith angle b, gives a receiver. */
static double cap_above_horizon(double a, double b) {
    const int rings = 200, spokes = 100;
    double sum = 0;
    int i, j;
    for (i = 0; i < rings; i++) {
        double z = 1 - (1 - cos(a)) * (i + 0.5) / rings, r = sqrt(1 - z * z);
        for (j = 0; j < spokes; j++) sum += fmax(0, z * cos(b) + r * cos(2 * pi * (j + 0.5) / spokes) * sin(b));
    }
    return sum * 2 * (1 - cos(a)) / (rings * spokes) / (sin(a) * sin(a));
}

static void horizon_cuts_caps(void **state) {
    static const double half[3] = { 0.2, 0.5, 1 }, ours[3] = { 0.00055, 0.0082, 0.068 }, papers[3] = { 0.043, 0.110, 0.245 };
    int k, i;
    (void)state;
    for (k = 0; k < 3; k++) {
        double a = half[k], worst = 0, worst_paper = 0;
        for (i = -40; i <= 40; i++) {
            double b = pi / 2 + 1.1 * a * i / 40, truth = cap_above_horizon(a, b);
            prt_fiv_hidden h;
            prt_rgb e, p;
            memset(&h, 0, sizeof h);
            h.radius = (prt_real)sin(a);
            h.to_centre = vec3(sin(b), 0, cos(b));
            h.fiv.r = h.fiv.g = h.fiv.b = scaled(h.to_centre, pi * sin(a) * sin(a));
            assert_int_equal(prt_fiv_shade_vectors(rgb(pi, pi, pi), vec3(0, 0, 1), 1, &h, 0, &e), PRT_OK);
            assert_int_equal(prt_fiv_shade_vectors(rgb(pi, pi, pi), vec3(0, 0, 1), 1, &h, PRT_FIV_PAPER_PARTIAL, &p), PRT_OK);
            worst = fmax(worst, fabs((pi - (double)e.g) / (pi * sin(a) * sin(a)) - truth));
            worst_paper = fmax(worst_paper, fabs((pi - (double)p.g) / (pi * sin(a) * sin(a)) - truth));
            if (i <= -37) assert_near((pi - (double)e.g) / (pi * sin(a) * sin(a)), cos(b), 300 * EPS);   /* whole */
            if (i >= 37) assert_near(e.g, pi, 4 * EPS);                                                  /* below */
        }
        print_message("cap of half-angle %.1f cut by the horizon: error %.4f, the paper's factor %.4f\n", a, worst, worst_paper);
        assert_at_most(worst, ours[k] + 300 * EPS);
        assert_near(worst_paper, papers[k], 0.05 * papers[k]);
    }
}

/* ---- overlap ---- */

/* Area common to two discs by counting on a grid. */
static double lens_by_counting(double a, double b, double d) {
    const int n = 700;
    int i, j, hits = 0;
    for (i = 0; i < n; i++)
        for (j = 0; j < n; j++) {
            double x = -a + 2 * a * (i + 0.5) / n, y = -a + 2 * a * (j + 0.5) / n;
            hits += x * x + y * y < a * a && (x - d) * (x - d) + y * y < b * b;
        }
    return 4.0 * a * a * hits / n / n;
}

static void lens_of_two_discs(void **state) {
    static const double discs[5][3] = { { 1, 1, 0.5 }, { 0.3, 0.2, 0.25 }, { 0.5, 0.2, 0.31 }, { 0.2, 0.21, 0.4 }, { 1, 0.1, 0.95 } };
    int k;
    (void)state;
    for (k = 0; k < 5; k++)
        assert_near(textbook_lens(discs[k][0], discs[k][1], discs[k][2]), lens_by_counting(discs[k][0], discs[k][1], discs[k][2]),
                    5e-3 * discs[k][0] * discs[k][0]);
}

/* Two caps on the sphere: the part that both cover, over the sum of their areas, as the discs of equations 13 and 14 have it
   (radius 2 sin(a/2), a chord apart: area-preserving) and as the paper's discs at unit distance (radius sin(a)) would. */
static void discs_stand_in_for_caps(void **state) {
    const int points = 400, pairs = 300;
    double mean = 0, mean_flat = 0, mean_share = 0;
    int k, i;
    (void)state;
    for (k = 0; k < pairs; k++) {
        double a = 0.1 + uniform(), b = 0.1 + uniform(), apart = uniform() * (a + b), both = 0, areas, share, flat;
        for (i = 0; i < points; i++) {                         /* a spiral over the first cap */
            double z = 1 - (1 - cos(a)) * (i + 0.5) / points, r = sqrt(1 - z * z);
            both += r * cos(2.39996322972865 * i) * sin(apart) + z * cos(apart) > cos(b);
        }
        areas = 2 - cos(a) - cos(b);
        both *= (1 - cos(a)) / points / areas;
        share = textbook_lens(2 * sin(a / 2), 2 * sin(b / 2), 2 * sin(apart / 2))
                / (pi * 4 * (sin(a / 2) * sin(a / 2) + sin(b / 2) * sin(b / 2)));
        flat = textbook_lens(sin(a), sin(b), 2 * sin(apart / 2)) / (pi * (sin(a) * sin(a) + sin(b) * sin(b)));
        mean += fabs(share - both) / pairs;
        mean_flat += fabs(flat - both) / pairs;
        mean_share += both / pairs;
    }
    print_message("share of two overlapping caps, %.3f in the mean: mean error %.4f, by discs of radius sin(a) %.4f\n", mean_share,
                  mean, mean_flat);
    assert_at_most(mean, 0.005);
    assert_at_most(mean, mean_flat);
}

/* Under even light of radiance 1, 2 and .5. */
static prt_fiv_hidden ball(prt_vec3 dir, double distance, double radius) {
    prt_fiv_hidden h;
    double s = radius / distance;
    memset(&h, 0, sizeof h);
    h.to_centre = scaled(dir, distance);
    h.radius = (prt_real)radius;
    h.fiv.r = scaled(dir, pi * s * s);
    h.fiv.g = scaled(dir, 2 * pi * s * s);
    h.fiv.b = scaled(dir, pi * s * s / 2);
    return h;
}

static void overlap_takes_back_the_lens(void **state) {
    const prt_rgb total = rgb(pi, 2 * pi, pi / 2);
    prt_fiv_hidden h[3];
    prt_rgb one, two, out;
    double want[3];
    int k;
    (void)state;
    h[0] = ball(vec3(0, 0, 1), 3, 1);
    h[1] = h[0];
    assert_int_equal(prt_fiv_shade_vectors(total, vec3(0, 0, 1), 1, h, 0, &one), PRT_OK);
    assert_int_equal(prt_fiv_shade_vectors(total, vec3(0, 0, 1), 2, h, 0, &two), PRT_OK);      /* coincident */
    assert_near(one.g, 2 * pi - 2 * pi / 9, 20 * EPS);
    assert_near(two.g, one.g, 20 * EPS);
    assert_int_equal(prt_fiv_shade_vectors(total, vec3(0, 0, 1), 2, h, PRT_FIV_NO_OVERLAP, &two), PRT_OK);
    assert_near(two.g, 2 * pi - 4 * pi / 9, 20 * EPS);
    h[1] = ball(vec3(0, 0, 1), 6, 0.5);                            /* hidden behind the first; discs are not sin^2 a */
    assert_int_equal(prt_fiv_shade_vectors(total, vec3(0, 0, 1), 2, h, 0, &two), PRT_OK);
    assert_near(two.g, one.g, 0.03 * 2 * pi / 144);
    h[1] = ball(vec3(0.8, 0, 0.6), 3, 1);                                                      /* apart */
    assert_int_equal(prt_fiv_shade_vectors(total, vec3(0, 0, 1), 2, h, 0, &two), PRT_OK);
    assert_near(two.g, 2 * pi - 2 * pi / 9 * 1.6, 40 * EPS);
    for (k = 0; k < 3000; k++) {                                                               /* anywhere */
        double tilt = 0.5 * uniform(), a = 2 * pi * uniform();
        h[1] = ball(vec3(sin(tilt) * cos(a), sin(tilt) * sin(a), cos(tilt)), 2 + 2 * uniform(), 0.5 + uniform());
        assert_int_equal(prt_fiv_shade_vectors(total, vec3(0, 0, 1), 2, h, 0, &out), PRT_OK);
        textbook_shade(total, vec3(0, 0, 1), 2, h, 0, want);
        assert_near(out.r, want[0], 30 * EPS * pi); assert_near(out.g, want[1], 30 * EPS * 2 * pi);
        assert_near(out.b, want[2], 30 * EPS * pi);
    }
}

/* Under one light that is even over the sky, discs of which a part is filled at random share the product of the parts:
   two in one place, .5 and .4 filled, hide .5 + .4 - .2 of it. The same vectors under a sky that is dark elsewhere, with
   hardly more light in all than either takes, are whole discs. */
static void overlap_of_discs_that_are_filled_in_part(void **state) {
    const double s2 = 1.0 / 9, most = 1e-3 * pi * s2;              /* the radii differ by 1e-4, so that they are two bodies */
    prt_fiv_hidden h[2];
    prt_rgb out = { 0, 0, 0 };
    (void)state;
    h[0] = ball(vec3(0, 0, 1), 3, 1);
    h[1] = ball(vec3(0, 0, 1), 3, 1.0001);
    h[0].fiv.r.z *= (prt_real)0.5;
    h[1].fiv.r.z *= (prt_real)0.4;
    assert_int_equal(prt_fiv_shade_vectors(rgb(pi, pi, pi), vec3(0, 0, 1), 2, h, PRT_FIV_FILLED_OVERLAP, &out), PRT_OK);
    assert_near(out.r, pi - pi * s2 * 0.7, most);
    assert_int_equal(prt_fiv_shade_vectors(rgb(pi, pi, pi), vec3(0, 0, 1), 2, h, 0, &out), PRT_OK);
    assert_near(out.r, pi - pi * s2 * 0.5, most);
    assert_int_equal(prt_fiv_shade_vectors(rgb(0.55 * pi * s2, pi, pi), vec3(0, 0, 1), 2, h, PRT_FIV_FILLED_OVERLAP, &out), PRT_OK);
    assert_near(out.r, 0.05 * pi * s2, most);
}

/* ---- shading ---- */

/* A table of a ball of radius 1 under the radiance 1 + z (r), 1 (g) and 0.5 (b): vectors in closed form. For 1 + z,
   int (1 + w_z) w dw over a cap of half-angle a about n is pi s^2 n + c0 z + c1 n_z n with the cap's second moments. */
enum { BALL_THETAS = 65, BALL_PHIS = 128, BALL_RHOS = 24 };
static prt_fiv ball_samples[BALL_THETAS * BALL_PHIS * BALL_RHOS];
static prt_real ball_rho[BALL_RHOS];

static void ball_vectors(prt_vec3 n, double rho, double v[9]) {
    double s = 1 / rho, c = sqrt(1 - s * s), along = 2 * pi * (1 - c * c * c) / 3;             /* int (n.w)^2 */
    double across = (2 * pi * (1 - c) - along) / 2, d[3];
    int k;
    d[0] = (double)n.x; d[1] = (double)n.y; d[2] = (double)n.z;
    for (k = 0; k < 3; k++) {
        v[3 + k] = pi * s * s * d[k];
        v[6 + k] = v[3 + k] / 2;
        v[k] = v[3 + k] + (along - across) * d[2] * d[k] + (k == 2 ? across : 0);
    }
}

static prt_fiv_table ball_table(void) {
    prt_fiv_table t = { BALL_THETAS, BALL_PHIS, BALL_RHOS, ball_rho, 1, ball_samples, NULL };
    int i, j, k;
    double v[9];
    for (k = 0; k < BALL_RHOS; k++) {
        ball_rho[k] = (prt_real)(1.02 * pow(1.07, k));
        for (i = 0; i < BALL_THETAS; i++)
            for (j = 0; j < BALL_PHIS; j++) {
                double theta = pi * i / (BALL_THETAS - 1), phi = 2 * pi * j / BALL_PHIS;
                ball_vectors(vec3(sin(theta) * cos(phi), sin(theta) * sin(phi), cos(theta)), (double)ball_rho[k], v);
                ball_samples[(k * BALL_THETAS + i) * BALL_PHIS + j] = fiv_of(v);
            }
    }
    return t;
}

static void ball_over_a_plane(void **state) {
    prt_fiv_table t = ball_table();
    prt_fiv_occluder o = { NULL, { 0, 0, 0 } };
    double worst = 0;
    int k;
    (void)state;
    o.table = &t;
    for (k = 0; k < 500; k++) {
        prt_vec3 p = vec3(6 * uniform() - 3, 6 * uniform() - 3, 1), to;
        double v[9], r, want;
        prt_rgb total = rgb(pi + 2 * pi / 3, pi, pi / 2), out = rgb(0, 0, 0);
        o.position = vec3(0, 0, 2 + uniform());
        to = vec3((double)o.position.x - (double)p.x, (double)o.position.y - (double)p.y, (double)o.position.z - 1);
        r = sqrt((double)to.x * (double)to.x + (double)to.y * (double)to.y + (double)to.z * (double)to.z);
        assert_int_equal(prt_fiv_shade(total, p, vec3(0, 0, 1), 1, &o, 0, &out), PRT_OK);
        ball_vectors(scaled(to, 1 / r), r, v);
        want = (double)total.r - v[2];
        worst = fmax(worst, fabs((double)out.r - want) / v[2]);
        assert_near(out.g, pi - v[5], 0.0045 * v[5] + 20 * EPS);   /* .0036 in distance, .0006 in angle */
        assert_near(out.r, want, 0.0055 * v[2] + 20 * EPS);
        assert_near(out.b, pi / 2 - v[8], 0.0045 * v[8] + 20 * EPS);
    }
    print_message("a ball over a plane, 65x128x24 table: within %.4f of what it takes\n", worst);
}

enum { MANY = 80, RECEIVERS = 53 };

static void scene_of(prt_fiv_occluder *o, const prt_fiv_table *t, int count) {
    int k;
    for (k = 0; k < count; k++) {
        o[k].table = t;
        o[k].position = scaled(random_direction(), 1.2 + 8 * uniform());
    }
}

static void shading_agrees_with_the_textbook(void **state) {
    static const unsigned flags[6] = { 0, PRT_FIV_PAPER_PARTIAL, PRT_FIV_NO_OVERLAP, PRT_FIV_PAPER_PARTIAL | PRT_FIV_NO_OVERLAP,
                                       PRT_FIV_FILLED_OVERLAP, PRT_FIV_PAPER_PARTIAL | PRT_FIV_FILLED_OVERLAP };
    static const int counts[6] = { 0, 1, 2, 7, 33, MANY };
    prt_fiv_table t = ball_table();
    prt_fiv_occluder o[MANY];
    prt_fiv_hidden h[MANY];
    int k, i, f, n;
    (void)state;
    for (n = 0; n < 6; n++)
        for (k = 0; k < 30; k++) {
            prt_vec3 p = scaled(random_direction(), 0.2), normal = random_direction();
            prt_rgb total = rgb(4, 3 * uniform(), 20);
            scene_of(o, &t, counts[n]);
            for (i = 0; i < counts[n]; i++) {
                h[i].radius = 1;
                h[i].to_centre = vec3((double)o[i].position.x - (double)p.x, (double)o[i].position.y - (double)p.y,
                                      (double)o[i].position.z - (double)p.z);
                assert_int_equal(prt_fiv_lookup(&t, h[i].to_centre, &h[i].fiv), PRT_OK);
            }
            for (f = 0; f < 6; f++) {
                prt_rgb out = { 0, 0, 0 }, vectors = { 0, 0, 0 };
                double want[3], tolerance = (20 + 4 * counts[n]) * EPS * 20;
                textbook_shade(total, normal, counts[n], h, flags[f], want);
                assert_int_equal(prt_fiv_shade(total, p, normal, counts[n], o, flags[f], &out), PRT_OK);
                assert_int_equal(prt_fiv_shade_vectors(total, normal, counts[n], h, flags[f], &vectors), PRT_OK);
                assert_near(out.r, want[0], tolerance); assert_near(out.g, want[1], tolerance);
                assert_near(out.b, want[2], tolerance);
                assert_near(vectors.r, want[0], tolerance); assert_near(vectors.b, want[2], tolerance);
                assert_true(within(out, total));
            }
        }
}

static void batches_give_the_same_bits(void **state) {
    prt_fiv_table t = ball_table();
    prt_fiv_occluder o[MANY];
    prt_vec3 p[RECEIVERS], n[RECEIVERS];
    prt_rgb total[RECEIVERS], out[RECEIVERS], one;
    int k, first, count;
    (void)state;
    skip_if_fast_math();
    scene_of(o, &t, MANY);
    for (k = 0; k < RECEIVERS; k++) {
        p[k] = scaled(random_direction(), 2 * uniform());
        n[k] = random_direction();
        total[k] = rgb(4 * uniform(), 3, 2);
    }
    for (first = 0; first < RECEIVERS; first += 5)
        for (count = 0; count <= RECEIVERS - first; count += count < 20 ? 1 : 11) {
            assert_int_equal(prt_fiv_shade_n(count, total + first, p + first, n + first, 40, o, 0, out), PRT_OK);
            for (k = 0; k < count; k += 7) {
                prt_fiv_shade(total[first + k], p[first + k], n[first + k], 40, o, 0, &one);
                assert_memory_equal(&one, &out[k], sizeof one);
            }
        }
    memcpy(out, total, sizeof out);                                /* in place */
    assert_int_equal(prt_fiv_shade_n(RECEIVERS, out, p, n, MANY, o, 0, out), PRT_OK);
    for (k = 0; k < RECEIVERS; k++) {
        prt_fiv_shade(total[k], p[k], n[k], MANY, o, 0, &one);
        assert_memory_equal(&one, &out[k], sizeof one);
    }
}

/* ---- self-shadow ---- */

/* A ball under even light shadows no part of itself, and its surface receives pi. Places outside see past its edge light
   from below the surface's horizon, which counts against it: at height h what is left is (R/(R+h))^2 of it. */
static void self_shadow_darkens_with_the_height_of_its_samples(void **state) {
    static const double heights[4] = { 0.01, 0.05, 0.1, 0.2 };
    prt_fiv_table t = ball_table();
    prt_fiv environment = nothing;
    int k;
    (void)state;
    for (k = 0; k < 4; k++) {
        prt_real rho = (prt_real)(1 + heights[k]);
        prt_fiv samples[2 * 16];
        prt_rgb out;
        double s = 1 / (double)rho;
        int i, j;
        for (i = 0; i < 2; i++)                                /* poles alone: the receiver stands on the axis */
            for (j = 0; j < 16; j++) {
                samples[i * 16 + j] = nothing;
                samples[i * 16 + j].r.z = (prt_real)((i ? -1 : 1) * pi * s * s);
            }
        t.theta_count = 2; t.phi_count = 16; t.rho_count = 1;
        t.rho = &rho;
        t.samples = samples;
        assert_int_equal(prt_fiv_self(&environment, &t, vec3(0, 0, 1), vec3(0, 0, 1), &out), PRT_OK);
        assert_near(out.r, pi * s * s, 20 * EPS);
        assert_near(out.r, pi * (1 - 2 * heights[k]), pi * 3.1 * heights[k] * heights[k]);
    }
}

static void self_shadow_leaves_out_the_inside(void **state) {
    prt_fiv_table t = random_table();
    prt_fiv environment = nothing;
    unsigned char inside[SAMPLES];
    double v[9], all[9];
    int k, c;
    (void)state;
    for (k = 0; k < SAMPLES; k++) inside[k] = (unsigned char)(k % 3 == 0);
    t.inside = inside;
    for (c = 0; c < 9; c++) all[c] = signed_uniform();
    environment = fiv_of(all);
    for (k = 0; k < 500; k++) {
        prt_vec3 p = scaled(random_direction(), 1 + 3 * uniform()), n = random_direction();
        prt_rgb out;
        textbook_lookup(&t, scaled(p, -1), v);
        components(&environment, all);
        assert_int_equal(prt_fiv_self(&environment, &t, p, n, &out), PRT_OK);
        for (c = 0; c < 9; c++) v[c] = all[c] - v[c];
        assert_near(out.r, fmax(0, dot3(v, n)), 5e5 * EPS); assert_near(out.g, fmax(0, dot3(v + 3, n)), 5e5 * EPS);
        assert_near(out.b, fmax(0, dot3(v + 6, n)), 5e5 * EPS);
    }
}

/* ---- any light ---- */

enum { BANDS = 4, LIGHT = BANDS * BANDS, HIDDEN = (BANDS + 1) * (BANDS + 1) };
static prt_real hidden_samples[SAMPLES * HIDDEN];

static prt_fiv_transfer random_transfer(void) {
    prt_fiv_transfer t = { BANDS, THETAS, PHIS, RHOS, some_rho, 1, hidden_samples, NULL };
    int k;
    for (k = 0; k < SAMPLES * HIDDEN; k++) hidden_samples[k] = (prt_real)signed_uniform();
    return t;
}

static void random_light(prt_real light[3 * LIGHT]) {
    int k;
    for (k = 0; k < 3 * LIGHT; k++) light[k] = (prt_real)signed_uniform();
}

static void turn_of(prt_real m[9]) {                           /* about a random axis, by Rodrigues */
    prt_vec3 u = random_direction();
    double a = 2 * pi * uniform(), x = (double)u.x, y = (double)u.y, z = (double)u.z, c = cos(a), s = sin(a), d = 1 - c;
    m[0] = (prt_real)(c + x * x * d); m[1] = (prt_real)(x * y * d - z * s); m[2] = (prt_real)(x * z * d + y * s);
    m[3] = (prt_real)(y * x * d + z * s); m[4] = (prt_real)(c + y * y * d); m[5] = (prt_real)(y * z * d - x * s);
    m[6] = (prt_real)(z * x * d - y * s); m[7] = (prt_real)(z * y * d + x * s); m[8] = (prt_real)(c + z * z * d);
}

static prt_vec3 turned(const prt_real m[9], prt_vec3 v) {
    double x = (double)v.x, y = (double)v.y, z = (double)v.z;
    return vec3((double)m[0] * x + (double)m[1] * y + (double)m[2] * z, (double)m[3] * x + (double)m[4] * y + (double)m[5] * z,
                (double)m[6] * x + (double)m[7] * y + (double)m[8] * z);
}

/* The vectors are sum_ij V_j L_i int Y_j w_k Y_i dw, the integrals being triple products. */
static void transfer_is_bilinear(void **state) {
    static const int axis[3] = { 1, -1, 0 };
    prt_fiv_transfer t = random_transfer();
    prt_real light[3 * LIGHT], vectors[9 * HIDDEN];
    int place, c, k, i, j, li, lj;
    (void)state;
    random_light(light);
    assert_int_equal(prt_fiv_transfer_light(BANDS, NULL, light, vectors), PRT_OK);
    for (place = 0; place < SAMPLES; place += 37) {
        double want[9] = { 0, 0, 0, 0, 0, 0, 0, 0, 0 }, got[9];
        prt_fiv one[SAMPLES];
        for (li = 0, i = 0; li < BANDS; li++)
            for (; i < (li + 1) * (li + 1); i++)
                for (lj = 0, j = 0; lj <= BANDS; lj++)
                    for (; j < (lj + 1) * (lj + 1); j++)
                        for (k = 0; k < 3; k++) {
                            double g = sqrt(4 * pi / 3) * prt_sh_triple(1, axis[k], li, i - li * (li + 1), lj, j - lj * (lj + 1));
                            for (c = 0; c < 3; c++)
                                want[3 * c + k] += g * (double)light[c * LIGHT + i] * (double)hidden_samples[place * HIDDEN + j];
                        }
        assert_int_equal(prt_fiv_transfer_samples(&t, vectors, place, 1, one), PRT_OK);
        components(&one[place], got);
        for (k = 0; k < 9; k++) assert_near(got[k], want[k], 100 * EPS);
    }
}

/* A table made for one light is looked up as the transfer table is, under that light; a turned occluder under a light sees
   what an unturned one sees under the light turned back. */
static void transfer_lookup_agrees_with_its_table(void **state) {
    static prt_fiv samples[SAMPLES];
    prt_fiv_transfer t = random_transfer();
    prt_fiv_table table = { THETAS, PHIS, RHOS, some_rho, 1, samples, NULL };
    prt_real light[3 * LIGHT], back[9], turn[9], lit[3 * LIGHT], vectors[9 * HIDDEN], about[9 * HIDDEN];
    unsigned char inside[SAMPLES];
    double got[9], want[9];
    int k, i, c;
    (void)state;
    random_light(light);
    for (k = 0; k < SAMPLES; k++) inside[k] = (unsigned char)(uniform() < 0.2);
    for (k = 0; k < 200; k++) {
        prt_vec3 to = scaled(random_direction(), 0.5 + 6 * uniform()), away;
        prt_fiv a = nothing, b = nothing;
        turn_of(turn);
        for (i = 0; i < 9; i++) back[i] = turn[i % 3 * 3 + i / 3];
        for (c = 0; c < 3; c++) assert_int_equal(prt_sh_rotate(BANDS, back, light + c * LIGHT, lit + c * LIGHT), PRT_OK);
        assert_int_equal(prt_fiv_transfer_light(BANDS, NULL, lit, vectors), PRT_OK);
        assert_int_equal(prt_fiv_transfer_light(BANDS, turn, light, about), PRT_OK);
        assert_int_equal(prt_fiv_transfer_samples(&t, vectors, 0, SAMPLES, samples), PRT_OK);
        t.inside = table.inside = k % 2 ? inside : NULL;
        assert_int_equal(prt_fiv_lookup(&table, to, &a), PRT_OK);
        assert_int_equal(prt_fiv_transfer_lookup(&t, NULL, vectors, to, &b), PRT_OK);
        components(&a, want);
        components(&b, got);
        for (i = 0; i < 9; i++) assert_near(got[i], want[i], k % 2 ? 5e5 * EPS : 200 * EPS);
        away = turned(turn, to);
        assert_int_equal(prt_fiv_transfer_lookup(&t, turn, about, away, &b), PRT_OK);
        a.r = turned(turn, a.r); a.g = turned(turn, a.g); a.b = turned(turn, a.b);
        components(&a, want);
        components(&b, got);
        for (i = 0; i < 9; i++) assert_near(got[i], want[i], k % 2 ? 5e5 * EPS : 2000 * EPS);
    }
}

/* A cap under a light: closed-form projection of the cap against a ring quadrature of w L(w) over it. */
static void transfer_of_a_cap(void **state) {
    prt_real light[3 * LIGHT], vectors[9 * HIDDEN], cap[HIDDEN], rho = 2;
    prt_fiv_transfer t = { BANDS, 1, 1, 1, &rho, 1, cap, NULL };
    double want[9] = { 0, 0, 0, 0, 0, 0, 0, 0, 0 }, got[9];
    const double half = pi / 6;
    prt_vec3 n = random_direction(), u = vec3(-(double)n.y, (double)n.x, 0), v;
    prt_fiv f = nothing;
    int i, j, c, k;
    (void)state;
    u = scaled(u, 1 / sqrt((double)u.x * (double)u.x + (double)u.y * (double)u.y));
    v = vec3((double)n.y * (double)u.z - (double)n.z * (double)u.y, (double)n.z * (double)u.x - (double)n.x * (double)u.z,
             (double)n.x * (double)u.y - (double)n.y * (double)u.x);
    random_light(light);
    assert_int_equal(prt_sh_cone(BANDS + 1, n, (prt_real)half, cap), PRT_OK);
    assert_int_equal(prt_fiv_transfer_light(BANDS, NULL, light, vectors), PRT_OK);
    assert_int_equal(prt_fiv_transfer_lookup(&t, NULL, vectors, scaled(n, 2), &f), PRT_OK);
    components(&f, got);
    for (i = 0; i < 400; i++)
        for (j = 0; j < 32; j++) {
            double z = 1 - (1 - cos(half)) * (i + 0.5) / 400, r = sqrt(1 - z * z), a = 2 * pi * j / 32, d[3];
            d[0] = z * (double)n.x + r * (cos(a) * (double)u.x + sin(a) * (double)v.x);
            d[1] = z * (double)n.y + r * (cos(a) * (double)u.y + sin(a) * (double)v.y);
            d[2] = z * (double)n.z + r * (cos(a) * (double)u.z + sin(a) * (double)v.z);
            for (c = 0; c < 3; c++) {
                double l = (double)prt_sh_at(BANDS, light + c * LIGHT, vec3(d[0], d[1], d[2]));
                for (k = 0; k < 3; k++) want[3 * c + k] += l * d[k] * 2 * pi * (1 - cos(half)) / (400 * 32);
            }
        }
    for (k = 0; k < 9; k++) assert_near(got[k], want[k], 2e-6 + 100 * EPS);
}

static void transfer_survives_bad_samples(void **state) {
    prt_fiv_transfer t = random_transfer();
    prt_real light[3 * LIGHT], vectors[9 * HIDDEN];
    prt_fiv f = nothing;
    int k;
    (void)state;
    skip_if_fast_math();
    random_light(light);
    assert_int_equal(prt_fiv_transfer_light(BANDS, NULL, light, vectors), PRT_OK);
    for (k = 0; k < SAMPLES * HIDDEN; k += 71) hidden_samples[k] = k % 2 ? (prt_real)NAN : (prt_real)INFINITY;
    for (k = 0; k < 500; k++) {
        assert_int_equal(prt_fiv_transfer_lookup(&t, NULL, vectors, scaled(random_direction(), 5 * uniform()), &f), PRT_OK);
        assert_true(prt__finite3(f.r) && prt__finite3(f.g) && prt__finite3(f.b));
    }
    vectors[0] = (prt_real)NAN;
    assert_int_equal(prt_fiv_transfer_lookup(&t, NULL, vectors, vec3(1, 0, 0), &f), PRT_OK);
    assert_true(f.r.x == 0 && f.g.x == 0);
}

static void transfer_refuses_bad_arguments(void **state) {
    prt_fiv_transfer t = random_transfer(), bad;
    prt_real light[3 * LIGHT] = { 0 }, vectors[9 * HIDDEN] = { 0 }, crooked[9] = { 2, 0, 0, 0, 1, 0, 0, 0, 1 };
    prt_vec3 z = vec3(0, 0, 1);
    prt_fiv f = nothing;
    int k;
    (void)state;
    memset(&f, 0x55, sizeof f);
    assert_int_equal(prt_fiv_transfer_light(0, NULL, light, vectors), PRT_ERR_BANDS);
    assert_int_equal(prt_fiv_transfer_light(PRT_MAX_BANDS, NULL, light, vectors), PRT_ERR_BANDS);
    assert_int_equal(prt_fiv_transfer_light(BANDS, NULL, NULL, vectors), PRT_ERR_NULL);
    assert_int_equal(prt_fiv_transfer_light(BANDS, NULL, light, NULL), PRT_ERR_NULL);
    assert_int_equal(prt_fiv_transfer_light(BANDS, crooked, light, vectors), PRT_ERR_ROTATION);
    assert_int_equal(prt_fiv_transfer_lookup(NULL, NULL, vectors, z, &f), PRT_ERR_NULL);
    assert_int_equal(prt_fiv_transfer_lookup(&t, NULL, NULL, z, &f), PRT_ERR_NULL);
    assert_int_equal(prt_fiv_transfer_lookup(&t, NULL, vectors, z, NULL), PRT_ERR_NULL);
    assert_int_equal(prt_fiv_transfer_samples(NULL, vectors, 0, 1, &f), PRT_ERR_NULL);
    assert_int_equal(prt_fiv_transfer_samples(&t, vectors, 0, SAMPLES + 1, &f), PRT_ERR_COUNT);
    assert_int_equal(prt_fiv_transfer_samples(&t, vectors, -1, 1, &f), PRT_ERR_COUNT);
    assert_int_equal(prt_fiv_transfer_samples(&t, NULL, 0, 1, &f), PRT_ERR_NULL);
    assert_int_equal(prt_fiv_transfer_samples(&t, vectors, 0, 1, NULL), PRT_ERR_NULL);
    for (k = 0; k < 7; k++) {
        prt_result want = k < 2 ? PRT_ERR_BANDS : k < 5 ? PRT_ERR_COUNT : PRT_ERR_NULL;
        bad = t;
        if (k == 0) bad.bands = 0;
        if (k == 1) bad.bands = PRT_MAX_BANDS;
        if (k == 2) bad.theta_count = 0;
        if (k == 3) bad.phi_count = 0;
        if (k == 4) bad.rho_count = -3;
        if (k == 5) bad.rho = NULL;
        if (k == 6) bad.samples = NULL;
        assert_int_equal(prt_fiv_transfer_lookup(&bad, NULL, vectors, z, &f), want);
        if (k != 5) assert_int_equal(prt_fiv_transfer_samples(&bad, vectors, 0, 1, &f), want);
    }
    for (k = 0; k < (int)sizeof f; k++) assert_int_equal(((unsigned char *)&f)[k], 0x55);
}

/* ---- packed tables ---- */

static double value_of_half(int half) {
    int exponent = half >> 10 & 31, mantissa = half & 1023;
    double v = exponent ? ldexp(1024 + mantissa, exponent - 25) : ldexp(mantissa, -24);
    return half & 0x8000 ? -v : v;
}

static void halves_are_rounded_to_nearest(void **state) {
    int k;
    (void)state;
    skip_if_fast_math();                                       /* subnormals may count as 0 */
    for (k = 0; k < 0x7bff; k++) {
        double v = value_of_half(k), next = value_of_half(k + 1), middle = (v + next) / 2;
        assert_near(prt__real_of_half((uint16_t)k), v, 0);
        assert_near(prt__real_of_half((uint16_t)(k | 0x8000)), -v, 0);
        assert_int_equal(prt__half_of(v), k);
        assert_int_equal(prt__half_of(-v), k ? k | 0x8000 : 0);
        assert_int_equal(prt__half_of(middle - (next - v) / 1024), k);
        assert_int_equal(prt__half_of(middle + (next - v) / 1024), k + 1);
        assert_int_equal(prt__half_of(middle), k + (k & 1));
    }
    assert_int_equal(prt__half_of(65504), 0x7bff);
}

static void packed_tables_keep_their_error(void **state) {
    static uint16_t data[SAMPLES * 9];
    static prt_fiv back[SAMPLES];
    prt_fiv low[RHOS], step[RHOS];
    prt_fiv_table t = random_table(), again;
    prt_fiv_packed packed;
    unsigned char inside[SAMPLES];
    int bits, k, i;
    (void)state;
    for (k = 0; k < SAMPLES; k++) some_samples[k].g = scaled(some_samples[k].g, pow(10, -k / (THETAS * PHIS)));
    for (k = 0; k < SAMPLES; k++) some_samples[k].b = vec3(3, -3, 0);          /* nothing to spread */
    for (k = 0; k < SAMPLES; k++) inside[k] = (unsigned char)(uniform() < 0.2);
    t.inside = inside;
    for (bits = 8; bits <= 16; bits += 8) {
        assert_int_equal(prt_fiv_packed_size(&t, bits), SAMPLES * 9 * bits / 8);
        assert_int_equal(prt_fiv_pack(&t, bits, data, low, step, &packed), PRT_OK);
        assert_int_equal(prt_fiv_unpack(&packed, 0, SAMPLES, back), PRT_OK);
        for (k = 0; k < SAMPLES; k++) {
            double got[9], want[9], steps[9];
            components(&back[k], got);
            components(&some_samples[k], want);
            components(&step[k / (THETAS * PHIS)], steps);
            for (i = 0; i < 9; i++)
                assert_near(got[i], want[i], bits == 16 ? fabs(want[i]) / 2048 + ldexp(1, -25) : steps[i] * 0.5001 + 8 * EPS);
        }
        again = packed.grid;
        again.samples = back;
        for (k = 0; k < 500; k++) {
            prt_vec3 to = scaled(random_direction(), 6 * uniform());
            double got[9], want[9];
            prt_fiv a = { { 0, 0, 0 }, { 0, 0, 0 }, { 0, 0, 0 } }, b = a;
            assert_int_equal(prt_fiv_packed_lookup(&packed, to, &a), PRT_OK);
            assert_int_equal(prt_fiv_lookup(&again, to, &b), PRT_OK);
            components(&a, got);
            components(&b, want);
            for (i = 0; i < 9; i++) assert_near(got[i], want[i], 50 * EPS * 3);
        }
    }
}

/* Tables of every kind around the same receivers: what the lookups and prt_fiv_shade_vectors make of them one by one. */
enum { KINDS = 5 };
typedef struct menagerie {
    uint16_t halves[SAMPLES * 9];
    unsigned char bytes[SAMPLES * 9];
    prt_fiv low[RHOS], step[RHOS];
    prt_fiv_table plain;
    prt_fiv_packed half, byte;
    prt_fiv_transfer transfer;
    prt_real turn[9], still[9 * HIDDEN], turning[9 * HIDDEN];
    prt_fiv_body bodies[KINDS];
} menagerie;

static void gather(menagerie *m) {
    prt_real light[3 * LIGHT];
    int k;
    random_light(light);
    turn_of(m->turn);
    memset(m->bodies, 0, sizeof m->bodies);
    m->plain = random_table();
    m->transfer = random_transfer();
    assert_int_equal(prt_fiv_pack(&m->plain, 16, m->halves, NULL, NULL, &m->half), PRT_OK);
    assert_int_equal(prt_fiv_pack(&m->plain, 8, m->bytes, m->low, m->step, &m->byte), PRT_OK);
    assert_int_equal(prt_fiv_transfer_light(BANDS, NULL, light, m->still), PRT_OK);
    assert_int_equal(prt_fiv_transfer_light(BANDS, m->turn, light, m->turning), PRT_OK);
    m->bodies[0].table = &m->plain;
    m->bodies[1].packed = &m->half;
    m->bodies[2].packed = &m->byte;
    m->bodies[3].transfer = m->bodies[4].transfer = &m->transfer;
    m->bodies[3].vectors = m->still;
    m->bodies[4].vectors = m->turning;
    m->bodies[4].rotation = m->turn;
    for (k = 0; k < KINDS; k++) m->bodies[k].position = scaled(random_direction(), 1.5 + 2 * uniform());
}

static void bodies_of_every_kind(void **state) {
    static menagerie m;
    prt_vec3 p[RECEIVERS], n[RECEIVERS];
    prt_rgb total[RECEIVERS], out[RECEIVERS], one;
    prt_fiv_hidden h[KINDS];
    int round, k, i;
    (void)state;
    for (round = 0; round < 20; round++) {
        gather(&m);
        for (k = 0; k < RECEIVERS; k++) {
            p[k] = scaled(random_direction(), 2 * uniform());
            n[k] = random_direction();
            total[k] = rgb(4 * uniform(), 3, 8);
        }
        assert_int_equal(prt_fiv_shade_bodies_n(RECEIVERS, total, p, n, KINDS, m.bodies, 0, out), PRT_OK);
        for (k = 0; k < RECEIVERS; k++) {
            for (i = 0; i < KINDS; i++) {
                const prt_fiv_body *b = &m.bodies[i];
                h[i].radius = 1;
                h[i].to_centre = vec3((double)b->position.x - (double)p[k].x, (double)b->position.y - (double)p[k].y,
                                      (double)b->position.z - (double)p[k].z);
                assert_int_equal(b->table ? prt_fiv_lookup(b->table, h[i].to_centre, &h[i].fiv)
                                 : b->packed ? prt_fiv_packed_lookup(b->packed, h[i].to_centre, &h[i].fiv)
                                 : prt_fiv_transfer_lookup(b->transfer, b->rotation, b->vectors, h[i].to_centre, &h[i].fiv),
                                 PRT_OK);
            }
            assert_int_equal(prt_fiv_shade_vectors(total[k], n[k], KINDS, h, 0, &one), PRT_OK);
            assert_near(out[k].r, (double)one.r, 2e4 * EPS);
            assert_near(out[k].g, (double)one.g, 2e4 * EPS);
            assert_near(out[k].b, (double)one.b, 2e4 * EPS);
            assert_true(within(out[k], total[k]));
        }
    }
}

static void bodies_in_batches(void **state) {
    static menagerie m;
    prt_vec3 p[RECEIVERS], n[RECEIVERS];
    prt_rgb total[RECEIVERS], out[RECEIVERS], one;
    prt_fiv_occluder o;
    int k;
    (void)state;
    skip_if_fast_math();
    gather(&m);
    for (k = 0; k < RECEIVERS; k++) {
        p[k] = scaled(random_direction(), 2 * uniform());
        n[k] = random_direction();
        total[k] = rgb(4 * uniform(), 3, 8);
    }
    assert_int_equal(prt_fiv_shade_bodies_n(RECEIVERS, total, p, n, KINDS, m.bodies, 0, out), PRT_OK);
    for (k = 0; k < RECEIVERS; k++) {
        assert_int_equal(prt_fiv_shade_bodies_n(1, total + k, p + k, n + k, KINDS, m.bodies, 0, &one), PRT_OK);
        assert_memory_equal(&one, &out[k], sizeof one);
    }
    o.table = &m.plain;
    o.position = m.bodies[0].position;
    assert_int_equal(prt_fiv_shade_bodies_n(RECEIVERS, total, p, n, 1, m.bodies, 0, out), PRT_OK);
    for (k = 0; k < RECEIVERS; k++) {
        assert_int_equal(prt_fiv_shade(total[k], p[k], n[k], 1, &o, 0, &one), PRT_OK);
        assert_memory_equal(&one, &out[k], sizeof one);
    }
}

static void bad_bodies_write_nothing(void **state) {
    static menagerie m;
    const prt_vec3 z = { 0, 0, 1 };
    const prt_rgb total = { 1, 1, 1 };
    prt_rgb out = { 7, 7, 7 };
    prt_fiv_body b[KINDS];
    prt_fiv_packed packed;
    prt_fiv_transfer transfer;
    (void)state;
    gather(&m);
#define REFUSED(why) do { assert_int_equal(prt_fiv_shade_bodies_n(1, &total, &z, &z, KINDS, b, 0, &out), why); \
        assert_true(out.r == 7 && out.g == 7 && out.b == 7); } while (0)
    memcpy(b, m.bodies, sizeof b); b[0].table = NULL; REFUSED(PRT_ERR_NULL);                   /* of no kind */
    memcpy(b, m.bodies, sizeof b); b[3].vectors = NULL; REFUSED(PRT_ERR_NULL);
    packed = m.half;
    memcpy(b, m.bodies, sizeof b); b[1].packed = &packed; packed.data = NULL; REFUSED(PRT_ERR_NULL);
    packed = m.half; packed.bits = 12; REFUSED(PRT_ERR_COUNT);
    packed = m.half; packed.grid.rho = NULL; REFUSED(PRT_ERR_NULL);
    packed = m.byte; packed.step = NULL; REFUSED(PRT_ERR_NULL);
    transfer = m.transfer;
    memcpy(b, m.bodies, sizeof b); b[4].transfer = &transfer; transfer.bands = 0; REFUSED(PRT_ERR_BANDS);
    b[0].table = NULL; REFUSED(PRT_ERR_BANDS);                     /* pointers last */
    transfer = m.transfer; transfer.phi_count = 0; REFUSED(PRT_ERR_COUNT);
    memcpy(b, m.bodies, sizeof b);
    assert_int_equal(prt_fiv_shade_bodies_n(-1, &total, &z, &z, KINDS, b, 0, &out), PRT_ERR_COUNT);
    assert_int_equal(prt_fiv_shade_bodies_n(1, &total, &z, &z, -1, b, 0, &out), PRT_ERR_COUNT);
    assert_int_equal(prt_fiv_shade_bodies_n(1, &total, &z, &z, 1, NULL, 0, &out), PRT_ERR_NULL);
    assert_int_equal(prt_fiv_shade_bodies_n(1, NULL, &z, &z, KINDS, b, 0, &out), PRT_ERR_NULL);
    assert_int_equal(prt_fiv_shade_bodies_n(1, &total, &z, &z, KINDS, b, 0, NULL), PRT_ERR_NULL);
    assert_int_equal(prt_fiv_shade_bodies_n(0, NULL, NULL, NULL, 0, NULL, 0, NULL), PRT_OK);
    assert_true(out.r == 7);
#undef REFUSED
}

static void packing_refuses_bad_arguments(void **state) {
    static uint16_t data[SAMPLES * 9];
    prt_fiv low[RHOS], step[RHOS], f;
    prt_fiv_table t = random_table();
    prt_fiv_packed packed, bad;
    (void)state;
    memset(&f, 0, sizeof f);
    assert_int_equal(prt_fiv_packed_size(&t, 9), 0);
    assert_int_equal(prt_fiv_packed_size(NULL, 8), 0);
    assert_int_equal(prt_fiv_pack(NULL, 8, data, low, step, &packed), PRT_ERR_NULL);
    assert_int_equal(prt_fiv_pack(&t, 12, data, low, step, &packed), PRT_ERR_COUNT);
    assert_int_equal(prt_fiv_pack(&t, 8, NULL, low, step, &packed), PRT_ERR_NULL);
    assert_int_equal(prt_fiv_pack(&t, 8, data, NULL, step, &packed), PRT_ERR_NULL);
    assert_int_equal(prt_fiv_pack(&t, 8, data, low, step, NULL), PRT_ERR_NULL);
    assert_int_equal(prt_fiv_pack(&t, 16, data, NULL, NULL, &packed), PRT_OK);
    assert_int_equal(prt_fiv_packed_lookup(NULL, vec3(0, 0, 1), &f), PRT_ERR_NULL);
    assert_int_equal(prt_fiv_packed_lookup(&packed, vec3(0, 0, 1), NULL), PRT_ERR_NULL);
    assert_int_equal(prt_fiv_unpack(&packed, 0, SAMPLES + 1, &f), PRT_ERR_COUNT);
    assert_int_equal(prt_fiv_unpack(&packed, 0, 1, NULL), PRT_ERR_NULL);
    bad = packed; bad.bits = 8;
    assert_int_equal(prt_fiv_packed_lookup(&bad, vec3(0, 0, 1), &f), PRT_ERR_NULL);
    bad = packed; bad.bits = 0;
    assert_int_equal(prt_fiv_packed_lookup(&bad, vec3(0, 0, 1), &f), PRT_ERR_COUNT);
    bad = packed; bad.data = NULL;
    assert_int_equal(prt_fiv_packed_lookup(&bad, vec3(0, 0, 1), &f), PRT_ERR_NULL);
    some_samples[5].r.x = 65520;
    assert_int_equal(prt_fiv_pack(&t, 16, data, NULL, NULL, &packed), PRT_ERR_VALUE);
    assert_int_equal(prt_fiv_pack(&t, 8, data, low, step, &packed), PRT_OK);
    skip_if_fast_math();
    some_samples[5].r.x = (prt_real)NAN;
    assert_int_equal(prt_fiv_pack(&t, 8, data, low, step, &packed), PRT_ERR_VALUE);
}

/* ---- the total ---- */

/* I_tot = 1 + N.v is smooth: bilinear interpolation of it errs by its curvature, |v|, times (2/size)^2/8 a direction. */
static void total_between_texels(void **state) {
    enum { SIZE = 16 };
    static prt_rgb total[6 * SIZE * SIZE];
    static const int axis[6] = { 0, 0, 1, 1, 2, 2 };
    int k, face;
    double bound = 2 * 4.0 / SIZE / SIZE / 8 * 3;
    (void)state;
    for (k = 0; k < 6 * SIZE * SIZE; k++) {
        double s = (2 * (k % SIZE) + 1.0) / SIZE - 1, u = (2 * (k / SIZE % SIZE) + 1.0) / SIZE - 1, d[3] = { 0, 0, 0 }, r;
        face = k / SIZE / SIZE;
        if (axis[face] == 0) { d[0] = face == 0 ? 1 : -1; d[1] = -u; d[2] = face == 0 ? -s : s; }
        if (axis[face] == 1) { d[0] = s; d[1] = face == 2 ? 1 : -1; d[2] = face == 2 ? u : -u; }
        if (axis[face] == 2) { d[0] = face == 4 ? s : -s; d[1] = -u; d[2] = face == 4 ? 1 : -1; }
        r = sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]);
        total[k] = rgb(2 + d[0] / r, 2 + d[1] / r, 2 + d[2] / r);
    }
    for (k = 0; k < 5000; k++) {
        prt_vec3 n = random_direction();
        prt_rgb got = prt_fiv_total(SIZE, total, n);
        assert_near(got.r, 2 + (double)n.x, bound); assert_near(got.g, 2 + (double)n.y, bound);
        assert_near(got.b, 2 + (double)n.z, bound);
    }
    assert_near(prt_fiv_total(SIZE, total, vec3(1, 0, 0)).r, 3, bound);
    assert_true(prt_fiv_total(0, total, vec3(1, 0, 0)).r == 0 && prt_fiv_total(SIZE, NULL, vec3(1, 0, 0)).r == 0);
    assert_true(finite_rgb(prt_fiv_total(1, total, vec3(0, 0, 0))));
}

/* ---- bad input: defined, finite, within 0 ... total ---- */

static void every_place_is_survived(void **state) {
    static const double sizes[7] = { 0, 1e-30, 1e-3, 1, 1e3, 1e18, 1e38 };
    prt_fiv_table t = ball_table(), none = ball_table(), narrow = ball_table();
    unsigned char inside[BALL_THETAS * BALL_PHIS * BALL_RHOS];
    prt_fiv_occluder o[6];
    const prt_rgb total = rgb(1, 3, 0);
    int a, b, k, f;
    (void)state;
    memset(inside, 1, sizeof inside);
    none.radius = 0;
    narrow.theta_count = narrow.phi_count = narrow.rho_count = 1;
    for (a = 0; a < 7; a++)
        for (b = 0; b < 7; b++)
            for (k = 0; k < 40; k++) {
                prt_vec3 p = scaled(random_direction(), sizes[a]), n = random_direction();
                prt_rgb out;
                prt_fiv v = nothing;
                t.inside = k % 2 ? inside : NULL;
                for (f = 0; f < 6; f++) o[f].position = scaled(random_direction(), sizes[b]);
                o[0].table = o[1].table = o[2].table = &t; o[3].table = &none; o[4].table = o[5].table = &narrow;
                o[1].position = p;                                         /* at the receiver */
                o[2].position = o[0].position;                             /* coincident */
                assert_int_equal(prt_fiv_shade(total, p, n, 6, o, (unsigned)k % 4, &out), PRT_OK);
                assert_true(finite_rgb(out) && within(out, total));
                assert_int_equal(prt_fiv_lookup(&t, p, &v), PRT_OK);
                assert_true(prt__finite3(v.r) && prt__finite3(v.g) && prt__finite3(v.b));
                assert_int_equal(prt_fiv_self(&v, &t, p, n, &out), PRT_OK);
                assert_true(finite_rgb(out) && out.r >= 0 && out.g >= 0 && out.b >= 0);
            }
}

static void zero_radius_hides_nothing(void **state) {
    prt_fiv_table t = ball_table();
    prt_fiv_occluder o = { NULL, { 0, 0, 2 } };
    prt_rgb out = { 0, 0, 0 };
    (void)state;
    o.table = &t;
    t.radius = 0;
    assert_int_equal(prt_fiv_shade(rgb(1, 2, 3), vec3(0, 0, 0), vec3(0, 0, 1), 1, &o, 0, &out), PRT_OK);
    assert_true(out.r == 1 && out.g == 2 && out.b == 3);
    t.radius = -1;
    assert_int_equal(prt_fiv_shade(rgb(1, 2, 3), vec3(0, 0, 0), vec3(0, 0, 1), 1, &o, 0, &out), PRT_OK);
    assert_true(out.r == 1 && out.g == 2 && out.b == 3);
}

static void one_row_serves_every_direction(void **state) {
    prt_real rho[2] = { 1, 2 };
    prt_fiv samples[2 * 4];
    prt_fiv_table t = { 1, 1, 2, rho, 1, samples, NULL };
    prt_fiv f = nothing;
    int k;
    (void)state;
    memset(samples, 0, sizeof samples);
    samples[0].r.x = 2; samples[1].r.x = 4;
    for (k = 0; k < 50; k++) {
        assert_int_equal(prt_fiv_lookup(&t, scaled(random_direction(), 1.5), &f), PRT_OK);
        assert_near(f.r.x, 3, 20 * EPS);
    }
    t.theta_count = 2; t.rho_count = 1;                                    /* theta = 0 and pi: linear between */
    assert_int_equal(prt_fiv_lookup(&t, vec3(0.5, 0.5, 0), &f), PRT_OK);
    assert_near(f.r.x, 3, 20 * EPS);
    t.theta_count = 1; t.phi_count = 2;                                    /* phi = 0 and pi */
    assert_int_equal(prt_fiv_lookup(&t, vec3(0, 0.9, 0.1), &f), PRT_OK);
    assert_near(f.r.x, 3, 20 * EPS);
    assert_int_equal(prt_fiv_lookup(&t, vec3(0, -0.9, 0.1), &f), PRT_OK);
    assert_near(f.r.x, 3, 20 * EPS);
}

static void disordered_distances_and_bad_samples(void **state) {
    prt_real rho[4] = { 3, 1, 1, -5 };
    prt_fiv samples[4 * 2 * 4];
    prt_fiv_table t = { 2, 4, 4, rho, 1, samples, NULL };
    prt_fiv_occluder o[2] = { { NULL, { 0, 0, 2 } }, { NULL, { 1, 0, 1 } } };
    const prt_rgb total = rgb(1, 2, 3);
    const prt_real bad[4] = { (prt_real)NAN, (prt_real)INFINITY, -(prt_real)INFINITY, PRT__REAL_MAX };
    prt_rgb out = { 0, 0, 0 };
    prt_fiv f = nothing;
    int k, c;
    (void)state;
    skip_if_fast_math();
    o[0].table = o[1].table = &t;
    for (k = 0; k < 2000; k++) {
        prt_real *value = (prt_real *)samples;
        prt_vec3 n = random_direction();
        for (c = 0; c < 32 * 9; c++) value[c] = uniform() < 0.03 ? bad[c % 4] : (prt_real)signed_uniform();
        if (k % 5 == 0) rho[k % 4] = bad[k / 4 % 4];
        if (k % 7 == 0) rho[k % 4] = (prt_real)(4 * uniform() - 1);
        if (k % 11 == 0) n.x = bad[k % 4];
        if (k % 13 == 0) o[0].position.y = bad[k % 4]; else o[0].position.y = 0;
        t.radius = k % 17 ? 1 : bad[k % 4];
        assert_int_equal(prt_fiv_shade(total, vec3(0, 0, 0), n, 2, o, (unsigned)k % 4, &out), PRT_OK);
        assert_true(finite_rgb(out) && within(out, total));
        assert_int_equal(prt_fiv_lookup(&t, scaled(random_direction(), 2), &f), PRT_OK);
        assert_true(prt__finite3(f.r) && prt__finite3(f.g) && prt__finite3(f.b));
    }
    for (c = 0; c < 32; c++) memset(&samples[c], 0xff, sizeof samples[c]);  /* NaN everywhere */
    assert_int_equal(prt_fiv_lookup(&t, vec3(0, 1, 0), &f), PRT_OK);
    assert_true(f.r.x == 0 && f.g.y == 0 && f.b.z == 0);
    assert_int_equal(prt_fiv_shade(rgb(NAN, -1, 2), vec3(0, 0, 0), vec3(0, 0, 1), 2, o, 0, &out), PRT_OK);
    assert_true(out.r == 0 && out.g == 0 && out.b == 2);
}

static void nan_samples_are_left_out(void **state) {
    prt_fiv_table t = random_table();
    unsigned char inside[SAMPLES];
    double want[9], got[9];
    prt_fiv f = nothing;
    int k, n;
    (void)state;
    skip_if_fast_math();
    for (k = 0; k < SAMPLES; k++) inside[k] = (unsigned char)(uniform() < 0.2);
    for (k = 0; k < SAMPLES; k++) if (inside[k]) some_samples[k].g.y = (prt_real)NAN;
    for (k = 0; k < 1000; k++) {
        prt_vec3 to = scaled(random_direction(), 1 + 4 * uniform());
        t.inside = NULL;
        assert_int_equal(prt_fiv_lookup(&t, to, &f), PRT_OK);
        t.inside = inside;
        textbook_lookup(&t, to, want);
        components(&f, got);
        for (n = 0; n < 9; n++) assert_near(got[n], want[n], 5e5 * EPS);
    }
}

/* If all eight are inside, all of them count. */
static void all_inside_counts_all(void **state) {
    prt_fiv_table t = random_table();
    unsigned char inside[SAMPLES];
    double want[9], got[9];
    prt_fiv f = nothing;
    int k, n;
    (void)state;
    memset(inside, 1, sizeof inside);
    for (k = 0; k < 100; k++) {
        prt_vec3 to = scaled(random_direction(), 1 + 4 * uniform());
        t.inside = NULL;
        textbook_lookup(&t, to, want);
        t.inside = inside;
        assert_int_equal(prt_fiv_lookup(&t, to, &f), PRT_OK);
        components(&f, got);
        for (n = 0; n < 9; n++) assert_near(got[n], want[n], 100 * EPS);
    }
}

static void bad_arguments_write_nothing(void **state) {
    prt_fiv_table t = random_table(), bad;
    prt_fiv_occluder o[2];
    prt_fiv_hidden h;
    prt_fiv f = nothing;
    prt_rgb out = { 7, 7, 7 }, total = { 1, 1, 1 };
    prt_vec3 z = vec3(0, 0, 1);
    int k;
    (void)state;
    memset(&h, 0, sizeof h);
    memset(&f, 0, sizeof f);
    o[0].table = o[1].table = &t;
    o[0].position = o[1].position = z;
    assert_int_equal(prt_fiv_lookup(NULL, z, &f), PRT_ERR_NULL);
    assert_int_equal(prt_fiv_lookup(&t, z, NULL), PRT_ERR_NULL);
    for (k = 0; k < 5; k++) {
        prt_result want = k < 3 ? PRT_ERR_COUNT : PRT_ERR_NULL;
        bad = t;
        if (k == 0) bad.theta_count = 0;
        if (k == 1) bad.phi_count = -1;
        if (k == 2) bad.rho_count = 0;
        if (k == 3) bad.rho = NULL;
        if (k == 4) bad.samples = NULL;
        o[1].table = &bad;
        assert_int_equal(prt_fiv_lookup(&bad, z, &f), want);
        assert_int_equal(prt_fiv_shade(total, z, z, 2, o, 0, &out), want);
        assert_int_equal(prt_fiv_shade_n(1, &total, &z, &z, 2, o, 0, &out), want);
        assert_int_equal(prt_fiv_self(&f, &bad, z, z, &out), want);
    }
    o[1].table = NULL;
    assert_int_equal(prt_fiv_shade(total, z, z, 2, o, 0, &out), PRT_ERR_NULL);
    assert_int_equal(prt_fiv_shade(total, z, z, -1, o, 0, &out), PRT_ERR_COUNT);
    assert_int_equal(prt_fiv_shade(total, z, z, 1, NULL, 0, &out), PRT_ERR_NULL);
    assert_int_equal(prt_fiv_shade(total, z, z, 1, o, 0, NULL), PRT_ERR_NULL);
    assert_int_equal(prt_fiv_shade_n(-1, &total, &z, &z, 1, o, 0, &out), PRT_ERR_COUNT);
    assert_int_equal(prt_fiv_shade_n(1, NULL, &z, &z, 1, o, 0, &out), PRT_ERR_NULL);
    assert_int_equal(prt_fiv_shade_n(1, &total, NULL, &z, 1, o, 0, &out), PRT_ERR_NULL);
    assert_int_equal(prt_fiv_shade_n(1, &total, &z, NULL, 1, o, 0, &out), PRT_ERR_NULL);
    assert_int_equal(prt_fiv_shade_vectors(total, z, -1, &h, 0, &out), PRT_ERR_COUNT);
    assert_int_equal(prt_fiv_shade_vectors(total, z, 1, NULL, 0, &out), PRT_ERR_NULL);
    assert_int_equal(prt_fiv_shade_vectors(total, z, 1, &h, 0, NULL), PRT_ERR_NULL);
    assert_int_equal(prt_fiv_self(NULL, &t, z, z, &out), PRT_ERR_NULL);
    assert_int_equal(prt_fiv_self(&f, NULL, z, z, &out), PRT_ERR_NULL);
    assert_int_equal(prt_fiv_self(&f, &t, z, z, NULL), PRT_ERR_NULL);
    assert_true(out.r == 7 && out.g == 7 && out.b == 7 && f.r.x == 0);
    assert_int_equal(prt_fiv_shade_n(0, NULL, NULL, NULL, 0, NULL, 0, NULL), PRT_OK);
    assert_int_equal(prt_fiv_shade(total, z, z, 0, NULL, 0, &out), PRT_OK);
    assert_true(out.r == 1);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(vectors_of_directions_add_up),
        cmocka_unit_test(vector_of_a_cap),
        cmocka_unit_test(lookup_returns_samples_at_their_places),
        cmocka_unit_test(lookup_is_trilinear),
        cmocka_unit_test(lookup_is_continuous_over_poles_and_seam),
        cmocka_unit_test(lookup_falls_off_with_the_solid_angle),
        cmocka_unit_test(interpolation_error_of_geometric_distances),
        cmocka_unit_test(horizon_cuts_caps),
        cmocka_unit_test(lens_of_two_discs),
        cmocka_unit_test(discs_stand_in_for_caps),
        cmocka_unit_test(overlap_takes_back_the_lens),
        cmocka_unit_test(overlap_of_discs_that_are_filled_in_part),
        cmocka_unit_test(ball_over_a_plane),
        cmocka_unit_test(shading_agrees_with_the_textbook),
        cmocka_unit_test(batches_give_the_same_bits),
        cmocka_unit_test(self_shadow_darkens_with_the_height_of_its_samples),
        cmocka_unit_test(self_shadow_leaves_out_the_inside),
        cmocka_unit_test(transfer_is_bilinear),
        cmocka_unit_test(transfer_lookup_agrees_with_its_table),
        cmocka_unit_test(transfer_of_a_cap),
        cmocka_unit_test(transfer_survives_bad_samples),
        cmocka_unit_test(transfer_refuses_bad_arguments),
        cmocka_unit_test(halves_are_rounded_to_nearest),
        cmocka_unit_test(packed_tables_keep_their_error),
        cmocka_unit_test(packing_refuses_bad_arguments),
        cmocka_unit_test(bodies_of_every_kind),
        cmocka_unit_test(bodies_in_batches),
        cmocka_unit_test(bad_bodies_write_nothing),
        cmocka_unit_test(total_between_texels),
        cmocka_unit_test(every_place_is_survived),
        cmocka_unit_test(zero_radius_hides_nothing),
        cmocka_unit_test(one_row_serves_every_direction),
        cmocka_unit_test(disordered_distances_and_bad_samples),
        cmocka_unit_test(nan_samples_are_left_out),
        cmocka_unit_test(all_inside_counts_all),
        cmocka_unit_test(bad_arguments_write_nothing),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
