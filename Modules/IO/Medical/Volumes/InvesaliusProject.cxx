#include "Files/SafeArchive.h"
#include "Files/Words.h"
#include "Volumes/VolumeFormat.h"

#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkXMLDataElement.h"
#include "vtkXMLDataParser.h"

#include <glm/common.hpp>
#include <glm/vector_relational.hpp>

#include <algorithm>
#include <optional>
#include <sstream>

// An InVesalius 3 project is a gzipped tar with one folder of property lists (XML) and raw arrays.
// main.plist names the samples' file; they are int16, little-endian, [z][y][x]. x runs to the
// patient's left, z to superior, but rows are stored bottom-up: y runs to ANTERIOR. They are turned
// here, so that the image has the identity as direction. The file knows no position: the first
// sample becomes the world's origin.
namespace hasp
{
namespace
{

constexpr std::size_t PropertyListLimit = 1 << 20;

struct Matrix
{
  std::string fileName;
  glm::ivec3 dims{ 0 };
};

/// Leaves out what lies deeper than a property list goes: VTK's elements end each other in turn, so
/// that a hundred thousand of them overrun the stack.
class ShallowParser : public vtkXMLDataParser
{
public:
  static ShallowParser* New() { VTK_STANDARD_NEW_BODY(ShallowParser); }
  bool WasDeep() const { return this->Deep; }

protected:
  void StartElement(const char* name, const char** attributes) override
  {
    if (++this->Depth <= Deepest)
      vtkXMLDataParser::StartElement(name, attributes);
    else
      this->Deep = true;
  }
  void EndElement(const char* name) override
  {
    if (this->Depth-- <= Deepest)
      vtkXMLDataParser::EndElement(name);
  }

private:
  static constexpr int Deepest = 32; // InVesalius writes four
  int Depth = 0;
  bool Deep = false;
};

std::string TextOf(const char* text)
{
  return Trimmed(text ? text : "");
}

/// The element after <key>name</key>, or nullptr.
vtkXMLDataElement* Find(vtkXMLDataElement* dict, const std::string& name)
{
  for (int n = 0; dict && n + 1 < dict->GetNumberOfNestedElements(); n += 2)
    if (TextOf(dict->GetNestedElement(n)->GetCharacterData()) == name)
      return dict->GetNestedElement(n + 1);
  return nullptr;
}

std::string TextOf(vtkXMLDataElement* dict, const std::string& name)
{
  vtkXMLDataElement* element = Find(dict, name);
  return element ? TextOf(element->GetCharacterData()) : std::string();
}

std::optional<double> Number(vtkXMLDataElement* element)
{
  const auto number = FiniteNumbers(element ? TextOf(element->GetCharacterData()) : "", 1);
  return number ? std::optional<double>(number->front()) : std::nullopt;
}

/// The three numbers of an array, or an error naming the key.
glm::dvec3 Three(
  const std::filesystem::path& file, vtkXMLDataElement* dict, const std::string& name)
{
  vtkXMLDataElement* array = Find(dict, name);
  glm::dvec3 numbers(0.0);
  if (!array || array->GetNumberOfNestedElements() != 3)
    ThrowFileError(file, "main.plist: " + name + " must be an array of three numbers");
  for (int n = 0; n < 3; ++n)
  {
    const auto number = Number(array->GetNestedElement(n));
    if (!number)
      ThrowFileError(file, "main.plist: " + name + " holds what is no number");
    numbers[n] = *number;
  }
  return numbers;
}

void ParseMain(const std::filesystem::path& file, const std::string& text,
  const VolumeReadSettings& settings, Passport& passport, Matrix& matrix)
{
  vtkNew<ShallowParser> parser;
  vtkNew<vtkCallbackCommand> silent; // an observer keeps VTK from printing; Parse returns 0 as well
  silent->SetCallback([](vtkObject*, unsigned long, void*, void*) {});
  parser->AddObserver(vtkCommand::ErrorEvent, silent);
  std::istringstream stream(text);
  parser->SetStream(&stream);
  vtkXMLDataElement* root =
    parser->Parse() && !parser->WasDeep() ? parser->GetRootElement() : nullptr;
  vtkXMLDataElement* dict = root ? root->FindNestedElementWithName("dict") : nullptr;
  vtkXMLDataElement* samples = Find(dict, "matrix");
  if (!samples)
    ThrowFileError(file, "main.plist is no property list with a matrix; save the project again");
  if (TextOf(samples, "dtype") != "int16")
    ThrowFileError(file, "main.plist: samples are not int16; only int16 is read");
  if (const std::string orientation = TextOf(dict, "orientation");
      !orientation.empty() && orientation != "1")
    ThrowFileError(file, "main.plist: orientation is not 1 (axial), only that is read; import the "
                         "scan as axial slices");
  matrix.fileName = TextOf(samples, "filename");
  const glm::dvec3 shape = Three(file, samples, "shape"); // z, y, x
  if (glm::any(glm::lessThan(shape, glm::dvec3(1.0))) ||
      glm::any(glm::greaterThan(shape, glm::dvec3(1e6))) || shape != glm::floor(shape))
    ThrowFileError(file, "main.plist: shape must be three whole numbers in [1, 1000000]");
  matrix.dims = { int(shape.z), int(shape.y), int(shape.x) };
  CheckSampleBytes(file, matrix.dims.x, matrix.dims.y, matrix.dims.z, 2, settings.memoryLimitBytes);
  const glm::dvec3 spacing = Three(file, dict, "spacing");
  if (!glm::all(glm::greaterThan(spacing, glm::dvec3(0.0))))
    ThrowFileError(file, "main.plist: spacing must be > 0 mm on each axis");
  passport.format = "InVesalius";
  passport.geometry.dims = matrix.dims;
  passport.geometry.spacing = spacing;
  passport.modality = KnownModality(TextOf(dict, "modality"));
  passport.hounsfield = passport.modality == "CT"; // InVesalius stores rescaled values
  passport.sampleType = "int16";
  passport.warnings.push_back("InVesalius projects hold no patient position: the first sample is "
                              "put at the world's origin.");
}

vtkSmartPointer<vtkImageData> LoadMatrix(const std::filesystem::path& file,
  const Passport& passport, const Matrix& matrix, const VolumeReadSettings& settings,
  const ProgressFunction& progress)
{
  vtkSmartPointer<vtkImageData> image;
  const glm::ivec3 d = matrix.dims;
  const std::size_t rowBytes = std::size_t(d.x) * 2, sliceBytes = rowBytes * d.y;
  // The walk goes on to the archive's end: a bad entry after the samples is still a bad archive.
  WalkArchive(file, settings.memoryLimitBytes,
    [&](const ArchiveEntry& entry)
    {
      if (entry.Name() != matrix.fileName)
        return true;
      if (entry.Size() != sliceBytes * d.z)
        ThrowFileError(file, "the file of samples has " + std::to_string(entry.Size()) +
                               " bytes, " + std::to_string(d.x) + " x " + std::to_string(d.y) +
                               " x " + std::to_string(d.z) + " int16 samples need " +
                               std::to_string(sliceBytes * d.z));
      image = NewImage(passport.geometry, VTK_SHORT);
      auto* slice = static_cast<std::byte*>(image->GetScalarPointer());
      for (int k = 0; k < d.z; ++k, slice += sliceBytes)
      {
        entry.Read(slice, sliceBytes);
        for (int low = 0, high = d.y - 1; low < high; ++low, --high)
          std::swap_ranges(
            slice + low * rowBytes, slice + (low + 1) * rowBytes, slice + high * rowBytes);
        ReportProgress(progress, double(k + 1) / d.z);
      }
      return true;
    });
  if (!image)
    ThrowFileError(file, "the archive lacks the file of samples that main.plist names");
  return image;
}

} // namespace

OpenedVolume OpenInvesalius(const std::filesystem::path& file, const VolumeReadSettings& settings)
{
  OpenedVolume opened;
  Matrix matrix;
  WalkArchive(file, settings.memoryLimitBytes,
    [&](const ArchiveEntry& entry)
    {
      if (entry.Name() != "main.plist")
        return true;
      if (entry.Size() > PropertyListLimit)
        ThrowFileError(file, "main.plist has " + std::to_string(entry.Size()) +
                               " bytes, more than a property list can need");
      std::string text(entry.Size(), '\0');
      entry.Read(text.data(), text.size());
      ParseMain(file, text, settings, opened.passport, matrix);
      return false;
    });
  if (matrix.dims.x == 0)
    ThrowFileError(file, "has no main.plist: it is no InVesalius project");
  opened.load = [file, matrix, settings, passport = opened.passport](
                  const ProgressFunction& progress, Passport&)
  { return LoadMatrix(file, passport, matrix, settings, progress); };
  return opened;
}

} // namespace hasp
