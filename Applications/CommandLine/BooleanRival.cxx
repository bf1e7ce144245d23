// hasp-boolean-rival: a random tree of meshes by vtkBooleanOperationPolyDataFilter, in a process of
// its own, so that a crash or a loop without an end costs `hasp report distance` one tree.
//
// Usage: hasp-boolean-rival SEED DEPTH
// Output: closed manifold crossings volume seconds   (0 or 1, 0 or 1, pairs or -1, mm^3, s)
#include "Evaluation/MeshCheck.h"
#include "RandomTree.h"
#include "vtkHaspVolumeView.h"

#if HASP_WITH_CGAL
#include "Evaluation/SelfIntersections.h"
#endif

#include "vtkAppendPolyData.h"
#include "vtkBooleanOperationPolyDataFilter.h"
#include "vtkCapsuleSource.h"
#include "vtkCleanPolyData.h"
#include "vtkCubeSource.h"
#include "vtkCylinderSource.h"
#include "vtkLinearSubdivisionFilter.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkObject.h"
#include "vtkPolyData.h"
#include "vtkPolyDataAlgorithm.h"
#include "vtkReverseSense.h"
#include "vtkSelectEnclosedPoints.h"
#include "vtkTransform.h"
#include "vtkTransformPolyDataFilter.h"
#include "vtkTriangleFilter.h"

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <exception>

namespace
{

using namespace hasp;
using Mesh = vtkSmartPointer<vtkPolyData>;
using Kind = SolidNode::Kind;

constexpr int Round = 64; ///< corners of a circle: 0.16 % of a cylinder's volume is cut off
double booleanSeconds = 0.0;

/// Closed, of triangles, its points welded.
Mesh Cleaned(vtkPolyDataAlgorithm* source, double tolerance)
{
  vtkNew<vtkTriangleFilter> triangles;
  triangles->SetInputConnection(source->GetOutputPort());
  triangles->PassLinesOff();
  triangles->PassVertsOff();
  vtkNew<vtkCleanPolyData> clean;
  clean->SetInputConnection(triangles->GetOutputPort());
  clean->ToleranceIsAbsoluteOn();
  clean->SetAbsoluteTolerance(tolerance);
  clean->ConvertPolysToLinesOff();
  clean->ConvertLinesToPointsOff();
  clean->Update();
  return clean->GetOutput();
}

/// To where the node has it, each triangle cut into 4^finer: the filter is better on small ones.
/// `alongY`: the source's axis is y, not x.
Mesh Placed(vtkPolyDataAlgorithm* source, const SolidNode& node, bool alongY, int finer)
{
  const glm::dmat3 frame = FrameOf(node.axis);
  const glm::dmat3 axes = alongY ? glm::dmat3(frame[2], frame[0], frame[1]) : frame;
  vtkNew<vtkMatrix4x4> matrix;
  for (int column = 0; column < 3; ++column)
    for (int row = 0; row < 3; ++row)
      matrix->SetElement(row, column, axes[column][row]);
  for (int row = 0; row < 3; ++row)
    matrix->SetElement(row, 3, node.at[row]);
  vtkNew<vtkTransform> transform;
  transform->SetMatrix(matrix);
  vtkNew<vtkLinearSubdivisionFilter> small;
  small->SetInputData(Cleaned(source, 1e-6));
  small->SetNumberOfSubdivisions(finer);
  vtkNew<vtkTransformPolyDataFilter> move;
  if (finer > 0)
    move->SetInputConnection(small->GetOutputPort());
  else
    move->SetInputConnection(source->GetOutputPort());
  move->SetTransform(transform);
  return Cleaned(move, 1e-6);
}

Mesh LeafOf(const SolidNode& node)
{
  if (node.kind == Kind::Box)
  {
    vtkNew<vtkCubeSource> cube;
    cube->SetXLength(2.0 * node.size.x);
    cube->SetYLength(2.0 * node.size.y);
    cube->SetZLength(2.0 * node.size.z);
    return Placed(cube, node, false, 2);
  }
  if (node.kind == Kind::Cylinder)
  {
    vtkNew<vtkCylinderSource> cylinder;
    cylinder->SetHeight(2.0 * node.size.x);
    cylinder->SetRadius(node.mm);
    cylinder->SetResolution(Round);
    return Placed(cylinder, node, true, 1);
  }
  vtkNew<vtkCapsuleSource> capsule;
  capsule->SetCylinderLength(2.0 * node.size.x);
  capsule->SetRadius(node.mm);
  capsule->SetThetaResolution(Round);
  capsule->SetPhiResolution(Round);
  return Placed(capsule, node, true, 0);
}

/// Is a point of `part` in `whole`?
bool IsInside(const Mesh& part, const Mesh& whole)
{
  vtkNew<vtkSelectEnclosedPoints> inside;
  inside->Initialize(whole);
  double at[3];
  part->GetPoint(0, at);
  const bool is = inside->IsInsideSurface(at) != 0;
  inside->Complete();
  return is;
}

/// Surfaces that do not meet, which VTK's filter makes nothing of.
Mesh Apart(int operation, const Mesh& a, const Mesh& b)
{
  const bool aInB = IsInside(a, b), bInA = IsInside(b, a);
  const vtkNew<vtkPolyData> nothing;
  if (operation == vtkBooleanOperationPolyDataFilter::VTK_INTERSECTION)
    return aInB ? a : bInA ? b : Mesh(nothing);
  const bool difference = operation == vtkBooleanOperationPolyDataFilter::VTK_DIFFERENCE;
  if (aInB)
    return difference ? Mesh(nothing) : b;
  if (bInA != difference) // within a union, or beside a difference
    return a;
  vtkNew<vtkReverseSense> turned; // a hollow
  turned->SetInputData(b);
  turned->SetReverseCells(difference);
  turned->Update();
  vtkNew<vtkAppendPolyData> both;
  both->AddInputData(a);
  both->AddInputData(turned->GetOutput());
  both->Update();
  return both->GetOutput();
}

Mesh Joined(int operation, const Mesh& a, const Mesh& b)
{
  const bool none = a->GetNumberOfPolys() == 0, other = b->GetNumberOfPolys() == 0;
  if (none || other) // what VTK refuses, and what is known
    return operation == vtkBooleanOperationPolyDataFilter::VTK_INTERSECTION ? (none ? a : b)
           : operation == vtkBooleanOperationPolyDataFilter::VTK_UNION      ? (none ? b : a)
                                                                            : a;
  vtkNew<vtkBooleanOperationPolyDataFilter> boolean;
  boolean->SetOperation(operation);
  boolean->SetInputData(0, a);
  boolean->SetInputData(1, b);
  const auto start = std::chrono::steady_clock::now();
  boolean->Update();
  booleanSeconds += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  if (boolean->GetOutput()->GetNumberOfPolys() == 0)
    return Apart(operation, a, b);
  return Cleaned(boolean, 1e-6); // what it leaves twice along its lines
}

Mesh MeshOf(const SolidNode& node)
{
  if (node.parts.empty())
    return LeafOf(node);
  const int operation = node.kind == Kind::Union ? vtkBooleanOperationPolyDataFilter::VTK_UNION
                        : node.kind == Kind::Intersection
                          ? vtkBooleanOperationPolyDataFilter::VTK_INTERSECTION
                          : vtkBooleanOperationPolyDataFilter::VTK_DIFFERENCE;
  Mesh mesh = MeshOf(node.parts.front());
  for (std::size_t n = 1; n < node.parts.size(); ++n)
    mesh = Joined(operation, mesh, MeshOf(node.parts[n]));
  return mesh;
}

} // namespace

int main(int argc, char** argv)
{
  if (argc != 3)
    return 2;
  vtkObject::GlobalWarningDisplayOff();
  try
  {
    RandomTreeSettings settings;
    settings.depth = std::atoi(argv[2]);
    settings.meshes = true;
    const SolidNode tree =
      RandomTree(static_cast<std::uint32_t>(std::strtoul(argv[1], nullptr, 10)), settings);
    const TriangleMesh mesh = WeldPoints(TrianglesOf(MeshOf(tree)));
    const MeshCheck check = CheckMesh(mesh);
    long crossings = -1;
#if HASP_WITH_CGAL
    if (check.Sound())
      crossings = static_cast<long>(CountSelfIntersections(mesh));
#endif
    std::printf("%d %d %ld %.17g %.9g\n", check.Closed(), check.Sound(), crossings, check.volumeMm3,
      booleanSeconds);
  }
  catch (const std::exception&)
  {
    return 1;
  }
}
