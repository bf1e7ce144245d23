#ifndef WindowTextures_h
#define WindowTextures_h

class vtkRenderer;

/// Frees what a renderer's props keep in its window that VTK 9.1 would use in the next window too,
/// where it is something else or nothing: textures of actors and backgrounds, and all of props that
/// are neither actors nor volumes (text, widgets, 2D actors). Mappers know their window, and are
/// left alone. Costs making them anew; the window must live and have been drawn. Threads: RENDER.
void ReleaseTextures(vtkRenderer* renderer);

#endif
