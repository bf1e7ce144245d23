#pragma once
#include "IOFixture.h"

#include <dcmtk/config/osconfig.h>

#include <dcmtk/dcmdata/dctk.h>

/// Writes series of DICOM slices, sound or with a fault.
class DicomFixture : public IOFixture
{
protected:
  /// Called for each slice k before it is written; what it changes is the fault.
  using Edit = std::function<void(int k, DcmDataset& slice)>;

  /// One CT slice a file, stored as value + 1024 in 12 unsigned bits with an intercept of -1024;
  /// names are in another order than positions. Big values do not fit and fail the test.
  void WriteSeries(const std::filesystem::path& folder, const hasp::GridGeometry& geometry,
    const std::vector<std::int16_t>& samples, const Edit& edit = {},
    E_TransferSyntax syntax = EXS_LittleEndianExplicit) const;

  /// The sound series with one fault, in Folder/"series".
  std::filesystem::path Faulty(const Edit& edit) const;
  std::filesystem::path FileOf(const std::filesystem::path& folder, int k) const;
};
