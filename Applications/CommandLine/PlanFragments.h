#pragma once
#include "VolumeInput.h"

#include "Planning/PlanFile.h"
#include "vtkHaspLabelTable.h"

#include <string>
#include <vector>

namespace hasp
{

/// A label map with its scan, as a plan keeps them.
struct FragmentLabels
{
  std::string scanHash, blob;          ///< VolumeHash; the SHA-256 of the map in the plan's folder
  LabelTable fragments;                ///< one each, in their order
  double isovalue = 226.0;             ///< LabelSource::isovalue
  double spacingMm = 0.5;              ///< LabelSource::spacingMm
  std::vector<std::uint16_t> locked{}; ///< labels whose fragments do not move
};

/// Edits that add the scan (unless the plan has it), a segmentation of it, and a fragment for each
/// label. firstId: PlanHistory::NewId().
std::vector<PlanEdit> FragmentEdits(const Plan& plan, PlanId firstId, const FragmentLabels& labels);

/// Stores labels as a blob of the plan's folder. Throws as WriteBlob.
std::string StoreLabels(const std::string& planFolder, vtkImageData* labels);

/// `hasp plan --fragments`.
struct PlanFragmentsChoice
{
  std::string labels; ///< a label map's file; empty: not asked for
  VolumeChoices scan;
  double isovalue = 226.0;
  std::vector<std::uint16_t> only;   ///< labels; empty: all
  std::vector<std::uint16_t> locked; ///< labels whose fragments stay where they are
};

void AddFragmentOptions(CLI::App& verb, PlanFragmentsChoice& choice);

/// Makes them one step of the plan. Returns what to say once it is stored. Throws Failure.
std::string MakeFragments(PlanDocument& document, const std::string& planFolder,
  const PlanFragmentsChoice& choice, Session& session);

} // namespace hasp
