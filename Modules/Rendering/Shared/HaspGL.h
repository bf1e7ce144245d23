#ifndef HaspGL_h
#define HaspGL_h
// OpenGL entry points, by whichever loader this VTK was built with (glew before 9.4, glad since).
#if VTK_MODULE_ENABLE_VTK_glad
#include "vtk_glad.h"
#else
#include "vtk_glew.h"
#endif
#endif
