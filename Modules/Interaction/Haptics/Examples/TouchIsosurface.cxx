// TouchIsosurface <DICOM folder, .inv3, .mha or .vti> <isovalue>: press a ball on it
#include "Devices/SimulatedHapticDevice.h"
#include "HapticExchange.h"
#include "vtkActor.h"
#include "vtkHaspClusteredCellMapper.h"
#include "vtkHaspHapticInteractor.h"
#include "vtkHaspHapticLoop.h"
#include "vtkHaspVolumeReader.h"
#include "vtkPolyDataMapper.h"
#include "vtkSphereSource.h"
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
  vtkNew<vtkActor> skull, ball;
  skull->SetMapper(bone);
  vtkNew<vtkSphereSource> sphere;
  sphere->SetRadius(5.0);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(sphere->GetOutputPort());
  ball->SetMapper(mapper);
  const double *box = skull->GetBounds(), *middle = skull->GetCenter();
  const double x = 0.5 * (box[1] + middle[0]); // in it, as the hand is
  ball->SetPosition(x, middle[1], middle[2]);
  vtkNew<vtkHaspHapticInteractor> haptic; // with SetRenderer and UseMouse: a mouse
  haptic->AddTouchable(skull);
  const int tool = haptic->AddTool(ball);
  haptic->SetDevice(std::make_unique<hasp::SimulatedHapticDevice>(
    hasp::SimulatedDeviceSettings{}, hasp::HandIntention({ { x, middle[1], middle[2] } })));
  while (haptic->Update(), haptic->GetState() == vtkHaspHapticInteractor::Baking)
    ; // with a window: draw meanwhile
  for (haptic->Start(), haptic->Grab(tool); haptic->GetLoop()->GetSnapshot().contacts == 0;)
    if (haptic->Update(); !haptic->GetLoop()->IsRunning())
      return 1;
  std::cout << haptic->GetLoop()->GetSnapshot().contacts << " points touch\n";
}
