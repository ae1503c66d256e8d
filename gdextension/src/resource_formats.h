// SPDX-License-Identifier: MIT
#pragma once

/// Lets the engine load and save .lut files as LensingTable and .stars files as StarCatalogue: by load() and
/// ResourceSaver, in the inspector, in exports. Once, after the classes are registered.
void register_resource_formats();

/// Takes back what register_resource_formats() did, before the library goes.
void unregister_resource_formats();
