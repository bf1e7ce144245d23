#include "PlanEntries.h"

#include "FragmentSurfaces.h"
#include "PlanText.h"
#include "Session.h"
#include "SurfaceInput.h"
#include "VerbWork.h"
#include "vtkHaspSurfaceHash.h"
#include "vtkHaspVolumeView.h"

#include "Planning/PlanLists.h"

#include <CLI/CLI.hpp>

#include <algorithm>

namespace hasp
{
namespace
{

/// What BakeSurface would refuse is refused now.
void RequireBody(
  const TriangleMesh& mesh, const SurfaceSource& source, const std::string& name, Session& session)
{
  SurfaceFragmentSettings settings;
  settings.thicknessMm = source.thicknessMm;
  settings.behind = source.side == SheetSide::Behind;
  settings.spacingMm = source.spacingMm;
  try
  {
    for (const std::string& warning : BakeSurface(mesh, settings, {}).warnings)
      SayWarning(session, name + ": " + WithoutSubject(warning));
  }
  catch (const std::invalid_argument& error)
  {
    throw Failure(ExitCode::BadInput,
      name + ": " + WithoutSubject(SafeText(error)) +
        (source.thicknessMm == 0.0 ? "; --thickness makes open ones sheets" : ""));
  }
}

void RequireNew(
  const std::vector<PlanSurface>& surfaces, const PlanSurface& entered, const std::string& name)
{
  for (const PlanSurface& surface : surfaces)
    if (surface.hash == entered.hash)
      throw Failure(ExitCode::BadInput, name + " has the triangles of surface " +
                                          std::to_string(surface.id) +
                                          " of the plan; give each surface once");
}

} // namespace

void AddSurfaceOptions(CLI::App& verb, SurfaceEntries& entries)
{
  CLI::Option* files = verb.add_option("--surface", entries.files,
    "Surfaces that become fragments: sherds, dental scans, plates; .stl, .ply, .obj, .3mf or .vtp");
  verb
    .add_option("--thickness", entries.thicknessMm,
      "With --surface: open ones are sheets, so many mm thick; 0: all are closed")
    ->check(Within(0.0, 50.0))
    ->needs(files);
  verb
    .add_flag("--both-sides", entries.bothSides,
      "With --thickness: half of it on either side, not all behind the face")
    ->needs(files);
  verb
    .add_option("--grid", entries.spacingMm, "With --surface: of the grid they are measured on, mm")
    ->check(Within(0.1, 2.0))
    ->needs(files);
}

std::string EnterSurfaces(PlanDocument& document, const SurfaceEntries& entries, Session& session)
{
  std::vector<PlanSurface> surfaces = document.history.Current().surfaces;
  std::vector<PlanEdit> edits;
  PlanId next = document.history.NewId();
  std::string said;
  session.result["entered"] = nlohmann::ordered_json::array();
  for (std::size_t n = 0; n < entries.files.size(); ++n)
  {
    const std::string name = "--surface number " + std::to_string(n + 1);
    const TriangleMesh mesh =
      MakeTriangleMesh(ReadSurface(entries.files[n], name, false, session).surface);
    const PlanSurface surface{ next++, "", SurfaceHash(mesh) };
    RequireNew(surfaces, surface, name);
    PlanFragment fragment;
    fragment.id = next++;
    const SurfaceSource source{ surface.id, entries.thicknessMm,
      entries.bothSides ? SheetSide::Both : SheetSide::Behind, entries.spacingMm };
    RequireBody(mesh, source, name, session);
    fragment.source = source;
    edits.push_back(AddObject<PlanSurface>{ surface });
    edits.push_back(AddObject<PlanFragment>{ fragment });
    surfaces.push_back(surface);
    session.result["entered"].push_back({ { "surface", surface.id }, { "fragment", fragment.id } });
    said += (said.empty() ? "" : "\n") + name + " is fragment " + std::to_string(fragment.id);
  }
  session.progress.Wipe();
  return Try(ExitCode::BadInput, "",
    [&]
    {
      const std::string label = TextOf(document.history.Current(), edits);
      document.history.Do(std::move(edits), label);
      return said;
    });
}

} // namespace hasp
