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
  const auto bytes = [](const auto& values) { return values.size() * sizeof(values[0]); };
  this->Clusters = MakeBuffer(cells.clusters.data(), bytes(cells.clusters));
  try
  {
    this->Corners = MakeBuffer(cells.corners.data(), bytes(cells.corners));
  }
  catch (...)
  {
    this->Release();
    throw;
  }
  this->ByteCount = bytes(cells.clusters) + bytes(cells.corners);
  this->Divide(cells);
  glGenVertexArrays(1, &this->VertexArray); // core profiles draw nothing without one
}

void CellBuffers::Divide(const hasp::ClusteredCells& cells)
{
  GLint blockLimit = 0;
  glGetIntegerv(GL_MAX_SHADER_STORAGE_BLOCK_SIZE, &blockLimit);
  // Offsets of bound ranges must be multiples of what is at most 256 bytes: 8 clusters, 64 words.
  constexpr std::size_t clusterStep = 8, wordStep = 64;
  const std::size_t wordLimit = blockLimit / sizeof(std::uint32_t) - wordStep;
  // A vertex's number, 512 * 6 a cluster, must fit a GLint.
  const std::size_t clusterLimit =
    std::min<std::size_t>(blockLimit / sizeof(hasp::CellCluster), 0x7FFFFFFF / (512 * 6));
  const std::size_t count = cells.clusters.size();
  const auto wordAt = [&](std::size_t c)
  { return c < count ? cells.clusters[c].firstWord : cells.corners.size(); };
  for (std::size_t first = 0, end = 0; first < count; first = end)
  {
    const std::size_t firstWord = wordAt(first) / wordStep * wordStep;
    const auto fits = [&](std::size_t to)
    { return to - first <= clusterLimit && wordAt(to) - firstWord <= wordLimit; };
    while (end < count && fits(std::min(end + clusterStep, count)))
      end = std::min(end + clusterStep, count);
    // Two words more: the last pair of corners is read as whole words.
    this->Parts.push_back(
      { first, end, firstWord, std::min(wordAt(end) + 2, cells.corners.size()) });
  }
  this->CellCounts.reserve(count);
  for (const hasp::CellCluster& cluster : cells.clusters)
    this->CellCounts.push_back(static_cast<std::uint16_t>(cluster.CellCount()));
}

void CellBuffers::Release()
{
  if (this->Clusters)
    glDeleteBuffers(1, &this->Clusters);
  if (this->Corners)
    glDeleteBuffers(1, &this->Corners);
  if (this->VertexArray)
    glDeleteVertexArrays(1, &this->VertexArray);
  *this = {};
}

void CellBuffers::Draw(const std::vector<std::uint32_t>& clusters, unsigned int primitive,
  int verticesPerCell, const std::function<void(int)>& setFirstWord) const
{
  if (!this->Uploaded() || clusters.empty())
    return;
  glBindVertexArray(this->VertexArray);
  std::vector<GLint> firsts;
  std::vector<GLsizei> counts;
  auto next = clusters.begin();
  for (const Part& part : this->Parts)
  {
    firsts.clear();
    counts.clear();
    for (; next != clusters.end() && *next < part.end; ++next)
    {
      firsts.push_back(static_cast<GLint>((*next - part.first) * 512 * verticesPerCell));
      counts.push_back(this->CellCounts[*next] * verticesPerCell);
    }
    if (firsts.empty())
      continue;
    const auto bind = [](GLuint slot, GLuint buffer, std::size_t from, std::size_t to)
    {
      glBindBufferRange(
        GL_SHADER_STORAGE_BUFFER, slot, buffer, GLintptr(from), GLsizeiptr(to - from));
    };
    bind(0, this->Clusters, part.first * sizeof(hasp::CellCluster),
      part.end * sizeof(hasp::CellCluster));
    bind(1, this->Corners, part.firstWord * sizeof(GLuint), part.endWord * sizeof(GLuint));
    setFirstWord(static_cast<int>(part.firstWord));
    glMultiDrawArrays(primitive, firsts.data(), counts.data(), static_cast<GLsizei>(firsts.size()));
  }
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 0, 0);
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 1, 0);
  glBindVertexArray(0);
}
