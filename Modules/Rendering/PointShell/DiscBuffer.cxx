#include "DiscBuffer.h"

#include "HaspGL.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkShaderProgram.h"
#include "vtkTextureUnitManager.h"

#include <algorithm>
#include <cstring>
#include <stdexcept>
#include <string>
#include <utility>

namespace
{
constexpr std::size_t Block = 256; // discs: 8 KiB
}

void DiscBuffer::Allocate(std::size_t count)
{
  GLint texels = 0;
  glGetIntegerv(GL_MAX_TEXTURE_BUFFER_SIZE, &texels);
  const std::size_t most = static_cast<std::size_t>(texels) / 2;
  if (count > most)
    throw std::runtime_error("this OpenGL draws " + std::to_string(most) + " discs at most, not " +
                             std::to_string(count) + "; draw fewer levels");
  this->Release();
  for (int old = 0; old < 32 && glGetError() != GL_NO_ERROR; ++old) // somebody else's; a lost
  {                                                                 // context has no end of them
  }
  glGenBuffers(1, &this->Buffer);
  glGenVertexArrays(1, &this->Array);                 // core profiles draw nothing without one
  this->Capacity = std::min(count + count / 4, most); // a dynamic shell's number varies
  glBindBuffer(GL_TEXTURE_BUFFER, this->Buffer);
  glBufferData(GL_TEXTURE_BUFFER, static_cast<GLsizeiptr>(this->Bytes()), nullptr, GL_DYNAMIC_DRAW);
  if (glGetError() == GL_NO_ERROR)
    return;
  const std::size_t bytes = this->Bytes();
  glBindBuffer(GL_TEXTURE_BUFFER, 0);
  this->Release();
  throw std::runtime_error(
    "the GPU has no room for " + std::to_string(bytes >> 10) + " KiB of discs; draw fewer levels");
}

void DiscBuffer::Upload(std::shared_ptr<const Discs> discs)
{
  if (discs == this->Held)
    return;
  if (discs->size() > this->Capacity)
    this->Allocate(discs->size());
  glBindBuffer(GL_TEXTURE_BUFFER, this->Buffer);
  const std::size_t count = discs->size(), known = this->Held ? this->Held->size() : 0;
  const auto same = [&](std::size_t first)
  {
    const std::size_t end = std::min(first + Block, count);
    return end <= known && std::memcmp(discs->data() + first, this->Held->data() + first,
                             (end - first) * sizeof(hasp::ShellDisc)) == 0;
  };
  this->Uploaded = 0;
  for (std::size_t first = 0; first < count;)
  {
    std::size_t end = first;
    while (end < count && !same(end))
      end = std::min(end + Block, count);
    if (end > first)
      glBufferSubData(GL_TEXTURE_BUFFER, static_cast<GLintptr>(first * sizeof(hasp::ShellDisc)),
        static_cast<GLsizeiptr>((end - first) * sizeof(hasp::ShellDisc)), discs->data() + first);
    this->Uploaded += end - first;
    first = end + Block; // that block is the same, or past the end
  }
  glBindBuffer(GL_TEXTURE_BUFFER, 0);
  this->Held = std::move(discs);
}

void DiscBuffer::Bind(vtkOpenGLRenderWindow* window, vtkShaderProgram* program, bool withBits)
{
  constexpr GLenum formats[] = { GL_RGBA32F, GL_RGBA32UI };
  constexpr const char* names[] = { "discs", "discBits" };
  for (int n = 0; n < (withBits ? 2 : 1); ++n)
  {
    this->Units[n] = window->GetTextureUnitManager()->Allocate();
    if (this->Units[n] < 0)
    {
      this->Unbind(window); // the one before
      throw std::runtime_error("no texture unit is free for the discs");
    }
    window->GetState()->vtkglActiveTexture(GL_TEXTURE0 + this->Units[n]);
    const bool made = this->Textures[n] != 0;
    if (!made)
      glGenTextures(1, &this->Textures[n]);
    glBindTexture(GL_TEXTURE_BUFFER, this->Textures[n]);
    if (!made)
      glTexBuffer(GL_TEXTURE_BUFFER, formats[n], this->Buffer);
    program->SetUniformi(names[n], this->Units[n]);
  }
}

void DiscBuffer::Unbind(vtkOpenGLRenderWindow* window)
{
  for (int& unit : this->Units)
    if (unit >= 0)
    {
      window->GetState()->vtkglActiveTexture(GL_TEXTURE0 + unit);
      glBindTexture(GL_TEXTURE_BUFFER, 0);
      window->GetTextureUnitManager()->Free(unit);
      unit = -1;
    }
}

void DiscBuffer::Draw() const
{
  glBindVertexArray(this->Array);
  glDrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(6 * this->Held->size()));
  glBindVertexArray(0);
}

void DiscBuffer::Release()
{
  glDeleteTextures(2, this->Textures); // 0 is nothing
  glDeleteBuffers(1, &this->Buffer);
  glDeleteVertexArrays(1, &this->Array);
  *this = {};
}
