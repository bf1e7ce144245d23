#pragma once
#include "Evaluation/FitCertificate.h"

#include <string>
#include <vector>

class vtkImageData;

namespace hasp
{

struct Session;

struct CertificatePicture
{
  std::string caption;
  std::string png;    ///< the file's bytes
  bool ofGap = false; ///< coloured by GapColour
};

/// The part on the bone around it (BoneAround) from three sides, and, where a shell is claimed, its
/// inner wall from the bone, coloured by its gap; on all of them the faults that have a place, by
/// their numbers, in front of everything. The same bytes for the same part with the same OpenGL.
/// Throws Failure: CannotDraw. RENDER thread.
std::vector<CertificatePicture> DrawCertificate(const TriangleMesh& part, vtkImageData* bone,
  const FitCertificate& certificate, Session& session);

} // namespace hasp
