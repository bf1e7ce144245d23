#pragma once
#include "Evaluation/FitCertificate.h"
#include "Grid/GridView.h"

#include <string>

class vtkImageData;

namespace hasp
{

struct Session;

/// A surface as it will be printed, points made one by place alone; its warnings are said. Throws
/// Failure: BadInput if it cannot be read.
TriangleMesh ReadPart(const std::string& path, Session& session);

/// An STL file under way, whatever it is called yet: by VTK's reader, which is not the writer's
/// own. Throws Failure: FailedCheck if it cannot be read.
TriangleMesh ReadBackStl(const std::string& stl);

/// Certifies a part, with CGAL where it is there; its time is listed among the resources. Throws
/// Failure: FailedCheck for what cannot be measured.
FitCertificate MeasurePart(
  const TriangleMesh& part, const AnyGridView& bone, const PartClaims& claims, Session& session);

/// Says in the head of a binary STL file, 80 bytes of text, that it does not hold. Throws Failure.
void MarkAsFailed(const std::string& stl);

/// Certifies a part, with CGAL where it is there, and hands the certificate to the session: its
/// JSON under "certificate", its text on standard output without --json, its time among the
/// resources. Throws Failure: FailedCheck for what cannot be measured.
FitCertificate CertifyPart(
  const TriangleMesh& part, vtkImageData* bone, const PartClaims& claims, Session& session);

/// Failure: FailedCheck with these words and the faults, a line each.
[[noreturn]] void ThrowFaults(const FitCertificate& certificate, const std::string& words);

} // namespace hasp
