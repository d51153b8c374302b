/* A compute shader in SPIR-V on a Vulkan device. */
#include "runner.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <vulkan/vulkan.h>

static struct {
    VkInstance instance;
    VkPhysicalDevice physical;
    VkPhysicalDeviceProperties properties;
    VkPhysicalDeviceMemoryProperties memory;
    VkDevice device;
    VkQueue queue;
    uint32_t family;
    VkCommandPool commands;
    VkDescriptorPool descriptors;
    VkDescriptorSetLayout set_layout;
    VkPipelineLayout layout;
    VkQueryPool stamps;                                /* before and after a dispatch; 0: the queue has no clock */
} vk;

static int failed(VkResult result, const char *doing, why *w) {
    return result == VK_SUCCESS ? 0 : why_set(w, "Vulkan: error %d while %s", (int)result, doing);
}

/* The first device that is a processor, or that is none; if there is no such, the first */
static int choose_device(int processor, why *w) {
    VkPhysicalDevice found[16];
    uint32_t count = 16, i;
    VkResult result = vkEnumeratePhysicalDevices(vk.instance, &count, found);
    if ((result != VK_SUCCESS && result != VK_INCOMPLETE) || count == 0) return why_set(w, "Vulkan: no device");
    vk.physical = found[0];
    for (i = 0; i < count; i++) {
        vkGetPhysicalDeviceProperties(found[i], &vk.properties);
        if ((vk.properties.deviceType == VK_PHYSICAL_DEVICE_TYPE_CPU) == processor) { vk.physical = found[i]; break; }
    }
    vkGetPhysicalDeviceProperties(vk.physical, &vk.properties);
    vkGetPhysicalDeviceMemoryProperties(vk.physical, &vk.memory);
    return 0;
}

static int choose_queue(uint32_t *clock_bits, why *w) {
    VkQueueFamilyProperties family[16];
    uint32_t count = 16;
    vkGetPhysicalDeviceQueueFamilyProperties(vk.physical, &count, family);
    for (vk.family = 0; vk.family < count; vk.family++)
        if (family[vk.family].queueFlags & VK_QUEUE_COMPUTE_BIT) {
            *clock_bits = family[vk.family].timestampValidBits;
            return 0;
        }
    return why_set(w, "Vulkan: no queue for compute shaders");
}

static int create_device(why *w) {
    VkPhysicalDeviceVulkan12Features offered12, wanted12;
    VkPhysicalDeviceVulkan11Features offered11, wanted11;
    VkPhysicalDeviceFeatures2 offered;
    VkDeviceQueueCreateInfo queue;
    VkDeviceCreateInfo info;
    float priority = 1;
    memset(&offered12, 0, sizeof offered12); memset(&wanted12, 0, sizeof wanted12);
    memset(&offered11, 0, sizeof offered11); memset(&wanted11, 0, sizeof wanted11);
    memset(&offered, 0, sizeof offered); memset(&queue, 0, sizeof queue); memset(&info, 0, sizeof info);
    offered12.sType = wanted12.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_2_FEATURES;
    offered11.sType = wanted11.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_1_FEATURES;
    offered.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_FEATURES_2;
    offered.pNext = &offered11;
    offered11.pNext = &offered12;
    vkGetPhysicalDeviceFeatures2(vk.physical, &offered);
    wanted12.shaderFloat16 = offered12.shaderFloat16;  /* only half precision needs these */
    wanted11.storageBuffer16BitAccess = offered11.storageBuffer16BitAccess;
    wanted11.uniformAndStorageBuffer16BitAccess = offered11.uniformAndStorageBuffer16BitAccess;
    wanted11.storageInputOutput16 = offered11.storageInputOutput16;
    wanted11.pNext = &wanted12;
    queue.sType = VK_STRUCTURE_TYPE_DEVICE_QUEUE_CREATE_INFO;
    queue.queueFamilyIndex = vk.family;
    queue.queueCount = 1;
    queue.pQueuePriorities = &priority;
    info.sType = VK_STRUCTURE_TYPE_DEVICE_CREATE_INFO;
    info.pNext = &wanted11;
    info.queueCreateInfoCount = 1;
    info.pQueueCreateInfos = &queue;
    if (failed(vkCreateDevice(vk.physical, &info, NULL, &vk.device), "opening the device", w)) return -1;
    vkGetDeviceQueue(vk.device, vk.family, 0, &vk.queue);
    return 0;
}

static int create_pools(why *w) {
    VkCommandPoolCreateInfo commands;
    VkDescriptorPoolCreateInfo descriptors;
    VkDescriptorPoolSize size = { VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, 2 };
    VkDescriptorSetLayoutCreateInfo set;
    VkDescriptorSetLayoutBinding binding[2];
    VkPipelineLayoutCreateInfo layout;
    uint32_t i;
    memset(&commands, 0, sizeof commands); memset(&descriptors, 0, sizeof descriptors);
    memset(&set, 0, sizeof set); memset(binding, 0, sizeof binding); memset(&layout, 0, sizeof layout);
    commands.sType = VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO;
    commands.queueFamilyIndex = vk.family;
    descriptors.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO;
    descriptors.maxSets = 1;
    descriptors.poolSizeCount = 1;
    descriptors.pPoolSizes = &size;
    for (i = 0; i < 2; i++) {
        binding[i].binding = i;
        binding[i].descriptorType = VK_DESCRIPTOR_TYPE_STORAGE_BUFFER;
        binding[i].descriptorCount = 1;
        binding[i].stageFlags = VK_SHADER_STAGE_COMPUTE_BIT;
    }
    set.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO;
    set.bindingCount = 2;
    set.pBindings = binding;
    layout.sType = VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO;
    layout.setLayoutCount = 1;
    layout.pSetLayouts = &vk.set_layout;
    return failed(vkCreateCommandPool(vk.device, &commands, NULL, &vk.commands), "making a command pool", w) ||
           failed(vkCreateDescriptorPool(vk.device, &descriptors, NULL, &vk.descriptors), "making descriptors", w) ||
           failed(vkCreateDescriptorSetLayout(vk.device, &set, NULL, &vk.set_layout), "describing the buffers", w) ||
           failed(vkCreatePipelineLayout(vk.device, &layout, NULL, &vk.layout), "making a layout", w) ? -1 : 0;
}

static int create_clock(uint32_t clock_bits, why *w) {
    VkQueryPoolCreateInfo info;
    if (!clock_bits) return 0;
    memset(&info, 0, sizeof info);
    info.sType = VK_STRUCTURE_TYPE_QUERY_POOL_CREATE_INFO;
    info.queryType = VK_QUERY_TYPE_TIMESTAMP;
    info.queryCount = 2;
    return failed(vkCreateQueryPool(vk.device, &info, NULL, &vk.stamps), "making a clock", w) ? -1 : 0;
}

int vulkan_create(int processor, why *w) {
    uint32_t clock_bits = 0;
    VkApplicationInfo application;
    VkInstanceCreateInfo info;
    VkResult result;
    memset(&application, 0, sizeof application); memset(&info, 0, sizeof info);
    application.sType = VK_STRUCTURE_TYPE_APPLICATION_INFO;
    application.apiVersion = VK_API_VERSION_1_2;
    info.sType = VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO;
    info.pApplicationInfo = &application;
    result = vkCreateInstance(&info, NULL, &vk.instance);
    if (result == VK_ERROR_INCOMPATIBLE_DRIVER) return why_set(w, "Vulkan: no driver for any device is installed");
    if (failed(result, "starting", w)) return -1;
    if (!choose_device(processor, w) && !choose_queue(&clock_bits, w) && !create_device(w) && !create_pools(w) &&
        !create_clock(clock_bits, w)) return 0;
    vulkan_destroy();
    return -1;
}

void vulkan_destroy(void) {
    if (vk.device) {
        vkDestroyQueryPool(vk.device, vk.stamps, NULL);
        vkDestroyPipelineLayout(vk.device, vk.layout, NULL);
        vkDestroyDescriptorSetLayout(vk.device, vk.set_layout, NULL);
        vkDestroyDescriptorPool(vk.device, vk.descriptors, NULL);
        vkDestroyCommandPool(vk.device, vk.commands, NULL);
        vkDestroyDevice(vk.device, NULL);
    }
    if (vk.instance) vkDestroyInstance(vk.instance, NULL);
    memset(&vk, 0, sizeof vk);
}

const char *vulkan_name(void) { return vk.properties.deviceName; }
int vulkan_is_processor(void) { return vk.properties.deviceType == VK_PHYSICAL_DEVICE_TYPE_CPU; }

/* ---- one program ---- */

typedef struct buffer { VkBuffer buffer; VkDeviceMemory memory; VkDeviceSize size; void *mapped; } buffer;

static int host_memory(uint32_t allowed, uint32_t *type, why *w) {
    const VkMemoryPropertyFlags wanted = VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT | VK_MEMORY_PROPERTY_HOST_COHERENT_BIT;
    for (*type = 0; *type < vk.memory.memoryTypeCount; (*type)++)
        if ((allowed >> *type & 1) && (vk.memory.memoryTypes[*type].propertyFlags & wanted) == wanted) return 0;
    return why_set(w, "Vulkan: no memory that both sides see");
}

static int create_buffer(buffer *b, size_t size, why *w) {
    VkBufferCreateInfo info;
    VkMemoryAllocateInfo allocation;
    VkMemoryRequirements needs;
    memset(&info, 0, sizeof info); memset(&allocation, 0, sizeof allocation);
    info.sType = VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO;
    info.size = b->size = size ? size : 4;
    info.usage = VK_BUFFER_USAGE_STORAGE_BUFFER_BIT;
    if (failed(vkCreateBuffer(vk.device, &info, NULL, &b->buffer), "making a buffer", w)) return -1;
    vkGetBufferMemoryRequirements(vk.device, b->buffer, &needs);
    allocation.sType = VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO;
    allocation.allocationSize = needs.size;
    return host_memory(needs.memoryTypeBits, &allocation.memoryTypeIndex, w) ||
           failed(vkAllocateMemory(vk.device, &allocation, NULL, &b->memory), "taking memory", w) ||
           failed(vkBindBufferMemory(vk.device, b->buffer, b->memory, 0), "binding memory", w) ||
           failed(vkMapMemory(vk.device, b->memory, 0, VK_WHOLE_SIZE, 0, &b->mapped), "mapping memory", w) ? -1 : 0;
}

static void destroy_buffer(buffer *b) {
    if (b->buffer) vkDestroyBuffer(vk.device, b->buffer, NULL);
    if (b->memory) vkFreeMemory(vk.device, b->memory, NULL);
}

static int load_module(const char *path, VkShaderModule *module, why *w) {
    static uint32_t code[1 << 20];
    VkShaderModuleCreateInfo info;
    FILE *f = fopen(path, "rb");
    size_t words;
    if (!f) return why_set(w, "cannot read %s", path);
    words = fread(code, sizeof *code, sizeof code / sizeof *code, f);
    fclose(f);
    if (words == 0 || words == sizeof code / sizeof *code) return why_set(w, "%s: empty, or above 4 MiB", path);
    memset(&info, 0, sizeof info);
    info.sType = VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO;
    info.codeSize = words * sizeof *code;
    info.pCode = code;
    return failed(vkCreateShaderModule(vk.device, &info, NULL, module), "reading SPIR-V", w);
}

static int create_pipeline(VkShaderModule module, VkPipeline *pipeline, why *w) {
    VkComputePipelineCreateInfo info;
    memset(&info, 0, sizeof info);
    info.sType = VK_STRUCTURE_TYPE_COMPUTE_PIPELINE_CREATE_INFO;
    info.stage.sType = VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO;
    info.stage.stage = VK_SHADER_STAGE_COMPUTE_BIT;
    info.stage.module = module;
    info.stage.pName = "main";
    info.layout = vk.layout;
    return failed(vkCreateComputePipelines(vk.device, VK_NULL_HANDLE, 1, &info, NULL, pipeline), "compiling", w);
}

static int bind_buffers(const buffer buffers[2], VkDescriptorSet *set, why *w) {
    VkDescriptorSetAllocateInfo info;
    VkDescriptorBufferInfo range[2];
    VkWriteDescriptorSet write[2];
    uint32_t i;
    memset(&info, 0, sizeof info); memset(write, 0, sizeof write);
    info.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_ALLOCATE_INFO;
    info.descriptorPool = vk.descriptors;
    info.descriptorSetCount = 1;
    info.pSetLayouts = &vk.set_layout;
    if (failed(vkAllocateDescriptorSets(vk.device, &info, set), "making a descriptor set", w)) return -1;
    for (i = 0; i < 2; i++) {
        range[i].buffer = buffers[i].buffer;
        range[i].offset = 0;
        range[i].range = VK_WHOLE_SIZE;
        write[i].sType = VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET;
        write[i].dstSet = *set;
        write[i].dstBinding = i;
        write[i].descriptorCount = 1;
        write[i].descriptorType = VK_DESCRIPTOR_TYPE_STORAGE_BUFFER;
        write[i].pBufferInfo = &range[i];
    }
    vkUpdateDescriptorSets(vk.device, 2, write, 0, NULL);
    return 0;
}

/* Seconds between the two stamps, by the device's clock; 0 without one */
static double stamped_seconds(void) {
    uint64_t stamp[2] = { 0, 0 };
    if (!vk.stamps || vkGetQueryPoolResults(vk.device, vk.stamps, 0, 2, sizeof stamp, stamp, sizeof *stamp,
                                            VK_QUERY_RESULT_64_BIT | VK_QUERY_RESULT_WAIT_BIT) != VK_SUCCESS) return 0;
    return (double)(stamp[1] - stamp[0]) * (double)vk.properties.limits.timestampPeriod * 1e-9;
}

static int dispatch(VkPipeline pipeline, VkDescriptorSet set, int groups, double *seconds, why *w) {
    VkCommandBufferAllocateInfo allocation;
    VkCommandBufferBeginInfo begin;
    VkSubmitInfo submit;
    VkCommandBuffer commands;
    int bad;
    memset(&allocation, 0, sizeof allocation); memset(&begin, 0, sizeof begin); memset(&submit, 0, sizeof submit);
    allocation.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO;
    allocation.commandPool = vk.commands;
    allocation.level = VK_COMMAND_BUFFER_LEVEL_PRIMARY;
    allocation.commandBufferCount = 1;
    if (failed(vkAllocateCommandBuffers(vk.device, &allocation, &commands), "making a command buffer", w)) return -1;
    begin.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO;
    begin.flags = VK_COMMAND_BUFFER_USAGE_ONE_TIME_SUBMIT_BIT;
    vkBeginCommandBuffer(commands, &begin);
    if (vk.stamps) {
        vkCmdResetQueryPool(commands, vk.stamps, 0, 2);
        vkCmdWriteTimestamp(commands, VK_PIPELINE_STAGE_TOP_OF_PIPE_BIT, vk.stamps, 0);
    }
    vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_COMPUTE, pipeline);
    vkCmdBindDescriptorSets(commands, VK_PIPELINE_BIND_POINT_COMPUTE, vk.layout, 0, 1, &set, 0, NULL);
    vkCmdDispatch(commands, (uint32_t)groups, 1, 1);
    if (vk.stamps) vkCmdWriteTimestamp(commands, VK_PIPELINE_STAGE_BOTTOM_OF_PIPE_BIT, vk.stamps, 1);
    vkEndCommandBuffer(commands);
    submit.sType = VK_STRUCTURE_TYPE_SUBMIT_INFO;
    submit.commandBufferCount = 1;
    submit.pCommandBuffers = &commands;
    bad = failed(vkQueueSubmit(vk.queue, 1, &submit, VK_NULL_HANDLE), "starting a compute shader", w) ||
          failed(vkQueueWaitIdle(vk.queue), "running a compute shader", w);
    if (!bad && seconds) *seconds = stamped_seconds();
    vkFreeCommandBuffers(vk.device, vk.commands, 1, &commands);
    return bad ? -1 : 0;
}

int run_vulkan(const char *spirv_path, const work *job, int runs, double *seconds, why *w) {
    size_t each = (size_t)job->items * sizeof(float), read = each * (size_t)job->ins;
    size_t written = each * (size_t)job->outs;
    double now = 0;
    int i;
    VkShaderModule module = VK_NULL_HANDLE;
    VkPipeline pipeline = VK_NULL_HANDLE;
    VkDescriptorSet set;
    buffer buffers[2];
    int bad;
    memset(buffers, 0, sizeof buffers);
    bad = load_module(spirv_path, &module, w) || create_pipeline(module, &pipeline, w) ||
          create_buffer(&buffers[0], read, w) || create_buffer(&buffers[1], written, w) ||
          bind_buffers(buffers, &set, w);
    if (!bad) {
        memcpy(buffers[0].mapped, job->in, read);
        for (i = 0; i < runs && !bad; i++) {
            bad = dispatch(pipeline, set, job->items / 64, &now, w);
            if (seconds && (i == 0 || now < *seconds)) *seconds = now;
        }
        if (!bad) memcpy(job->out, buffers[1].mapped, written);
    }
    vkResetDescriptorPool(vk.device, vk.descriptors, 0);
    vkDestroyPipeline(vk.device, pipeline, NULL);
    vkDestroyShaderModule(vk.device, module, NULL);
    destroy_buffer(&buffers[0]);
    destroy_buffer(&buffers[1]);
    return bad ? -1 : 0;
}
