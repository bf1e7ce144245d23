#include "TracedCells.h"

#include "CellLight.h"
#include "CellScene.h"
#include "CellTracing.h"
#include "HaspGL.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"

#include <chrono>
#include <stdexcept>

namespace
{
void Fill(vtkSmartPointer<vtkTextureObject>& texture, vtkOpenGLRenderWindow* window,
  const glm::ivec2& size, int components, int type, const void* data)
{
  if (!texture)
    texture = vtkSmartPointer<vtkTextureObject>::New();
  texture->SetContext(window);
  texture->SetMinificationFilter(vtkTextureObject::Nearest);
  texture->SetMagnificationFilter(vtkTextureObject::Nearest);
  if (type == VTK_UNSIGNED_INT)
  {
    texture->SetInternalFormat(GL_R32UI);
    texture->SetFormat(GL_RED_INTEGER);
    texture->SetDataType(GL_UNSIGNED_INT);
  }
  if (!texture->Create2DFromRaw(static_cast<unsigned int>(size.x),
        static_cast<unsigned int>(size.y), components, type, const_cast<void*>(data)))
    throw std::runtime_error("the GPU has no room for the traced picture");
}
}

TracedCells::TracedCells() = default;
TracedCells::~TracedCells() = default;
TracedCells& TracedCells::operator=(TracedCells&&) = default;

void TracedCells::UploadLight(
  vtkOpenGLRenderWindow* window, const CellTracing& tracing, const CellLight* light)
{
  if (!light)
  {
    this->Light = nullptr;
    this->LightByteCount = 0;
    this->LightTime = 0;
  }
  else if (light->PictureTime() != this->LightTime)
  {
    const vtkOpenGLState::ScopedglActiveTexture unit(window->GetState());
    this->LightTime = 0;
    Fill(
      this->Light, window, tracing.Picture().size, 2, VTK_UNSIGNED_CHAR, light->Picture().data());
    this->LightByteCount = light->PictureBytes();
    this->LightTime = light->PictureTime();
  }
}

void TracedCells::Upload(
  vtkOpenGLRenderWindow* window, const CellTracing& tracing, bool selection, const CellLight* light)
{
  const hasp::TracedPicture& picture = tracing.Picture();
  const bool there = this->PictureTime == tracing.PictureTime();
  if (picture.cells.empty())
    return;
  this->UploadLight(window, tracing, light);
  if (there && (this->Numbers || !selection))
    return;
  const auto start = std::chrono::steady_clock::now();
  vtkOpenGLState::ScopedglActiveTexture unit(window->GetState());
  this->PictureTime = 0; // if there is no room there is none
  if (!there)
  {
    this->Milliseconds = 0.0;
    this->Numbers = nullptr;
    Fill(this->Gradients, window, picture.size, 4, VTK_FLOAT, picture.gradients.data());
    this->ByteCount = picture.gradients.size() * sizeof(picture.gradients[0]);
  }
  if (selection)
  {
    Fill(this->Numbers, window, picture.size, 1, VTK_UNSIGNED_INT, picture.cells.data());
    this->ByteCount += picture.cells.size() * sizeof(picture.cells[0]);
  }
  if (this->VertexArray == 0)
    glGenVertexArrays(1, &this->VertexArray);
  this->PictureTime = tracing.PictureTime();
  const std::chrono::duration<double, std::milli> spent = std::chrono::steady_clock::now() - start;
  this->Milliseconds += spent.count();
}

void TracedCells::Draw(
  vtkShaderProgram* program, const CellTracing& tracing, const CellScene& scene) const
{
  const hasp::TracedPicture& picture = tracing.Picture();
  if (picture.cells.empty())
    return;
  const glm::ivec2 firstPixel = scene.viewportOrigin + tracing.Origin();
  const glm::vec2 size(scene.viewportSize);
  const glm::vec2 low = 2.0F * glm::vec2(tracing.Origin()) / size - 1.0F;
  const glm::vec2 high = 2.0F * glm::vec2(tracing.Origin() + picture.size) / size - 1.0F;
  const float rectangle[4] = { low.x, low.y, high.x, high.y };
  program->SetUniform4f("rectangle", rectangle);
  program->SetUniform2i("firstPixel", &firstPixel.x);
  vtkOpenGLState::ScopedglActiveTexture unit(this->Gradients->GetContext()->GetState());
  this->Gradients->Activate();
  program->SetUniformi("gradients", this->Gradients->GetTextureUnit());
  if (this->Numbers)
  {
    this->Numbers->Activate();
    program->SetUniformi("numbers", this->Numbers->GetTextureUnit());
  }
  if (this->Light)
  {
    this->Light->Activate();
    program->SetUniformi("light", this->Light->GetTextureUnit());
  }
  glBindVertexArray(this->VertexArray);
  glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
  glBindVertexArray(0);
  this->Gradients->Deactivate();
  if (this->Numbers)
    this->Numbers->Deactivate();
  if (this->Light)
    this->Light->Deactivate();
}

void TracedCells::Release()
{
  if (this->VertexArray)
    glDeleteVertexArrays(1, &this->VertexArray);
  *this = {};
}
