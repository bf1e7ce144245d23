// TouchIsosurface <DICOM folder, .inv3, .mha or .vti> <isovalue> <radius>: press a ball on it
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
  if (argc != 4)
    return 1;
  vtkNew<vtkHaspVolumeReader> reader;
  reader->SetFileName(argv[1]);
  vtkNew<vtkHaspClusteredCellMapper> bone;
  bone->SetInputConnection(reader->GetOutputPort());
  bone->SetIsoValue(std::stod(argv[2]));
  vtkNew<vtkActor> skull, ball;
  skull->SetMapper(bone);
  vtkNew<vtkSphereSource> sphere;
  sphere->SetRadius(std::stod(argv[3]));
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(sphere->GetOutputPort());
  ball->SetMapper(mapper);
  const double* box = skull->GetBounds();
  const double at[3] = { box[1], 0.5 * (box[2] + box[3]), 0.5 * (box[4] + box[5]) };
  ball->SetPosition(at[0], at[1], at[2]);
  vtkNew<vtkHaspHapticInteractor> haptic; // with SetRenderer and UseMouse: a mouse
  haptic->AddTouchable(skull);
  const int tool = haptic->AddTool(ball);
  haptic->SetDevice(std::make_unique<hasp::SimulatedHapticDevice>(
    hasp::SimulatedDeviceSettings{}, hasp::HandIntention({ { at[0], at[1], at[2] } })));
  while (haptic->Update(), haptic->GetState() == vtkHaspHapticInteractor::Baking)
    ; // with a window: draw meanwhile
  for (haptic->Start(), haptic->Grab(tool); haptic->GetLoop()->GetSnapshot().ticks < 1000;)
    if (haptic->Update(); !haptic->GetLoop()->IsRunning())
      return 1; // nothing is there to be touched
  std::cout << haptic->GetLoop()->GetSnapshot().contacts << " points touch\n";
}
