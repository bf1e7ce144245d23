#ifndef HapticProps_h
#define HapticProps_h

#include "BodyBaking.h"
#include "HapticExchange.h"

#include "vtkHaspInteractionHapticsModule.h" // for export macro: tests
#include "vtkSmartPointer.h"
#include "vtkWeakPointer.h"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

class vtkDataSet;
class vtkHaspClusteredCellMapper;
class vtkImageData;
class vtkProp3D;

namespace hasp
{

/// One prop, as haptics has it.
struct HapticProp
{
  std::uint64_t id = 0;
  vtkWeakPointer<vtkProp3D> prop; ///< null: it is gone, or it never was one (an image alone)
  vtkSmartPointer<vtkImageData> image;
  vtkWeakPointer<vtkHaspClusteredCellMapper> cells; ///< whose isovalue counts; null: its own
  double isovalue = 0.0;                            ///< its own
  RigidPose fixed{};                                ///< where an image alone stands
  glm::dvec3 origin{ 0.0 };                         ///< of the body's axes, in its data
  bool touchable = false;
  int tool = -1; ///< number of the group it moves with; -1: none
  BakedBody baked;
  // Of what is baked, or being baked.
  double bakedIsovalue = 0.0;
  vtkWeakPointer<vtkDataSet> bakedData;
  vtkMTimeType bakedTime = 0; ///< of the data: images that share samples may share it, too
  bool ready = false, failed = false;

  /// Can be felt with: what a dynamic shell draws from needs no baking anew while the map waits for
  /// it.
  bool Feels() const { return this->prop && (this->ready || this->baked.dynamic); }
  /// Of the body's axes, world. Throws as PoseOf.
  RigidPose Pose() const;
  /// Of the surface that is shown.
  double Isovalue() const;
};

/// Which props can be touched and which can be taken in hand, and their maps and shells, baked one
/// after the other on a WORKER as soon as there are both.
///
/// Where a mapper's isovalue changes, what is made of it is made anew; a dynamic shell follows at
/// once, and stays in hand while the map that others touch is made anew. Where an actor is given
/// another mapper, a mapper other data, or data is Modified, all that is made of it is made anew,
/// and nothing of it is felt meanwhile. Pipelines are not asked for newer data: pictures do that.
///
/// Threads: RENDER. Samples and points are read by the WORKER: shared with the prop's data, which
/// may be replaced, but not changed in place while State is Baking.
class VTKHASPINTERACTIONHAPTICS_EXPORT HapticProps
{
public:
  HapticProps();
  ~HapticProps();

  /// What a prop's mapper shows: the isosurface of a vtkHaspClusteredCellMapper, or a
  /// vtkPolyDataMapper's closed surface. Throws std::invalid_argument for others, and as PoseOf.
  void AddTouchable(vtkProp3D* prop);
  void AddTouchable(vtkImageData* image, double isovalue, const RigidPose& imageToWorld);
  /// Props that are taken in hand together; number of the group.
  int AddTool(const std::vector<vtkProp3D*>& group);
  void Remove(vtkProp3D* prop);

  double spacingMm = 0.0;
  int shellPoints = 16'384;
  bool dynamicShells = false; ///< of tools that are isosurfaces, from the next AddTool on

  /// Takes what is baked, begins with what is next. True if something became ready or went. Faults
  /// are told once, in `faults`.
  bool Update(std::vector<std::string>& faults);

  bool Wanted() const; ///< something can be touched, and something taken in hand
  bool Baking() const { return this->Work != nullptr; }
  bool Complete() const;   ///< all that is wanted is there, or has failed
  double Progress() const; ///< of all that is wanted, [0, 1]
  const std::vector<HapticProp>& All() const { return this->Props; }

  bool ToolReady(int tool) const;
  /// The shells of a tool, seen from `toolInWorld`, and what it can touch: all that is ready but
  /// itself.
  std::vector<HapticShell> Shells(int tool, const RigidPose& toolInWorld) const;
  std::vector<HapticBody> Bodies(int tool) const;
  /// Of the props of Shells(tool), in that order: the isovalues of dynamic ones, NaN of others.
  decltype(HapticControl::isovalues) Isovalues(int tool) const;
  /// The tool whose surface is nearest to a point (world), within reachMm; -1: none. Of shells by
  /// their points, of dynamic ones by the cells that their surface crosses: 1 ms or less a tool.
  int Nearest(const glm::dvec3& point, double reachMm) const;
  void ListResources(ResourceList& list) const;

private:
  HapticProp& Find(vtkProp3D* prop);
  bool DropStale();
  void BeginNext(std::vector<std::string>& faults);

  std::vector<HapticProp> Props;
  std::unique_ptr<BodyBaking> Work;
  std::uint64_t WorkOf = 0, Ids = 0; ///< ids of props
  int Tools = 0;
};

} // namespace hasp

#endif
