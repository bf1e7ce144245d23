#ifndef BorrowedView_h
#define BorrowedView_h

#include "StereoOutput.h"
#include "StereoRig.h"

#include "vtkNew.h"
#include "vtkSmartPointer.h"

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include <vector>

class vtkCamera;
class vtkRenderWindow;
class vtkRenderer;

/// Sets a renderer's camera, and the switches and viewports of its window, aside for a while;
/// brings them back whatever happens. Other layers of its viewport that look through the same
/// camera get the eyes' too. Meanwhile a visible window does not swap. Threads: RENDER.
class BorrowedView
{
public:
  /// The renderer is in a window. `camera`: what the eyes' are like but for their views; their
  /// clipping range is reset to what is visible.
  BorrowedView(vtkRenderer* renderer, vtkCamera* camera);
  ~BorrowedView();
  BorrowedView(const BorrowedView&) = delete;
  BorrowedView& operator=(const BorrowedView&) = delete;

  /// What an eye sees, and where: `grid.size` pixels from the lower left one of the viewport on.
  struct Eye
  {
    hasp::EyeView view;
    hasp::EyeGrid grid;
  };
  /// Before both eyes are drawn: tells mappers what each will see (vtkHaspStereoPair.h), so that
  /// they do for both at once what they can. Without it each frame is one of its own.
  void Announce(const Eye& left, const Eye& right);

  /// Draws one eye. What lies in the renderer's viewport (texts, other layers) is squeezed along.
  void Draw(const hasp::EyeView& view, hasp::StereoEye eye, const hasp::EyeGrid& grid);

  /// From now on a frame swaps again, if the window did before, and viewports are whole.
  void ShowFrames();

  glm::ivec2 Origin() const { return this->origin; } ///< of the viewport, pixels
  glm::ivec2 Size() const { return this->size; }     ///< of the viewport; >= 0

private:
  void Aim(const hasp::EyeView& view, hasp::StereoEye eye, const hasp::EyeGrid& grid);
  void ResetClippingRange();
  glm::dmat4 WorldToClip() const;
  void SetViewports(glm::ivec2 pixels);

  struct Kept
  {
    vtkSmartPointer<vtkRenderer> renderer;
    glm::dvec4 viewport;
  };
  vtkRenderer* renderer;
  vtkRenderWindow* window;
  vtkSmartPointer<vtkCamera> camera, settings;
  vtkNew<vtkCamera> eyeCamera;
  int stereo;
  int swapBuffers;
  std::vector<Kept> kept;                               ///< renderers within the viewport
  std::vector<vtkSmartPointer<vtkRenderer>> throughEye; ///< ours and those that share its camera
  glm::ivec2 origin, size;
};

/// Pixels of a renderer's viewport; at least 1 x 1. Throws std::invalid_argument, saying what is
/// missing: no renderer, no window, no pixels.
glm::ivec2 ViewportSize(vtkRenderer* renderer);

#endif
