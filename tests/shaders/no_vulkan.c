/* Where the Vulkan headers and loader are missing */
#include "runner.h"

int vulkan_create(why *w) { return why_set(w, "Vulkan was not there when the test was built (libvulkan-dev)"); }
void vulkan_destroy(void) {}
const char *vulkan_name(void) { return "no Vulkan"; }
int run_vulkan(const char *spirv_path, const work *job, why *w) {
    (void)spirv_path;
    (void)job;
    return why_set(w, "Vulkan was not there when the test was built (libvulkan-dev)");
}
