#include "CellBuffers.h"

#include "HaspGL.h"

#include <limits>
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

constexpr GLsizei BatchCells = 20000;

/// Draws that wait for OpenGL: no more than two, the last of which may still be waiting in the end.
class DrawQueue
{
public:
  DrawQueue() = default;
  ~DrawQueue() { glDeleteSync(this->Last); } // null is none
  DrawQueue(const DrawQueue&) = delete;
  DrawQueue& operator=(const DrawQueue&) = delete;

  /// What was sent since the last call; waits until that before it is done.
  void Add()
  {
    GLsync now = glFenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0);
    glFlush();
    if (this->Last)
      glClientWaitSync(this->Last, 0, GL_TIMEOUT_IGNORED);
    glDeleteSync(this->Last);
    this->Last = now;
  }

private:
  GLsync Last = nullptr;
};

} // namespace

void CellBuffers::Upload(const hasp::ClusteredCells& cells, std::size_t blockBytes)
{
  this->Release();
  if (cells.Count() == 0)
    return;
  this->PartList = hasp::DivideClusters(cells, blockBytes);
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
  this->CellCounts.reserve(cells.clusters.size());
  for (const hasp::CellCluster& cluster : cells.clusters)
    this->CellCounts.push_back(static_cast<std::uint16_t>(cluster.CellCount()));
  glGenVertexArrays(1, &this->VertexArray); // core profiles draw nothing without one
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

void CellBuffers::Bind(const hasp::ClusterPart& part) const
{
  const auto bind = [](GLuint slot, GLuint buffer, std::size_t from, std::size_t to)
  {
    glBindBufferRange(
      GL_SHADER_STORAGE_BUFFER, slot, buffer, GLintptr(from), GLsizeiptr(to - from));
  };
  bind(0, this->Clusters, part.first * sizeof(hasp::CellCluster),
    part.end * sizeof(hasp::CellCluster));
  bind(1, this->Corners, part.firstWord * sizeof(GLuint), part.endWord * sizeof(GLuint));
}

void CellBuffers::BindVertexArray() const
{
  glBindVertexArray(this->VertexArray);
}

void CellBuffers::Unbind() const
{
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 0, 0);
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 1, 0);
  glBindVertexArray(0);
}

void CellBuffers::Draw(const CellDraws& draws, const std::function<void(const DrawRange&)>& prepare,
  bool inBatches) const
{
  if (draws.ranges.empty())
    return;
  this->BindVertexArray();
  DrawQueue queue;
  std::vector<GLint> firsts;
  std::vector<GLsizei> counts;
  for (const DrawRange& range : draws.ranges)
  {
    firsts.clear();
    counts.clear();
    const int vertices = range.VerticesPerCell();
    for (std::size_t n = range.first; n < range.first + range.count; ++n)
    {
      firsts.push_back(static_cast<GLint>(draws.entries[n] * 512 * vertices));
      counts.push_back(this->CellCounts[range.part.first + draws.entries[n]] * vertices);
    }
    this->Bind(range.part);
    prepare(range);
    const GLsizei batch = inBatches ? BatchCells * vertices : std::numeric_limits<GLsizei>::max();
    for (std::size_t first = 0, end = 0; first < firsts.size(); first = end)
    {
      for (GLsizei sum = 0; end < firsts.size() && sum < batch; ++end)
        sum += counts[end]; // below 2^31 in all: a part has so many vertices at most
      glMultiDrawArrays(range.points ? GL_POINTS : GL_TRIANGLES, firsts.data() + first,
        counts.data() + first, static_cast<GLsizei>(end - first));
      if (inBatches)
        queue.Add();
    }
  }
  this->Unbind();
}
