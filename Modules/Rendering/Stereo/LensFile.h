#pragma once
#include "LensModel.h"
#include "vtkHaspRenderingStereoModule.h" // for export macro

#include <string>

namespace hasp
{

/// A lens model as JSON:
///
///   { "format": "hasp-lens-1", "note": "...", "coefficients": [k1, k2, k3],
///     "leftCenter": [x, y], "rightCenter": [x, y], "colorScale": [red, green, blue] }
///
/// with the units of LensModel.h. Strict: every key but "note" must be there, and no other. Errors
/// are std::runtime_error (file, syntax) or std::invalid_argument (content) and say which key,
/// never the file's name or text. Whether the lens folds over depends on the picture:
/// ValidateLens. Without HASP_ENABLE_JSON both throw std::runtime_error. Any thread.
VTKHASPRENDERINGSTEREO_EXPORT LensModel ParseLens(const std::string& json);
VTKHASPRENDERINGSTEREO_EXPORT LensModel ReadLens(const std::string& path);

} // namespace hasp
