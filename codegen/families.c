#include "kernels.h"

#define FAMILY(name, description, from, to, forms) { #name, from, to, forms, describe_##description },
const family families[] = { FAMILIES(FAMILY) };
const int family_count = (int)(sizeof families / sizeof families[0]);
