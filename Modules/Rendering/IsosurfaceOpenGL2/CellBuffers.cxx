#include "CellBuffers.h"

#include "HaspGL.h"

#include <algorithm>
#include <stdexcept>
#include <string>

namespace
{
unsigned int MakeBuffer(const void* data, std::size_t bytes)
{
  for (int old = 0; old < 32 && glGetError() != GL_NO_ERROR; ++old) // somebody else's; a lost
  {                                                                 // context has no end of them
  }
  GLuint buffer = 0;
  glGenBuffers(1, &buffer);
  glBindBuffer(GL_SHADER_STORAGE_BUFFER, buffer);
  glBufferData(GL_SHADER_STORAGE_BUFFER, static_cast<GLsizeiptr>(bytes), data, GL_STATIC_DRAW);
  glBindBuffer(GL_SHADER_STORAGE_BUFFER, 0);
  if (glGetError() == GL_NO_ERROR)
    return buffer;
  glDeleteBuffers(1, &buffer);
  throw std::runtime_error(
    "the GPU has no room for " + std::to_string(bytes >> 20) + " MiB of active cells");
}
}

void CellBuffers::Upload(const hasp::ClusteredCells& cells)
{
  this->Release();
  if (cells.Count() == 0)
    return;
  this->BytesPerCell = cells.Stride() * sizeof(std::uint32_t);
  this->Cells = MakeBuffer(cells.words.data(), cells.words.size() * sizeof(std::uint32_t));
  this->CellBytes = cells.words.size() * sizeof(std::uint32_t);
  try
  {
    this->Clusters =
      MakeBuffer(cells.clusters.data(), cells.clusters.size() * sizeof(cells.clusters[0]));
    this->ClusterBytes = cells.clusters.size() * sizeof(cells.clusters[0]);
  }
  catch (...)
  {
    this->Release();
    throw;
  }
  glGenVertexArrays(1, &this->VertexArray); // core profiles draw nothing without one
}

void CellBuffers::Release()
{
  if (this->Cells)
    glDeleteBuffers(1, &this->Cells);
  if (this->Clusters)
    glDeleteBuffers(1, &this->Clusters);
  if (this->VertexArray)
    glDeleteVertexArrays(1, &this->VertexArray);
  *this = {};
}

void CellBuffers::Draw(const std::vector<hasp::CellRange>& ranges, unsigned int primitive,
  int verticesPerCell, const std::function<void(int)>& setFirstCell) const
{
  if (!this->Uploaded() || ranges.empty())
    return;
  GLint blockLimit = 0;
  glGetIntegerv(GL_MAX_SHADER_STORAGE_BLOCK_SIZE, &blockLimit);
  // Whole multiples of 64 cells keep every part's offset a multiple of 256 bytes, the largest
  // alignment OpenGL may ask for; 6 vertices a cell must fit a GLsizei.
  std::size_t part = static_cast<std::size_t>(blockLimit) / this->BytesPerCell / 64 * 64;
  part = std::min<std::size_t>(part, std::size_t{ 1 } << 28);

  const std::size_t count = this->CellBytes / this->BytesPerCell;
  glBindVertexArray(this->VertexArray);
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 1, this->Clusters);
  std::vector<GLint> firsts;
  std::vector<GLsizei> counts;
  for (std::size_t begin = 0; begin < count; begin += part)
  {
    const std::size_t end = std::min(begin + part, count);
    firsts.clear();
    counts.clear();
    for (const hasp::CellRange& range : ranges)
    {
      const std::size_t from = std::max<std::size_t>(range.first, begin);
      const std::size_t to = std::min<std::size_t>(range.first + range.count, end);
      if (from >= to)
        continue;
      firsts.push_back(static_cast<GLint>((from - begin) * verticesPerCell));
      counts.push_back(static_cast<GLsizei>((to - from) * verticesPerCell));
    }
    if (firsts.empty())
      continue;
    glBindBufferRange(GL_SHADER_STORAGE_BUFFER, 0, this->Cells,
      static_cast<GLintptr>(begin * this->BytesPerCell),
      static_cast<GLsizeiptr>((end - begin) * this->BytesPerCell));
    setFirstCell(static_cast<int>(begin));
    glMultiDrawArrays(primitive, firsts.data(), counts.data(), static_cast<GLsizei>(firsts.size()));
  }
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 0, 0);
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 1, 0);
  glBindVertexArray(0);
}
