#pragma once
#include "Grid/GridView.h"

#include <cstdint>
#include <string>
#include <vector>

namespace hasp
{

/// The longest decimal text of a number that a DICOM decimal string (DS) holds: 16 characters.
std::string DecimalString(double value);
double FromDecimalString(const std::string& text);

/// How samples become the 16-bit stored values of a DICOM series. The numbers are those that the
/// file's texts give back.
struct StoredValues
{
  bool isSigned = false;
  double slope = 1.0, intercept = 0.0;
  double error = 0.0; ///< largest difference between a sample and what is read back
};

/// Integers are stored as they are. Floats are stored minus their smallest value if all differ from
/// it by whole numbers up to 65535, else at 65536 levels. Throws std::invalid_argument for samples
/// that are NaN or infinite, or too far apart for float.
StoredValues ChooseStoredValues(const AnyGridView& grid);

/// The stored values of slice k. `into` has room for one slice.
void StoreSlice(
  const AnyGridView& grid, const StoredValues& how, int k, std::vector<std::uint16_t>& into);

} // namespace hasp
