// SPDX-License-Identifier: MIT
// Preloaded in front of the sanitizer's runtime: opens libraries without RTLD_DEEPBIND, which it cannot support.
// With KEEP_LIBRARIES=1 in the environment, libraries stay in memory until the sanitizer has written its report.
#define _GNU_SOURCE
#include <dlfcn.h>
#include <stdlib.h>
#include <string.h>

void *dlopen(const char *file, int mode) {
	static void *(*next)(const char *, int) = 0;
	if (next == 0) {
		next = (void *(*)(const char *, int))dlsym(RTLD_NEXT, "dlopen");
	}
	const char *keep = getenv("KEEP_LIBRARIES");
	const int kept = keep != 0 && strcmp(keep, "1") == 0 ? RTLD_NODELETE : 0;
	return next(file, (mode & ~RTLD_DEEPBIND) | kept);
}
