#ifndef LightPicture_h
#define LightPicture_h

#include "Light/SceneLightCache.h"

#include "vtkSmartPointer.h"
#include "vtkTextureObject.h"

class vtkOpenGLRenderWindow;

/// What a renderer draws into: its pixels of the window.
struct LightViewport
{
  glm::ivec2 origin{ 0 }, size{ 0 };
  bool Empty() const { return this->size.x < 1 || this->size.y < 1; }
};

/// Depth of what has been drawn in the viewport, [0, 1] a pixel, row by row from the lowest; with
/// several samples a pixel that of one of them, which need not be in its centre. Returns the
/// samples a pixel, at least 1. Threads: RENDER, with the context current.
int ReadDepths(const LightViewport& viewport, std::vector<float>& depths);

/// Draws pictures of light over what was drawn, without touching depth. Threads: RENDER, with the
/// context current. 16 bytes a pixel of texture, from the first picture on, and 4 for what is
/// behind. Both throw std::runtime_error if the GPU has no room.
class LightPicture
{
public:
  /// Added to the coverage of a pixel: what it does not cover shows what is behind, not what was
  /// drawn over that.
  static constexpr float ShowsBehind = 2.0F;

  /// Keeps what the viewport shows now as what is behind: before anything is drawn, the background.
  void KeepBehind(vtkOpenGLRenderWindow* window, const LightViewport& viewport);
  /// picture: radiance times coverage, and coverage. encoded: radiance is linear, and shown as
  /// sRGB; else as it is.
  void Draw(vtkOpenGLRenderWindow* window, const LightViewport& viewport,
    const hasp::LitPicture& picture, float exposure, bool encoded);
  void ReleaseBehind() { this->Behind = nullptr; }
  void Release() { this->Texture = this->Behind = nullptr; }
  std::size_t Bytes() const;

private:
  vtkSmartPointer<vtkTextureObject> Texture, Behind;
};

#endif
