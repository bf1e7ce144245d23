#include "PictureFiles.h"

#include "vtkImageData.h"
#include "vtkImageDifference.h"
#include "vtkNew.h"
#include "vtkPNGReader.h"
#include "vtkPNGWriter.h"
#include "vtkRenderWindow.h"
#include "vtkUnsignedCharArray.h"

#include <cstring>
#include <stdexcept>
#include <string>

namespace hasp
{
namespace
{

vtkSmartPointer<vtkImageData> MakeVTKImage(const RGBPicture& picture)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(picture.width, picture.height, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  std::memcpy(image->GetScalarPointer(), picture.pixels.data(), picture.pixels.size());
  return image;
}

} // namespace

RGBPicture ReadPNG(const std::filesystem::path& file)
{
  if (!std::filesystem::is_regular_file(file))
    throw std::runtime_error("no such picture: " + file.string());
  vtkNew<vtkPNGReader> reader;
  if (!reader->CanReadFile(file.c_str()))
    throw std::runtime_error("not a PNG file: " + file.string());
  reader->SetFileName(file.c_str());
  reader->Update();
  vtkImageData* image = reader->GetOutput();
  const int components = image->GetNumberOfScalarComponents();
  if (reader->GetErrorCode() != 0 || !image->GetScalarPointer() ||
      image->GetScalarType() != VTK_UNSIGNED_CHAR || (components != 3 && components != 4))
    throw std::runtime_error("not a picture of 8-bit RGB or RGBA, or cut short: " + file.string());

  RGBPicture picture(image->GetDimensions()[0], image->GetDimensions()[1]);
  const auto* from = static_cast<const std::uint8_t*>(image->GetScalarPointer());
  for (std::size_t p = 0; p < picture.pixels.size() / 3; ++p)
    std::memcpy(&picture.pixels[3 * p], from + p * components, 3);
  return picture;
}

void WritePNG(const RGBPicture& picture, const std::filesystem::path& file)
{
  if (file.has_parent_path())
    std::filesystem::create_directories(file.parent_path());
  vtkNew<vtkPNGWriter> writer;
  writer->SetFileName(file.c_str());
  writer->SetInputData(MakeVTKImage(picture));
  writer->Write();
  if (writer->GetErrorCode() != 0 || !std::filesystem::is_regular_file(file))
    throw std::runtime_error("cannot write " + file.string());
}

RGBPicture GrabWindow(vtkRenderWindow* window)
{
  if (window->GetNeverRendered())
    window->Render();
  const int* size = window->GetSize();
  RGBPicture picture(size[0], size[1]);
  vtkNew<vtkUnsignedCharArray> pixels;
  constexpr int front = 1; // the finished frame
  if (window->GetPixelData(0, 0, size[0] - 1, size[1] - 1, front, pixels) != VTK_OK ||
      pixels->GetNumberOfValues() != static_cast<vtkIdType>(picture.pixels.size()))
    throw std::runtime_error("no pixels can be read from the window: is there OpenGL?");
  std::memcpy(picture.pixels.data(), pixels->GetPointer(0), picture.pixels.size());
  return picture;
}

double MeasureAsVTKDoes(const RGBPicture& got, const RGBPicture& expected)
{
  vtkNew<vtkImageDifference> difference;
  difference->SetInputData(MakeVTKImage(got));
  difference->SetImageData(MakeVTKImage(expected));
  difference->Update();
  return difference->GetThresholdedError();
}

} // namespace hasp
