#include "PictureFile.h"

#include "Failure.h"
#include "VtkMessages.h"

#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPNGWriter.h"
#include "vtkRenderWindow.h"
#include "vtkUnsignedCharArray.h"
#include "vtkWindowToImageFilter.h"

namespace hasp
{

std::string PngFile(vtkImageData* picture)
{
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputData(picture);
  writer->WriteToMemoryOn();
  writer->Write();
  ThrowVtkError(ExitCode::CannotDraw, "cannot encode the picture");
  vtkUnsignedCharArray* bytes = writer->GetResult();
  return { reinterpret_cast<const char*>(bytes->GetPointer(0)),
    static_cast<std::size_t>(bytes->GetNumberOfValues()) };
}

vtkSmartPointer<vtkImageData> WindowPicture(vtkRenderWindow* window)
{
  vtkNew<vtkWindowToImageFilter> read;
  read->SetInput(window);
  read->SetInputBufferTypeToRGB();
  read->ReadFrontBufferOff();
  read->ShouldRerenderOff();
  read->Update();
  return read->GetOutput();
}

} // namespace hasp
