#pragma once
#include "Evaluation/FitCertificate.h"
#include "Failure.h"
#include "Grid/GridView.h"

#include <string>

class vtkImageData;

namespace hasp
{

struct Session;

/// A part as it will be printed.
struct PrintedPart
{
  TriangleMesh mesh;    ///< points made one by place alone
  bool saidRed = false; ///< its file says that it does not hold
};

/// A part's file; its warnings are said. Throws Failure: BadInput if it cannot be read.
PrintedPart ReadPart(const std::string& path, Session& session);

/// A part's file under way, by its ending: .stl, .ply and .obj by VTK's readers, which are not the
/// writer's own. Of .3mf there is no second reader: lib3mf reads what lib3mf wrote, in a process of
/// its own, so that a fault that it makes both ways is not seen here. Throws Failure: FailedCheck
/// if it cannot be read.
TriangleMesh ReadBack(const std::string& pendingFile, Session& session);
/// The same of .stl, whatever the file is called.
TriangleMesh ReadBackStl(const std::string& file);

/// Certifies a part, with CGAL where it is there; its time is listed among the resources. Throws
/// Failure: BadInput for claims, or a volume, that nothing can be held to; FailedCheck for what
/// cannot be measured.
FitCertificate MeasurePart(
  const TriangleMesh& part, const AnyGridView& bone, const PartClaims& claims, Session& session);

/// MeasurePart, and hands the certificate to the session: its JSON under "certificate", its text on
/// standard output without --json. A part whose file says that it does not hold never does.
FitCertificate CertifyPart(
  const PrintedPart& part, vtkImageData* bone, const PartClaims& claims, Session& session);

/// FailedCheck with these words and the faults, a line each.
Failure Faulty(const FitCertificate& certificate, const std::string& words);

} // namespace hasp
