#include "StorageBuffer.h"

#include "HaspGL.h"

#include <stdexcept>
#include <string>

void StorageBuffer::Upload(const void* data, std::size_t bytes, const char* what)
{
  this->Release();
  if (bytes == 0)
    return;
  for (int old = 0; old < 32 && glGetError() != GL_NO_ERROR; ++old) // somebody else's; a lost
  {                                                                 // context has no end of them
  }
  glGenBuffers(1, &this->Name);
  glBindBuffer(GL_SHADER_STORAGE_BUFFER, this->Name);
  glBufferData(GL_SHADER_STORAGE_BUFFER, static_cast<GLsizeiptr>(bytes), data, GL_STATIC_DRAW);
  glBindBuffer(GL_SHADER_STORAGE_BUFFER, 0);
  this->ByteCount = bytes;
  if (glGetError() == GL_NO_ERROR)
    return;
  this->Release();
  throw std::runtime_error(
    "the GPU has no room for " + std::to_string(bytes >> 10) + " KiB of " + what);
}

void StorageBuffer::Replace(std::size_t from, const void* data, std::size_t bytes)
{
  glBindBuffer(GL_SHADER_STORAGE_BUFFER, this->Name);
  glBufferSubData(
    GL_SHADER_STORAGE_BUFFER, static_cast<GLintptr>(from), static_cast<GLsizeiptr>(bytes), data);
  glBindBuffer(GL_SHADER_STORAGE_BUFFER, 0);
}

void StorageBuffer::Release()
{
  if (this->Name)
    glDeleteBuffers(1, &this->Name);
  *this = {};
}

void StorageBuffer::Bind(unsigned int slot, std::size_t from, std::size_t to) const
{
  glBindBufferRange(
    GL_SHADER_STORAGE_BUFFER, slot, this->Name, GLintptr(from), GLsizeiptr(to - from));
}
