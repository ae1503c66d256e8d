// SPDX-License-Identifier: MIT
// Loads a DLL and looks for a function in it, as Godot does: load.exe FILE FUNCTION. 0 when both are there.
#include <windows.h>

#include <cstdio>
#include <string>

int wmain(int count, wchar_t **arguments) {
	if (count != 3) {
		std::fprintf(stderr, "usage: load.exe FILE FUNCTION\n");
		return 2;
	}
	const HMODULE library = LoadLibraryW(arguments[1]);
	if (library == nullptr) {
		std::fprintf(stderr, "cannot be loaded: error %lu\n", GetLastError());
		return 1;
	}
	const std::wstring wide(arguments[2]);
	const std::string function(wide.begin(), wide.end());
	return GetProcAddress(library, function.c_str()) != nullptr ? 0 : 1;
}
