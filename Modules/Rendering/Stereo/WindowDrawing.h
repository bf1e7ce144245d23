#ifndef WindowDrawing_h
#define WindowDrawing_h

#include "SceneFollower.h"
#include "StereoOutputPass.h"
#include "StereoWindow.h"

#include "vtkRenderWindow.h"
#include "vtkWeakPointer.h"

#include <glm/mat4x4.hpp>

#include <array>
#include <memory>
#include <optional>
#include <string>

class BorrowedView;
class vtkOpenGLRenderWindow;
class vtkRenderer;

/// What all windows of a scene share: where the viewer is, and how the scene's camera looks.
struct ViewedScene
{
  vtkRenderer* renderer = nullptr;
  hasp::StereoHead head{};       ///< in the room
  glm::dmat4 roomToWorld{ 1.0 }; ///< read where a window has a screen or a display
  double eyeAngle = 2.0;         ///< of windows without
};

/// Draws one window of vtkHaspStereoWindows, and keeps what that takes. Throws std::runtime_error
/// and std::invalid_argument. Threads: RENDER.
class WindowDrawing
{
public:
  WindowDrawing(vtkRenderWindow* window, const hasp::StereoWindow& settings);

  vtkRenderWindow* Window() const { return this->Shown; } ///< null when it is gone
  const hasp::StereoWindow& Settings() const { return this->Set; }
  void ChangeSettings(const hasp::StereoWindow& settings);

  void Draw(const ViewedScene& scene);
  /// After Draw: lets go of what VTK would take for another window's (WindowTextures.h).
  void Leave(const ViewedScene& scene);
  /// A place in an eye's view.
  struct Position
  {
    hasp::StereoEye eye;
    glm::dvec2 device;          ///< (-1,-1) lower left, (1,1) upper right
    glm::dvec3 origin, through; ///< of its ray in the world: the eye, and a point seen there
  };
  /// What a pixel shows; none where there is nothing to see. of: where it is for that eye, whosever
  /// pixel it is and even outside of the window.
  std::optional<Position> FindPosition(
    const ViewedScene& scene, glm::ivec2 pixel, std::optional<hasp::StereoEye> of = {});

  const StereoOutputPass& Pass() const { return this->Output; }
  double SecondEyeMilliseconds() const { return this->SecondEye; }
  /// True for the first of equal messages after another or none ("").
  bool IsNews(const std::string& error);

private:
  vtkRenderer* RendererFor(const ViewedScene& scene);
  std::array<hasp::EyeView, 2> Views(const ViewedScene& scene, glm::ivec2 size) const;
  void DrawEyes(
    vtkOpenGLRenderWindow* window, BorrowedView& view, const std::array<hasp::EyeView, 2>& views);
  void UpdateLenses(const std::array<hasp::EyeView, 2>& views, glm::ivec2 eyeSize);
  void ShowQuadBuffers(vtkOpenGLRenderWindow* window, const PixelRectangle& target);

  vtkWeakPointer<vtkRenderWindow> Shown;
  hasp::StereoWindow Set;
  std::unique_ptr<SceneFollower> Follower; ///< none where the scene's renderer is in the window
  StereoOutputPass Output;
  glm::ivec2 LensSize{ 0 }; ///< of the tables of Output
  glm::dvec2 LensAspects{ 0.0 };
  double SecondEye = 0.0;
  std::string LastError;
};

#endif
