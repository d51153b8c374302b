/* libFuzzer: arbitrary bytes as a transfer file. Each input is read twice, as it is and with both checksums made right,
   so that the fuzzer reaches what lies behind them; the arrays have exactly the promised size, for AddressSanitizer. A
   file that was accepted must come back byte for byte when it is written again: a set of rows has one encoding. */
#define _POSIX_C_SOURCE 200809L
#include <stdlib.h>

#include "../../examples/common/replacement.c"
#include "../../examples/common/transfer_file.c"
#include "../../examples/common/why.c"

enum { MOST_NUMBERS = 1 << 16 };

static void read_back(const unsigned char *bytes, size_t size) {
    transfer_info info;
    why w;
    FILE *file = fmemopen((void *)(uintptr_t)bytes, size, "rb");
    unsigned char *done;
    float *transfer;
    if (!file) return;
    if (transfer_file_read_info(file, "input", &info, &w) || info.point_count > MOST_NUMBERS ||
        info.point_count * info.bands * info.bands > MOST_NUMBERS) {
        fclose(file);
        return;
    }
    rewind(file);
    done = (unsigned char *)malloc((size_t)info.point_count + 1);
    transfer = (float *)malloc((size_t)info.point_count * info.bands * info.bands * sizeof *transfer + 1);
    if (done && transfer && transfer_file_read(file, "input", &info, done, transfer, &w) == 0) {
        char *again = NULL;
        size_t again_size = 0;
        FILE *out = open_memstream(&again, &again_size);
        if (transfer_file_write(out, "output", &info, done, transfer, &w)) abort();
        fclose(out);
        if (again_size != size || memcmp(again, bytes, size)) abort();
        free(again);
    }
    free(done);
    free(transfer);
    fclose(file);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);
int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    unsigned char *sealed;
    if (size == 0) return 0;
    read_back(data, size);
    if (size < TRANSFER_FILE_HEADER_BYTES + 8) return 0;
    sealed = (unsigned char *)malloc(size);
    if (!sealed) return 0;
    memcpy(sealed, data, size);
    memcpy(sealed, transfer_magic, 8);
    put32(sealed + 8, TRANSFER_FILE_VERSION);
    put64(sealed + 56, transfer_checksum(TRANSFER_CHECKSUM_START, sealed, 56));
    put64(sealed + size - 8, transfer_checksum(TRANSFER_CHECKSUM_START, sealed, size - 8));
    read_back(sealed, size);
    free(sealed);
    return 0;
}
