#include "relighter.h"

#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "progress.h"

/* Coefficients stand in fours, the last filled up with zeros: CHUNKS vec4 for each vertex and for each colour. */
static int chunks_of(int bands) { return (PRT_SH_COUNT(bands) + 3) / 4; }

static const char mesh_vertex[] =
    "layout(std430, binding = 0) readonly buffer Points { float point[]; };\n"         /* x y z of each vertex */
    "layout(std430, binding = 1) readonly buffer Triangles { uint corner[]; };\n"
    "uniform mat4 clip_from_world;\n"
    "out vec3 share;\n"                                                                 /* of each corner */
    "void main() {\n"
    "    uint v = 3u * corner[gl_VertexID];\n"
    "    int k = gl_VertexID % 3;\n"
    "    share = vec3(k == 0, k == 1, k == 2);\n"
    "    gl_Position = clip_from_world * vec4(point[v], point[v + 1u], point[v + 2u], 1);\n"
    "}\n";

/* Shading from four coefficients of transfer, a texel, under those of the light */
static const char shade_four[] =
/* BEGIN GENERATED: prt_codegen --lang glsl --bands 4 --emit shade_diffuse_four */
    "// shade_diffuse, the share of four coefficients: 12 multiplications, 9 additions (9 can fuse), 3 stores\n"
    "vec3 prt_shade_diffuse_four(vec4 transfer, vec4 red, vec4 green, vec4 blue) {\n"
    "    float t1 = (red.x * transfer.x + red.y * transfer.y) + red.z * transfer.z;\n"
    "    float t2 = (transfer.x * green.x + transfer.y * green.y) + transfer.z * green.z;\n"
    "    float t3 = (transfer.x * blue.x + transfer.y * blue.y) + transfer.z * blue.z;\n"
    "    return vec3(t1 + red.w * transfer.w, t2 + transfer.w * green.w, t3 + transfer.w * blue.w);\n"
    "}\n"
/* END GENERATED */
;

static const char mesh_fragment[] =
    "layout(std430, binding = 1) readonly buffer Triangles { uint corner[]; };\n"
    "layout(binding = 1) uniform samplerBuffer transfer;\n"                            /* CHUNKS texels a vertex */
    "layout(std140, binding = 0) uniform Light { vec4 light[3 * CHUNKS]; };\n"
    "uniform vec3 albedo;\n"
    "in vec3 share;\n"
    "out vec4 color;\n"
    "void main() {\n"
    "    int t = 3 * gl_PrimitiveID;\n"
    "    ivec3 at = CHUNKS * ivec3(corner[t], corner[t + 1], corner[t + 2]);\n"
    "    vec3 radiance = vec3(0);\n"
    "    for (int i = 0; i < CHUNKS; i++) {\n"
    "        vec4 here = share.x * texelFetch(transfer, at.x + i) + share.y * texelFetch(transfer, at.y + i) +\n"
    "                    share.z * texelFetch(transfer, at.z + i);\n"
    "        radiance += prt_shade_diffuse_four(here, light[i], light[CHUNKS + i], light[2 * CHUNKS + i]);\n"
    "    }\n"
    "    color = vec4(albedo * radiance, 1);\n"
    "}\n";

static const char background_vertex[] =
    "out vec2 place;\n"
    "void main() {\n"
    "    place = vec2(4 * (gl_VertexID & 1) - 1, 2 * (gl_VertexID & 2) - 1);\n"
    "    gl_Position = vec4(place, 0, 1);\n"
    "}\n";

/* The map is small, so it is magnified by cubic B-splines: four bilinear look-ups placed by their weights. */
static const char background_fragment[] =
    "layout(binding = 0) uniform sampler2D environment;\n"
    "uniform vec3 right, up, forward;\n"
    "in vec2 place;\n"
    "out vec4 color;\n"
    "vec3 look(vec2 uv) {\n"
    "    vec2 size = vec2(textureSize(environment, 0)), at = uv * size - 0.5, f = fract(at), i = at - f + 0.5;\n"
    "    vec2 w0 = (1 - f) * (1 - f) * (1 - f) / 6, w3 = f * f * f / 6;\n"
    "    vec2 w1 = 2.0 / 3 - 0.5 * f * f * (2 - f), s0 = w0 + w1, s1 = 1 - s0;\n"
    "    vec2 p0 = (i - 1 + w1 / s0) / size, p1 = (i + 1 + w3 / s1) / size;\n"
    "    return s0.y * (s0.x * texture(environment, p0).rgb + s1.x * texture(environment, vec2(p1.x, p0.y)).rgb) +\n"
    "           s1.y * (s0.x * texture(environment, vec2(p0.x, p1.y)).rgb + s1.x * texture(environment, p1).rgb);\n"
    "}\n"
    "void main() {\n"
    "    vec3 d = normalize(forward + place.x * right + place.y * up);\n"
    "    float pi = 3.14159265358979;\n"
    "    color = vec4(look(vec2(atan(d.y, d.x) / (2 * pi), acos(clamp(d.z, -1.0, 1.0)) / pi)), 0);\n"
    "}\n";

static GLuint make_buffer(const void *data, size_t size) {
    GLuint buffer;
    gl.CreateBuffers(1, &buffer);
    gl.NamedBufferData(buffer, (GLsizeiptr)size, data, GL_STATIC_DRAW);
    return buffer;
}

static int upload_mesh(relighter *r, const mesh *m, why *w) {
    float *xyz = (float *)malloc(3 * sizeof(float) * (size_t)m->point_count);
    int i;
    if (!xyz) return why_set(w, "out of memory");
    for (i = 0; i < m->point_count; i++) {
        xyz[3 * (size_t)i] = (float)m->points[i].position.x;
        xyz[3 * (size_t)i + 1] = (float)m->points[i].position.y;
        xyz[3 * (size_t)i + 2] = (float)m->points[i].position.z;
    }
    r->points = make_buffer(xyz, 3 * sizeof(float) * (size_t)m->point_count);
    r->triangles = make_buffer(m->triangles, 3 * sizeof *m->triangles * (size_t)m->triangle_count);
    r->triangle_count = m->triangle_count;
    free(xyz);
    return 0;
}

static GLuint make_renderbuffer(const relighter *r, GLenum format, GLenum attachment) {
    GLuint buffer;
    gl.CreateRenderbuffers(1, &buffer);
    gl.NamedRenderbufferStorage(buffer, format, r->width, r->height);
    gl.NamedFramebufferRenderbuffer(r->framebuffer, attachment, GL_RENDERBUFFER, buffer);
    return buffer;
}

int relighter_create(relighter *r, const mesh *m, int width, int height, why *w) {
    GLint most = 0;
    memset(r, 0, sizeof *r);
    gl.GetIntegerv(GL_MAX_RENDERBUFFER_SIZE, &most);
    if (width > most || height > most)
        return why_set(w, "OpenGL: a picture of %d x %d samples is too large", width, height);
    r->width = width;
    r->height = height;
    gl.CreateVertexArrays(1, &r->no_attributes);
    gl.CreateFramebuffers(1, &r->framebuffer);
    r->color = make_renderbuffer(r, GL_RGBA32F, GL_COLOR_ATTACHMENT0);
    r->depth = make_renderbuffer(r, GL_DEPTH_COMPONENT32F, GL_DEPTH_ATTACHMENT);
    r->background_program = gl_program("background", "", background_vertex, background_fragment, w);
    if (!r->background_program || upload_mesh(r, m, w) || gl_check("setting up", w)) {
        relighter_destroy(r);
        return -1;
    }
    return 0;
}

static void drop_transfer(relighter *r) {
    const GLuint buffers[2] = { r->transfer, r->light };
    if (r->mesh_program) gl.DeleteProgram(r->mesh_program);
    gl.DeleteTextures(1, &r->transfer_texels);
    gl.DeleteBuffers(2, buffers);
    r->mesh_program = r->transfer_texels = r->transfer = r->light = 0;
}

void relighter_destroy(relighter *r) {
    const GLuint buffers[2] = { r->points, r->triangles };
    drop_transfer(r);
    if (r->background_program) gl.DeleteProgram(r->background_program);
    gl.DeleteBuffers(2, buffers);
    gl.DeleteTextures(1, &r->environment);
    gl.DeleteRenderbuffers(1, &r->color);
    gl.DeleteRenderbuffers(1, &r->depth);
    gl.DeleteFramebuffers(1, &r->framebuffer);
    gl.DeleteVertexArrays(1, &r->no_attributes);
    memset(r, 0, sizeof *r);
}

/* Transfer is read through a buffer texture, whose limit is far above that of a storage block. */
int relighter_fits(int bands, const mesh *m, why *w) {
    double texels = (double)chunks_of(bands) * m->point_count, limit, size;
    double block = 12.0 * (m->point_count > m->triangle_count ? m->point_count : m->triangle_count);
    GLint64 most_texels = 0, storage = 0, uniform = 0;
    gl.GetInteger64v(GL_MAX_TEXTURE_BUFFER_SIZE, &most_texels);
    gl.GetInteger64v(GL_MAX_SHADER_STORAGE_BLOCK_SIZE, &storage);
    gl.GetInteger64v(GL_MAX_UNIFORM_BLOCK_SIZE, &uniform);
    limit = most_texels < INT_MAX ? (double)most_texels : INT_MAX;
    if (block > (double)storage)
        return why_set(w, "%.0f MB of triangles are more than this OpenGL's %.0f MB: take a coarser mesh, or more rays", block * 1e-6,
                       (double)storage * 1e-6);
    size = 16e-6 * texels;
    if (texels <= limit && 48 * chunks_of(bands) <= uniform) return 0;
    return why_set(w, "%d bands for %d points make %.0f MB of transfer, more than this OpenGL's %.0f MB: fewer --bands",
                   bands, m->point_count, size, 16e-6 * limit);
}

int relighter_set_transfer(relighter *r, int bands, const mesh *m, const prt_real *transfer, why *w) {
    size_t point_count = (size_t)m->point_count, count = (size_t)PRT_SH_COUNT(bands), padded = 4 * (size_t)chunks_of(bands), i, k;
    float *fours;
    char before[40 + sizeof shade_four];
    if (relighter_fits(bands, m, w)) return -1;
    fours = (float *)calloc(point_count * padded, sizeof *fours);
    if (!fours) return why_set(w, "out of memory");
    for (k = 0; k < point_count; k++)
        for (i = 0; i < count; i++) fours[k * padded + i] = (float)transfer[k * count + i];
    drop_transfer(r);
    r->bands = bands;
    r->transfer = make_buffer(fours, point_count * padded * sizeof *fours);
    gl.CreateTextures(GL_TEXTURE_BUFFER, 1, &r->transfer_texels);
    gl.TextureBuffer(r->transfer_texels, GL_RGBA32F, r->transfer);
    r->light = make_buffer(NULL, 3 * padded * sizeof *fours);
    free(fours);
    snprintf(before, sizeof before, "#define CHUNKS %d\n%s", chunks_of(bands), shade_four);
    r->mesh_program = gl_program("mesh", before, mesh_vertex, mesh_fragment, w);
    return r->mesh_program ? gl_check("uploading transfer", w) : -1;
}

int relighter_set_environment(relighter *r, const image *environment, why *w) {
    gl.DeleteTextures(1, &r->environment);
    gl.CreateTextures(GL_TEXTURE_2D, 1, &r->environment);
    gl.TextureStorage2D(r->environment, 1, GL_RGB32F, environment->width, environment->height);
    gl.TextureSubImage2D(r->environment, 0, 0, 0, environment->width, environment->height, GL_RGB, GL_FLOAT,
                         environment->rgb);
    gl.TextureParameteri(r->environment, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    gl.TextureParameteri(r->environment, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    gl.TextureParameteri(r->environment, GL_TEXTURE_WRAP_S, GL_REPEAT);
    gl.TextureParameteri(r->environment, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    return gl_check("uploading the environment", w);
}

static void set_vector(GLuint program, const char *name, double x, double y, double z) {
    GLfloat v[3];
    v[0] = (GLfloat)x; v[1] = (GLfloat)y; v[2] = (GLfloat)z;
    gl.Uniform3fv(gl.GetUniformLocation(program, name), 1, v);
}

static void draw_background(const relighter *r, const camera *c) {
    camera_frame f = camera_make_frame(c, (double)r->width / r->height);
    gl.UseProgram(r->background_program);
    set_vector(r->background_program, "right", f.right[0], f.right[1], f.right[2]);
    set_vector(r->background_program, "up", f.up[0], f.up[1], f.up[2]);
    set_vector(r->background_program, "forward", f.forward[0], f.forward[1], f.forward[2]);
    gl.BindTextureUnit(0, r->environment);
    gl.Disable(GL_DEPTH_TEST);
    gl.DrawArrays(GL_TRIANGLES, 0, 3);
    gl.Finish();
}

static void upload_light(const relighter *r, const prt_real *light) {
    float fours[4 * ((PRT_SH_COUNT(PRT_MAX_BANDS) + 3) / 4)];
    int count = PRT_SH_COUNT(r->bands), padded = 4 * chunks_of(r->bands), c, i;
    for (c = 0; c < 3; c++) {
        for (i = 0; i < padded; i++) fours[i] = i < count ? (float)light[c * count + i] : 0;
        gl.NamedBufferSubData(r->light, c * padded * (GLintptr)sizeof *fours, padded * (GLsizeiptr)sizeof *fours,
                              fours);
    }
}

static void draw_mesh(const relighter *r, const camera *c, const prt_real *light, double albedo) {
    float clip[16];
    camera_clip_from_world(c, (double)r->width / r->height, 0.05, 50, clip);
    upload_light(r, light);
    gl.UseProgram(r->mesh_program);
    gl.UniformMatrix4fv(gl.GetUniformLocation(r->mesh_program, "clip_from_world"), 1, GL_FALSE, clip);
    set_vector(r->mesh_program, "albedo", albedo, albedo, albedo);
    gl.BindBufferBase(GL_SHADER_STORAGE_BUFFER, 0, r->points);
    gl.BindBufferBase(GL_SHADER_STORAGE_BUFFER, 1, r->triangles);
    gl.BindTextureUnit(1, r->transfer_texels);
    gl.BindBufferBase(GL_UNIFORM_BUFFER, 0, r->light);
    gl.Enable(GL_DEPTH_TEST);
    gl.DepthFunc(GL_LESS);
    gl.DrawArrays(GL_TRIANGLES, 0, 3 * r->triangle_count);
    gl.Finish();
}

/* OpenGL's first row is the lowest. */
static void read_back(const relighter *r, picture *out) {
    size_t row = 4 * (size_t)r->width, i;
    int y;
    gl.ReadPixels(0, 0, r->width, r->height, GL_RGBA, GL_FLOAT, out->rgba);
    for (y = 0; y < r->height / 2; y++) {
        float *a = out->rgba + row * (size_t)y, *b = out->rgba + row * (size_t)(r->height - 1 - y);
        for (i = 0; i < row; i++) { float swap = a[i]; a[i] = b[i]; b[i] = swap; }
    }
}

int relighter_draw(relighter *r, const camera *c, const prt_real *light, double albedo, picture *out, double *seconds,
                   why *w) {
    const GLfloat black[4] = { 0, 0, 0, 0 }, far_away = 1;
    double before;
    gl.BindFramebuffer(GL_FRAMEBUFFER, r->framebuffer);
    gl.BindVertexArray(r->no_attributes);
    gl.Viewport(0, 0, r->width, r->height);
    gl.ClearBufferfv(GL_COLOR, 0, black);
    gl.ClearBufferfv(GL_DEPTH, 0, &far_away);
    if (r->environment) draw_background(r, c);
    before = processor_seconds();
    draw_mesh(r, c, light, albedo);
    if (seconds) *seconds = processor_seconds() - before;
    if (out) read_back(r, out);
    return gl_check("drawing", w);
}
