/* transfer_file: baked transfer on disk, whole or half done.

   A bake writes one row of bands^2 numbers a point. The file holds the rows that are finished, in runs of neighbouring
   points, and what they were baked with, so that an interrupted bake can go on and nobody mixes two bakes.

   LAYOUT (everything little-endian, no padding)
     offset  bytes
          0      8  89 50 52 54 0d 0a 1a 0a: "\x89PRT\r\n\x1a\n", spoiled by every text-mode transfer
          8      4  version, 1
         12      4  bands n, 1 ... 1024
         16      4  rays a point
         20      4  bias of the ray origins along the normal, float
         24      8  seed
         32      8  points in the mesh
         40      8  hash of the mesh: FNV-1a of positions, normals and triangles (mesh_hash)
         48      8  runs that follow
         56      8  FNV-1a, 64 bits, of bytes 0 ... 55
     each run:   8  first point
                 8  points in the run, at least 1; runs ascend and never touch, so that a set of points has one encoding
          4 n^2 k  the rows, float, finite
     at the end  8  FNV-1a, 64 bits, of everything before; then the file ends

   SAFETY
     Saving goes through replacement.h: a full disk, a crash or a kill leaves the old file as it was. Loading allocates
     nothing: it reads into arrays whose size the caller chose, after the header has been compared with what the caller
     expects. */
#ifndef EXAMPLES_TRANSFER_FILE_H
#define EXAMPLES_TRANSFER_FILE_H

#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

#include "why.h"

enum { TRANSFER_FILE_VERSION = 1, TRANSFER_FILE_MAX_BANDS = 1024, TRANSFER_FILE_HEADER_BYTES = 64 };

typedef struct transfer_info {
    uint32_t bands, rays;
    float    bias;
    uint64_t seed, point_count, mesh_hash;
} transfer_info;

#define TRANSFER_CHECKSUM_START UINT64_C(14695981039346656037)

/* FNV-1a over 64 bits; start with TRANSFER_CHECKSUM_START. Every change of a single byte changes the result. */
uint64_t transfer_checksum(uint64_t hash, const void *bytes, size_t count);

/* The bytes that a complete file with this header has; 0 where they do not fit 63 bits. */
uint64_t transfer_file_bytes(const transfer_info *info);

/* Saves the rows of transfer[point_count][bands^2] whose done[point] is not 0. 0, or -1 with the reason in w. */
int transfer_file_save(const char *path, const transfer_info *info, const unsigned char *done, const float *transfer,
                       why *w);

/* Reads what a file was baked with. 0, or -1 with the reason in w. */
int transfer_file_info(const char *path, transfer_info *info, why *w);

/* Reads the finished rows into transfer[point_count][bands^2] and marks them in done[point_count] (0 or 1).
   The file must have been baked with exactly what `expected` says. On failure (-1, reason in w) done is all 0. */
int transfer_file_load(const char *path, const transfer_info *expected, unsigned char *done, float *transfer, why *w);

/* The same from streams that are already open; `name` is what messages call them. */
int transfer_file_write(FILE *file, const char *name, const transfer_info *info, const unsigned char *done,
                        const float *transfer, why *w);
int transfer_file_read_info(FILE *file, const char *name, transfer_info *info, why *w);
int transfer_file_read(FILE *file, const char *name, const transfer_info *expected, unsigned char *done,
                       float *transfer, why *w);

#endif
