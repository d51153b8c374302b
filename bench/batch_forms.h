/* batch_forms.h - what batch_forms.c measures, once for each width of vectors. */
#ifndef BATCH_FORMS_H
#define BATCH_FORMS_H

typedef struct batch_rates {
    int lanes;
    double flops;                      /* peak, per ns, a multiply-add counted as two */
    double ns[7];                      /* a pair, at 3 to 6 bands */
} batch_rates;

void batch_portable(batch_rates *rates);
void batch_avx2(batch_rates *rates);   /* where BENCH_HAS_AVX2 */
void batch_native(batch_rates *rates);

#endif
