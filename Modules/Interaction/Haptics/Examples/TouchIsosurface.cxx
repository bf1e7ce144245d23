// TouchIsosurface <DICOM folder, .inv3, .mha or .vti> <isovalue>: press its surface on a copy
#include "Devices/SimulatedHapticDevice.h"
#include "HapticExchange.h"
#include "vtkActor.h"
#include "vtkHaspClusteredCellMapper.h"
#include "vtkHaspHapticInteractor.h"
#include "vtkHaspHapticLoop.h"
#include "vtkHaspVolumeReader.h"
#include <iostream>

int main(int argc, char* argv[])
{
  if (argc != 3)
    return 1;
  vtkNew<vtkHaspVolumeReader> reader;
  reader->SetFileName(argv[1]);
  vtkNew<vtkHaspClusteredCellMapper> bone;
  bone->SetInputConnection(reader->GetOutputPort());
  bone->SetIsoValue(std::stod(argv[2]));
  vtkNew<vtkActor> skull, copy;
  skull->SetMapper(bone);
  copy->SetMapper(bone);
  const double* box = skull->GetBounds();
  copy->SetPosition(0.25 * (box[1] - box[0]), 0.0, 0.0); // in each other: that is felt at once
  vtkNew<vtkHaspHapticInteractor> haptic;                // with SetRenderer and UseMouse: a mouse
  haptic->AddTouchable(skull);
  const int tool = haptic->AddTool(copy);
  haptic->SetDevice(std::make_unique<hasp::SimulatedHapticDevice>(
    hasp::SimulatedDeviceSettings{}, hasp::HandIntention(hasp::RigidPose{})));
  std::cerr << "Making distances and points of it: half a minute for a head\n";
  while (haptic->Update(), haptic->GetState() == vtkHaspHapticInteractor::Baking)
    ; // with a window: draw meanwhile
  for (haptic->Start(), haptic->Grab(tool); haptic->GetLoop()->GetSnapshot().contacts == 0;)
    if (haptic->Update(); !haptic->GetLoop()->IsRunning())
      return 1;
  std::cout << haptic->GetLoop()->GetSnapshot().contacts << " points touch\n";
}
