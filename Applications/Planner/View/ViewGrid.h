#pragma once
#include "View/SliceAxis.h"
#include "View/SliceContours.h"
#include "View/SliceImage.h"

#include <QWidget>

#include <glm/vec3.hpp>

#include <array>
#include <map>
#include <memory>
#include <optional>
#include <vector>

class QSplitter;
class vtkImageData;

namespace hasp
{

class FrameView;
class SceneView;
class SliceView;

/// The four views, linked: 3D, axial, coronal, sagittal. A double click makes one of them fill the
/// space, and again all four come back; the bars between them can be drawn. The crosshair is one
/// place for all of them, slices share window and zoom.
///
/// Their object names are view.scene, view.axial, view.coronal and view.sagittal.
/// Threads: RENDER.
class ViewGrid : public QWidget
{
  Q_OBJECT
public:
  explicit ViewGrid(QWidget* parent = nullptr);
  ~ViewGrid() override;

  SceneView& Scene() { return *this->Space; }
  SliceView& Slice(SliceAxis axis) { return *this->Slices.at(std::size_t(axis)); }

  /// What the slices show; nullptr: nothing. Goes to its middle and a window of bone, or, where the
  /// values are no HU, from the 1st to the 99th percentile. The image is held; what changes in it
  /// is followed: DrawAll.
  void SetImage(vtkImageData* image, bool hounsfield);
  vtkImageData* Image() const;
  ///@{
  /// World mm; clamped into the image.
  void SetCrosshair(const glm::dvec3& place);
  glm::dvec3 Crosshair() const { return this->At; }
  ///@}
  ///@{
  /// Grey values' width and middle.
  void SetWindowLevel(double window, double level);
  double Window() const { return this->Width; }
  double Level() const { return this->Middle; }
  ///@}
  ///@{
  /// Default: visible.
  void SetCrosshairVisible(bool visible);
  bool IsCrosshairVisible() const { return this->CrossVisible; }
  ///@}
  ///@{
  /// Over all three slices: SliceView.h.
  void SetLabels(
    vtkImageData* labels, const std::map<int, glm::dvec3>& colours, double opacity = 0.45);
  void SetContours(const std::vector<SliceContour>& contours);
  void SetIsovalueLine(const std::optional<double>& value);
  ///@}
  ///@{
  /// One of the four; nullptr: four-up. What had the keyboard and is hidden gives it to the view.
  void Maximise(QWidget* view);
  QWidget* Maximised() const { return this->Large; }
  ///@}
  void DrawAll();
  /// No view has a frame to come.
  bool IsSettled() const;

Q_SIGNALS:
  void CrosshairMoved();
  void WindowLevelChanged();
  void CrosshairVisibleChanged(bool visible);
  void MaximisedChanged();

private:
  void LinkSlice(SliceView* slice);
  void ShowInScene(SliceAxis axis, bool shown);
  void PlaceInScene(); ///< the slices that the 3D view shows
  std::array<FrameView*, 4> All() const;

  SceneView* Space;
  std::array<SliceView*, 3> Slices{};
  std::array<QSplitter*, 3> Bars{}; ///< the rows', and the one between them
  std::array<std::unique_ptr<SliceImage>, 3> InSpace;
  vtkSmartPointer<vtkImageData> Shown;
  glm::dvec3 At{ 0.0 };
  double Width = 1000.0, Middle = 400.0;
  bool CrossVisible = true;
  QWidget* Large = nullptr;
};

} // namespace hasp
