/* Where the Vulkan headers and loader are missing */
#include "runner.h"

int vulkan_create(int processor, why *w) {
    (void)processor;
    return why_set(w, "Vulkan was not there when the test was built (libvulkan-dev)");
}
void vulkan_destroy(void) {}
const char *vulkan_name(void) { return "no Vulkan"; }
int vulkan_is_processor(void) { return 0; }
int run_vulkan(const char *spirv_path, const work *job, int runs, double *seconds, why *w) {
    (void)spirv_path;
    (void)job;
    (void)runs;
    (void)seconds;
    return why_set(w, "Vulkan was not there when the test was built (libvulkan-dev)");
}
