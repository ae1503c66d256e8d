// SPDX-License-Identifier: MIT
// Preloaded in front of the sanitizer's runtime: opens libraries without RTLD_DEEPBIND, which it cannot support.
#define _GNU_SOURCE
#include <dlfcn.h>

void *dlopen(const char *file, int mode) {
	static void *(*next)(const char *, int) = 0;
	if (next == 0) {
		next = (void *(*)(const char *, int))dlsym(RTLD_NEXT, "dlopen");
	}
	return next(file, mode & ~RTLD_DEEPBIND);
}
