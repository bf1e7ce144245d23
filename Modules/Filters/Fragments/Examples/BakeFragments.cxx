// BakeFragments <scan> <labels> <isovalue>
// What a scene draws, touches and moves of each fragment, made on another thread.
#include "vtkHaspClusteredCells.h"
#include "vtkHaspFragmentScan.h"
#include "vtkHaspVolumeReader.h"
#include "vtkNew.h"
#include <cstdio>
#include <cstdlib>
#include <future>
int main(int argc, char* argv[])
try
{
  if (argc != 4)
    return std::fputs("BakeFragments <scan> <labels> <isovalue>\n", stderr), 1;
  vtkNew<vtkHaspVolumeReader> scan, labels; // labels: unsigned short, on the scan's grid
  scan->SetFileName(argv[1]);
  scan->Update();
  labels->SetFileName(argv[2]);
  labels->Update();
  hasp::FragmentModels fragments( // nothing is made before it is asked for
    hasp::FragmentScanOf(scan->GetOutput(), labels->GetOutput(), std::atof(argv[3])));
  std::vector<std::uint16_t> all;
  for (const hasp::FragmentLabel& fragment : fragments.Labels())
    all.push_back(fragment.label);
  const auto work = fragments.Begin(all, { .map = true, .shell = true, .cells = true });
  auto worker = std::async(
    std::launch::async, [&] { work->Run([](double) { return true; }); }); // progress; false cancels
  worker.get(); // a scene draws meanwhile, and asks fragments.Finished(label)
  vtkNew<vtkHaspClusteredCells> cells; // of a vtkHaspClusteredCellMapper, SetLabelPose moves one
  cells->SetCells(fragments.Cells());
  hasp::ResourceList list;
  fragments.ListResources(list);
  for (const hasp::ResourceUse& use : list)
    std::printf("%-30s %9zu bytes  %s\n", use.resource.c_str(), use.bytes, use.reason.c_str());
}
catch (const std::exception& error)
{
  return std::fprintf(stderr, "%s\n", error.what()), 1;
}
