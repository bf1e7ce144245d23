#ifndef CellUniforms_h
#define CellUniforms_h

class vtkActor;
class vtkHaspClusteredCellMapper;
class vtkRenderer;
class vtkShaderProgram;

/// Sets what the shaders of the clustered cells know of camera, actor, clipping planes and lights.
/// Matrices are multiplied and inverted in double precision and rounded to float last.
/// The eye is taken from the full matrix, so every kind of stereo and off-axis camera comes out
/// right. Threads: RENDER, with the program bound.
void SetCellUniforms(vtkShaderProgram* program, vtkHaspClusteredCellMapper* mapper,
  vtkRenderer* renderer, vtkActor* actor);

#endif
