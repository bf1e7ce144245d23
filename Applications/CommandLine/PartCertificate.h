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

/// A part's file under way, by its ending: .stl, .ply and .obj by VTK's readers, which are not the
/// writer's own. Of .3mf there is no second reader: lib3mf reads what lib3mf wrote, in a process of
/// its own, so that a fault that it makes both ways is not seen here. Throws Failure: FailedCheck
/// if it cannot be read.
TriangleMesh ReadBack(const std::string& pendingFile, Session& session);
/// The same of .stl, whatever the file is called.
TriangleMesh ReadBackStl(const std::string& file);

/// Certifies a part, with CGAL where it is there; its time is listed among the resources. Throws
/// Failure: FailedCheck for what cannot be measured.
FitCertificate MeasurePart(
  const TriangleMesh& part, const AnyGridView& bone, const PartClaims& claims, Session& session);

/// Certifies a part, with CGAL where it is there, and hands the certificate to the session: its
/// JSON under "certificate", its text on standard output without --json, its time among the
/// resources. Throws Failure: FailedCheck for what cannot be measured.
FitCertificate CertifyPart(
  const TriangleMesh& part, vtkImageData* bone, const PartClaims& claims, Session& session);

/// Failure: FailedCheck with these words and the faults, a line each.
[[noreturn]] void ThrowFaults(const FitCertificate& certificate, const std::string& words);

} // namespace hasp
