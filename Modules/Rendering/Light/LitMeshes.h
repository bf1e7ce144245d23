#ifndef LitMeshes_h
#define LitMeshes_h

#include "Light/TriangleTracer.h"

class vtkPolyDataMapper;

/// The triangles that a mapper draws, as light needs them: polygons (convex ones, as fans) and
/// strips; normals of the points if `smooth`; colours where the mapper maps scalars, as linear if
/// `linear`, else as they are. Points that are not finite are left out with their triangles.
/// Threads: RENDER.
hasp::LitMesh LitMeshOf(vtkPolyDataMapper* mapper, bool smooth, bool linear);

/// sRGB to linear, IEC 61966-2-1. v in [0, 1].
float LinearOf(double v);

#endif
