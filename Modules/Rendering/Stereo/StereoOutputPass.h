#ifndef StereoOutputPass_h
#define StereoOutputPass_h

#include "LensTable.h"
#include "StereoOutput.h"

#include "vtkOpenGLFramebufferObject.h"
#include "vtkSmartPointer.h"
#include "vtkTextureObject.h"

#include <array>
#include <cstddef>

class vtkOpenGLRenderWindow;

/// Part of a window: the lower left pixel, and pixels.
struct PixelRectangle
{
  glm::ivec2 origin{ 0 };
  glm::ivec2 size{ 1 };
};

/// The eyes' pictures of one window as textures, and the pass that puts them together in it.
/// 4 bytes a pixel an eye, and lens tables of 8 or 24. Threads: RENDER, with the context current.
class StereoOutputPass
{
public:
  ~StereoOutputPass() { this->Release(); }

  /// Keeps what was just drawn (of several samples a pixel, their mean) as an eye's picture.
  /// Throws std::runtime_error if there is no room.
  void Keep(vtkOpenGLRenderWindow* window, hasp::StereoEye eye, const PixelRectangle& drawn);

  /// Draws the output over `target` of the window's frame. An eye that was not kept is the other.
  /// Throws std::runtime_error if the shader does not compile.
  void Compose(
    vtkOpenGLRenderWindow* window, const hasp::StereoOutput& output, const PixelRectangle& target);

  /// The tables that later outputs are drawn with; empty ones: none.
  void SetLenses(const std::array<hasp::LensTable, 2>& lenses);

  void ForgetPicture(hasp::StereoEye eye);
  void Release();
  std::size_t PictureBytes() const;
  std::size_t LensBytes() const;

private:
  struct Eye
  {
    vtkSmartPointer<vtkOpenGLFramebufferObject> Picture;
    vtkSmartPointer<vtkTextureObject> Lens;
    hasp::LensTable Table;
    glm::ivec2 Size{ 0 };
  };
  void FollowContext(vtkOpenGLRenderWindow* window);
  void UploadLens(vtkOpenGLRenderWindow* window, Eye& eye);

  std::array<Eye, 2> Eyes;
  vtkMTimeType ContextTime = 0; ///< of the context that all of it belongs to
};

#endif
