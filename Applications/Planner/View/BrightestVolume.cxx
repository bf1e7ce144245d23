#include "View/BrightestVolume.h"

#include "Model/PlanSession.h"
#include "Model/ScanShelf.h"
#include "View/ScanSurface.h"
#include "View/SceneView.h"
#include "VolumeLook.h"

#include "vtkBoundingBox.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkVolume.h"

#include <QCoreApplication>

namespace hasp
{

BrightestVolume::~BrightestVolume()
{
  this->Release();
}

void BrightestVolume::Release()
{
  this->Image = nullptr;
  this->Refusal.clear();
  if (!this->Shown)
    return;
  vtkRenderer* renderer = this->Of.view.Renderer();
  renderer->GetRenderWindow()->MakeCurrent();
  this->Shown->ReleaseGraphicsResources(renderer->GetRenderWindow());
  renderer->RemoveViewProp(this->Shown);
  this->Shown = nullptr;
}

void BrightestVolume::Make(vtkImageData* image, PlanId volume)
{
  this->Image = image;
  vtkRenderer* renderer = this->Of.view.Renderer();
  renderer->GetRenderWindow()->MakeCurrent(); // what OpenGL can is asked
  this->Refusal = WhyTooLarge(image, renderer);
  const VolumeLook look = UsualLook(this->Of.scans.OfVolume(this->Of.plan.Now(), volume)->passport);
  if (this->Refusal.empty() && !(look.window[0] < look.window[1]))
    this->Refusal = "all values of the scan are the same";
  if (!this->Refusal.empty())
    return this->Of.fault(
      QCoreApplication::translate("PlanScene", "The brightest values cannot be shown: %1.")
        .arg(QString::fromStdString(this->Refusal)));
  this->Shown = MakeBrightest(image, look.window);
  renderer->AddViewProp(this->Shown);
}

bool BrightestVolume::Sync()
{
  vtkImageData* image = this->Of.brightest ? this->Scan.Image() : nullptr;
  if (image == this->Image)
    return false;
  this->Release();
  if (image)
    this->Make(image, this->Scan.Volume());
  return true;
}

void BrightestVolume::AddBounds(vtkBoundingBox& box) const
{
  if (this->Shown)
    box.AddBounds(this->Shown->GetBounds());
}

void BrightestVolume::ListResources(ResourceList& list) const
{
  if (this->Shown)
    list.push_back({ "brightest values, GPU", VolumeBytes(this->Shown), 0.0,
      "asked for; its time is a frame's" });
  else
    list.push_back({ "brightest values, GPU", 0, 0.0,
      !this->Of.brightest      ? "switched off"
      : !this->Refusal.empty() ? this->Refusal
      : this->Scan.Volume()    ? "the scan is not in memory"
                               : "the plan has no scan" });
}

} // namespace hasp
