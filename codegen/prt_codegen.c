/* prt_codegen - prints the straight-line kernels of prt.h in C, GLSL, HLSL, WGSL and Metal, and keeps the fenced
   blocks of prt.h up to date.

     prt_codegen --list                                  families, bands, operation counts
     prt_codegen --lang glsl --bands 4 --emit sh_eval,sh_irradiance -o prt.glsl
     prt_codegen --update prt.h shaders/prt.glsl         rewrite every fenced block, or a whole file that it printed
     prt_codegen --check  prt.h shaders/prt.glsl         say whether --update would change them; exit 1 if so

   --lang c|glsl|hlsl|wgsl|metal   [c]
   --emit NAME,NAME...             kernels, as --list names them; "all" for all that have the bands asked for
   --bands N | A-B                 [4]; functions of a range carry their number of bands in their names
   --precision float|half|float16  [float] half: mediump, min16float, f16, half, _Float16, which may be wider than 16
                                   bits;
                                   float16: float16_t in GLSL (Vulkan), half in HLSL (Shader Model 6.2,
                                   -enable-16bit-types), the others as half
   --prefix NAME                   before the names of functions [prt_]
   -o FILE                         [standard output]
   --table NAME --count N          a table of constants instead (of prt.h alone)

   A fence of prt.h carries its own command, whose kernels are printed in the forms that the header uses:
     / * BEGIN GENERATED: prt_codegen --lang c --emit sh_eval --bands 1-10 * /
     ...
     / * END GENERATED * /
   A fence of another language, in the source file of any program, holds the functions as a string of C. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "../prt.h"                                    /* its version */
#include "kernels.h"
#include "language.h"

typedef struct request {
    const char *lang, *prefix, *path;
    precision precision;
    char emit[1024];                                   /* names, separated by commas */
    const char *table;                                 /* name of a table instead */
    int count;                                         /* its entries */
    int first_bands, last_bands;
} request;

static int fail(const char *what, const char *which, const char *remedy) {
    fprintf(stderr, "prt_codegen: %s '%s': %s\n", what, which, remedy);
    return 1;
}

static const family *find_family(const char *name, unsigned forms) {
    int i;
    for (i = 0; i < family_count; i++)
        if (!strcmp(families[i].name, name) && families[i].forms & forms) return &families[i];
    return NULL;
}

/* ---- printing what a request asks for ---- */

/* The forms that prt.h uses */
static void print_header_forms(FILE *to, const family *f, int bands) {
    kernel *k = f->describe(bands);
    char name[96];
    snprintf(name, sizeof name, "prt__%s", k->name);
    if (f->forms & FORM_ONE) print_kernel(to, &dialect_header, k, name);
    if (f->forms & FORM_DOUBLE) print_kernel(to, &dialect_header_double, k, name);
    if (f->forms & FORM_LANES) print_kernel(to, &dialect_header_lanes, k, name);
    if (f->forms & FORM_SWEPT) print_swept(to, k, name);
    if (f->forms & FORM_NODES) print_kernel(to, &dialect_header_nodes, k, name);
    if (f->forms & FORM_BLOCK) print_kernel(to, &dialect_header_block, k, name);
    if (f->forms & FORM_STRIDED) print_kernel(to, &dialect_header_strided, k, name);
    kernel_free(k);
}

/* double prt__roots()[k] = sqrt(k), prt__inverse_roots()[k] = 1/sqrt(k) (0 at k = 0) for k < count */
static void print_root_table(FILE *to, const char *name, const char *what, int count, int inverse) {
    int k, column = 0;
    fprintf(to, "/* %s for k = 0 ... %d */\nPRT__STATIC const double *prt__%s(void) {\n"
                "    static const double table[%d] = {\n",
            what, count - 1, name, count);
    for (k = 0; k < count; k++) {
        char text[64];
        xreal root = x_sqrt(x_ratio(k, 1));
        x_print(inverse && k ? 1 / root : root, 20, text);
        column += fprintf(to, "%s%s%s", column ? " " : "        ", text, k + 1 < count ? "," : "");
        if (column > 92 || k + 1 == count) { fprintf(to, "\n"); column = 0; }
    }
    fprintf(to, "    };\n    return table;\n}\n\n");
}

/* double prt__ch_a()[(l-1)l/2 + m], prt__ch_c(): the factors of CH's recurrence, 0 <= m < l < bands */
static void print_ch_table(FILE *to, const char *name, factor *of, int bands) {
    int l, m, column = 0, count = bands * (bands - 1) / 2;
    fprintf(to, "/* %s(l,m) of CH's recurrence at (l-1)l/2 + m, 0 <= m < l < %d */\n", name, bands);
    fprintf(to, "PRT__STATIC const double *prt__ch_%s(void) {\n    static const double table[%d] = {\n", name, count);
    for (l = 1; l < bands; l++)
        for (m = 0; m < l; m++) {
            char text[64];
            int last = l == bands - 1 && m == l - 1;
            x_print(of(l, m), 17, text);
            column += fprintf(to, "%s%s%s", column ? " " : "        ", text, last ? "" : ",");
            if (column > 98 || last) { fprintf(to, "\n"); column = 0; }
        }
    fprintf(to, "    };\n    return table;\n}\n\n");
}

static int print_table(FILE *to, const request *r) {
    if (!strcmp(r->table, "grids")) {
        if (r->count < 1 || r->count > 64) return fail("table", r->table, "give --count from 1 to 64");
        print_grid_tables(to, r->count);
        return 0;
    }
    if (!strcmp(r->table, "windows")) {
        if (r->count < 1 || r->count > 20) return fail("table", r->table, "give --count from 1 to 20");
        print_window_tables(to, r->count);
        return 0;
    }
    if (!strcmp(r->table, "nodes")) {
        if (r->last_bands < 3 || r->last_bands > 6) return fail("table", r->table, "give --bands from 3-3 to 3-6");
        print_node_tables(to, r->last_bands);
        return 0;
    }
    if (!strcmp(r->table, "ch_steps")) {
        if (r->first_bands < 2 || r->first_bands > 200) return fail("table", r->table, "give --bands from 2 to 200");
        print_ch_table(to, "a", ch_factor_a, r->first_bands);
        print_ch_table(to, "c", ch_factor_c, r->first_bands);
        return 0;
    }
    if (!strcmp(r->table, "swap_yz")) {
        print_swaps(to);
        return 0;
    }
    if (strcmp(r->table, "roots"))
        return fail("unknown table", r->table, "use roots, ch_steps, grids, nodes, windows or swap_yz");
    if (r->count < 2 || r->count > 100000) return fail("table", r->table, "give --count from 2 to 100000");
    print_root_table(to, "roots", "sqrt(k)", r->count, 0);
    print_root_table(to, "inverse_roots", "1/sqrt(k), and 0", r->count, 1);
    return 0;
}

static int check_bands(const family *f, int first, int last) {
    char range[96];
    if ((f->max_bands == 0 || (first >= f->min_bands && last <= f->max_bands)) && first <= last) return 0;
    snprintf(range, sizeof range, "%s at %d to %d bands", f->name, first, last);
    return fail("no such kernel", range, "prt_codegen --list names the bands");
}

/* One function, named as in prt.h; with its bands where there are several */
static void print_function(FILE *to, const dialect *d, const request *r, const family *f, int bands) {
    kernel *k;
    char name[160];
    if (f->max_bands == 0 && bands > r->first_bands) return;       /* the same for all bands: once */
    k = f->describe(bands);
    if (r->first_bands == r->last_bands || f->max_bands == 0) snprintf(name, sizeof name, "%s%s", r->prefix, f->name);
    else snprintf(name, sizeof name, "%s%s_%d", r->prefix, f->name, bands);
    print_kernel(to, d, k, name);
    kernel_free(k);
}

static int print_all_functions(FILE *to, const dialect *d, const request *r) {
    int bands, i, banded = 0;
    char range[40];
    for (i = 0; i < family_count; i++) {
        const family *f = &families[i];
        if (!(f->forms & FORM_TEXT) ||
            (f->max_bands && (r->first_bands < f->min_bands || r->last_bands > f->max_bands))) continue;
        banded += f->max_bands > 0;
        for (bands = r->first_bands; bands <= r->last_bands; bands++) print_function(to, d, r, f, bands);
    }
    snprintf(range, sizeof range, "%d-%d", r->first_bands, r->last_bands);
    return banded ? 0 : fail("no kernel has the bands", range, "prt_codegen --list names them");
}

/* Whether a name stands in a list before this place */
static int named_before(const char *list, const char *name, const char *place) {
    size_t length = strlen(name);
    const char *found = list;
    for (; (found = strstr(found, name)) && found < place; found += length)
        if ((found == list || found[-1] == ',') && (found[length] == ',' || !found[length])) return 1;
    return 0;
}

static int print_functions(FILE *to, const dialect *d, const request *r) {
    char names[sizeof r->emit], *name;
    int bands, count = 0;
    if (!strcmp(r->emit, "all")) return print_all_functions(to, d, r);
    snprintf(names, sizeof names, "%s", r->emit);
    for (name = strtok(names, ","); name; name = strtok(NULL, ","), count++) {
        const family *f = find_family(name, FORM_TEXT);
        if (!f) return fail("unknown kernel", name, "prt_codegen --list names them");
        if (named_before(r->emit, name, r->emit + (name - names)))
            return fail("named twice in --emit", name, "leave one out");
        if (check_bands(f, r->first_bands, r->last_bands)) return 1;
        for (bands = r->first_bands; bands <= r->last_bands; bands++) print_function(to, d, r, f, bands);
    }
    return count ? 0 : fail("no name in", "--emit", "prt_codegen --list names the kernels");
}

/* Functions of a shading language as a string of C; they hold neither quotes nor backslashes. */
static int print_quoted(FILE *to, const request *r) {
    const dialect *d = find_dialect(r->lang, r->precision);
    FILE *text = tmpfile();
    int c, fresh = 1, bad;
    if (!d) return fail("unknown language", r->lang, "use c, glsl, hlsl, wgsl or metal");
    if (!text) return fail("cannot write", "a temporary file", "check permissions");
    bad = print_functions(text, d, r);
    rewind(text);
    while ((c = fgetc(text)) != EOF) {
        if (c == '\n') { fputs(fresh ? "" : "\\n\"\n", to); fresh = 1; continue; }
        if (fresh) fputs("    \"", to);
        fresh = 0;
        fputc(c, to);
    }
    fclose(text);
    return bad;
}

/* The kernels of a fence, in the forms of prt.h, or quoted */
static int print_fence(FILE *to, const request *r) {
    char names[sizeof r->emit], *name;
    if (r->table) return print_table(to, r);
    if (strcmp(r->lang, "c")) return print_quoted(to, r);
    snprintf(names, sizeof names, "%s", r->emit);
    for (name = strtok(names, ","); name; name = strtok(NULL, ",")) {
        const family *f = find_family(name, FORM_HEADER);
        int bands, first = r->first_bands, last = r->last_bands;
        if (!f) return fail("no kernel of prt.h is called", name, "families.c names them");
        if (!first) { first = f->min_bands; last = f->max_bands; }
        if (check_bands(f, first, last)) return 1;
        for (bands = first; bands <= last; bands++) print_header_forms(to, f, bands);
    }
    return 0;
}

static const char *const precision_option[PRECISIONS] = { "", " --precision half", " --precision float16" };

static void print_preamble(FILE *to, const dialect *d, const request *r) {
    fprintf(to, "%sprt.h " PRT_VERSION ": precomputed radiance transfer - MIT or Unlicense, your choice%s\n",
            d->comment_open, d->comment_close);
    fprintf(to, "%sGenerated by: prt_codegen --lang %s --bands %d", d->comment_open, r->lang, r->first_bands);
    if (r->last_bands != r->first_bands) fprintf(to, "-%d", r->last_bands);
    if (strcmp(r->prefix, "prt_")) fprintf(to, " --prefix %s", r->prefix);
    fprintf(to, " --emit %s%s%s", r->emit, precision_option[r->precision], d->comment_close);
    fprintf(to, "\n%sReal SH, orthonormal, no Condon-Shortley phase, +z polar; coefficient (l,m) at l(l+1)+m; "
                "see prt.h.%s\n", d->comment_open, d->comment_close);
    fputs(d->preamble, to);
    fprintf(to, "\n");
}

static int print_language(FILE *to, const request *r) {
    const dialect *d = find_dialect(r->lang, r->precision);
    if (!d) return fail("unknown language", r->lang, "use c, glsl, hlsl, wgsl or metal");
    print_preamble(to, d, r);
    return print_functions(to, d, r);
}

/* To r->path by way of a temporary, so that a failure leaves the old file whole */
static int print_request(const request *r) {
    char temporary[1024];
    FILE *to;
    int bad;
    if (r->table) return print_table(stdout, r);
    if (!r->path) return print_language(stdout, r);
    snprintf(temporary, sizeof temporary, "%s.new", r->path);
    to = fopen(temporary, "wb");
    if (!to) return fail("cannot write", temporary, "check that the folder exists and may be written");
    bad = print_language(to, r);
    if (fclose(to) && !bad) bad = fail("cannot write", temporary, "is the disk full?");
    if (!bad && rename(temporary, r->path)) bad = fail("cannot write", r->path, "the old file is untouched");
    if (bad) remove(temporary);
    return bad;
}

static int print_list(void) {
    int i, bands;
    printf("%-24s %5s %6s %6s %6s %6s %6s %6s %6s\n", "kernel", "bands", "mul", "add", "fused", "others", "loads",
           "stores", "live");
    for (i = 0; i < family_count; i++)
        for (bands = families[i].min_bands; families[i].forms & FORM_TEXT && bands <= families[i].max_bands; bands++) {
            kernel *k = families[i].describe(bands);
            op_count c;
            kernel_count_uses(k);
            c = kernel_operations(k);
            printf("%-24s %5d %6d %6d %6d %6d %6d %6d %6d\n", families[i].name, bands, c.multiplications, c.additions,
                   c.fused, c.divisions + c.roots + c.others, c.loads, c.stores, kernel_live_values(k));
            kernel_free(k);
        }
    return 0;
}

/* ---- command line; fences use the same words ---- */

static int is_identifier(const char *word) {
    static const char letters[] = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ_0123456789";
    return word[strspn(word, letters)] == 0 && !(*word >= '0' && *word <= '9');
}

static int parse_request(request *r, int count, char **words) {
    int i;
    memset(r, 0, sizeof *r);
    r->lang = "c";
    r->prefix = "prt_";
    for (i = 0; i < count; i++) {
        const char *value = i + 1 < count ? words[i + 1] : NULL;
        if (!value) return fail("no value after", words[i], "see the head of prt_codegen.c");
        if (!strcmp(words[i], "--lang")) r->lang = value;
        else if (!strcmp(words[i], "--prefix")) {
            r->prefix = value;
            if (!is_identifier(value)) return fail("prefix", value, "letters, digits and _, not a digit first");
        }
        else if (!strcmp(words[i], "-o")) r->path = value;
        else if (!strcmp(words[i], "--precision")) {
            if (!strcmp(value, "float")) r->precision = PRECISION_FLOAT;
            else if (!strcmp(value, "half")) r->precision = PRECISION_HALF;
            else if (!strcmp(value, "float16")) r->precision = PRECISION_FLOAT16;
            else return fail("unknown precision", value, "use float, half or float16");
        }
        else if (!strcmp(words[i], "--emit")) {
            if (strlen(value) >= sizeof r->emit)
                return fail("too many names", "--emit", "ask for fewer kernels at a time");
            strcpy(r->emit, value);
        }
        else if (!strcmp(words[i], "--table")) r->table = value;
        else if (!strcmp(words[i], "--count")) r->count = (int)strtol(value, NULL, 10);
        else if (!strcmp(words[i], "--bands")) {
            char *end;
            r->first_bands = r->last_bands = (int)strtol(value, &end, 10);
            if (*end == '-') r->last_bands = (int)strtol(end + 1, &end, 10);
            if (*end || end == value || r->first_bands < 1) return fail("bands", value, "give N or A-B, from 1");
        } else return fail("unknown option", words[i], "see the head of prt_codegen.c");
        i++;
    }
    if (r->emit[0] || r->table) return 0;
    return fail("nothing to print", "--emit", "name kernels; prt_codegen --list shows them");
}

/* The request behind "prt_codegen" in a line of a file */
static int parse_line(request *r, const char *line, char *copy, size_t size) {
    char *words[16], *word;
    int count = 0;
    snprintf(copy, size, "%.*s", (int)strcspn(line, "\n"), line);
    word = strstr(copy, "prt_codegen");
    for (word = word ? strtok(word, " ") : NULL; word && count < 16 && strcmp(word, "*/"); word = strtok(NULL, " "))
        words[count++] = word;
    if (count < 1) return fail("a fence without its command", copy, "write: BEGIN GENERATED: prt_codegen --emit ...");
    return parse_request(r, count - 1, words + 1);
}

/* ---- fenced blocks ---- */

static char *read_file(const char *path) {
    FILE *f = fopen(path, "rb");
    char *text = NULL;
    size_t length = 0, capacity = 0, got;
    if (!f) return NULL;
    do {
        if (length + 65536 > capacity) {
            char *more = (char *)realloc(text, capacity = capacity * 2 + 65537);
            if (!more) { free(text); fclose(f); return NULL; }
            text = more;
        }
        got = fread(text + length, 1, 65535, f);
        length += got;
    } while (got);
    text[length] = 0;
    fclose(f);
    return text;
}

/* Copies text to the stream with every fenced block printed anew, or the whole of it if it says that it was printed. */
static int regenerate(FILE *to, const char *text) {
    const char *begin = strstr(text, "Generated by: prt_codegen");
    if (begin && begin - text < 200) {
        char copy[2048];
        request r;
        return parse_line(&r, begin, copy, sizeof copy) || print_language(to, &r);
    }
    while ((begin = strstr(text, "/* BEGIN GENERATED"))) {
        const char *body = strchr(begin, '\n'), *end = strstr(begin, "/* END GENERATED */");
        char copy[512];
        request r;
        if (!body || !end) return fail("a fence without its end", "BEGIN GENERATED", "close it with END GENERATED");
        fwrite(text, 1, (size_t)(body + 1 - text), to);
        if (parse_line(&r, begin, copy, sizeof copy) || print_fence(to, &r)) return 1;
        text = end;
    }
    fputs(text, to);
    return 0;
}

static int update_file(const char *path, int check_only) {
    char *old = read_file(path), *fresh, temporary[1024];
    FILE *to;
    int bad, same;
    if (!old) return fail("cannot read", path, "give the path of prt.h");
    snprintf(temporary, sizeof temporary, "%s.new", path);
    to = check_only ? tmpfile() : fopen(temporary, "wb");
    if (!to) return fail("cannot write", check_only ? "a temporary file" : temporary, "check permissions");
    bad = regenerate(to, old);
    if (check_only) {
        size_t length;
        fflush(to);
        length = (size_t)ftell(to);
        rewind(to);
        fresh = (char *)malloc(length + 1);
        same = fresh && fread(fresh, 1, length, to) == length && strlen(old) == length && !memcmp(fresh, old, length);
        free(fresh);
        fclose(to);
        if (!bad && !same) bad = fail("generated blocks differ in", path, "run make gen and commit the result");
    } else if (fclose(to) || bad || rename(temporary, path)) {
        remove(temporary);
        if (!bad) bad = fail("cannot write", path, "the old file is untouched");
    }
    free(old);
    return bad;
}

int main(int argc, char **argv) {
    request r;
    if (argc == 2 && !strcmp(argv[1], "--list")) return print_list();
    if (argc >= 3 && (!strcmp(argv[1], "--update") || !strcmp(argv[1], "--check"))) {
        int i, bad = 0;
        for (i = 2; i < argc; i++) bad |= update_file(argv[i], !strcmp(argv[1], "--check"));
        return bad;
    }
    if (parse_request(&r, argc - 1, argv + 1)) return 1;
    if (!r.first_bands) r.first_bands = r.last_bands = 4;
    return print_request(&r);
}
