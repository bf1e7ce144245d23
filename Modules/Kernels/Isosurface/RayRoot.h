#pragma once
// glsl/RayRoot.glsl as C++: see there for what each function takes and gives.
#include <glm/common.hpp>
#include <glm/exponential.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace hasp::glsl
{
using glm::abs;
using glm::max;
using glm::min;
using glm::sqrt;
using glm::vec2;
using glm::vec3;
using glm::vec4;

#define HASP_FUNCTION inline
#define HASP_OUT(T) T&
#include "Isosurface/glsl/RayRoot.glsl"
#undef HASP_FUNCTION
#undef HASP_OUT
} // namespace hasp::glsl
