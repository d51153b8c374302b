#include "mesh.h"

#include <limits.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "mesh_import.h"
#include "transfer_file.h"

void mesh_free(mesh *m) {
    free(m->points);
    free(m->triangles);
    memset(m, 0, sizeof *m);
}

int mesh_copy(const mesh *from, mesh *to, why *w) {
    size_t points = (size_t)from->point_count * sizeof *to->points;
    size_t triangles = 3 * (size_t)from->triangle_count * sizeof *to->triangles;
    *to = *from;
    to->points = (prt_point *)malloc(points);
    to->triangles = (uint32_t *)malloc(triangles);
    if (!to->points || !to->triangles) {
        mesh_free(to);
        return why_set(w, "out of memory for a copy of the mesh");
    }
    memcpy(to->points, from->points, points);
    memcpy(to->triangles, from->triangles, triangles);
    return 0;
}

static void turn_to_z_up(prt_vec3 *v, int count) {
    int i;
    for (i = 0; i < count; i++) {
        prt_real y = v[i].y;
        v[i].y = -v[i].z;
        v[i].z = y;
    }
}

static int make_points(const char *path, const raw_mesh *raw, mesh *m, why *w) {
    prt_mesh source;
    prt_result result;
    memset(&source, 0, sizeof source);
    source.vertex_count = raw->vertex_count;
    source.positions = raw->positions;
    source.normals = raw->normals;
    source.triangle_count = raw->triangle_count;
    source.triangles = raw->triangles;
    m->points = (prt_point *)malloc((size_t)raw->vertex_count * sizeof *m->points);
    if (!m->points) return why_set(w, "%s: out of memory", path);
    result = prt_points_from_vertices(&source, m->points, &m->report);
    if (result == PRT_ERR_VALUE)
        return why_set(w, "%s: has a vertex whose position is not finite (NaN or infinity): repair the file", path);
    if (result != PRT_OK) return why_set(w, "%s: is damaged: %s", path, prt_result_string(result));
    m->point_count = raw->vertex_count;
    return 0;
}

int mesh_load(const char *path, mesh_up up, mesh *m, why *w) {
    raw_mesh raw;
    int failed;
    memset(m, 0, sizeof *m);
    if (raw_mesh_import(path, &raw, w)) return -1;
    if (up == MESH_Y_UP) {
        turn_to_z_up(raw.positions, raw.vertex_count);
        turn_to_z_up(raw.normals, raw.vertex_count);
    }
    failed = make_points(path, &raw, m, w);
    m->triangle_count = raw.triangle_count;
    m->transmissive_faces = raw.transmissive_faces;
    m->triangles = raw.triangles;
    raw.triangles = NULL;
    raw_mesh_free(&raw);
    if (failed) mesh_free(m);
    return failed;
}

/* ---- placing ---- */

int mesh_fit_unit_sphere(mesh *m, why *w) {
    double x0 = (double)m->report.centre.x, y0 = (double)m->report.centre.y, z0 = (double)m->report.centre.z, most = 0;
    int i;
    for (i = 0; i < m->point_count; i++) {
        const prt_vec3 *p = &m->points[i].position;
        double x = (double)p->x - x0, y = (double)p->y - y0, z = (double)p->z - z0, r = sqrt(x * x + y * y + z * z);
        if (r > most) most = r;
    }
    if (!(most > 0)) return why_set(w, "all vertices of the mesh lie in one place, so that there is nothing to see");
    for (i = 0; i < m->point_count; i++) {
        prt_vec3 *p = &m->points[i].position;
        p->x = (prt_real)(((double)p->x - x0) / most);
        p->y = (prt_real)(((double)p->y - y0) / most);
        p->z = (prt_real)(((double)p->z - z0) / most);
    }
    return 0;
}

/* The edge's key, smaller vertex first, and which corner of which triangle it belongs to. */
typedef struct edge { uint64_t key; uint32_t place; } edge;

static int by_key(const void *a, const void *b) {
    uint64_t x = ((const edge *)a)->key, y = ((const edge *)b)->key;
    return x < y ? -1 : x > y;
}

static prt_point middle_of(const prt_point *a, const prt_point *b) {
    prt_point p;
    prt_real length;
    p.position.x = (a->position.x + b->position.x) / 2;
    p.position.y = (a->position.y + b->position.y) / 2;
    p.position.z = (a->position.z + b->position.z) / 2;
    p.normal.x = a->normal.x + b->normal.x;
    p.normal.y = a->normal.y + b->normal.y;
    p.normal.z = a->normal.z + b->normal.z;
    length = (prt_real)sqrt((double)(p.normal.x * p.normal.x + p.normal.y * p.normal.y + p.normal.z * p.normal.z));
    if (!(length > 0)) p.normal = a->normal;
    else { p.normal.x /= length; p.normal.y /= length; p.normal.z /= length; }
    return p;
}

/* The mesh's edges, each as often as it has triangles, sorted so that these stand together. */
static void list_edges(const mesh *m, edge *list) {
    size_t count = 3 * (size_t)m->triangle_count, i;
    for (i = 0; i < count; i++) {
        uint32_t a = m->triangles[i], b = m->triangles[i % 3 == 2 ? i - 2 : i + 1];
        list[i].key = (uint64_t)(a < b ? a : b) << 32 | (a < b ? b : a);
        list[i].place = (uint32_t)i;
    }
    qsort(list, count, sizeof *list, by_key);
}

enum { UNCUT = -1 };                   /* as an edge's middle; else the point there */

static uint32_t *put_triangle(uint32_t *to, int64_t a, int64_t b, int64_t c) {
    to[0] = (uint32_t)a;
    to[1] = (uint32_t)b;
    to[2] = (uint32_t)c;
    return to + 3;
}

/* One triangle by the middles of its edges (edge k runs from corner k to the next). */
static uint32_t *cut_triangle(const uint32_t v[3], const int64_t middle[3], uint32_t *to) {
    int cuts = (middle[0] != UNCUT) + (middle[1] != UNCUT) + (middle[2] != UNCUT), k = 0;
    int64_t a, b, c, ab, bc, ca;
    if (cuts == 1) while (middle[k] == UNCUT) k++;                  /* turned so that the cut edge, */
    if (cuts == 2) while (middle[(k + 2) % 3] != UNCUT) k++;        /* or the two of them, come first */
    a = v[k]; b = v[(k + 1) % 3]; c = v[(k + 2) % 3];
    ab = middle[k]; bc = middle[(k + 1) % 3]; ca = middle[(k + 2) % 3];
    if (cuts == 0) return put_triangle(to, a, b, c);
    if (cuts == 1) return put_triangle(put_triangle(to, a, ab, c), ab, b, c);
    to = put_triangle(to, ab, b, bc);
    if (cuts == 2) return put_triangle(put_triangle(to, a, ab, bc), a, bc, c);
    return put_triangle(put_triangle(put_triangle(to, a, ab, ca), ca, bc, c), ab, bc, ca);
}

/* Makes the points in the middle of the wanted edges: of edge i at middle[i]. */
static int make_middles(mesh *m, const edge *list, mesh_edge_test wanted, void *user, int64_t *middle, uint32_t *ends) {
    size_t count = 3 * (size_t)m->triangle_count, i;
    int fresh = 0;
    for (i = 0; i < count; i++) {
        uint32_t a = (uint32_t)(list[i].key >> 32), b = (uint32_t)list[i].key;
        if (i > 0 && list[i].key == list[i - 1].key) {
            middle[list[i].place] = middle[list[i - 1].place];
        } else if (wanted && !wanted(user, a, b)) {
            middle[list[i].place] = UNCUT;
        } else {
            middle[list[i].place] = m->point_count + fresh;
            m->points[m->point_count + fresh] = middle_of(m->points + a, m->points + b);
            ends[2 * fresh] = a;
            ends[2 * fresh + 1] = b;
            fresh++;
        }
    }
    return fresh;
}

int mesh_cut_edges(mesh *m, mesh_edge_test wanted, void *user, uint32_t **ends, why *w) {
    size_t edges = 3 * (size_t)m->triangle_count, i;
    edge *list = (edge *)malloc(edges * sizeof *list);
    int64_t *middle = (int64_t *)malloc(edges * sizeof *middle);
    uint32_t *pairs = (uint32_t *)malloc(2 * edges * sizeof *pairs);
    uint32_t *triangles = (uint32_t *)malloc(4 * edges * sizeof *triangles), *end = triangles;
    prt_point *points = (prt_point *)realloc(m->points, ((size_t)m->point_count + edges) * sizeof *points);
    int failed = !list || !middle || !pairs || !triangles || !points || edges > INT_MAX / 8;
    if (points) m->points = points;
    if (!failed) {
        list_edges(m, list);
        m->point_count += make_middles(m, list, wanted, user, middle, pairs);
        for (i = 0; i < edges; i += 3) end = cut_triangle(m->triangles + i, middle + i, end);
        free(m->triangles);
        m->triangle_count = (int)((end - triangles) / 3);
        m->triangles = triangles;
    } else {
        free(triangles);
    }
    free(list);
    free(middle);
    if (ends && !failed) *ends = pairs;
    else free(pairs);
    return failed ? why_set(w, "out of memory for a finer mesh") : 0;
}

static void set_floor_point(prt_point *point, prt_vec3 centre, double radius, double angle) {
    point->position.x = (prt_real)((double)centre.x + radius * cos(angle));
    point->position.y = (prt_real)((double)centre.y + radius * sin(angle));
    point->position.z = centre.z;
    point->normal.x = 0; point->normal.y = 0; point->normal.z = 1;
}

/* Ring k has 6k points: a hexagonal lattice bent into circles, triangles nearly equilateral everywhere. */
int mesh_add_floor(mesh *m, prt_vec3 centre, prt_real radius, prt_real spacing, why *w) {
    int rings = (int)ceil((double)radius / (double)spacing), base = m->point_count, k, i;
    size_t points = (size_t)base + 1 + 3 * (size_t)rings * (size_t)(rings + 1);
    size_t triangles = (size_t)m->triangle_count + 6 * (size_t)rings * (size_t)rings;
    prt_point *new_points;
    uint32_t *new_triangles, *t;
    new_points = (prt_point *)realloc(m->points, points * sizeof *new_points);
    if (new_points) m->points = new_points;
    new_triangles = (uint32_t *)realloc(m->triangles, triangles * 3 * sizeof *new_triangles);
    if (new_triangles) m->triangles = new_triangles;
    if (!new_points || !new_triangles || points > INT_MAX || triangles > INT_MAX / 3)
        return why_set(w, "out of memory for the floor");
    t = m->triangles + 3 * (size_t)m->triangle_count;
    set_floor_point(m->points + base, centre, 0, 0);
    for (k = 1; k <= rings; k++) {
        int outer = base + 1 + 3 * k * (k - 1), inner = k > 1 ? outer - 6 * (k - 1) : base;
        for (i = 0; i < 6 * k; i++) {
            int side = i / k, along = i % k, in = k > 1 ? inner + (side * (k - 1) + along) % (6 * (k - 1)) : base;
            int next = outer + (i + 1) % (6 * k);
            set_floor_point(m->points + outer + i, centre, (double)radius * k / rings,
                            2 * 3.14159265358979323846 * i / (6 * k));
            *t++ = (uint32_t)(outer + i); *t++ = (uint32_t)next; *t++ = (uint32_t)in;
            if (along < k - 1) {
                int in_next = inner + (side * (k - 1) + along + 1) % (6 * (k - 1));
                *t++ = (uint32_t)next; *t++ = (uint32_t)in_next; *t++ = (uint32_t)in;
            }
        }
    }
    m->point_count = (int)points;
    m->triangle_count = (int)triangles;
    return 0;
}

static uint64_t hash_words(uint64_t hash, const uint32_t *words, int count) {
    int i;
    for (i = 0; i < count; i++) {
        unsigned char bytes[4];
        bytes[0] = (unsigned char)words[i];
        bytes[1] = (unsigned char)(words[i] >> 8);
        bytes[2] = (unsigned char)(words[i] >> 16);
        bytes[3] = (unsigned char)(words[i] >> 24);
        hash = transfer_checksum(hash, bytes, 4);
    }
    return hash;
}

uint64_t mesh_hash(const mesh *m) {
    uint64_t hash = TRANSFER_CHECKSUM_START;
    int i;
    for (i = 0; i < m->point_count; i++) {
        const prt_point *p = m->points + i;
        float values[6];
        uint32_t words[6];
        values[0] = (float)p->position.x; values[1] = (float)p->position.y; values[2] = (float)p->position.z;
        values[3] = (float)p->normal.x;   values[4] = (float)p->normal.y;   values[5] = (float)p->normal.z;
        memcpy(words, values, sizeof words);
        hash = hash_words(hash, words, 6);
    }
    for (i = 0; i < m->triangle_count; i++) hash = hash_words(hash, m->triangles + 3 * (size_t)i, 3);
    return hash;
}
