#pragma once
#include "View/SceneActor.h"

#include <vector>

class vtkPolyData;
class vtkPolyDataMapper;
class vtkTextActor;

namespace hasp
{

/// A line, or the legs of an angle and its arc, between marked points, with the value beside it:
/// the text lies over all else and faces the viewer. Not picked. Threads: RENDER.
class MeasureActor : public SceneActor
{
public:
  explicit MeasureActor(SceneView& view);
  ~MeasureActor() override;

  /// Two points of the world or three. The same again: nothing.
  void SetPlaces(const std::vector<glm::dvec3>& places);
  void SetText(const std::string& text);
  void SetTextLook(const glm::dvec3& colour, bool visible);
  void FollowCover(); ///< the text is seen while the lines are among the view's props
  void ListResources(ResourceList& list) const override;

protected:
  std::optional<DataHit> First(const glm::dvec3&, const glm::dvec3&) const override { return {}; }
  bool DataBounds(double bounds[6]) const override;

private:
  std::vector<glm::dvec3> Places;
  vtkNew<vtkPolyData> Lines;
  vtkNew<vtkPolyDataMapper> Drawn;
  vtkNew<vtkTextActor> Text;
};

} // namespace hasp
