// ReadVolume <DICOM folder or volume file> <out.nrrd>
// Reads a volume into a pipeline, says what is known of it and why it is refused, and writes it.
#include "vtkHaspVolumeFile.h" // Passport, VolumeReadSettings
#include "vtkHaspVolumeReader.h"
#include "vtkHaspVolumeWriter.h"

#include "vtkNew.h"

#include <iostream>

int main(int argc, char* argv[])
{
  if (argc != 3)
    return 1;
  vtkNew<vtkHaspVolumeReader> reader;
  hasp::VolumeReadSettings settings;
  settings.resample = false; // true: mend tilt and gaps, and record the error in mm
  settings.hash = true;      // the same for one volume in every format
  reader->SetSettings(settings);
  reader->SetFileName(argv[1]);
  reader->Update();
  const hasp::Passport& passport = reader->GetPassport(); // nothing of the patient is in it
  for (const hasp::ImportFault& fault : passport.faults)
    std::cout << "fault: " << fault.text << "\n";
  if (reader->GetErrorCode() != 0)
    return 1;
  std::cout << passport.format << ", " << passport.sampleType << ", "
            << (passport.hounsfield ? "HU" : "the file does not say HU") << ", hash "
            << passport.hash << "\n";
  vtkNew<vtkHaspVolumeWriter> writer; // .nrrd, .nii.gz, .mha or .vti; whole or not at all
  writer->SetInputConnection(reader->GetOutputPort());
  writer->SetFileName(argv[2]);
  return writer->Write() ? 0 : 1;
}
