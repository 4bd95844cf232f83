// SPDX-License-Identifier: Apache-2.0
// Keys of extensions (core/terms/extensions.hpp) in scene files.
#pragma once
#include <vector>

#include "io/scene/tables/read_sections.hpp"

namespace thaw {

/// Reads a table [extension.NAME].
void readExtension(TableReader& reader, ExtensionSettings& settings, SceneReading& reading);

/// Reads the elastic law of a material, and the table of its keys if it is that of an extension.
void readLaw(TableReader& reader, Material& material);

/// Returns the names of shapes of extensions.
std::vector<std::string> extensionShapes();
/// Reads the shape of an extension, if the table has or records one.
void readExtensionShape(TableReader& reader, Shape& shape);

/// Returns the names that output.fields may list: those of frames, surface_velocity, and fields of the
/// scene's extensions.
std::vector<std::string> outputFields(const Scene& scene);

}  // namespace thaw
