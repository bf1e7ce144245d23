#include "CellsInput.h"

#include "Failure.h"
#include "Files.h"
#include "Session.h"
#include "vtkHaspCellFile.h"
#include "vtkHaspFileNames.h"

#include "Isosurface/ClusteredCells.h"

#include <chrono>
#include <new>

namespace hasp
{

std::shared_ptr<const ClusteredCells> ReadCells(const std::string& path, Session& session)
{
  RequireInput(path);
  session.progress.Step("reading " + FileLabel(path));
  try
  {
    const auto start = std::chrono::steady_clock::now();
    auto cells = LoadCells(path, {},
      [&session](double share)
      {
        session.progress.Share(share);
        return true;
      });
    const std::chrono::duration<double, std::milli> spent =
      std::chrono::steady_clock::now() - start;
    session.resources.push_back({ "reading active cells", 0, spent.count(),
      std::to_string(cells->Count()) + " cells, each cluster checked" });
    return cells;
  }
  catch (const std::bad_alloc&)
  {
    throw; // no fault of the file; the caller says what to do
  }
  catch (const std::exception& error)
  {
    throw Failure(ExitCode::BadInput, SafeText(error));
  }
}

} // namespace hasp
