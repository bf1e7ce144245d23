#include "OcclusionCulling.h"

#include "CellBuffers.h"
#include "CellLayout.h"
#include "CellScene.h"
#include "ClusterState.h"
#include "HaspGL.h"
#include "ShaderSlots.h"
#include "vtkHaspClusterBoxFS.h"
#include "vtkHaspClusterBoxVS.h"
#include "vtkHaspClusterCommandsCS.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkOpenGLState.h"
#include "vtkShaderProgram.h"

#include <stdexcept>
#include <string>
#include <utility>

namespace
{

constexpr std::size_t CommandBytes = 4 * sizeof(GLuint);
constexpr std::size_t Pieces = 4;
constexpr std::size_t GroupSize = 128; // of vtkHaspClusterCommandsCS.glsl

/// Where what is bound begins: at a multiple of 64 words, for OpenGL asks for up to 256 bytes.
std::size_t BoundFrom(std::size_t first)
{
  return first / 64 * 64;
}

std::string WithParts(std::string shader)
{
  FillSlot(shader, "CellLayout", CellLayout);
  FillSlot(shader, "ClusterState", ClusterState);
  return shader;
}

unsigned int MakeBuffer(GLenum target, const void* data, std::size_t bytes, GLenum use)
{
  GLuint buffer = 0;
  glGenBuffers(1, &buffer);
  glBindBuffer(target, buffer);
  glBufferData(target, static_cast<GLsizeiptr>(bytes), data, use);
  glBindBuffer(target, 0);
  return buffer;
}

/// VTK's shader cache knows no compute shaders.
unsigned int MakeComputeProgram(const std::string& text)
{
  const GLuint shader = glCreateShader(GL_COMPUTE_SHADER);
  const char* source = text.c_str();
  glShaderSource(shader, 1, &source, nullptr);
  glCompileShader(shader);
  const GLuint program = glCreateProgram();
  glAttachShader(program, shader);
  glLinkProgram(program);
  glDeleteShader(shader); // when the program goes
  GLint linked = 0;
  glGetProgramiv(program, GL_LINK_STATUS, &linked);
  if (linked)
    return program;
  glDeleteProgram(program);
  throw std::runtime_error("the shader that writes draw commands did not compile");
}

} // namespace

void OcclusionCulling::Reset(const hasp::ClusteredCells& cells)
{
  this->Release();
  const std::size_t count = cells.clusters.size();
  if (count == 0)
    return;
  std::vector<std::uint32_t> states;
  states.reserve(count);
  for (const hasp::CellCluster& cluster : cells.clusters)
    states.push_back(hasp::UnseenState(cluster));
  this->CommandProgram = MakeComputeProgram(WithParts(vtkHaspClusterCommandsCS));
  const std::size_t words = count * sizeof(GLuint);
  this->States = MakeBuffer(GL_SHADER_STORAGE_BUFFER, states.data(), words, GL_DYNAMIC_COPY);
  this->Order = MakeBuffer(GL_SHADER_STORAGE_BUFFER, nullptr, words, GL_STREAM_DRAW);
  this->Commands =
    MakeBuffer(GL_DRAW_INDIRECT_BUFFER, nullptr, count * CommandBytes, GL_DYNAMIC_COPY);
  this->ByteCount = 2 * words + count * CommandBytes;
  if (glGetError() != GL_NO_ERROR)
  {
    this->Release();
    throw std::runtime_error("the GPU has no room for the state of its clusters");
  }
}

void OcclusionCulling::Release()
{
  for (unsigned int* buffer : { &this->States, &this->Order, &this->Commands })
    if (*buffer)
      glDeleteBuffers(1, buffer);
  if (this->CommandProgram)
    glDeleteProgram(this->CommandProgram);
  *this = {};
}

int OcclusionCulling::ViewerOf(const Frame& frame)
{
  for (std::size_t v = 0; v < this->Viewers.size(); ++v)
    if (this->Viewers[v].renderer == frame.renderer && this->Viewers[v].actor == frame.actor)
      return static_cast<int>(v);
  const std::size_t viewer = this->NextViewer++ % hasp::glsl::HaspViewers;
  this->Viewers.resize(std::max(this->Viewers.size(), viewer + 1));
  this->Viewers[viewer] = { frame.renderer, frame.actor, false };
  return static_cast<int>(viewer); // what its forerunner saw is a guess like any other
}

void OcclusionCulling::Draw(const Frame& frame)
{
  const CellDraws& draws = frame.draws;
  if (draws.ranges.empty())
    return;
  glBindBuffer(GL_SHADER_STORAGE_BUFFER, this->Order);
  glBufferSubData(GL_SHADER_STORAGE_BUFFER, 0,
    static_cast<GLsizeiptr>(draws.entries.size() * sizeof(GLuint)), draws.entries.data());
  glBindBuffer(GL_SHADER_STORAGE_BUFFER, 0);
  frame.buffers.BindVertexArray();

  const int viewer = this->ViewerOf(frame);
  const bool followsLeft = std::exchange(this->Viewers[viewer].leftEye, frame.leftEye);
  const bool second = followsLeft && !frame.leftEye;
  for (const DrawRange& range : draws.ranges)
    this->WriteCommands(frame, range, viewer, false, second);
  for (const DrawRange& range : draws.ranges)
    this->DrawCells(frame, range);
  for (std::size_t piece = 0; piece < Pieces; ++piece)
  {
    for (const DrawRange& range : draws.ranges)
      this->TestBoxes(frame, range.Piece(piece, Pieces), viewer);
    for (const DrawRange& range : draws.ranges)
      this->WriteCommands(frame, range.Piece(piece, Pieces), viewer, true);
    for (const DrawRange& range : draws.ranges)
      this->DrawCells(frame, range.Piece(piece, Pieces));
  }
  for (GLuint slot = 2; slot < 5; ++slot)
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, slot, 0);
  frame.buffers.Unbind();
}

void OcclusionCulling::Bind(const Frame& frame, const DrawRange& range) const
{
  const auto bind =
    [](GLuint slot, GLuint buffer, std::size_t from, std::size_t to, std::size_t size)
  {
    glBindBufferRange(GL_SHADER_STORAGE_BUFFER, slot, buffer, static_cast<GLintptr>(from * size),
      static_cast<GLsizeiptr>((to - from) * size));
  };
  const std::size_t first = BoundFrom(range.first), end = range.first + range.count;
  frame.buffers.Bind(range.part);
  bind(2, this->States, BoundFrom(range.part.first), range.part.end, sizeof(GLuint));
  bind(3, this->Order, first, end, sizeof(GLuint));
  bind(4, this->Commands, first, end, CommandBytes);
}

void OcclusionCulling::WriteCommands(
  const Frame& frame, const DrawRange& range, int viewer, bool late, bool keep) const
{
  if (range.count == 0)
    return;
  this->Bind(frame, range);
  frame.window->GetShaderCache()->ReleaseCurrentShader(); // VTK must not take it for still bound
  const GLuint program = this->CommandProgram;
  glUseProgram(program);
  const auto set = [program](const char* name, std::size_t value)
  { glUniform1i(glGetUniformLocation(program, name), static_cast<GLint>(value)); };
  set("firstEntry", range.first - BoundFrom(range.first));
  set("entryCount", range.count);
  set("firstCluster", range.part.first - BoundFrom(range.part.first));
  set("verticesPerCell", range.VerticesPerCell());
  set("viewer", viewer);
  set("late", late);
  set("keep", keep);
  glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT); // what the boxes' fragments wrote
  // A range is of one part: below 2^31 / 3072 clusters, so 5462 groups; OpenGL promises 65535.
  glDispatchCompute(static_cast<GLuint>((range.count + GroupSize - 1) / GroupSize), 1, 1);
  glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_COMMAND_BARRIER_BIT);
  glUseProgram(0);
}

void OcclusionCulling::TestBoxes(const Frame& frame, const DrawRange& range, int viewer) const
{
  if (range.count == 0)
    return;
  static const std::string vertex = WithParts(vtkHaspClusterBoxVS),
                           fragment = WithParts(vtkHaspClusterBoxFS);
  vtkShaderProgram* program =
    frame.window->GetShaderCache()->ReadyShaderProgram(vertex.c_str(), fragment.c_str(), "");
  if (!program)
    throw std::runtime_error("the shaders of the clusters' boxes did not compile");
  frame.scene.SetBoxUniforms(program);
  program->SetUniformi(
    "firstCluster", static_cast<int>(range.part.first - BoundFrom(range.part.first)));
  program->SetUniformi("viewer", viewer);
  this->Bind(frame, range);
  vtkOpenGLState* state = frame.window->GetState();
  vtkOpenGLState::ScopedglDepthMask depthMask(state);
  vtkOpenGLState::ScopedglColorMask colorMask(state);
  state->vtkglDepthMask(GL_FALSE);
  state->vtkglColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  glDrawArrays(GL_TRIANGLES, static_cast<GLint>((range.first - BoundFrom(range.first)) * 18),
    static_cast<GLsizei>(range.count * 18));
}

void OcclusionCulling::DrawCells(const Frame& frame, const DrawRange& range) const
{
  if (range.count == 0)
    return;
  frame.ready();
  frame.buffers.Bind(range.part);
  frame.prepare(range);
  glBindBuffer(GL_DRAW_INDIRECT_BUFFER, this->Commands);
  glMultiDrawArraysIndirect(range.points ? GL_POINTS : GL_TRIANGLES,
    reinterpret_cast<const void*>(range.first * CommandBytes), static_cast<GLsizei>(range.count),
    0);
  glBindBuffer(GL_DRAW_INDIRECT_BUFFER, 0);
}
