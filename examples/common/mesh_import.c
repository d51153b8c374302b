#define _POSIX_C_SOURCE 200809L
#include "mesh_import.h"

#include <assimp/cimport.h>
#include <assimp/material.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <fcntl.h>
#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

enum { MOST_SECONDS = 300 };                               /* of processor time, before assimp is given up */

void raw_mesh_free(raw_mesh *m) {
    free(m->positions);
    free(m->normals);
    free(m->triangles);
    memset(m, 0, sizeof *m);
}

static int raw_mesh_allocate(const char *path, uint64_t vertices, uint64_t triangles, raw_mesh *m, why *w) {
    memset(m, 0, sizeof *m);
    if (triangles == 0) return why_set(w, "%s: has no triangles, so that there is nothing to light", path);
    if (vertices > INT_MAX || triangles > INT_MAX / 3) return why_set(w, "%s: has more than 2^31 vertices", path);
    m->vertex_count = (int)vertices;
    m->triangle_count = (int)triangles;
    m->positions = (prt_vec3 *)malloc((size_t)vertices * sizeof *m->positions);
    m->normals = (prt_vec3 *)malloc((size_t)vertices * sizeof *m->normals);
    m->triangles = (uint32_t *)malloc((size_t)triangles * 3 * sizeof *m->triangles);
    if (m->positions && m->normals && m->triangles) return 0;
    raw_mesh_free(m);
    return why_set(w, "%s: out of memory", path);
}

/* ---- in the other process ---- */

/* Materials are removed afterwards, so that vertices merge across them. */
static int count_transmissive(const struct aiScene *scene) {
    uint64_t count = 0;
    unsigned k, i;
    for (k = 0; k < scene->mNumMeshes; k++) {
        const struct aiMesh *part = scene->mMeshes[k];
        float opacity = 1;
        if (part->mMaterialIndex >= scene->mNumMaterials ||
            aiGetMaterialFloatArray(scene->mMaterials[part->mMaterialIndex], AI_MATKEY_OPACITY, &opacity, NULL) !=
                AI_SUCCESS || !(opacity < 1))
            continue;
        for (i = 0; i < part->mNumFaces; i++) count += part->mFaces[i].mNumIndices > 2;
    }
    return count < INT_MAX ? (int)count : INT_MAX;
}

static const struct aiScene *import_scene(const char *path, int *transmissive_faces) {
    struct aiPropertyStore *properties = aiCreatePropertyStore();
    const struct aiScene *scene;
    aiSetImportPropertyInteger(properties, AI_CONFIG_PP_SBP_REMOVE, aiPrimitiveType_POINT | aiPrimitiveType_LINE);
    aiSetImportPropertyInteger(properties, AI_CONFIG_PP_RVC_FLAGS,
                               aiComponent_TANGENTS_AND_BITANGENTS | aiComponent_COLORS | aiComponent_TEXCOORDS |
                               aiComponent_BONEWEIGHTS | aiComponent_ANIMATIONS | aiComponent_TEXTURES |
                               aiComponent_LIGHTS | aiComponent_CAMERAS | aiComponent_MATERIALS);
    scene = aiImportFileExWithProperties(path, aiProcess_ValidateDataStructure, NULL, properties);
    aiReleasePropertyStore(properties);
    if (!scene) return NULL;
    *transmissive_faces = count_transmissive(scene);
    return aiApplyPostProcessing(scene, aiProcess_Triangulate | aiProcess_SortByPType | aiProcess_RemoveComponent |
                                        aiProcess_PreTransformVertices | aiProcess_JoinIdenticalVertices);
}

/* assimp's messages may run over several lines and end in one. */
static void first_line(const char *text, char *line, size_t size) {
    size_t length = strcspn(text, "\r\n");
    if (length >= size) length = size - 1;
    memcpy(line, text, length);
    line[length] = 0;
}

static void copy_vectors(const struct aiVector3D *from, unsigned count, prt_vec3 *to) {
    unsigned i;
    for (i = 0; i < count; i++) {
        to[i].x = from ? from[i].x : 0;
        to[i].y = from ? from[i].y : 0;
        to[i].z = from ? from[i].z : 0;
    }
}

static void copy_triangles(const struct aiMesh *from, uint32_t base, uint32_t *to) {
    unsigned i;
    for (i = 0; i < from->mNumFaces; i++) {
        const unsigned *corner = from->mFaces[i].mIndices;
        if (from->mFaces[i].mNumIndices != 3) continue;
        *to++ = base + corner[0];
        *to++ = base + corner[1];
        *to++ = base + corner[2];
    }
}

static uint64_t count_triangles(const struct aiMesh *from) {
    uint64_t count = 0;
    unsigned i;
    for (i = 0; i < from->mNumFaces; i++) count += from->mFaces[i].mNumIndices == 3;
    return count;
}

static int copy_scene(const struct aiScene *scene, const char *path, raw_mesh *m, why *w) {
    uint64_t vertices = 0, triangles = 0;
    unsigned k;
    for (k = 0; k < scene->mNumMeshes; k++) {
        vertices += scene->mMeshes[k]->mNumVertices;
        triangles += count_triangles(scene->mMeshes[k]);
    }
    if (raw_mesh_allocate(path, vertices, triangles, m, w)) return -1;
    vertices = triangles = 0;
    for (k = 0; k < scene->mNumMeshes; k++) {
        const struct aiMesh *part = scene->mMeshes[k];
        copy_vectors(part->mVertices, part->mNumVertices, m->positions + vertices);
        copy_vectors(part->mNormals, part->mNumVertices, m->normals + vertices);
        copy_triangles(part, (uint32_t)vertices, m->triangles + 3 * triangles);
        vertices += part->mNumVertices;
        triangles += count_triangles(part);
    }
    return 0;
}

static int import(const char *path, raw_mesh *m, why *w) {
    int transmissive_faces = 0;
    const struct aiScene *scene = import_scene(path, &transmissive_faces);
    if (!scene) {
        char reason[256];
        first_line(aiGetErrorString(), reason, sizeof reason);
        return why_set(w, "%s: cannot be read as a mesh: %s", path, reason);
    }
    if (copy_scene(scene, path, m, w)) return -1;          /* the scene goes with the process */
    m->transmissive_faces = transmissive_faces;
    return 0;
}

/* ---- between the two ---- */

typedef struct answer { int failed, vertex_count, triangle_count, transmissive_faces; why why; } answer;

static void import_and_answer(const char *path, int descriptor) {
    const struct rlimit limit = { MOST_SECONDS, MOST_SECONDS };
    FILE *to = fdopen(descriptor, "wb");
    raw_mesh m;
    answer a;
    int silent = open("/dev/null", O_WRONLY);
    if (silent >= 0) dup2(silent, STDERR_FILENO);          /* what a dying C++ runtime says helps nobody */
    setrlimit(RLIMIT_CPU, &limit);
    memset(&m, 0, sizeof m);
    memset(&a, 0, sizeof a);
    a.failed = import(path, &m, &a.why);
    if (!a.failed) {
        a.vertex_count = m.vertex_count;
        a.triangle_count = m.triangle_count;
        a.transmissive_faces = m.transmissive_faces;
    }
    if (!to || fwrite(&a, sizeof a, 1, to) != 1) _exit(1);
    if (!a.failed) {
        fwrite(m.positions, sizeof *m.positions, (size_t)m.vertex_count, to);
        fwrite(m.normals, sizeof *m.normals, (size_t)m.vertex_count, to);
        fwrite(m.triangles, 3 * sizeof *m.triangles, (size_t)m.triangle_count, to);
    }
    _exit(fclose(to) != 0);
}

static int read_answer(FILE *from, const char *path, raw_mesh *m, why *w) {
    answer a;
    size_t vertices, triangles;
    if (fread(&a, sizeof a, 1, from) != 1)
        return why_set(w, "%s: cannot be read as a mesh: assimp breaks down over it, so the file is damaged", path);
    if (a.failed) {
        *w = a.why;
        return -1;
    }
    vertices = (size_t)a.vertex_count;
    triangles = (size_t)a.triangle_count;
    if (raw_mesh_allocate(path, vertices, triangles, m, w)) return -1;
    m->transmissive_faces = a.transmissive_faces;
    if (fread(m->positions, sizeof *m->positions, vertices, from) == vertices &&
        fread(m->normals, sizeof *m->normals, vertices, from) == vertices &&
        fread(m->triangles, 3 * sizeof *m->triangles, triangles, from) == triangles)
        return 0;
    raw_mesh_free(m);
    return why_set(w, "%s: the process that read it was ended", path);
}

/* assimp never comes out of a PLY header that does not end, and takes a text body that was cut short for whole; so the
   header must end, and a text file must have a line for each element. */
static int check_ply(const char *path, why *w) {
    char line[1024] = "";
    FILE *file = fopen(path, "rb");
    double wanted = 0, got = 0;
    int ascii = 0, ended = 0, first = 1;
    if (!file) return 0;                                   /* assimp says why */
    while (!ended && fgets(line, sizeof line, file) && (!first || strncmp(line, "ply", 3) == 0)) {
        double count;
        if (sscanf(line, "element %*s %lf", &count) == 1) wanted += count;
        ascii |= strncmp(line, "format ascii", 12) == 0;
        ended = strncmp(line, "end_header", 10) == 0;
        first = 0;
    }
    while (ended && ascii && fgets(line, sizeof line, file)) got += strchr(line, '\n') != NULL || feof(file);
    fclose(file);
    if (first || (ended && (!ascii || got >= wanted))) return 0;
    return why_set(w, "%s: cannot be read as a mesh: the PLY file is cut short", path);
}

int raw_mesh_import(const char *path, raw_mesh *m, why *w) {
    int ends[2], failed;
    FILE *from;
    pid_t child;
    memset(m, 0, sizeof *m);
    if (check_ply(path, w)) return -1;
    if (pipe(ends)) return why_set(w, "%s: no pipe to read it through", path);
    fflush(NULL);
    child = fork();
    if (child == 0) {
        close(ends[0]);
        import_and_answer(path, ends[1]);
    }
    close(ends[1]);
    from = child > 0 ? fdopen(ends[0], "rb") : NULL;
    failed = from ? read_answer(from, path, m, w) : why_set(w, "%s: no process to read it in", path);
    if (from) fclose(from); else close(ends[0]);
    if (child > 0) waitpid(child, NULL, 0);
    return failed;
}
