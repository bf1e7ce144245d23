#ifndef AttributeBuffers_h
#define AttributeBuffers_h

#include "CellColoring.h"
#include "CellLabels.h"
#include "Isosurface/CellAttributes.h"
#include "Isosurface/MovedClusters.h"
#include "LabelFrames.h"
#include "StorageBuffer.h"

#include "vtkType.h"

#include <optional>

struct CellScene;
class vtkShaderProgram;

/// Labels and colours of cells on the GPU, each only if the scene asks for it, and where poses take
/// the cells. Threads: RENDER, with the context current.
class AttributeBuffers
{
public:
  /// When what is given to Update last changed.
  struct Times
  {
    vtkMTimeType cells = 0;  ///< cells, their labels, their colours
    vtkMTimeType labels = 0; ///< what is said of labels
  };
  /// The only cells that have changed since what is on the GPU, and of these the labels alone.
  using LabelEdit = std::optional<hasp::CellRange>;
  /// Brings what is asked for up to date and releases what is not. Throws std::runtime_error if the
  /// GPU has no room.
  void Update(const hasp::ClusteredCells& cells, const hasp::CellColoring& coloring,
    const hasp::CellLabels& labels, bool colored, const Times& times, const LabelEdit& edit);
  /// When the cells were as they are on the GPU.
  vtkMTimeType CellsTime() const { return this->Then.cells; }
  /// The frames of the labels' poses for this view; once a frame, if Labelled.
  void UpdateFrames(const CellScene& scene);
  /// Binds what belongs to clusters [first, end) of the cells, and sets their uniforms.
  void Bind(const hasp::ClusteredCells& cells, std::size_t first, std::size_t end,
    vtkShaderProgram* program) const;
  /// Leaves their storage blocks empty.
  void Unbind() const;
  void Release();

  bool Labelled() const { return this->Labels.Bytes() > 0; }
  bool Moved() const { return this->Labelled() && this->Frames.Moved(); }
  bool Colored() const { return this->Colors.Bytes() > 0; }
  /// Colours are places in a table.
  bool Tabled() const { return this->ColorTable.Bytes() > 0; }
  /// The clusters in each view, if Moved.
  std::vector<hasp::VisibleClusters> Cull(std::span<const glm::dmat4> indexToClip,
    const glm::ivec2& viewport, double pointLimit, double margin) const;
  std::size_t LabelBytes() const;
  std::size_t ColorBytes() const;

private:
  void UpdateLabels(
    const hasp::ClusteredCells& cells, const hasp::CellLabels& labels, const LabelEdit& changed);

  StorageBuffer Labels, LabelTable, FrameData;
  StorageBuffer FirstColors, Colors, ColorTable;
  LabelFrames Frames;
  hasp::MovedClusters Clusters; ///< empty unless Moved
  Times Then;
  bool ColoredThen = false;
};

#endif
