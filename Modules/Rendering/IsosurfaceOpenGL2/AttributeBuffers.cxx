#include "AttributeBuffers.h"

#include "CellScene.h"
#include "HaspGL.h"

#include "vtkShaderProgram.h"

#include <algorithm>

namespace
{

// Slots of storage blocks; 0 and 1 are the cells.
enum Slot : unsigned int
{
  FirstColorSlot = 2,
  ColorTableSlot,
  LabelSlot,
  LabelTableSlot,
  FrameSlot,
  ColorSlot
};

/// Where bound ranges may begin: at multiples of what is at most 256 bytes.
constexpr std::size_t Step = 256;

template <typename T>
void UploadAll(StorageBuffer& buffer, const std::vector<T>& values, const char* what)
{
  buffer.Upload(values.data(), values.size() * sizeof(T), what);
}

} // namespace

void AttributeBuffers::Update(const hasp::ClusteredCells& cells, const hasp::CellColoring& coloring,
  const hasp::CellLabels& labels, bool colored, const Times& times, const LabelEdit& edit)
{
  const bool labelled = !cells.labels.empty() && !labels.empty();
  const bool same = colored == this->ColoredThen && labelled == this->Labelled();
  const bool newCells = !same || (times.cells != this->Then.cells && !edit);
  LabelEdit changed = times.cells != this->Then.cells ? edit : hasp::CellRange{};
  if (newCells)
  {
    this->Release();
    changed = std::nullopt;
  }
  if (labelled && (times.cells != this->Then.cells || times.labels != this->Then.labels))
    this->UpdateLabels(cells, labels, changed);
  if (newCells && colored && !cells.colors.empty())
  {
    UploadAll(this->FirstColors, cells.firstColors, "colours");
    UploadAll(this->Colors, cells.colors, "colours");
    UploadAll(this->ColorTable, coloring.table, "colours");
  }
  this->Then = times;
  this->ColoredThen = colored;
}

/// changed  whose labels are others than on the GPU; nothing: all are new
void AttributeBuffers::UpdateLabels(
  const hasp::ClusteredCells& cells, const hasp::CellLabels& labels, const LabelEdit& changed)
{
  if (!changed)
  {
    std::vector<std::uint16_t> whole = cells.labels; // words
    whole.resize((whole.size() + 1) / 2 * 2);
    UploadAll(this->Labels, whole, "labels");
  }
  else if (!changed->Empty())
    this->Labels.Replace(changed->first * sizeof(std::uint16_t), &cells.labels[changed->first],
      (changed->end - changed->first) * sizeof(std::uint16_t));
  const std::vector<std::uint32_t> before = this->Frames.moveOfLabel;
  this->Frames = LabelFrames(labels, cells.geometry);
  UploadAll(this->LabelTable, this->Frames.table, "what is said of labels");
  if (!this->Frames.Moved())
    this->Clusters = {};
  else if (!changed || !changed->Empty() || this->Frames.moveOfLabel != before)
    this->Clusters =
      hasp::MovedClusters(cells, this->Frames.moveOfLabel, this->Frames.moves.size());
}

void AttributeBuffers::UpdateFrames(const CellScene& scene)
{
  std::vector<float> data;
  for (const glm::dmat4& move : this->Frames.moves)
    scene.AppendFrame(data, move);
  UploadAll(this->FrameData, data, "poses of labels");
}

void AttributeBuffers::Bind(const hasp::ClusteredCells& cells, std::size_t first, std::size_t end,
  vtkShaderProgram* program) const
{
  const bool last = end == cells.clusters.size();
  if (this->Labelled())
  {
    const std::size_t from = cells.clusters[first].firstCell * sizeof(std::uint16_t) / Step * Step;
    const std::size_t to = last ? cells.Count() : cells.clusters[end].firstCell;
    this->Labels.Bind(LabelSlot, from, (to * sizeof(std::uint16_t) + 3) / 4 * 4);
    program->SetUniformi("firstLabelWord", static_cast<int>(from / sizeof(std::uint32_t)));
    this->LabelTable.Bind(LabelTableSlot);
    this->FrameData.Bind(FrameSlot);
  }
  if (this->Colored())
  {
    const std::size_t word = sizeof(std::uint32_t);
    const std::size_t fromCluster = first * word / Step * Step;
    this->FirstColors.Bind(FirstColorSlot, fromCluster, end * word);
    const std::size_t from = cells.firstColors[first] * word / Step * Step;
    const std::size_t to = last ? cells.colors.size() : cells.firstColors[end];
    this->Colors.Bind(ColorSlot, from, to * word);
    program->SetUniformi("firstColor", static_cast<int>(from / word));
    program->SetUniformi("clustersBefore", static_cast<int>(first - fromCluster / word));
    if (this->Tabled())
      this->ColorTable.Bind(ColorTableSlot);
  }
}

void AttributeBuffers::Unbind() const
{
  if (this->Labelled() || this->Colored())
    for (GLuint slot = FirstColorSlot; slot <= ColorSlot; ++slot)
      glBindBufferBase(GL_SHADER_STORAGE_BUFFER, slot, 0);
}

void AttributeBuffers::Release()
{
  for (StorageBuffer* buffer : { &this->Labels, &this->LabelTable, &this->FrameData,
         &this->FirstColors, &this->Colors, &this->ColorTable })
    buffer->Release();
  *this = {};
}

std::vector<hasp::VisibleClusters> AttributeBuffers::Cull(std::span<const glm::dmat4> indexToClip,
  const glm::ivec2& viewport, double pointLimit, double margin) const
{
  return this->Clusters.Cull(indexToClip, this->Frames.moves, viewport, pointLimit, margin);
}

std::size_t AttributeBuffers::LabelBytes() const
{
  return this->Labels.Bytes() + this->LabelTable.Bytes() + this->FrameData.Bytes() +
         this->Clusters.Bytes();
}

std::size_t AttributeBuffers::ColorBytes() const
{
  return this->FirstColors.Bytes() + this->Colors.Bytes() + this->ColorTable.Bytes();
}
