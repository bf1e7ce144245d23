#ifndef EyeCulling_h
#define EyeCulling_h

#include "Isosurface/ClusterCulling.h"

#include "vtkType.h"

#include <functional>
#include <list>

/// What two eyes see of a mapper's clusters, culled in one pass when the first of them is drawn:
/// the second one's frame finds its lists here. They are the same that each would get by itself.
/// Not used in mono, where it holds nothing. Threads: RENDER.
class EyeCulling
{
public:
  /// All that the clusters in view depend on.
  struct View
  {
    glm::dmat4 indexToClip;
    glm::ivec2 viewport;
    double pointLimit, margin;
    vtkMTimeType cells, labels; ///< when they last changed
    bool operator==(const View&) const = default;
  };
  /// Of one pass over the clusters: a list for each matrix.
  using Cull =
    std::function<std::vector<hasp::VisibleClusters>(std::span<const glm::dmat4> indexToClip)>;

  /// What this view sees. If it is not known, `cull` is called, for the other eye, too. Valid until
  /// the next call of any function.
  const hasp::VisibleClusters& Visible(
    const View& view, const glm::dmat4& otherIndexToClip, const Cull& cull);
  /// A frame of the window. Forgets what was not asked for since this eye's last one.
  void BeginFrame();

  std::size_t Bytes() const;
  int Passes() const { return this->PassCount; } ///< that were made over the clusters so far

private:
  struct Known
  {
    View view;
    hasp::VisibleClusters visible;
    int age; ///< frames begun since it was asked for or made
  };
  std::list<Known> Lists;
  int PassCount = 0;
};

#endif
