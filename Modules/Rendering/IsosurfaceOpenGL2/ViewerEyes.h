#ifndef ViewerEyes_h
#define ViewerEyes_h

#include "CacheProgress.h"
#include "DrawingChoice.h"

#include "vtkWeakPointer.h"

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>

#include <memory>
#include <optional>
#include <vector>

class vtkActor;
class vtkRenderer;

/// An eye that looks at a mapper: a vtkRenderer, or one of its two in stereo, by an actor of the
/// mapper, for each shows it at another place; and what is kept of it from one frame to the next.
/// Which of the two it is the camera's LeftEye says, while a renderer draws: VTK's stereo sets it,
/// and rigs that draw each eye as a frame of its own do (Rendering/Stereo, DrawnEye). Threads:
/// RENDER.
class ViewerEye
{
public:
  ViewerEye(vtkRenderer* renderer, vtkActor* actor, bool left, int number);
  ~ViewerEye();
  ViewerEye(const ViewerEye&) = delete;
  ViewerEye& operator=(const ViewerEye&) = delete;

  bool Is(vtkRenderer* renderer, vtkActor* actor, bool left) const;
  bool Lost() const;
  /// Of the same renderer and actor.
  bool IsBeside(const ViewerEye& other) const;
  bool IsLeft() const { return this->Left; }
  /// Has it been drawn in its renderer's last frame? A frame in stereo begins twice.
  bool IsDrawn(bool stereo) const;
  void IsDrawnNow();
  /// Is this the first call since the renderer has begun a frame? A translucent actor is drawn
  /// several times in one.
  bool BeginsFrame();

  DrawingChoice Choice;
  CacheProgress Progress;
  long long Turn = 0; ///< of all eyes' frames, the number of its last

  /// The matrix that would come next if the camera moved on as it did between the last two frames,
  /// seen a little wider; none where it has not moved or nothing is known.
  std::optional<glm::dmat4> Predict(const glm::dmat4& indexToClip) const;
  /// What this eye sees if the other one, drawn before it, sees indexToClip now and both moved
  /// together since their last frames; none where one has had no frame.
  std::optional<glm::dmat4> Beside(const ViewerEye& other, const glm::dmat4& indexToClip) const;
  void Moved(const glm::dmat4& indexToClip) { this->Last = indexToClip; }

  /// Reads the depth of a part of the framebuffer that is drawn to, of one sample where a pixel has
  /// several; leaves none where there is no depth.
  void ReadDepth(const glm::ivec2& origin, const glm::ivec2& size);
  /// Of the last frame; empty if its picture had another size.
  const std::vector<float>& Depth(const glm::ivec2& size);
  /// Of that picture; 0 if there is none.
  const glm::ivec2& GetDepthSize() const { return this->DepthSize; }

  void ForgetDepth() { this->DepthPixels = {}; }
  /// All but the choice.
  void Forget();
  std::size_t DepthBytes() const { return this->DepthPixels.size() * sizeof(float); }

  const int Number;         ///< of the eye, from 0
  long long ServedTurn = 0; ///< of the other eye's frame that cast rays for one of this eye, too
  bool Changed = false;     ///< the surface was another one in its last frame than in those before

private:
  class FrameObserver;
  std::unique_ptr<FrameObserver, void (*)(FrameObserver*)> Observer;
  vtkWeakPointer<vtkActor> Actor;
  bool Left;
  std::optional<glm::dmat4> Last;
  glm::ivec2 DepthSize{ 0 };
  std::vector<float> DepthPixels;
};

/// All eyes that look at a mapper.
class ViewerEyes
{
public:
  /// begins: a frame of it, nothing of which is drawn yet.
  ViewerEye& Of(vtkRenderer* renderer, vtkActor* actor, bool& begins);
  /// The right eye that follows this left one: its renderer's last frame was of it. Else null.
  ViewerEye* SecondOf(const ViewerEye& first);
  /// The left eye that this right one follows, whose choice is for both; else the eye itself.
  ViewerEye& FirstOf(ViewerEye& eye) const;
  std::size_t Bytes() const;
  void Forget();
  void ForgetChoices();
  void Unfill();
  /// Is any that is still drawn refining?
  bool Refining() const;
  /// What any may ask for in a later frame.
  DrawingChoice::Frame MayDraw() const;

private:
  std::vector<std::unique_ptr<ViewerEye>> Eyes;
  long long Turns = 0;
};

#endif
