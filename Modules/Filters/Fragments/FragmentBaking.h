#pragma once
#include "FragmentCrop.h"
#include "FragmentModels.h"
#include "FragmentTable.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace hasp
{

/// One fragment's models that are to be made.
struct FragmentTask
{
  FragmentCrop crop;
  FragmentWants wants;
  glm::dvec3 origin{ 0.0 };
  std::uint64_t version = 0;
  double samples = 0.0; ///< about as many as its grids will have
};

/// What FragmentModels::Begin fills in.
struct FragmentBaking::Internals
{
  FragmentScan scan;
  FragmentSettings settings; ///< none is 0
  std::shared_ptr<FragmentTable> table;
  std::vector<FragmentTask> tasks;
  bool cells = false;

  std::vector<std::uint16_t> outdated;
  std::size_t samples = 0;
};

/// Without labels.
std::shared_ptr<const ClusteredCells> ExtractBone(
  const FragmentScan& scan, const ProgressFunction& progress);

} // namespace hasp
